# SPDX-License-Identifier: Apache-2.0
"""The package declares what the headers do, and leaves nothing out."""
import ctypes
import dataclasses
import inspect
import json
import os
import re
import subprocess
import sys
import unittest

import headers

import awd
from awd import _c as c
from awd import (_density, _device, _enums, _field, _figures, _image, _library, _objects, _render,
                 _scene, _schedule)
from awd._library import lib
from awd.declared import declared

HEADER = headers.read()
COMPILED = headers.compiled(HEADER)

NUMBERS = {"uint32_t": ctypes.c_uint32, "int32_t": ctypes.c_int32, "uint64_t": ctypes.c_uint64,
           "size_t": ctypes.c_size_t, "float": ctypes.c_float, "double": ctypes.c_double}


class Declared(unittest.TestCase):
    def test_the_headers_were_read(self):
        self.assertGreater(len(HEADER.functions), 100)
        self.assertGreater(len(HEADER.structs), 25)
        self.assertGreater(len(HEADER.constants), 80)
        self.assertGreater(len(HEADER.inits), 15)

    def test_functions(self):
        want = {name: len(arguments) for name, (_, arguments) in HEADER.functions.items()}
        self.assertEqual(declared()["functions"], want)

    def test_constants(self):
        self.assertEqual(COMPILED["constants"], declared()["constants"])

    def test_structs(self):
        self.assertEqual(COMPILED["structs"], declared()["structs"])

    def test_types(self):
        for name, (result, arguments) in HEADER.functions.items():
            known = c.functions[name]
            for i, (text, kind) in enumerate(zip([result, *arguments],
                                                 [known.result, *known.arguments])):
                with self.subTest(function=name, number=i):
                    self.check_type(text, kind)

    def check_type(self, text, kind):
        text = re.sub(r"const |struct ", "", text)
        meaning = HEADER.types.get(text, text)
        if text == "void":
            self.assertIsNone(kind)
        elif text == "char*":
            self.assertIs(kind, ctypes.c_char_p)
        elif meaning in NUMBERS:
            self.assertIs(kind, NUMBERS[meaning])
        elif meaning == "handle":
            self.assertIs(kind, ctypes.c_void_p)
        elif meaning == "callback":
            self.assertIs(kind, getattr(c, text))
        else:
            self.assertTrue(text.endswith("*"), text)
            if kind is not ctypes.c_void_p:  # of arrays
                item = HEADER.types.get(text[:-1], text[:-1])
                want = NUMBERS.get(item) or (ctypes.c_void_p if item == "handle" else
                                             ctypes.c_char_p if item == "char*" else
                                             getattr(c, item))
                self.assertIs(kind._type_, want)

    def test_the_library_has_every_function(self):
        for name in HEADER.functions:
            self.assertIsInstance(getattr(lib, name), ctypes._CFuncPtr, name)

    def test_initial_structs(self):
        for struct, want in COMPILED["inits"].items():
            made = getattr(c, struct)()
            made.structSize = ctypes.sizeof(made)
            if struct == "AWDCamera":
                made = awd.Camera()._described()
            self.assertEqual(bytes(made), want, struct)

    def test_printed(self):
        run = subprocess.run([sys.executable, "-m", "awd.declared"], capture_output=True, text=True,
                             check=True, env={**os.environ, "AWD_LIBRARY": "/nowhere"})
        self.assertEqual(json.loads(run.stdout), declared())


class Wrapped(unittest.TestCase):
    """The classes leave nothing out of what is declared."""

    PREFIXES = {
        "Result": "AWD_", "Severity": "AWD_LOG_", "BasisFlags": "AWD_BASIS_",
        "Preset": "AWD_PRESET_", "Target": "AWD_TARGET_", "Estimator": "AWD_ESTIMATOR_",
        "Combination": "AWD_COMBINE_", "RefitStatus": "AWD_REFIT_", "Structure": "AWD_STRUCTURE_",
        "Sampler": "AWD_SAMPLER_", "CoefficientForm": "AWD_COEFFICIENTS_",
        "HemisphereMap": "AWD_MAP_", "Patches": "AWD_PATCHES_", "Guide": "AWD_GUIDE_",
        "DirectLight": "AWD_DIRECT_", "Roulette": "AWD_ROULETTE_", "Points": "AWD_POINTS_",
        "LightChoice": "AWD_LIGHTS_", "Quality": "AWD_QUALITY_", "FilmLayer": "AWD_FILM_"}
    OTHERS = re.compile(
        r"AWD_(VERSION.*|BASIS_(ABI|MAX_\w+)|FORMAT_\w+|MESH_SHARED|DEVICE_IGNORE_ENVIRONMENT"
        r"|ALL_AXES|INVALID_ID|PATCH_BACK|MAX_DIMENSIONS|MOST_FIELD_LIGHTS)")

    def test_enums(self):
        left = {name for name in HEADER.constants if not self.OTHERS.fullmatch(name)}
        for name, prefix in self.PREFIXES.items():
            for member in getattr(_enums, name):
                constant = prefix + member.name
                self.assertEqual(member.value, COMPILED["constants"][constant])
                left.discard(constant)
        self.assertEqual(left, set())

    def test_errors(self):
        for result in awd.Result:
            if result < awd.Result.ERROR_UNKNOWN:
                error = awd._errors.error_of(result, "text")
                self.assertEqual(error.result, result)
                self.assertIsNot(type(error), awd.Error)
                self.assertEqual(str(error), "text")
        self.assertIs(type(awd._errors.error_of(-1, "text")), awd.Error)

    def test_figures(self):
        structs = {"QualitySchedule": "AWDSchedule"}
        skipped = {"structSize", "reserved"}
        for name, kind in vars(_figures).items():
            if not (dataclasses.is_dataclass(kind) and isinstance(kind, type)):
                continue
            fields = {_figures.camel(field.name) for field in dataclasses.fields(kind)}
            want = set(HEADER.structs[structs.get(name, "AWD" + name)]) - skipped
            if name == "QualitySchedule":
                want = {"error", "totalSamples"}
            self.assertEqual(fields, want, name)

    def test_every_function_is_used_or_known_not_to_be(self):
        used = "".join(inspect.getsource(module) for module in (
            _density, _device, _field, _image, _library, _objects, _render, _scene,
            _schedule))
        left = {name for name in HEADER.functions if not re.search(rf"\blib\.{name}\b", used)}
        # Python counts references itself. A table of C functions comes from C. One item at a time
        # is what the functions for many do with one.
        not_used = {f"awd{verb}{kind}" for verb in ("Retain", "Release")
                    for kind in ("Device", "Scene", "Field", "Density", "Render", "Image")}
        not_used |= {"awdRegisterBasisModule", "awdFindPatch", "awdSampleField", "awdGetFieldPdf",
                     "awdRecordField"}
        self.assertEqual(left, not_used)


if __name__ == "__main__":
    unittest.main()
