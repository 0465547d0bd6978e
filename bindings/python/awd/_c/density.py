# SPDX-License-Identifier: Apache-2.0
"""awd/density.h"""
from ctypes import POINTER, Structure, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64

from ._declare import Array, function
from .types import (AWDCombination, AWDDensity, AWDDevice, AWDEstimator, AWDRefitStatus, AWDResult,
                    AWDTarget)

AWD_MAX_DIMENSIONS = 6
AWD_ALL_AXES = 0xFFFFFFFF

AWDDensityStructure = c_int32
AWD_STRUCTURE_DEFAULT = 0
AWD_STRUCTURE_GRID = 1
AWD_STRUCTURE_TREE = 2

AWDSampler = c_int32
AWD_SAMPLER_DEFAULT = 0
AWD_SAMPLER_INVERSE_CDF = 1
AWD_SAMPLER_COMPONENT = 2


class AWDDensityAxis(Structure):
    _fields_ = [
        ("basis", c_char_p),
        ("startLevel", c_uint32),
        ("maxLevel", c_uint32),
    ]


class AWDDensityDesc(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("dimensions", c_uint32),
        ("structure", AWDDensityStructure),
        ("axes", POINTER(AWDDensityAxis)),
        ("estimator", AWDEstimator),
        ("target", AWDTarget),
        ("sampler", AWDSampler),
        ("combination", AWDCombination),
        ("tau", c_double),
        ("shrinkage", c_double),
        ("passSamples", c_uint64),
        ("maxCoefficients", c_uint64),
        ("refitSolver", c_char_p),
        ("refitBytes", c_uint64),
    ]


function("awdNewDensity", AWDResult, AWDDevice, POINTER(AWDDensityDesc), POINTER(AWDDensity))
function("awdRetainDensity", None, AWDDensity)
function("awdReleaseDensity", None, AWDDensity)
function("awdForkDensity", AWDResult, AWDDensity, POINTER(AWDDensity))
function("awdJoinDensity", AWDResult, AWDDensity, AWDDensity)
function("awdSampleDensity", AWDResult, AWDDensity, c_size_t, Array, Array, Array, Array)
function("awdGetDensityPdf", AWDResult, AWDDensity, c_size_t, Array, Array)
function("awdRecordDensity", AWDResult, AWDDensity, c_size_t, Array, Array, Array, Array)


class AWDDensityReport(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("samples", c_uint64),
        ("rejected", c_uint64),
        ("coefficients", c_uint64),
        ("negative", c_uint64),
        ("coarsened", c_uint64),
        ("split", c_uint64),
        ("tau", c_double),
        ("estimator", AWDEstimator),
        ("kept", c_int32),
        ("estimatedLevels", c_uint32),
        ("refitStatus", AWDRefitStatus),
        ("refitIterations", c_uint32),
        ("refitAtBound", c_uint64),
        ("refitLambda", c_double),
        ("refitObjective", c_double),
        ("refitMessage", c_char_p),
    ]


function("awdAdaptDensity", AWDResult, AWDDensity, POINTER(AWDDensityReport))
function("awdRefineDensity", AWDResult, AWDDensity, c_uint32)


class AWDDensityEstimate(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("integral", c_double),
        ("standardError", c_double),
        ("samples", c_uint64),
        ("passes", c_uint64),
    ]


function("awdGetDensityEstimate", AWDResult, AWDDensity, POINTER(AWDDensityEstimate))


class AWDDensityInfo(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("dimensions", c_uint32),
        ("structure", AWDDensityStructure),
        ("estimator", AWDEstimator),
        ("target", AWDTarget),
        ("sampler", AWDSampler),
        ("combination", AWDCombination),
        ("uniforms", c_uint32),
        ("reserved", c_uint32),
        ("coefficients", c_uint64),
        ("leaves", c_uint64),
        ("bytes", c_uint64),
        ("samples", c_uint64),
        ("rejected", c_uint64),
        ("learned", c_uint64),
        ("passes", c_uint64),
    ]


function("awdGetDensityInfo", AWDResult, AWDDensity, POINTER(AWDDensityInfo))


class AWDDensityAxisInfo(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("basis", c_char_p),
        ("level", c_uint32),
        ("maxLevel", c_uint32),
        ("count", c_uint32),
        ("cells", c_uint32),
        ("order", c_uint32),
        ("flags", c_uint32),
    ]


function("awdGetDensityAxisInfo", AWDResult, AWDDensity, c_uint32, POINTER(AWDDensityAxisInfo))
AWDCoefficientForm = c_int32
AWD_COEFFICIENTS_SCALING = 0
AWD_COEFFICIENTS_ORTHONORMAL = 1

function("awdGetDensityCoefficients", AWDResult, AWDDensity, AWDCoefficientForm, Array, c_size_t)
function("awdSetDensityCoefficients", AWDResult, AWDDensity, Array, c_size_t)
function("awdGetDensityIntegral", AWDResult, AWDDensity, Array, Array, POINTER(c_double))
function("awdGetDensityLeaves", AWDResult, AWDDensity, Array, c_size_t, POINTER(c_size_t))
function("awdGetDensityDetailEnergy", AWDResult, AWDDensity, Array, c_size_t, POINTER(c_size_t))
function("awdExportDensityStatistics", AWDResult, AWDDensity, Array, c_size_t, POINTER(c_size_t))
function("awdAddDensityStatistics", AWDResult, AWDDensity, Array, c_size_t)
function("awdImportDensityStatistics", AWDResult, AWDDensity, Array, c_size_t)
function("awdSaveDensity", AWDResult, AWDDensity, Array, c_size_t, POINTER(c_size_t))
function("awdLoadDensity", AWDResult, AWDDevice, Array, c_size_t, POINTER(AWDDensity))
