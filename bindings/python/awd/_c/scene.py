# SPDX-License-Identifier: Apache-2.0
"""awd/scene.h"""
from ctypes import POINTER, Structure, c_float, c_int32, c_size_t, c_uint32, c_uint64

from ._declare import Array, function
from .types import AWDBuffer, AWDDevice, AWDResult, AWDScene

function("awdNewScene", AWDResult, AWDDevice, POINTER(AWDScene))
function("awdRetainScene", None, AWDScene)
function("awdReleaseScene", None, AWDScene)


class AWDMaterialDesc(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("albedo", c_float * 3),
        ("emission", c_float * 3),
    ]


function("awdAddMaterial", AWDResult, AWDScene, POINTER(AWDMaterialDesc), POINTER(c_uint32))

AWD_MESH_SHARED = 1


class AWDMeshDesc(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("vertices", AWDBuffer),
        ("indices", AWDBuffer),
        ("materials", AWDBuffer),
        ("patches", AWDBuffer),
        ("material", c_uint32),
        ("flags", c_uint32),
    ]


function("awdAddMesh", AWDResult, AWDScene, POINTER(AWDMeshDesc), POINTER(c_uint32))
function("awdCommitScene", AWDResult, AWDScene)


class AWDSceneInfo(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("triangles", c_uint64),
        ("skipped", c_uint64),
        ("lights", c_uint64),
        ("patches", c_uint64),
        ("meshes", c_uint32),
        ("materials", c_uint32),
        ("lower", c_float * 3),
        ("upper", c_float * 3),
    ]


function("awdGetSceneInfo", AWDResult, AWDScene, POINTER(AWDSceneInfo))


class AWDRay(Structure):
    _fields_ = [
        ("origin", c_float * 3),
        ("tnear", c_float),
        ("direction", c_float * 3),
        ("tfar", c_float),
    ]


class AWDHit(Structure):
    _fields_ = [
        ("t", c_float),
        ("normal", c_float * 3),
        ("u", c_float),
        ("v", c_float),
        ("mesh", c_uint32),
        ("triangle", c_uint32),
        ("material", c_uint32),
        ("patch", c_uint32),
    ]


function("awdIntersect", AWDResult, AWDScene, Array, c_size_t, Array)
function("awdOccluded", AWDResult, AWDScene, Array, c_size_t, Array)
function("awdGetTrianglePatch", AWDResult, AWDScene, c_uint32, c_uint32, c_int32, POINTER(c_uint32))
function("awdGetPointPatch", AWDResult, AWDScene, Array, POINTER(c_uint32))
