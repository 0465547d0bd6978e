// SPDX-License-Identifier: Apache-2.0
// The report that every command writes or updates: DIR/index.html, self-contained. Each command has
// a section there, which is kept as a file of its own: DIR/sections/NAME.html. Writing a section
// puts all that there are into the page anew.
#pragma once

#include <string>
#include <vector>

#include "plot.h"

namespace bench {

/// HTML of the text's characters.
std::string htmlEscape(const std::string& text);

/// A figure of a table: three significant digits, of which zeros follow up to a million; "–" if it
/// isn't finite.
std::string shortNumber(double value);

struct ReportTable {
  std::string caption;
  std::vector<std::string> columns;
  /// As many cells as there are columns, as text. Tables are sorted by a column, as numbers where
  /// its cells begin with numbers, when its head is clicked.
  std::vector<std::vector<std::string>> rows;
};

/// One of a row of images of the same size.
struct ReportImage {
  std::string caption;
  std::string png;  ///< the bytes of the file
};

/// What a command has to say, from its title on: texts, tables, plots and images in that order in
/// which they are added. Texts are plain.
class ReportSection {
 public:
  /// name: of the command, which decides where in the page it stands.
  ReportSection(std::string name, std::string title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// The command line that gives the figures above or below, the seeds in it.
  void command(const std::string& line);
  void table(const ReportTable& table);
  /// A chart drawn as SVG, whose colours follow the reader's light or dark page.
  void plot(const Plot& plot, const std::string& caption);
  /// Side by side, or below each other where the page is narrow.
  void images(const std::vector<ReportImage>& images, const std::string& caption);

  const std::string& name() const { return name_; }
  const std::string& html() const { return html_; }

 private:
  std::string name_, html_;
};

/// DIR/sections/NAME.html and DIR/index.html, each whole or not at all. The folder is made.
void writeReport(const std::string& folder, const ReportSection& section);

}  // namespace bench
