// SPDX-License-Identifier: Apache-2.0
#include "awd/device.h"

#include "api/handles.h"
#include "awd/basis.h"
#include "basis/device.h"
#include "basis/module_check.h"

namespace awd {

namespace {

constexpr uint32_t kMostThreads = 1024;
constexpr std::size_t kMostFolders = 4096;

void checkDesc(const AWDDeviceDesc& desc) {
  if (desc.threads > kMostThreads) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->threads is %u: at most %u, 0 for all there are",
         desc.threads, kMostThreads);
  }
  if (desc.flags & ~AWD_DEVICE_IGNORE_ENVIRONMENT) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->flags is 0x%x: only AWD_DEVICE_IGNORE_ENVIRONMENT (0x1) is known", desc.flags);
  }
  if (!desc.alloc != !desc.free) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->%s is set without desc->%s: set both, or neither for the library's own",
         desc.alloc ? "alloc" : "free", desc.alloc ? "free" : "alloc");
  }
  if (desc.basisPathCount > kMostFolders) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->basisPathCount is %zu: at most %zu",
         desc.basisPathCount, kMostFolders);
  }
  if (desc.basisPathCount > 0 && !desc.basisPaths) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->basisPaths is NULL, but basisPathCount is %zu",
         desc.basisPathCount);
  }
}

std::vector<std::string> checkFolders(const AWDDeviceDesc& desc) {
  std::vector<std::string> folders;
  for (std::size_t i = 0; i < desc.basisPathCount; ++i) {
    const char* path = desc.basisPaths[i];
    if (!path) fail(AWD_ERROR_INVALID_ARGUMENT, "desc->basisPaths[%zu] is NULL", i);
    if (path[0] != '/') {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->basisPaths[%zu] \"%s\" is not absolute: give the whole path, from '/' on", i,
           path);
    }
    folders.emplace_back(path);
  }
  return folders;
}

}  // namespace

}  // namespace awd

using awd::guard;

extern "C" {

uint32_t AWD_CALL awdGetVersion(void) noexcept { return AWD_VERSION; }

const char* AWD_CALL awdGetResultString(AWDResult result) noexcept {
  switch (result) {
    case AWD_SUCCESS:
      return "success";
    case AWD_ERROR_UNKNOWN:
      return "unknown error";
    case AWD_ERROR_INVALID_ARGUMENT:
      return "invalid argument";
    case AWD_ERROR_INVALID_OPERATION:
      return "invalid operation";
    case AWD_ERROR_OUT_OF_MEMORY:
      return "out of memory";
    case AWD_ERROR_UNSUPPORTED:
      return "unsupported";
    case AWD_ERROR_CANCELLED:
      return "cancelled";
    case AWD_ERROR_IO:
      return "input or output error";
    case AWD_ERROR_PLUGIN_LOAD:
      return "module can't be loaded";
    case AWD_ERROR_PLUGIN_ABI:
      return "module of another ABI";
    case AWD_ERROR_PLUGIN_NAME_TAKEN:
      return "name taken";
    case AWD_ERROR_PLUGIN_SELF_TEST:
      return "self-test failed";
    default:
      return "no result code of this version";
  }
}

AWDResult AWD_CALL awdNewDevice(const AWDDeviceDesc* desc, AWDDevice* device) noexcept {
  return guard("awdNewDevice", [&] {
    awd::clearOutput(device, "device");
    AWDDeviceDesc known = AWD_DEVICE_DESC_INIT;
    if (desc) known = awd::readStruct(desc, "desc", "AWD_DEVICE_DESC_INIT");
    awd::checkDesc(known);
    awd::give(device, awd::Device::make(known, awd::checkFolders(known)));
  });
}

void AWD_CALL awdRetainDevice(AWDDevice device) noexcept {
  if (device) awd::behind(device)->retain();
}

void AWD_CALL awdReleaseDevice(AWDDevice device) noexcept {
  if (device) awd::behind(device)->release();
}

AWDResult AWD_CALL awdLoadBasisModule(AWDDevice device, const char* absolutePath) noexcept {
  return guard("awdLoadBasisModule", [&] {
    awd::object(device, "device").registry().load(awd::need(absolutePath, "absolutePath"));
  });
}

AWDResult AWD_CALL awdRegisterBasisModule(AWDDevice device, const AWDBasisModule* module) noexcept {
  return guard("awdRegisterBasisModule",
               [&] { awd::object(device, "device").registry().add(*awd::need(module, "module")); });
}

AWDResult AWD_CALL awdCheckBasisModule(const char* absolutePath, AWDBasisCheckFn report,
                                       void* user) noexcept {
  return guard("awdCheckBasisModule", [&] {
    awd::checkModuleFile(awd::need(absolutePath, "absolutePath"), [&](const AWDBasisCheck& check) {
      if (report) report(user, &check);
    });
  });
}

AWDResult AWD_CALL awdGetBasisCount(AWDDevice device, size_t* count) noexcept {
  return guard("awdGetBasisCount", [&] {
    *awd::need(count, "count") = 0;
    *count = awd::object(device, "device").registry().count();
  });
}

AWDResult AWD_CALL awdGetBasisInfo(AWDDevice device, size_t index, AWDBasisInfo* info) noexcept {
  return guard("awdGetBasisInfo", [&] {
    awd::need(info, "info");
    awd::writeStruct(info, awd::object(device, "device").registry().info(index), "info",
                     "AWD_BASIS_INFO_INIT");
  });
}

}  // extern "C"
