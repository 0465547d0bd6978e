// SPDX-License-Identifier: Apache-2.0
#include "console.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <mutex>

namespace command {
namespace {

// The library logs from any thread, also while the status line stands.
std::mutex mutex;
bool statusShown = false;
std::atomic<bool> muted = false;

constexpr char kEraseLine[] = "\r\033[K";

void say(const char* kind, const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex);
  std::fprintf(stderr, "%sawd: %s%s\n", statusShown ? kEraseLine : "", kind, text.c_str());
  statusShown = false;
}

}  // namespace

void note(const std::string& text) {
  if (!muted) say("", text);
}
void warn(const std::string& text) {
  if (!muted) say("warning: ", text);
}
void complain(const std::string& text) { say("", text); }

void mute() { muted = true; }

bool hasTerminal() { return isatty(STDERR_FILENO) == 1; }

void showStatus(const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex);
  std::fprintf(stderr, "%s%s", kEraseLine, text.c_str());
  std::fflush(stderr);
  statusShown = true;
}

void clearStatus() {
  const std::lock_guard<std::mutex> lock(mutex);
  if (statusShown) std::fputs(kEraseLine, stderr);
  statusShown = false;
}

}  // namespace command
