// SPDX-License-Identifier: Apache-2.0
// What examples/embed/README.md leaves to the reader: a host without exceptions.
#define AWD_NO_EXCEPTIONS
#include <awd/awd.hpp>
#include <cstdio>

namespace {

int report(const char* reason) {
  std::printf("%s\n", reason);
  return 1;
}

int makeField(const awd::Device& device) {
  // @body
  return 0;
}

}  // namespace

int main() {
  const awd::Result<awd::Device> device = awd::Device::create();
  return device ? makeField(*device) : report(device.error().what());
}
