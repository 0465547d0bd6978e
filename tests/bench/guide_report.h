// SPDX-License-Identifier: Apache-2.0
// What `awd-bench guide` prints and writes: a row for each scene, number of samples and method.
#pragma once

#include <string>
#include <vector>

#include "guide_methods.h"
#include "render_shots.h"

namespace bench::guide {

class Report {
 public:
  /// `folder`: for guide.json and guide.csv; "": none are written. head: what was asked for.
  Report(std::string folder, Row head) : folder_(std::move(folder)), head_(std::move(head)) {}

  /// Prints the scene and the heads of its columns. What is added next is of this scene, which
  /// must live until then.
  void begin(const LoadedScene& loaded);
  /// Prints a row and keeps it. `base`: what to compare with, NULL: this is the baseline itself.
  void add(uint32_t samples, const Method& method, const std::vector<Shot>& shots,
           const std::vector<Shot>* base);
  /// All rows so far; complete: there will be no more, for nothing was interrupted.
  void write(bool complete);

 private:
  std::string folder_;
  Row head_;
  std::vector<Row> rows_;
  const LoadedScene* loaded_ = nullptr;
};

}  // namespace bench::guide
