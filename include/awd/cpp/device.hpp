// SPDX-License-Identifier: Apache-2.0
//
// awd/device.h in C++.
#ifndef AWD_CPP_DEVICE_HPP
#define AWD_CPP_DEVICE_HPP

#include <vector>

#include "awd/cpp/handle.hpp"
#include "awd/cpp/settings.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

/// Threads, callbacks, memory, and the registry of basis families.
class Device : public Owner<Device, AWDDevice, awdRetainDevice, awdReleaseDevice> {
 public:
  static Returns<Device> create(const AWDDeviceDesc& desc = DeviceDesc()) {
    Device device;
    return detail::outcome(awdNewDevice(&desc, device.out()), device);
  }

  Returns<void> loadBasisModule(Text absolutePath) const {
    const detail::Call call;
    return detail::outcome(call, awdLoadBasisModule(get(), absolutePath.get()));
  }
  /// The table must outlive the device.
  Returns<void> registerBasisModule(const AWDBasisModule& module) const {
    const detail::Call call;
    return detail::outcome(call, awdRegisterBasisModule(get(), &module));
  }
  /// Families that can be used, and rejected candidates. The texts live as long as the device.
  Returns<std::vector<AWDBasisInfo>> bases() const {
    const detail::Call call;
    std::vector<AWDBasisInfo> infos;
    std::size_t count = 0;
    AWDResult result = awdGetBasisCount(get(), &count);
    for (std::size_t i = 0; i < count && result == AWD_SUCCESS; ++i) {
      infos.push_back(AWD_BASIS_INFO_INIT);
      result = awdGetBasisInfo(get(), i, &infos.back());
    }
    return detail::outcome(call, result, infos);
  }
};

/// AWD_VERSION of the loaded library.
inline std::uint32_t version() noexcept { return awdGetVersion(); }

/// A short name of a result code.
inline const char* resultString(AWDResult result) noexcept { return awdGetResultString(result); }

/// Tests a module and registers nothing; callable(const AWDBasisCheck&) hears of every check.
template <class Callable>
Returns<void> checkBasisModule(Text absolutePath, Callable&& callable) {
  using Plain = std::remove_reference_t<Callable>;
  void* user = detail::userOf(callable);
  const detail::Call call(user);
  return detail::outcome(
      call, awdCheckBasisModule(absolutePath.get(), detail::onBasisCheck<Plain>, user));
}

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
