# SPDX-License-Identifier: Apache-2.0
"""awd/image.h"""
from ctypes import POINTER, Structure, c_char_p, c_float, c_size_t, c_uint32

from ._declare import Array, function
from .types import AWDDevice, AWDField, AWDImage, AWDRender, AWDResult

function("awdNewImage", AWDResult, AWDDevice, c_uint32, c_uint32, POINTER(AWDImage))
function("awdNewFilmImage", AWDResult, AWDRender, POINTER(AWDImage))
function("awdNewPatchImage", AWDResult, AWDField, c_uint32, c_uint32, POINTER(AWDImage))
function("awdReadImage", AWDResult, AWDDevice, c_char_p, POINTER(AWDImage))
function("awdRetainImage", None, AWDImage)
function("awdReleaseImage", None, AWDImage)
function("awdGetImageInfo", AWDResult, AWDImage, POINTER(c_uint32), POINTER(c_uint32),
         POINTER(c_uint32))
function("awdGetImageChannelName", AWDResult, AWDImage, c_uint32, POINTER(c_char_p))
function("awdSetImageChannel", AWDResult, AWDImage, c_char_p, Array, c_size_t, c_size_t)
function("awdGetImageChannel", AWDResult, AWDImage, c_char_p, Array, c_size_t, c_size_t)
function("awdSetImageMetadata", AWDResult, AWDImage, c_char_p, c_char_p)
function("awdGetImageMetadata", AWDResult, AWDImage, c_char_p, POINTER(c_char_p))
function("awdWriteImageEXR", AWDResult, AWDImage, c_char_p)


class AWDPNGDesc(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("exposure", c_float),
        ("reserved", c_uint32),
    ]


function("awdWriteImagePNG", AWDResult, AWDImage, c_char_p, POINTER(AWDPNGDesc))
