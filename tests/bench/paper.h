// SPDX-License-Identifier: Apache-2.0
// What the parts of `awd-bench paper` share: options, and where figures go. A part is a function
// that measures, adds rows and writes into the section.
#pragma once

#include <string>
#include <vector>

#include "render_shots.h"
#include "report.h"

namespace bench::paper {

struct Options {
  std::string folder;
  std::vector<std::string> parts{"passes", "quality", "bands", "radiosity", "questions"};
  std::vector<std::string> only;  ///< scenes of `quality` by name; none: all
  std::string references;         ///< a folder with SCENE-*.exr, or ""
  int seeds = 5;
  uint32_t threads = 1;
  uint32_t width = 64;
  uint32_t referenceSamples = 4096;
  bool quick = false;
};

struct Study {
  const Options& options;
  const awd::Device& device;
  ReportSection section;
  std::vector<Row> rows;
};

/// A measured scene was given up.
struct Cancelled {};

/// With its reference: that in the folder of references, else the one beside the scene, else one
/// that is made and kept in the folder of the report. Throws Cancelled.
LoadedScene loadReferenced(const Study& study, const std::string& name);

/// The bytes of a PNG of one value a pixel, from 0 (black) to the largest (white).
std::string greyPng(const std::vector<float>& values, uint32_t width);

/// "12.3 % less", "4.5 % more".
std::string moreOrLess(double ratio);

// The parts.
void measurePasses(Study& study);     ///< figure 1
void measureQuality(Study& study);    ///< table 1, figures 3, 5 and 6
void measureBands(Study& study);      ///< figure 4
void measureQuestions(Study& study);  ///< what the conclusion leaves open
#ifdef AWD_BENCH_EIGEN
void measureRadiosity(Study& study);  ///< the reference by radiosity
#endif

}  // namespace bench::paper
