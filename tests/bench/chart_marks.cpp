// SPDX-License-Identifier: Apache-2.0
#include "chart_marks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "report.h"

namespace bench {
namespace {

constexpr std::size_t kColours = 8;  // that the style sheet knows
constexpr double kAdvance = 0.56;    // of the font's size, a character
constexpr double kPi = 3.14159265358979324;

std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + chartLength(value) + "\"";
}

std::string polygon(double x, double y, double radius, int corners, double turn,
                    const std::string& classes) {
  std::string points;
  for (int k = 0; k < corners; ++k) {
    const double angle = turn + 2.0 * kPi * k / corners;
    points += (k == 0 ? "" : " ") + chartLength(x + radius * std::cos(angle)) + "," +
              chartLength(y + radius * std::sin(angle));
  }
  return "<polygon class=\"" + classes + "\" points=\"" + points + "\"/>";
}

}  // namespace

std::string chartLength(double value) {
  char text[32];
  const int length = std::snprintf(text, sizeof text, "%.1f", value);
  std::string number(text, static_cast<std::size_t>(length));
  if (number.size() > 2 && number.compare(number.size() - 2, 2, ".0") == 0) {
    number.resize(number.size() - 2);
  }
  return number;
}

std::string chartLine(double x0, double y0, double x1, double y1, const std::string& classes) {
  return "<line class=\"" + classes + "\"" + attribute("x1", x0) + attribute("y1", y0) +
         attribute("x2", x1) + attribute("y2", y1) + "/>";
}

std::string chartText(double x, double y, const std::string& words, ChartAnchor anchor,
                      const std::string& classes) {
  constexpr const char* kAnchors[] = {"start", "middle", "end"};
  return "<text class=\"" + classes + "\"" + attribute("x", x) + attribute("y", y) +
         " text-anchor=\"" + kAnchors[static_cast<int>(anchor)] + "\">" + htmlEscape(words) +
         "</text>";
}

std::string chartTextUpwards(double x, double y, const std::string& words) {
  return "<text class=\"chart-label\" text-anchor=\"middle\" transform=\"translate(" +
         chartLength(x) + " " + chartLength(y) + ") rotate(-90)\">" + htmlEscape(words) + "</text>";
}

std::string chartColour(std::size_t style) {
  return "chart-colour-" + std::to_string(style % kColours);
}

std::string chartMarker(double x, double y, std::size_t style) {
  const std::string classes = "chart-marker " + chartColour(style);
  // Once all colours are taken, they come again with other shapes.
  switch ((style + 3 * (style / kColours)) % kColours) {
    case 1:
      return polygon(x, y, 5.0, 4, 0.25 * kPi, classes);  // square
    case 2:
      return polygon(x, y, 5.2, 3, -0.5 * kPi, classes);  // upwards
    case 3:
      return polygon(x, y, 5.2, 4, 0.0, classes);  // diamond
    case 4:
      return polygon(x, y, 5.2, 3, 0.5 * kPi, classes);  // downwards
    case 5:
      return polygon(x, y, 5.0, 5, -0.5 * kPi, classes);
    case 6:
      return chartLine(x - 3.5, y - 3.5, x + 3.5, y + 3.5, "chart-cross " + chartColour(style)) +
             chartLine(x - 3.5, y + 3.5, x + 3.5, y - 3.5, "chart-cross " + chartColour(style));
    case 7:
      return chartLine(x - 4.5, y, x + 4.5, y, "chart-cross " + chartColour(style)) +
             chartLine(x, y - 4.5, x, y + 4.5, "chart-cross " + chartColour(style));
    default:
      return "<circle class=\"" + classes + "\"" + attribute("cx", x) + attribute("cy", y) +
             " r=\"4\"/>";
  }
}

double chartWidth(const std::string& words, double size) {
  // Bytes that begin a character of UTF-8.
  const auto characters = std::count_if(words.begin(), words.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  });
  return kAdvance * size * static_cast<double>(characters);
}

std::vector<std::string> chartWrapped(const std::string& words, double size, double width) {
  std::vector<std::string> lines;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (lines.empty() || chartWidth(longer, size) > width) {
      lines.push_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

}  // namespace bench
