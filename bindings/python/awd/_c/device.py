# SPDX-License-Identifier: Apache-2.0
"""awd/device.h"""
from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_size_t, c_uint32, c_void_p

from ._declare import function
from .types import (AWDAllocFn, AWDDevice, AWDFreeFn, AWDLogFn, AWDParallelForFn, AWDProgressFn,
                    AWDResult)
from .basis import AWDBasisModule

AWD_DEVICE_IGNORE_ENVIRONMENT = 1


class AWDDeviceDesc(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("threads", c_uint32),
        ("flags", c_uint32),
        ("log", AWDLogFn),
        ("logUser", c_void_p),
        ("progress", AWDProgressFn),
        ("progressUser", c_void_p),
        ("alloc", AWDAllocFn),
        ("free", AWDFreeFn),
        ("allocUser", c_void_p),
        ("parallelFor", AWDParallelForFn),
        ("parallelForUser", c_void_p),
        ("basisPaths", POINTER(c_char_p)),
        ("basisPathCount", c_size_t),
    ]


function("awdGetVersion", c_uint32)
function("awdGetResultString", c_char_p, AWDResult)
function("awdGetLastErrorMessage", c_char_p)
function("awdNewDevice", AWDResult, POINTER(AWDDeviceDesc), POINTER(AWDDevice))
function("awdRetainDevice", None, AWDDevice)
function("awdReleaseDevice", None, AWDDevice)
function("awdLoadBasisModule", AWDResult, AWDDevice, c_char_p)
function("awdRegisterBasisModule", AWDResult, AWDDevice, POINTER(AWDBasisModule))


class AWDBasisCheck(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("family", c_char_p),
        ("name", c_char_p),
        ("message", c_char_p),
        ("worst", c_double),
        ("limit", c_double),
        ("status", AWDResult),
        ("index", c_uint32),
    ]


AWDBasisCheckFn = CFUNCTYPE(None, c_void_p, POINTER(AWDBasisCheck))
function("awdCheckBasisModule", AWDResult, c_char_p, AWDBasisCheckFn, c_void_p)


class AWDBasisInfo(Structure):
    _fields_ = [
        ("structSize", c_size_t),
        ("name", c_char_p),
        ("summary", c_char_p),
        ("file", c_char_p),
        ("status", AWDResult),
        ("flags", c_uint32),
        ("message", c_char_p),
        ("order", c_uint32),
        ("minLevel", c_uint32),
        ("maxLevel", c_uint32),
        ("reserved", c_uint32),
    ]


function("awdGetBasisCount", AWDResult, AWDDevice, POINTER(c_size_t))
function("awdGetBasisInfo", AWDResult, AWDDevice, c_size_t, POINTER(AWDBasisInfo))
