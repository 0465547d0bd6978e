// SPDX-License-Identifier: Apache-2.0
#include "image/exr_names.h"

#include <algorithm>
#include <iterator>

namespace awd {

bool isReservedAttribute(std::string_view name) {
  // Required attributes and those of tiles, parts and deep data; then the standard attributes whose
  // type is not string. Standard strings (owner, comments, capDate, ...) are good metadata.
  static constexpr std::string_view kReserved[] = {
      "channels",
      "compression",
      "dataWindow",
      "displayWindow",
      "lineOrder",
      "pixelAspectRatio",
      "screenWindowCenter",
      "screenWindowWidth",
      "tiles",
      "name",
      "type",
      "version",
      "view",
      "multiView",
      "chunkCount",
      "maxSamplesPerPixel",
      "preview",
      "dwaCompressionLevel",
      "adoptedNeutral",
      "altitude",
      "aperture",
      "chromaticities",
      "deepImageState",
      "envmap",
      "expTime",
      "focus",
      "framesPerSecond",
      "idManifest",
      "isoSpeed",
      "keyCode",
      "latitude",
      "longitude",
      "timeCode",
      "utcOffset",
      "originalDataWindow",
      "whiteLuminance",
      "xDensity",
      "worldToCamera",
      "worldToNDC",
  };
  return std::find(std::begin(kReserved), std::end(kReserved), name) != std::end(kReserved);
}

}  // namespace awd
