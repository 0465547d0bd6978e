// SPDX-License-Identifier: Apache-2.0
// progress_bar.h and pdf_request.h, as far as they need no render
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "failure.h"
#include "interrupt.h"
#include "pdf_request.h"
#include "progress_bar.h"
#include "temporary_folder.h"

using namespace command;

namespace {

AWDProgress at(const char* operation, double fraction) {
  return {sizeof(AWDProgress), operation, nullptr, fraction};
}

TEST(ProgressBar, CountsPasses) {
  ProgressBar bar;
  bar.setPassCount(3);
  EXPECT_CONTAINS(bar.line(at("commit", 0.5)), "50 % commit");
  EXPECT_CONTAINS(bar.line(at("pass", 0.0)), " 0 % pass 1/3");
  EXPECT_CONTAINS(bar.line(at("pass", 1.0)), "100 % pass 1/3");
  EXPECT_CONTAINS(bar.line(at("adapt", 0.3)), "30 % adapt");
  EXPECT_CONTAINS(bar.line(at("pass", 0.2)), "20 % pass 2/3");
  EXPECT_CONTAINS(bar.line(at("pass", 0.2)), "20 % pass 2/3");
  EXPECT_CONTAINS(bar.line(at("pass", 0.1)), "10 % pass 3/3");
}

/// What the last passes have taught a field is worked in even then.
TEST(ProgressBar, LetsWorkFinishAfterAnInterrupt) {
  const auto interrupted = [] {
    ProgressBar bar;
    catchInterrupt();
    std::raise(SIGINT);
    const bool stops = !bar(at("pass", 0.5));
    bar.letFinish();
    std::exit(stops && bar(at("adapt", 0.5)) ? 0 : 1);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(0), "");
}

TEST(ProgressBar, IsAsLongAsTheFraction) {
  ProgressBar bar;
  EXPECT_EQ(bar.line(at("commit", 0.0)), "[" + std::string(40, ' ') + "] 0 % commit");
  EXPECT_EQ(bar.line(at("commit", 0.5)),
            "[" + std::string(20, '#') + std::string(20, ' ') + "] 50 % commit");
  EXPECT_EQ(bar.line(at("commit", 1.0)), "[" + std::string(40, '#') + "] 100 % commit");
}

TEST(PdfRequest, TakesTheFileAfterTheFirstColon) {
  EXPECT_EQ(PdfRequest("5:a.png").file(), "a.png");
  EXPECT_EQ(PdfRequest("5b:c:d.png").file(), "c:d.png");
  EXPECT_EQ(PdfRequest("12,34:a.png").file(), "a.png");
}

TEST(PdfRequest, RefusesEverythingElse) {
  for (const char* text : {"", "5", "5:", ":a.png", "b:a.png", "-1:a.png", "5bb:a.png", "5,:a.png",
                           "5,6,7:a.png", ",6:a.png", "5,6b:a.png", "4294967296:a.png", "a.png"}) {
    EXPECT_THROW(PdfRequest{text}, UsageError) << text;
  }
}

}  // namespace
