# SPDX-License-Identifier: Apache-2.0
"""awd/render.h"""
from ctypes import (POINTER, Structure, c_char_p, c_double, c_float, c_int32, c_size_t, c_uint32,
                    c_uint64)

from ._declare import Array, function
from .types import AWDCombination, AWDField, AWDPreset, AWDRender, AWDResult, AWDScene
from .field import AWDFieldDesc


class AWDCamera(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("eye", c_float * 3),
        ("lookDir", c_float * 3),
        ("up", c_float * 3),
        ("tanHalfFovX", c_float),
        ("width", c_uint32),
        ("height", c_uint32),
    ]


AWDGuide = c_int32
AWD_GUIDE_ADAPTIVE = 0
AWD_GUIDE_COSINE = 1
AWD_GUIDE_UNIFORM = 2

AWDDirectLight = c_int32
AWD_DIRECT_DEFAULT = 0
AWD_DIRECT_AREA = 1
AWD_DIRECT_WEIGHTED = 2
AWD_DIRECT_NONE = 3

AWDRoulette = c_int32
AWD_ROULETTE_DEFAULT = 0
AWD_ROULETTE_ALBEDO = 1
AWD_ROULETTE_THROUGHPUT = 2
AWD_ROULETTE_ADJOINT = 3

AWDPoints = c_int32
AWD_POINTS_DEFAULT = 0
AWD_POINTS_RANDOM = 1
AWD_POINTS_SOBOL = 2

AWDLightChoice = c_int32
AWD_LIGHTS_DEFAULT = 0
AWD_LIGHTS_POWER = 1
AWD_LIGHTS_LEARNED = 2


class AWDRenderDesc(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("camera", POINTER(AWDCamera)),
        ("preset", AWDPreset),
        ("guide", AWDGuide),
        ("direct", AWDDirectLight),
        ("roulette", AWDRoulette),
        ("shadowRays", c_uint32),
        ("maxLights", c_uint32),
        ("seed", c_uint64),
        ("combination", AWDCombination),
        ("points", AWDPoints),
        ("maxBytes", c_uint64),
        ("maxSplit", c_uint32),
        ("lights", AWDLightChoice),
    ]


function("awdNewSceneField", AWDResult, AWDScene, POINTER(AWDFieldDesc), POINTER(AWDField))
function("awdNewRender", AWDResult, AWDScene, AWDField, POINTER(AWDRenderDesc), POINTER(AWDRender))
function("awdRetainRender", None, AWDRender)
function("awdReleaseRender", None, AWDRender)
function("awdGetRenderField", AWDResult, AWDRender, POINTER(AWDField))


class AWDPassStatistics(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("cpuSeconds", c_double),
        ("wallSeconds", c_double),
        ("samplesPerPixel", c_uint64),
        ("samples", c_uint64),
        ("rays", c_uint64),
        ("shadowRays", c_uint64),
        ("patches", c_uint64),
        ("coefficients", c_uint64),
        ("bytes", c_uint64),
        ("rejectedSamples", c_uint64),
    ]


function("awdRenderPass", AWDResult, AWDRender, c_uint32, POINTER(AWDPassStatistics))


class AWDSchedule(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("samplesPerPass", POINTER(c_uint32)),
        ("passCount", c_uint32),
        ("totalSamples", c_uint32),
        ("seconds", c_double),
        ("error", c_double),
        ("resume", c_int32),
        ("maxPasses", c_uint32),
    ]


function("awdRenderPasses", AWDResult, AWDRender, POINTER(AWDSchedule))
function("awdSaveRender", AWDResult, AWDRender, c_char_p)
function("awdLoadRender", AWDResult, AWDScene, c_char_p, AWDField, POINTER(AWDRenderDesc),
         POINTER(AWDRender))
function("awdRenderPassPart", AWDResult, AWDRender, POINTER(AWDSchedule), c_uint32, c_uint32,
         POINTER(c_uint32))
function("awdExportPass", AWDResult, AWDRender, Array, c_size_t, POINTER(c_size_t),
         POINTER(c_size_t))
function("awdImportPass", AWDResult, AWDRender, Array, c_size_t, POINTER(AWDPassStatistics))
AWDQuality = c_int32
AWD_QUALITY_DRAFT = 1
AWD_QUALITY_NORMAL = 2
AWD_QUALITY_FINE = 3
AWD_QUALITY_REFERENCE = 4

function("awdGetQualitySchedule", AWDResult, AWDQuality, POINTER(AWDSchedule))
function("awdGetPassCount", AWDResult, AWDRender, POINTER(c_uint32))
function("awdGetPassStatistics", AWDResult, AWDRender, c_uint32, POINTER(AWDPassStatistics))
function("awdGetRenderStatistics", AWDResult, AWDRender, POINTER(AWDPassStatistics))
AWDFilmLayer = c_int32
AWD_FILM_RADIANCE = 1
AWD_FILM_VARIANCE = 2

function("awdReadFilm", AWDResult, AWDRender, AWDFilmLayer, Array, c_size_t, c_size_t)
function("awdGetFilmInfo", AWDResult, AWDRender, POINTER(c_uint32), POINTER(c_uint32),
         POINTER(c_uint64))


class AWDRenderError(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("error", c_double),
        ("lower", c_double),
        ("upper", c_double),
    ]


function("awdGetRenderError", AWDResult, AWDRender, POINTER(AWDRenderError))
function("awdGetPixelPatch", AWDResult, AWDRender, c_uint32, c_uint32, POINTER(c_uint32))
