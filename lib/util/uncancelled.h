// SPDX-License-Identifier: Apache-2.0
// A call that is not left in the middle.
#pragma once

#include <pthread.h>

namespace awd {

/// While one lives, a thread that is cancelled (pthread_cancel) goes on: unwinding would end at our
/// border, and with it the process.
class Uncancelled {
 public:
  Uncancelled() noexcept { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_); }
  ~Uncancelled() { pthread_setcancelstate(before_, nullptr); }
  Uncancelled(const Uncancelled&) = delete;
  Uncancelled& operator=(const Uncancelled&) = delete;

 private:
  int before_ = PTHREAD_CANCEL_ENABLE;
};

}  // namespace awd
