// SPDX-License-Identifier: Apache-2.0
// The page around the sections of a report: what it is about, the machine, contents, style and
// script. It loads nothing.
#pragma once

#include <string>
#include <vector>

namespace bench {

struct PageSection {
  std::string name;
  std::string html;  ///< a <section> with that id, whose title is its <h2>
};

/// In this order.
std::string reportPage(const std::vector<PageSection>& sections);

/// Day and minute, UTC.
std::string dateNow();

extern const char kReportStyle[];   ///< CSS
extern const char kReportScript[];  ///< JavaScript

}  // namespace bench
