/* SPDX-License-Identifier: Apache-2.0
 *
 * Images: named float channels and text metadata, read from and written to OpenEXR, written to
 * PNG. Files are written beside their place and renamed into it: an error leaves no half file, and
 * an older file of the name untouched.
 */
#ifndef AWD_IMAGE_H
#define AWD_IMAGE_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An image without channels; 1 <= width, height <= 65536. Free. */
AWD_EXPORT AWDResult AWD_CALL awdNewImage(AWDDevice device, uint32_t width, uint32_t height,
                                          AWDImage* image) AWD_NOEXCEPT;
/* The film: channels R G B; variance.R variance.G variance.B; samples.Y; metadata that says how
   it was made (keys begin with "awd."). Exclusive for the render. */
AWD_EXPORT AWDResult AWD_CALL awdNewFilmImage(AWDRender render, AWDImage* image) AWD_NOEXCEPT;
/* The density of a patch on the unit square, as awdGetPatchPdf, in channel Y; metadata with patch,
   basis, level and map. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdNewPatchImage(AWDField field, uint32_t patch, uint32_t n,
                                               AWDImage* image) AWD_NOEXCEPT;
/* Reads whatever OpenEXR reads: any compression, half, float or integer channels, scanlines or
   tiles (full resolution), luminance-chroma (as R G B), deep scanlines (composited), the first
   part of several with the other parts' channels as "part.channel". The data window becomes the
   image. A missing, truncated or damaged file is AWD_ERROR_IO; AWD_ERROR_UNSUPPORTED is one of a
   later version, or of more than 65536 pixels along an axis. Free. */
AWD_EXPORT AWDResult AWD_CALL awdReadImage(AWDDevice device, const char* path,
                                           AWDImage* image) AWD_NOEXCEPT;
/* One reference more, or less; NULL is allowed. Free. */
AWD_EXPORT void AWD_CALL awdRetainImage(AWDImage image) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdReleaseImage(AWDImage image) AWD_NOEXCEPT;

/* Size and number of channels; each pointer may be NULL. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetImageInfo(AWDImage image, uint32_t* width, uint32_t* height,
                                              uint32_t* channelCount) AWD_NOEXCEPT;
/* Channels are sorted by name; the text lives until the image changes. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetImageChannelName(AWDImage image, uint32_t index,
                                                     const char** name) AWD_NOEXCEPT;
/* Adds or replaces a channel: pixel (i, j), row 0 on top, at pixels + j * rowStride +
   i * pixelStride bytes; 0: packed. The name: 1 to 63 printable characters. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdSetImageChannel(AWDImage image, const char* name,
                                                 const float* pixels, size_t pixelStride,
                                                 size_t rowStride) AWD_NOEXCEPT;
/* Copies a channel out in the same layout; AWD_ERROR_INVALID_ARGUMENT if there is none of the
   name: the message lists those there are. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetImageChannel(AWDImage image, const char* name, float* pixels,
                                                 size_t pixelStride, size_t rowStride) AWD_NOEXCEPT;
/* Adds or replaces a line of metadata; key: 1 to 63 printable characters; value NULL removes it.
   Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdSetImageMetadata(AWDImage image, const char* key,
                                                  const char* value) AWD_NOEXCEPT;
/* *value is NULL when there is none of that key; else lives until the image changes. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetImageMetadata(AWDImage image, const char* key,
                                                  const char** value) AWD_NOEXCEPT;

/* One part of scanlines, float32, ZIP; metadata as string attributes. AWD_ERROR_IO if it can't be
   written, AWD_ERROR_INVALID_OPERATION if there is no channel. Free. */
AWD_EXPORT AWDResult AWD_CALL awdWriteImageEXR(AWDImage image, const char* path) AWD_NOEXCEPT;

/* How values become a PNG. */
typedef struct AWDPNGDesc {
  size_t structSize;
  float exposure;    /* stops: values are multiplied by 2^exposure */
  uint32_t reserved; /* 0 */
} AWDPNGDesc;

#ifdef __cplusplus
#define AWD_PNG_DESC_INIT                                                                          \
  AWDPNGDesc { sizeof(AWDPNGDesc), 0.0f, 0u }
#else
#define AWD_PNG_DESC_INIT                                                                          \
  { sizeof(AWDPNGDesc), 0.0f, 0u }
#endif

/* 8 bit. An image with R, G and B is written as colours in sRGB, clipped; any other shows its
   first channel in false colours from 0 (dark) to its maximum (bright). desc may be NULL.
   AWD_ERROR_IO if it can't be written, AWD_ERROR_INVALID_OPERATION if there is no channel,
   AWD_ERROR_UNSUPPORTED if it has more pixels than a PNG may. Free. */
AWD_EXPORT AWDResult AWD_CALL awdWriteImagePNG(AWDImage image, const char* path,
                                               const AWDPNGDesc* desc) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif
