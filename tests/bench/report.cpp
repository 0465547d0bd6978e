// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "chart.h"
#include "failure.h"
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

std::string pageOf(const std::filesystem::path& sections) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(sections)) {
    if (entry.path().extension() == ".html") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return std::pair(placeOf(a), a) < std::pair(placeOf(b), b);
  });
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">"
      "<title>libawd: measured</title></head>\n<body>\n<main>\n";
  for (const std::string& name : names) page += readFile(sections / (name + ".html"));
  return page + "</main>\n</body>\n</html>\n";
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
  html_ += "<div class=\"table\"><table class=\"sortable\">\n<caption>" +
           htmlEscape(table.caption) + "</caption>\n<thead><tr>";
  for (const std::string& column : table.columns) {
    html_ += "<th scope=\"col\">" + htmlEscape(column) + "</th>";
  }
  html_ += "</tr></thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.rows) {
    html_ += "<tr>";
    for (const std::string& cell : row) html_ += "<td>" + htmlEscape(cell) + "</td>";
    html_ += "</tr>\n";
  }
  html_ += "</tbody></table></div>\n";
}

void ReportSection::plot(const Plot& plot, const std::string& caption) {
  html_ += "<figure class=\"chart\">" + chartSvg(plot) + "<figcaption>" + htmlEscape(caption) +
           "</figcaption></figure>\n";
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
  command::writeFile(
      (sections / (section.name() + ".html")).string(),
      "<section id=\"" + htmlEscape(section.name()) + "\">\n" + section.html() + "</section>\n");
  command::writeFile((std::filesystem::path(folder) / "index.html").string(), pageOf(sections));
}

}  // namespace bench
