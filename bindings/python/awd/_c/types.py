# SPDX-License-Identifier: Apache-2.0
"""awd/types.h"""
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int32, c_size_t, c_uint32,
                    c_void_p)

AWD_VERSION_MAJOR = 0
AWD_VERSION_MINOR = 1
AWD_VERSION_PATCH = 0
AWD_VERSION = AWD_VERSION_MAJOR * 10000 + AWD_VERSION_MINOR * 100 + AWD_VERSION_PATCH
AWD_INVALID_ID = 0xFFFFFFFF
AWD_PATCH_BACK = 0x80000000

AWDResult = c_int32
AWD_SUCCESS = 0
AWD_ERROR_UNKNOWN = -1
AWD_ERROR_INVALID_ARGUMENT = -2
AWD_ERROR_INVALID_OPERATION = -3
AWD_ERROR_OUT_OF_MEMORY = -4
AWD_ERROR_UNSUPPORTED = -5
AWD_ERROR_CANCELLED = -6
AWD_ERROR_IO = -7
AWD_ERROR_PLUGIN_LOAD = -8
AWD_ERROR_PLUGIN_ABI = -9
AWD_ERROR_PLUGIN_NAME_TAKEN = -10
AWD_ERROR_PLUGIN_SELF_TEST = -11

AWDDevice = c_void_p
AWDScene = c_void_p
AWDField = c_void_p
AWDDensity = c_void_p
AWDRender = c_void_p
AWDImage = c_void_p
AWDFormat = c_int32
AWD_FORMAT_UNDEFINED = 0
AWD_FORMAT_UINT = 0x5001
AWD_FORMAT_UINT3 = 0x5003
AWD_FORMAT_FLOAT3 = 0x9003


class AWDBuffer(Structure):
    _fields_ = [
        ("data", c_void_p),
        ("byteOffset", c_size_t),
        ("byteStride", c_size_t),
        ("count", c_size_t),
        ("format", AWDFormat),
        ("reserved", c_uint32),
    ]


AWDPreset = c_int32
AWD_PRESET_DEFAULT = 0
AWD_PRESET_PAPER = 1

AWDTarget = c_int32
AWD_TARGET_DEFAULT = 0
AWD_TARGET_MEAN = 1
AWD_TARGET_RMS = 2

AWDEstimator = c_int32
AWD_ESTIMATOR_DEFAULT = 0
AWD_ESTIMATOR_PAPER = 1
AWD_ESTIMATOR_MIXTURE = 2
AWD_ESTIMATOR_RATIO = 3
AWD_ESTIMATOR_QUASI = 4
AWD_ESTIMATOR_REFIT = 5
AWD_ESTIMATOR_LUMPED = 6

AWDCombination = c_int32
AWD_COMBINE_DEFAULT = 0
AWD_COMBINE_COUNT = 1
AWD_COMBINE_CROSS_VARIANCE = 2
AWD_COMBINE_EXPERIENCE = 3

AWDRefitStatus = c_int32
AWD_REFIT_NONE = 0
AWD_REFIT_CONVERGED = 1
AWD_REFIT_LIMIT = 2
AWD_REFIT_FAILED = 3

AWD_LOG_INFO = 0
AWD_LOG_WARNING = 1
AWD_LOG_ERROR = 2

AWDLogFn = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)


class AWDProgress(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("operation", c_char_p),
        ("object", c_void_p),
        ("fraction", c_double),
    ]


AWDProgressFn = CFUNCTYPE(c_int32, c_void_p, POINTER(AWDProgress))
AWDAllocFn = CFUNCTYPE(c_void_p, c_void_p, c_size_t, c_size_t)
AWDFreeFn = CFUNCTYPE(None, c_void_p, c_void_p, c_size_t, c_size_t)
AWDTaskFn = CFUNCTYPE(None, c_void_p, c_size_t)
AWDParallelForFn = CFUNCTYPE(None, c_void_p, c_size_t, AWDTaskFn, c_void_p)
