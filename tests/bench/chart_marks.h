// SPDX-License-Identifier: Apache-2.0
// What charts are made of: lines, texts and markers as SVG. Lengths are pixels of an unscaled
// chart, y goes downwards. Colours and fonts come from the classes alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

constexpr double kChartText = 13.0, kChartTick = 12.0;  // font sizes, as in the style sheet

enum class ChartAnchor { kStart, kMiddle, kEnd };

/// With at most one decimal, which is finer than a screen.
std::string chartLength(double value);

std::string chartLine(double x0, double y0, double x1, double y1, const std::string& classes);
std::string chartText(double x, double y, const std::string& words, ChartAnchor anchor,
                      const std::string& classes);
/// Centred, along a line that goes up.
std::string chartTextUpwards(double x, double y, const std::string& words);
/// One shape a style, so that colour isn't all that tells.
std::string chartMarker(double x, double y, std::size_t style);
/// The class that sets the colour of a style.
std::string chartColour(std::size_t style);

/// How wide a text will be, near enough to leave room for it: fonts are the reader's.
double chartWidth(const std::string& words, double size);
/// Lines of words that fit into the width.
std::vector<std::string> chartWrapped(const std::string& words, double size, double width);

}  // namespace bench
