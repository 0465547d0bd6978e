# SPDX-License-Identifier: Apache-2.0
"""awd/basis.h"""
from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_size_t, c_uint32

AWD_BASIS_ABI = 1
AWD_BASIS_MAX_ORDER = 8
AWD_BASIS_MAX_LEVEL = 20

AWD_BASIS_ORTHOGONAL = 1
AWD_BASIS_PERIODIC = 2
AWD_BASIS_NESTED = 4


class AWDBasisFamily(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("name", c_char_p),
        ("summary", c_char_p),
        ("flags", c_uint32),
        ("order", c_uint32),
        ("sampleDims", c_uint32),
        ("minLevel", c_uint32),
        ("maxLevel", c_uint32),
        ("count", CFUNCTYPE(c_uint32, c_uint32)),
        ("cells", CFUNCTYPE(c_uint32, c_uint32)),
        ("support", CFUNCTYPE(None, c_uint32, c_uint32, POINTER(c_double))),
        ("weight", CFUNCTYPE(c_double, c_uint32, c_uint32)),
        ("eval", CFUNCTYPE(c_uint32, c_uint32, c_double, POINTER(c_uint32), POINTER(c_double))),
        ("sample", CFUNCTYPE(c_double, c_uint32, c_uint32, POINTER(c_double))),
        ("twoScale", CFUNCTYPE(c_uint32, c_uint32, c_uint32, POINTER(c_uint32), POINTER(c_double))),
        ("wavelet", CFUNCTYPE(None, c_uint32, POINTER(c_double))),
        ("vanishingMoments", c_uint32),
    ]


class AWDBasisHost(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("abi", c_uint32),
        ("libraryVersion", c_uint32),
    ]


class AWDBasisModule(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("abi", c_uint32),
        ("familyCount", c_uint32),
        ("version", c_char_p),
        ("license", c_char_p),
        ("families", POINTER(POINTER(AWDBasisFamily))),
    ]


AWDBasisModuleFn = CFUNCTYPE(POINTER(AWDBasisModule), POINTER(AWDBasisHost))
