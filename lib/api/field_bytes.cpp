// SPDX-License-Identifier: Apache-2.0
#include "api/handles.h"
#include "api/saved_bytes.h"
#include "awd/field.h"
#include "guide/field.h"
#include "util/atomic_file.h"
#include "util/file_bytes.h"

using namespace awd;

extern "C" {

AWDResult AWD_CALL awdSaveField(AWDField field, void* bytes, size_t capacity,
                                size_t* size) noexcept {
  return guard(__func__, [&] {
    const Field& known = idle(field, "field");
    giveBytes(known.bytesOf(), bytes, capacity, need(size, "size"));
  });
}

AWDResult AWD_CALL awdLoadField(AWDDevice device, const void* bytes, size_t size,
                                AWDField* field) noexcept {
  return guard(__func__, [&] {
    clearOutput(field, "field");
    Device& owner = object(device, "device");
    give(field, Field::load(owner.shareContext(), need(bytes, "bytes"), size, findersOf(owner)));
  });
}

AWDResult AWD_CALL awdWriteField(AWDField field, const char* path) noexcept {
  return guard(__func__, [&] {
    const auto bytes = idle(field, "field").bytesOf();
    AtomicFile file(need(path, "path"));
    file.write(bytes.data(), bytes.size());
    file.commit();
  });
}

AWDResult AWD_CALL awdReadField(AWDDevice device, const char* path, AWDField* field) noexcept {
  return guard(__func__, [&] {
    clearOutput(field, "field");
    Device& owner = object(device, "device");
    Ref<Context> context = owner.shareContext();
    const auto bytes = readFile(context->memory(), need(path, "path"));
    try {
      give(field, Field::load(std::move(context), bytes.data(), bytes.size(), findersOf(owner)));
    } catch (const Error& error) {
      fail(error.code(), "can't load \"%s\": %s", path, error.what());
    }
  });
}

AWDResult AWD_CALL awdMergeField(AWDField field, AWDField other) noexcept {
  return guard(__func__, [&] { idle(field, "field").merge(idle(other, "other")); });
}

}  // extern "C"
