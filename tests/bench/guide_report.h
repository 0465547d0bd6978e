// SPDX-License-Identifier: Apache-2.0
// What `awd-bench guide` and `awd-bench rival` print and write: a row for each scene, number of
// samples and method.
#pragma once

#include <string>
#include <vector>

#include "guide_section.h"
#include "render_shots.h"

namespace bench::guide {

class Report {
 public:
  /// `folder`: for NAME.json, NAME.csv and a section of the report; "": none are written. head:
  /// what was asked for, the "baseline" in it.
  Report(std::string folder, std::string name, Row head)
      : folder_(std::move(folder)), name_(std::move(name)), head_(std::move(head)) {}

  /// Prints the scene and the heads of its columns. What is added next is of this scene, which
  /// must live until then.
  void begin(const LoadedScene& loaded);
  /// Prints a row and keeps it. `base`: what to compare with, NULL: this is the baseline itself.
  void add(uint32_t samples, const std::string& method, const std::vector<Shot>& shots,
           const std::vector<Shot>* base);
  /// Shows what the baseline makes of the time of the methods compared, in front of the images of
  /// those, of which there is one at least.
  void showBaseline(uint32_t samples, const std::string& method, const Shot& shot);
  /// All rows so far; complete: there will be no more, for nothing was interrupted.
  void write(bool complete);
  const std::vector<Row>& rows() const { return rows_; }

 private:
  void keepImage(uint32_t samples, const std::string& method, const Shot& shot);
  std::vector<ReportImage> imagesOf(uint32_t samples, const std::string& method,
                                    const Shot& shot) const;

  std::string folder_, name_;
  Row head_;
  std::vector<Row> rows_;
  std::vector<Inset> insets_;  // one a scene
  const LoadedScene* loaded_ = nullptr;
};

}  // namespace bench::guide
