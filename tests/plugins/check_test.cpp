// SPDX-License-Identifier: Apache-2.0
// awdCheckBasisModule: every check with its figure, and nothing registered.
#include <cfenv>
#include <cmath>
#include <fstream>

#include "awd/basis.h"
#include "support.h"

namespace {

/// A check, copied.
struct Line {
  std::string family, name, message;
  double worst, limit;
  AWDResult status;
  uint32_t index;
};

/// What is reported about a file.
struct Report {
  explicit Report(const std::string& file) {
    const auto report = [](void* user, const AWDBasisCheck* check) {
      EXPECT_EQ(check->structSize, sizeof(AWDBasisCheck));
      static_cast<std::vector<Line>*>(user)->push_back({check->family, check->name, check->message,
                                                        check->worst, check->limit, check->status,
                                                        check->index});
    };
    result = awdCheckBasisModule(file.c_str(), report, &lines);
    if (result != AWD_SUCCESS) message = awdGetLastErrorMessage();
  }
  const Line* of(const std::string& name) const {
    for (const Line& line : lines) {
      if (line.name == name) return &line;
    }
    return nullptr;
  }

  std::vector<Line> lines;
  AWDResult result;
  std::string message;
};

TEST(CheckModule, ReportsEveryCheckOfEveryFamily) {
  const Report report(AWD_HONEST_FILE);
  EXPECT_EQ(report.result, AWD_SUCCESS) << report.message;
  EXPECT_GE(report.lines.size(), 3u * 12);
  const char* const families[] = {"test-linear", "test-linear-periodic", "test-quadratic"};
  std::vector<std::string> first, other;  // names of the checks
  for (const Line& line : report.lines) {
    ASSERT_LT(line.index, 3u);
    EXPECT_EQ(line.family, families[line.index]);
    EXPECT_EQ(line.status, AWD_SUCCESS);
    EXPECT_EQ(line.message, "");
    EXPECT_FALSE(line.name.empty());
    EXPECT_LE(line.worst, line.limit) << line.family << ": " << line.name;
    if (line.index != 1) (line.index == 0 ? first : other).push_back(line.name);
  }
  EXPECT_EQ(first, other);
  ASSERT_NE(report.of("weight"), nullptr);
  EXPECT_GT(report.of("weight")->limit, 0.0);
  EXPECT_NE(report.of("periodic"), nullptr) << "a check that only one family has";
}

TEST(CheckModule, GoesOnAfterAFailureAndTellsTheFirst) {
  const Report report(AWD_LYING_FOLDER "/weight.so");
  EXPECT_EQ(report.result, AWD_ERROR_PLUGIN_SELF_TEST);
  EXPECT_EQ(report.message,
            "awdCheckBasisModule: \"" AWD_LYING_FOLDER
            "/weight.so\": basis \"liar\": weight is not the integral: level 1, function 0: got "
            "0.50005, want 0.5");
  ASSERT_NE(report.of("weight"), nullptr);
  const Line& weight = *report.of("weight");
  EXPECT_EQ(weight.status, AWD_ERROR_PLUGIN_SELF_TEST);
  EXPECT_EQ(weight.message,
            "weight is not the integral: level 1, function 0: got 0.50005, want 0.5");
  EXPECT_NEAR(weight.worst, 1e-4, 1e-6) << "of a cell";
  ASSERT_NE(report.of("gram"), nullptr) << "a check after it";
  EXPECT_EQ(report.of("gram")->status, AWD_SUCCESS);
}

TEST(CheckModule, AFigureThatIsNoNumberIsInfinite) {
  const Report report(AWD_LYING_FOLDER "/nan.so");
  EXPECT_EQ(report.result, AWD_ERROR_PLUGIN_SELF_TEST);
  ASSERT_NE(report.of("values"), nullptr);
  EXPECT_TRUE(std::isinf(report.of("values")->worst));
}

TEST(CheckModule, NamesThatAreTakenDoNotMatter) {
  const test::Device device;
  ASSERT_EQ(awdLoadBasisModule(device, AWD_HONEST_FILE), AWD_SUCCESS);
  EXPECT_EQ(Report(AWD_HONEST_FILE).result, AWD_SUCCESS);
  const test::Folder folder;
  std::filesystem::copy(AWD_HAAR_FILE, folder / "haar.so");
  EXPECT_EQ(Report(folder / "haar.so").result, AWD_SUCCESS);
}

TEST(CheckModule, WhatIsNoModuleHasNoChecks) {
  const auto refused = [](const std::string& file, AWDResult code, const std::string& sentence) {
    const Report report(file);
    EXPECT_EQ(report.result, code) << file;
    EXPECT_TRUE(report.lines.empty()) << file;
    EXPECT_TRUE(test::contains(report.message, sentence)) << report.message;
  };
  refused(AWD_LYING_FOLDER "/text.so", AWD_ERROR_PLUGIN_LOAD,
          "\"" AWD_LYING_FOLDER "/text.so\": can't be opened: ");
  refused(AWD_LYING_FOLDER "/missing.so", AWD_ERROR_PLUGIN_LOAD, "No such file");
  refused(AWD_LYING_FOLDER "/no_entry.so", AWD_ERROR_PLUGIN_LOAD, "has no entry point");
  refused(AWD_LYING_FOLDER "/abi.so", AWD_ERROR_PLUGIN_ABI, "the module is of basis ABI 7");
  refused("haar.so", AWD_ERROR_INVALID_ARGUMENT, "absolutePath \"haar.so\" is not absolute");
  EXPECT_EQ(awdCheckBasisModule(nullptr, nullptr, nullptr), AWD_ERROR_INVALID_ARGUMENT);
}

TEST(CheckModule, TheReportMayBeLeftOut) {
  EXPECT_EQ(awdCheckBasisModule(AWD_HONEST_FILE, nullptr, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdCheckBasisModule(AWD_LYING_FOLDER "/unity.so", nullptr, nullptr),
            AWD_ERROR_PLUGIN_SELF_TEST);
}

TEST(CheckModule, TwoFamiliesOfOneNameCannotBothBeLoaded) {
  const Report report(AWD_TWICE_FILE);
  EXPECT_EQ(report.result, AWD_ERROR_PLUGIN_NAME_TAKEN);
  EXPECT_TRUE(
      test::contains(report.message,
                     "basis \"truthful\": the name \"truthful\" is taken by another family of "
                     "this module"))
      << report.message;
  EXPECT_EQ(report.lines.back().index, 1u);
}

TEST(CheckModule, LoadingLeavesTheRoundingAsItWas) {
  ASSERT_EQ(std::fesetround(FE_DOWNWARD), 0);
  const AWDResult result = awdCheckBasisModule(AWD_ROUNDING_FILE, nullptr, nullptr);
  const int after = std::fegetround();
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(after, FE_DOWNWARD);
  EXPECT_EQ(result, AWD_SUCCESS) << awdGetLastErrorMessage();
}

}  // namespace
