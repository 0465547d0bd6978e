// SPDX-License-Identifier: Apache-2.0
// OpenEXR in.
#pragma once

#include "image/image.h"

namespace awd {

/// Reads whatever OpenEXR reads, as float32 at full resolution; the first part's data window
/// becomes the image. Channels of further parts are called "part.channel", are 0 where that part
/// has no pixels, and keep luminance and chroma apart, which the first part turns into R G B.
/// Channels of lower resolution are repeated. Text attributes of the first part become metadata.
/// AWD_ERROR_IO, with path and reason, if the file is missing, cut off or damaged.
Ref<Image> readExr(Context& context, const char* path);

}  // namespace awd
