# SPDX-License-Identifier: Apache-2.0
"""awd/light.h"""
from ctypes import POINTER, c_double, c_float, c_uint32

from ._declare import function
from .types import AWDField, AWDResult

function("awdChooseLight", AWDResult, AWDField, c_uint32, c_double, POINTER(c_uint32),
         POINTER(c_float), POINTER(c_double))
function("awdGetLightChance", AWDResult, AWDField, c_uint32, c_uint32, POINTER(c_float))
function("awdRecordLight", AWDResult, AWDField, c_uint32, c_uint32, c_double)
function("awdGetPatchLight", AWDResult, AWDField, c_uint32, POINTER(c_float))
