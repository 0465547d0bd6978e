// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "commands.h"
#include "device.h"
#include "failure.h"
#include "write_file.h"

namespace command {
namespace {

struct PngOptions {
  std::string film, output;
  float exposure = 0.0f;
};

int convert(const PngOptions& options) {
  checkWritable(options.output);
  awd::PNGDesc desc;
  desc.exposure = options.exposure;
  awd::Image::read(openDevice(), options.film).writePNG(options.output, desc);
  return kDone;
}

}  // namespace

void addPngCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<PngOptions>();
  CLI::App* command = program.add_subcommand("png", "Turn an OpenEXR image into an sRGB PNG");
  command->add_option("FILM", options->film, "OpenEXR file")->required();
  command->add_option("OUT", options->output, "PNG file to write")->required();
  command->add_option("--exposure", options->exposure, "Stops: values are multiplied by 2^exposure")
      ->check(CLI::Range(-1000.0, 1000.0));
  command->callback([&action, options] {
    if (!(std::abs(options->exposure) <= 1000.0f)) {
      throw UsageError("--exposure must be within 1000 stops");
    }
    action = [options] { return convert(*options); };
  });
}

}  // namespace command
