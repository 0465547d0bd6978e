// SPDX-License-Identifier: Apache-2.0
#include "misuse/sequence.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

namespace awdmisuse {

namespace {

constexpr size_t kPage = size_t{1} << 20;
constexpr unsigned kSeconds = 120;  // after which a child hangs

/// What a child has to tell, also if it dies.
struct Report {
  size_t length;
  char complaint[2048];
  char calls[kPage - sizeof(size_t) - 2048];

  void add(const std::string& line) {
    if (length + line.size() + 2 > sizeof calls) return;
    std::memcpy(calls + length, line.data(), line.size());
    length += line.size();
    calls[length++] = '\n';
    calls[length] = '\0';
  }
  void complain(const std::string& what) {
    if (complaint[0] == '\0') std::snprintf(complaint, sizeof complaint, "%s", what.c_str());
  }
};

Report& sharedReport() {
  static Report* const kReport = [] {
    void* place =
        mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) throw std::bad_alloc();
    return static_cast<Report*>(place);
  }();
  return *kReport;
}

void runInChild(World& world, const std::vector<Step>& steps, const std::vector<double>& reference,
                Report& report) {
  const bool hadFailed = testing::Test::HasFailure();
  if (chdir(world.folder.path("").c_str()) != 0) report.complain("no folder");
  for (const Step& step : steps) {
    const Function& function = allFunctions()[step.function];
    Caller caller(world, step.seed, Caller::Mode::kWild);
    caller.named(function.name);
    caller.onBegin([&](const std::string& text) { report.add(text + ";"); });
    function.call(caller);
    if (!caller.complaint().empty()) return report.complain(caller.complaint());
  }
  world.cancelAfter = -1;
  report.add("// the reference operations");
  if (referenceBits(world.devices[0]) != reference) report.complain("other bits than before");
  report.add("// release of everything");
  world.release();
  awdReleaseDevice(world.devices[0]);
  if (const size_t left = world.memory.blocks() + world.others.blocks()) {
    report.complain(std::to_string(left) + " blocks were not freed");
  }
  if (!hadFailed && testing::Test::HasFailure()) report.complain("the allocator got wrong sizes");
}

}  // namespace

std::vector<Step> randomSteps(uint64_t seed, size_t count) {
  awdtest::Random random(seed);
  std::vector<Step> steps(count);
  for (Step& step : steps) step = {random.bits() % allFunctions().size(), random.bits()};
  return steps;
}

Outcome runSteps(World& world, const std::vector<Step>& steps,
                 const std::vector<double>& reference) {
  Report& report = sharedReport();
  report.length = 0;
  report.complaint[0] = report.calls[0] = '\0';
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    alarm(kSeconds);
    try {
      runInChild(world, steps, reference, report);
    } catch (const std::exception& error) {
      report.complain(error.what());
    }
    _exit(report.complaint[0] ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) {
    report.complain(WTERMSIG(status) == SIGALRM ? "it hangs" : strsignal(WTERMSIG(status)));
  } else if (WEXITSTATUS(status) != 0) {
    report.complain("ended with " + std::to_string(WEXITSTATUS(status)));
  }
  return {report.complaint, report.calls};
}

std::vector<Step> shrink(World& world, std::vector<Step> steps,
                         const std::vector<double>& reference) {
  const int noisy = dup(STDERR_FILENO), quiet = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(quiet, STDERR_FILENO);
  for (size_t length = steps.size() / 2; length > 0; length /= 2) {
    for (size_t at = 0; at + length <= steps.size();) {
      std::vector<Step> fewer = steps;
      const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(at);
      fewer.erase(begin, begin + static_cast<std::ptrdiff_t>(length));
      if (runSteps(world, fewer, reference).complaint.empty()) {
        at += length;
      } else {
        steps = std::move(fewer);
      }
    }
  }
  dup2(noisy, STDERR_FILENO);
  close(noisy), close(quiet);
  return steps;
}

}  // namespace awdmisuse
