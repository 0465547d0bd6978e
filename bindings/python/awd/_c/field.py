# SPDX-License-Identifier: Apache-2.0
"""awd/field.h"""
from ctypes import (POINTER, Structure, c_char_p, c_double, c_float, c_int32, c_size_t, c_uint32,
                    c_uint64)

from ._declare import Array, function
from .types import AWDDevice, AWDEstimator, AWDField, AWDPreset, AWDResult, AWDTarget

AWD_MOST_FIELD_LIGHTS = 64

AWDHemisphereMap = c_int32
AWD_MAP_DEFAULT = 0
AWD_MAP_SPHERICAL = 1
AWD_MAP_CONCENTRIC_COSINE = 2
AWD_MAP_CYLINDRICAL = 3
AWD_MAP_COSINE = 4

AWDPatches = c_int32
AWD_PATCHES_DEFAULT = 0
AWD_PATCHES_SPATIAL = 1
AWD_PATCHES_HOST = 2


class AWDFieldDesc(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("preset", AWDPreset),
        ("map", AWDHemisphereMap),
        ("basis", c_char_p),
        ("startLevel", c_uint32),
        ("maxLevel", c_uint32),
        ("tau", c_double),
        ("estimator", AWDEstimator),
        ("refitSolver", c_char_p),
        ("shrinkage", c_double),
        ("patches", AWDPatches),
        ("lower", c_float * 3),
        ("upper", c_float * 3),
        ("patchSamples", c_uint32),
        ("alpha", c_double),
        ("maxBytes", c_uint64),
        ("lightCount", c_uint32),
        ("lightPowers", POINTER(c_float)),
        ("target", AWDTarget),
    ]


function("awdNewField", AWDResult, AWDDevice, POINTER(AWDFieldDesc), POINTER(AWDField))
function("awdRetainField", None, AWDField)
function("awdReleaseField", None, AWDField)
function("awdFindPatch", AWDResult, AWDField, Array, Array, POINTER(c_uint32))


class AWDDirectionSample(Structure):
    _fields_ = [
        ("direction", c_float * 3),
        ("pdf", c_float),
        ("square", c_float * 2),
        ("component", c_uint32),
        ("solidAngle", c_float),
    ]


function("awdSampleField", AWDResult, AWDField, c_uint32, Array, Array, Array)
function("awdGetFieldPdf", AWDResult, AWDField, c_uint32, Array, Array, POINTER(c_float))
function("awdRecordField", AWDResult, AWDField, c_uint32, Array, c_double)
function("awdSetFieldScale", AWDResult, AWDField, c_double)


class AWDFieldStatistics(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("patches", c_uint64),
        ("coefficients", c_uint64),
        ("bytes", c_uint64),
        ("samples", c_uint64),
        ("rejected", c_uint64),
        ("saturated", c_uint64),
        ("kept", c_uint64),
        ("refitFailed", c_uint64),
        ("refitLimited", c_uint64),
        ("refitIterations", c_uint64),
        ("capped", c_uint64),
        ("rejectedNaN", c_uint64),
        ("rejectedInfinite", c_uint64),
        ("rejectedNegative", c_uint64),
        ("rejectedPdf", c_uint64),
    ]


function("awdAdaptField", AWDResult, AWDField, POINTER(AWDFieldStatistics))
function("awdMarkField", AWDResult, AWDField)
function("awdRevertField", AWDResult, AWDField)
function("awdGetFieldStatistics", AWDResult, AWDField, POINTER(AWDFieldStatistics))
function("awdGetFieldPatches", AWDResult, AWDField, Array, c_size_t, POINTER(c_size_t))


class AWDPatchInfo(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("basis", c_char_p),
        ("level", c_uint32),
        ("axisCount", c_uint32),
        ("samples", c_uint64),
        ("learned", c_uint64),
    ]


function("awdGetPatchInfo", AWDResult, AWDField, c_uint32, POINTER(AWDPatchInfo))
function("awdGetPatchCoefficients", AWDResult, AWDField, c_uint32, Array, c_size_t)
function("awdGetPatchMean", AWDResult, AWDField, c_uint32, POINTER(c_float))
function("awdGetContinuation", AWDResult, AWDField, c_uint32, c_float, c_float, c_uint32,
         POINTER(c_float))
function("awdGetPatchPdf", AWDResult, AWDField, c_uint32, c_uint32, Array, c_size_t)
function("awdMapDirection", AWDResult, AWDField, c_uint32, Array, Array, Array)
function("awdFindPatches", AWDResult, AWDField, c_size_t, Array, Array, Array)
function("awdSampleFieldBatch", AWDResult, AWDField, c_size_t, Array, Array, Array, Array)
function("awdGetFieldPdfs", AWDResult, AWDField, c_size_t, Array, Array, Array, Array)
function("awdRecordFieldBatch", AWDResult, AWDField, c_size_t, Array, Array, Array)


class AWDPathVertex(Structure):
    _fields_ = [
        ("patch", c_uint32),
        ("continuation", c_float),
        ("sample", AWDDirectionSample),
        ("emitted", c_float * 3),
        ("direct", c_float * 3),
        ("scattering", c_float * 3),
    ]


function("awdRecordFieldPath", AWDResult, AWDField, c_size_t, Array, Array, Array)
function("awdSaveField", AWDResult, AWDField, Array, c_size_t, POINTER(c_size_t))
function("awdLoadField", AWDResult, AWDDevice, Array, c_size_t, POINTER(AWDField))
function("awdWriteField", AWDResult, AWDField, c_char_p)
function("awdReadField", AWDResult, AWDDevice, c_char_p, POINTER(AWDField))
function("awdMergeField", AWDResult, AWDField, AWDField)
function("awdExportField", AWDResult, AWDField, Array, c_size_t, Array, c_size_t, POINTER(c_size_t),
         POINTER(c_size_t))
function("awdImportField", AWDResult, AWDField, Array, c_size_t, Array, c_size_t)
