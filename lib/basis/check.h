// SPDX-License-Identifier: Apache-2.0
// One property of a family, with the worst figure met and a sentence for the first violation.
#pragma once

#include <string>

namespace awd {

class Check {
 public:
  /// Holds as long as no figure exceeds `limit`.
  Check(const char* name, double limit) : name_(name), limit_(limit) {}

  const char* name() const { return name_; }
  double limit() const { return limit_; }
  /// Largest figure met; infinite once there was a NaN.
  double worst() const { return worst_; }
  bool ok() const { return ok_; }
  /// What is wrong and where; "" if nothing is.
  const std::string& sentence() const { return sentence_; }

  /// Takes a figure and returns whether it is the first to exceed the limit, as NaN does: then the
  /// caller says where.
  bool fails(double figure);
  [[gnu::format(printf, 2, 3)]] void say(const char* format, ...);
  /// A violation without a figure.
  void broken(std::string sentence);

 private:
  const char* name_;
  double limit_;
  double worst_ = 0.0;
  bool ok_ = true;
  std::string sentence_;
};

}  // namespace awd
