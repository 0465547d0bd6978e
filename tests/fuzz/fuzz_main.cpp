// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry points for the target that AWD_FUZZ_TARGET names. A corpus folder that is empty
// is given the target's own seeds.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "mutate.h"

extern "C" std::size_t LLVMFuzzerMutate(uint8_t* data, std::size_t size, std::size_t longest);
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerCustomMutator(uint8_t* data, std::size_t size, std::size_t longest,
                                               unsigned seed);

namespace {
const fuzz::Target& target = fuzz::AWD_FUZZ_TARGET;
}

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  namespace fs = std::filesystem;
  for (int i = 1; i < *argc; ++i) {
    const fs::path folder((*argv)[i]);
    if (!fs::is_directory(folder)) continue;
    if (!fs::is_empty(folder)) break;
    int number = 0;
    for (const fuzz::Input& seed : target.seeds()) {
      std::ofstream(folder / ("seed-" + std::to_string(number++)), std::ios::binary)
          .write(reinterpret_cast<const char*>(seed.data()),
                 static_cast<std::streamsize>(seed.size()));
    }
    break;
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  target.run(data, size);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(uint8_t* data, std::size_t size, std::size_t longest,
                                               unsigned seed) {
  awdtest::Random random(seed);
  if (random.bits() & 1) return LLVMFuzzerMutate(data, size, longest);
  const fuzz::Input changed = fuzz::mutated({data, data + size}, longest, random);
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}
