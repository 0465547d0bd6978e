// SPDX-License-Identifier: Apache-2.0
#include "report_page.h"

#include <ctime>
#include <fstream>
#include <thread>

#include "awd/awd.h"
#include "report.h"

namespace bench {
namespace {

// What it holds is what it may show: a browser refuses to load anything for it.
constexpr char kHead[] = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<title>libawd: measured</title>
)";

constexpr char kIntroduction[] = R"(<h1>libawd, measured</h1>
<p class="lead">A path tracer finds the light in a picture by following random paths through the
scene. Where it sends them blindly, few reach the light and the picture is noisy. <em>Guided</em>
rendering learns from earlier paths where light comes from and sends later ones there. libawd is a C
library that does this: each patch of a surface keeps a density over directions as wavelet
coefficients, refined where the light calls for it (after Pietrek and Peter, 1999). A density must
be learned and costs time, so guiding pays only if the noise falls by more than the time rises;
where it doesn't, the figures below say so.</p>
<details open><summary>The words used below</summary>
<dl>
<dt>samples per pixel</dt><dd>How many paths start in each pixel. Twice as many take twice the time
and halve the squared error.</dd>
<dt>relMSE</dt><dd>Relative mean squared error: the squared difference from a reference, over the
square of the reference, averaged over pixels. Smaller is better. <em>Trimmed</em>: without the
worst 0.1 % of the pixels, which a few stray bright dots can rule.</dd>
<dt>L1</dt><dd>The mean absolute difference from the reference, over all pixels and colours, which
a few bright dots move less.</dd>
<dt>efficiency</dt><dd>1 / (relMSE × CPU time). Relative to a baseline, 2 means the same quality in
half the time; below 1 guiding costs more than it gains. Training is counted.</dd>
<dt>cosine, adaptive</dt><dd>Unguided rendering, which follows the cosine or the surface's
reflection alone, and guided rendering by the library.</dd>
<dt>patch</dt><dd>A part of a surface that has a density of its own.</dd>
<dt>basis</dt><dd>The functions that a density is a sum of: boxes (haar), piecewise polynomials of
degree 1 to 3 (linear, quadratic and cubic B-splines), or tree wavelets, which jump at the borders of
cells (f2, m2, m3). Level l has 2<sup>l</sup> cells along each axis.</dd>
<dt>seeds</dt><dd>Repetitions with other random numbers. They are numbered from 1 on, so that a
command gives the same errors again; references have seeds of their own.</dd>
<dt>[a, b]</dt><dd>An interval over repetitions with other random numbers.</dd>
</dl></details>
)";

std::string cpuModel() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string compiler() {
#ifdef __clang__
  return __VERSION__;
#else
  return std::string("GCC ") + __VERSION__;
#endif
}

std::string versionOf(uint32_t version) {
  return std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
         std::to_string(version % 100);
}

std::string fact(const std::string& name, const std::string& value) {
  return "<dt>" + name + "</dt><dd>" + htmlEscape(value) + "</dd>";
}

std::string machine() {
  return "<dl class=\"facts\">" + fact("Processor", cpuModel()) +
         fact("Cores", std::to_string(std::thread::hardware_concurrency())) +
         fact("Compiler", compiler()) + fact("Build", AWD_BENCH_BUILD) +
         fact("libawd", versionOf(awdGetVersion())) + fact("Page written", dateNow()) + "</dl>\n";
}

/// The text of its <h2>, escaped as it stands there; its name if it has none.
std::string titleOf(const PageSection& section) {
  const std::size_t begin = section.html.find("<h2>");
  const std::size_t end = section.html.find("</h2>");
  if (begin == std::string::npos || end == std::string::npos) return htmlEscape(section.name);
  return section.html.substr(begin + 4, end - begin - 4);
}

}  // namespace

std::string dateNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  char text[64];
  if (!gmtime_r(&now, &utc) || !std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &utc)) {
    return "unknown";
  }
  return text;
}

std::string reportPage(const std::vector<PageSection>& sections) {
  std::string page = std::string(kHead) + "<style>\n" + kReportStyle +
                     "</style>\n</head>\n<body>\n<main>\n" + kIntroduction + machine() +
                     "<nav aria-label=\"Contents\"><ol>\n";
  for (const PageSection& section : sections) {
    page += "<li><a href=\"#" + htmlEscape(section.name) + "\">" + titleOf(section) +
            "</a> <code>" + htmlEscape(section.name) + "</code></li>\n";
  }
  page += "</ol></nav>\n";
  for (const PageSection& section : sections) page += section.html;
  return page + "</main>\n<script>\n" + kReportScript + "</script>\n</body>\n</html>\n";
}

}  // namespace bench
