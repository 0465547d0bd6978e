// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "chart.h"
#include "failure.h"
#include "report_page.h"
#include "write_file.h"

namespace bench {
namespace {

/// In the order of the page; sections of other names come after, by name.
constexpr std::array kOrder = {"paper",    "trade",   "guide", "rival",    "scale",
                               "extremes", "density", "refit", "wavelets", "speed"};

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63u] : '=';
    }
  }
  return text;
}

std::size_t placeOf(const std::string& name) {
  return static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), name) - kOrder.begin());
}

std::string readFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad() || !file.is_open()) throw command::Failure("can't read " + path.string());
  return text;
}

bool beginsWithNumber(const std::string& cell) {
  const std::size_t sign = cell.find_first_not_of("+-.");
  return sign <= 2 && std::isdigit(static_cast<unsigned char>(cell[sign]));
}

/// Whether a column is of numbers, or of dashes where there is none.
bool hasNumbers(const ReportTable& table, std::size_t column) {
  return std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
    const std::string& cell = row[column];
    return cell == "–" || cell == "-" || beginsWithNumber(cell);
  });
}

/// When the figures were complete, and who else was at work.
std::string whenText() {
  std::string text = "Measured until " + dateNow();
  double load[3] = {};
  if (getloadavg(load, 3) == 3) {
    text += ", while " + shortNumber(load[2]) +
            " threads wanted to run on the machine (mean of 15 minutes, these figures' included)";
  }
  return text + ".";
}

std::string pageOf(const std::filesystem::path& sections) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(sections)) {
    if (entry.path().extension() == ".html") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return std::pair(placeOf(a), a) < std::pair(placeOf(b), b);
  });
  std::vector<PageSection> all;
  for (const std::string& name : names) {
    all.push_back({name, readFile(sections / (name + ".html"))});
  }
  return reportPage(all);
}

}  // namespace

std::string htmlEscape(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else if (c == '>') {
      html += "&gt;";
    } else if (c == '"') {
      html += "&quot;";
    } else {
      html += c;
    }
  }
  return html;
}

std::string shortNumber(double value) {
  if (!std::isfinite(value)) return "–";
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  const double rounded = std::strtod(text, nullptr);
  if (std::abs(rounded) >= 1e3 && std::abs(rounded) <= 1e6) {
    std::snprintf(text, sizeof text, "%.0f", rounded);
  }
  return text;
}

ReportSection::ReportSection(std::string name, std::string title)
    : name_(std::move(name)), html_("<h2>" + htmlEscape(title) + "</h2>\n") {}

void ReportSection::heading(const std::string& text) {
  html_ += "<h3>" + htmlEscape(text) + "</h3>\n";
}

void ReportSection::paragraph(const std::string& text) {
  html_ += "<p>" + htmlEscape(text) + "</p>\n";
}

void ReportSection::command(const std::string& line) {
  html_ += "<pre class=\"command\">" + htmlEscape(line) + "</pre>\n";
}

void ReportSection::table(const ReportTable& table) {
  html_ += "<div class=\"table\" tabindex=\"0\"><table class=\"sortable\">\n<caption><span>" +
           htmlEscape(table.caption) + "</span></caption>\n<thead><tr>";
  std::vector<std::string> classes;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    classes.emplace_back(hasNumbers(table, i) ? " class=\"number\"" : "");
    html_ += "<th scope=\"col\"" + classes[i] + ">" + htmlEscape(table.columns[i]) + "</th>";
  }
  html_ += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    html_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html_ += "<td" + classes[i] + ">" + htmlEscape(row[i]) + "</td>";
    }
    html_ += "</tr>\n";
  }
  html_ += "</tbody></table></div>\n";
}

void ReportSection::plot(const Plot& plot, const std::string& caption) {
  html_ += "<figure class=\"chart\"><div class=\"scroll\" tabindex=\"0\">" + chartSvg(plot) +
           "</div><figcaption>" + htmlEscape(caption) + "</figcaption></figure>\n";
}

void ReportSection::images(const std::vector<ReportImage>& images, const std::string& caption) {
  html_ += "<figure class=\"images\"><div>";
  for (const ReportImage& image : images) {
    html_ += "<figure><img alt=\"" + htmlEscape(image.caption) + "\" src=\"data:image/png;base64," +
             base64(image.png) + "\"><figcaption>" + htmlEscape(image.caption) +
             "</figcaption></figure>";
  }
  html_ += "</div><figcaption>" + htmlEscape(caption) + "</figcaption></figure>\n";
}

void writeReport(const std::string& folder, const ReportSection& section) {
  const std::filesystem::path sections = std::filesystem::path(folder) / "sections";
  std::filesystem::create_directories(sections);
  command::writeFile((sections / (section.name() + ".html")).string(),
                     "<section id=\"" + htmlEscape(section.name()) + "\">\n" + section.html() +
                         "<p class=\"when\">" + whenText() + "</p>\n</section>\n");
  command::writeFile((std::filesystem::path(folder) / "index.html").string(), pageOf(sections));
}

}  // namespace bench
