// SPDX-License-Identifier: Apache-2.0
// Every lying plugin is refused, by the right code and with a sentence that says where it lies.
#include "support.h"

namespace {

struct Lie {
  const char* file;
  AWDResult code;
  const char* sentence;
};

const Lie kLies[] = {
    {"weight", AWD_ERROR_PLUGIN_SELF_TEST,
     "weight is not the integral: level 1, function 0: got 0.50005, want 0.5"},
    {"middle", AWD_ERROR_PLUGIN_SELF_TEST,
     "weight is not the integral: level 9, function 1: got 0.001955078125, want 0.001953125"},
    {"two_scale", AWD_ERROR_PLUGIN_SELF_TEST,
     "two-scale relation does not hold: level 4, function 1, x = "},
    {"unity", AWD_ERROR_PLUGIN_SELF_TEST,
     "functions do not sum to 1: level 2, x = 0.75: got 0.999999999, want 1"},
    {"sampler", AWD_ERROR_PLUGIN_SELF_TEST,
     "sampler does not follow the function: level 0, function 0: a share of "},
    {"sample_outside", AWD_ERROR_PLUGIN_SELF_TEST,
     "sample lies outside the support: level 0, function 0, u[0] = 1: got 1.001, want 0 to 1"},
    {"sample_nan", AWD_ERROR_PLUGIN_SELF_TEST,
     "sample lies outside the support: level 0, function 0, u[0] = 0: got "},
    {"state", AWD_ERROR_PLUGIN_SELF_TEST,
     "sampler is not repeatable: level 0, function 0: got 0, then 1"},
    {"negative", AWD_ERROR_PLUGIN_SELF_TEST,
     "value is negative or not finite: level 2, function 3, x = 0.75: got -1e-09"},
    {"nan", AWD_ERROR_PLUGIN_SELF_TEST,
     "value is negative or not finite: level 2, function 3, x = 0.75: got "},
    {"index", AWD_ERROR_PLUGIN_SELF_TEST, "eval: first index 1, but level 0 has 1 functions"},
    {"alive", AWD_ERROR_PLUGIN_SELF_TEST,
     "eval: level 0, x = 0: gives 9 values, but 1 to 8 can be alive"},
    {"polynomial", AWD_ERROR_PLUGIN_SELF_TEST,
     "not a polynomial of degree 0: level 3, cell 0, function 0, x = "},
    {"support", AWD_ERROR_PLUGIN_SELF_TEST,
     "support is too large: level 2, function 1 is 0 on cell 0"},
    {"flags", AWD_ERROR_PLUGIN_SELF_TEST,
     "flag ORTHOGONAL is not true: level 0: functions 0 and 1 have a scalar product of 0.5"},
    {"unknown_flag", AWD_ERROR_PLUGIN_SELF_TEST, "flags 0x100: only 0x7 are known"},
    {"count", AWD_ERROR_PLUGIN_SELF_TEST,
     "count out of range: level 3: got 4294967295, want 1 to 8"},
    {"wavelet_mass", AWD_ERROR_PLUGIN_SELF_TEST,
     "wavelet 0 carries mass: its integral is 0.316228 of its norm, want 0"},
    {"wavelet_nan", AWD_ERROR_PLUGIN_SELF_TEST, "wavelet 0: coefficient 1 is not finite: got "},
    {"wavelet_none", AWD_ERROR_PLUGIN_SELF_TEST,
     "wavelets do not determine level 1: wavelet 0 is a combination of level 0 and the wavelets "
     "before it (squared distance 0 of 1)"},
    {"name", AWD_ERROR_PLUGIN_SELF_TEST, "name does not match ^[a-z][a-z0-9_.-]{0,63}$"},
    {"null_function", AWD_ERROR_PLUGIN_SELF_TEST, "a function of the table is NULL"},
    {"short_struct", AWD_ERROR_PLUGIN_ABI, "AWDBasisFamily has structSize "},
    {"abi", AWD_ERROR_PLUGIN_ABI, "the module is of basis ABI 7, the library of 1"},
    {"newer", AWD_ERROR_PLUGIN_ABI, "the module is of basis ABI 2, the library of 1"},
    {"null_module", AWD_ERROR_PLUGIN_ABI, "the module refuses this version of the library"},
    {"no_entry", AWD_ERROR_PLUGIN_LOAD, "has no entry point awdBasisModule_v1"},
    {"text", AWD_ERROR_PLUGIN_LOAD, "can't be opened: "},
    {"missing", AWD_ERROR_PLUGIN_LOAD, "No such file"},
};

std::string fileOf(const Lie& lie) { return std::string(AWD_LYING_FOLDER "/") + lie.file + ".so"; }

void PrintTo(const Lie& lie, std::ostream* out) { *out << lie.file; }

class Lying : public testing::TestWithParam<Lie> {};

TEST_P(Lying, IsRefusedAndListed) {
  const test::Device device;
  const std::string before = test::names(device);
  const std::string file = fileOf(GetParam());
  EXPECT_EQ(awdLoadBasisModule(device, file.c_str()), GetParam().code);
  const std::string message = awdGetLastErrorMessage();
  EXPECT_TRUE(test::contains(message, GetParam().sentence)) << message;
  EXPECT_TRUE(test::contains(message, file)) << message;
  EXPECT_EQ(test::names(device), before);

  const std::vector<test::Info> lines = test::listing(device);
  ASSERT_EQ(lines.size(), 2u) << "haar and the one refused";
  EXPECT_EQ(lines[1].file, file);
  EXPECT_EQ(lines[1].status, GetParam().code);
  EXPECT_TRUE(test::contains(lines[1].message, GetParam().sentence)) << lines[1].message;

  // Asked again it says the same, and is not listed twice.
  EXPECT_EQ(awdLoadBasisModule(device, file.c_str()), GetParam().code);
  EXPECT_EQ(message, awdGetLastErrorMessage());
  EXPECT_EQ(test::listing(device).size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Plugins, Lying, testing::ValuesIn(kLies),
                         [](const auto& lie) { return std::string(lie.param.file); });

TEST(LyingFolder, WithoutALieTheSameSourceIsAccepted) {
  const test::Device device;
  EXPECT_EQ(awdLoadBasisModule(device, AWD_LYING_FOLDER "/none.so"), AWD_SUCCESS)
      << awdGetLastErrorMessage();
  EXPECT_EQ(test::names(device), "haar truthful");
}

TEST(LyingFolder, AFolderOfLiesHidesNothingAndListsAll) {
  const char* const folder = AWD_LYING_FOLDER;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
  desc.basisPaths = &folder;
  desc.basisPathCount = 1;
  std::vector<std::string> log;
  desc.log = [](void* user, int32_t severity, const char* text) {
    EXPECT_EQ(severity, AWD_LOG_WARNING);
    static_cast<std::vector<std::string>*>(user)->push_back(text);
  };
  desc.logUser = &log;
  const test::Device device(&desc);
  EXPECT_EQ(test::names(device), "haar truthful");
  const std::vector<test::Info> lines = test::listing(device);
  const std::size_t lies = std::size(kLies) - 1;  // one is not there
  ASSERT_EQ(lines.size(), 2 + lies);
  for (std::size_t i = 3; i < lines.size(); ++i) EXPECT_LT(lines[i - 1].file, lines[i].file);
  for (const Lie& lie : kLies) {
    for (std::size_t i = 2; i < lines.size(); ++i) {
      if (lines[i].file != fileOf(lie)) continue;
      EXPECT_EQ(lines[i].status, lie.code) << lie.file;
      EXPECT_TRUE(test::contains(lines[i].message, lie.sentence)) << lines[i].message;
    }
  }
  EXPECT_EQ(log.size(), lies);
  ASSERT_FALSE(log.empty());
  EXPECT_TRUE(test::contains(log[0], AWD_LYING_FOLDER "/abi.so\" refused: the module is of basis"))
      << log[0];
}

}  // namespace
