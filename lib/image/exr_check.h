// SPDX-License-Identifier: Apache-2.0
// A look at the headers of an OpenEXR file before OpenEXR sees them: it allocates whatever they
// ask for.
#pragma once

#include <cstddef>

namespace awd {

/// Whether any part is deep. AWD_ERROR_IO if the bytes are no OpenEXR file, if a header is cut off
/// or lacks what every header has, or if it claims more pixels than any file of this size can hold;
/// AWD_ERROR_UNSUPPORTED if an axis of the data window is longer than an Image's may be. `path` is
/// for the message.
bool checkExrHeaders(const char* bytes, std::size_t size, const char* path);

/// How many bytes of pixels a byte of a file can stand for, at most, by OpenEXR's number of the
/// compression.
double largestExrRatio(int compression);

}  // namespace awd
