// SPDX-License-Identifier: Apache-2.0
// A host in C++ of the installed library. Prints only what is wrong.
#include <array>
#include <awd/awd.hpp>
#include <cstdio>
#include <cstring>

int main() {
  try {
    const awd::Device device = awd::Device::create();
    awd::Field field = awd::Field::create(device);
    const std::array<float, 3> up = {0, 0, 1};
    const AWDDirectionSample sample = field.sample(0, up, std::array<double, 3>{0.3, 0.6, 0.9});
    field.record(0, sample, 1.0);
    field.adapt();
    if (!(field.pdf(0, up, sample.direction) > 0)) {
      std::fprintf(stderr, "a sample that can't be\n");
      return 1;
    }
    awd::FieldDesc desc;
    desc.basis = "none";
    awd::Field::create(device, desc);
    std::fprintf(stderr, "there is no such basis\n");
    return 1;
  } catch (const awd::Error& error) {
    if (error.code() == AWD_ERROR_UNSUPPORTED && std::strstr(error.what(), "none")) return 0;
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
