// SPDX-License-Identifier: Apache-2.0
// What rendered images are compared with, and how well that is known.
#pragma once

#include <optional>
#include <string>

#include "awd/awd.h"
#include "metrics.h"

namespace bench {

struct Reference {
  command::RgbImage mean;
  command::RgbImage variance;  ///< of each value of mean; empty: not known
  std::size_t files = 1;       ///< that mean is the mean of
  double relMse = 0.0;         ///< of mean by its variance; 0: not known
};

/// The mean of FOLDER/SCENE-*.exr, where * has no "-": independent renders of equal length, of
/// which two are enough to tell the variance. None if there is no such file.
std::optional<Reference> averageReference(AWDDevice device, const std::string& folder,
                                          const std::string& scene);

/// reference.exr beside the scene, averaged down to the camera's size. None if there is none.
std::optional<Reference> committedReference(AWDDevice device, const std::string& sceneFile,
                                            const AWDCamera& camera);

/// A film that was written as a file, with its own account of its variance.
Reference readFilm(AWDDevice device, const std::string& path);

}  // namespace bench
