# SPDX-License-Identifier: Apache-2.0
"""libawd from Python: adaptive wavelet densities for Monte Carlo ray tracing.

    with awd.Device() as device, awd.Scene(device) as scene:
        ...
        with awd.Render(scene, awd.Camera(width=256, height=256)) as render:
            render.run(samples=64, progress=True)
            film = render.film()

Lengths are in scene units, angles in radians, radiance in linear RGB. Wrong values are a TypeError
or ValueError before they reach the library; what the library says is an Error, with its message.
Two calls that may not use an object at once are an InvalidOperation. Arrays must not be changed
while a call uses them. libawd is found when the first call needs it: the file that $AWD_LIBRARY
names, else that of the wheel, else the system's.
"""
from . import _c
from ._callbacks import LogFunction, Progress, ProgressFunction, ProgressLike
from ._density import Axis, Density, DensitySamples
from ._device import Device, check_basis, library_path, library_version, result_string
from ._enums import (INVALID_ID, MOST_DIMENSIONS, MOST_LIGHTS, PATCH_BACK, BasisFlags,
                     CoefficientForm, Combination, DirectLight, Estimator, FilmLayer, Guide,
                     HemisphereMap, LightChoice, Patches, Points, Preset, Quality, RefitStatus,
                     Result, Roulette, Sampler, Severity, Structure, Target)
from ._errors import (Cancelled, Error, FileError, InvalidArgument, InvalidOperation,
                      LibraryNotFound, OutOfMemory, PluginABIError, PluginError, PluginLoadError,
                      PluginNameTaken, PluginSelfTestFailed, Unsupported)
from ._exchange import Records
from ._field import DIRECTION_SAMPLE, PATH_VERTEX, Field, LightSample
from ._figures import (BasisCheck, BasisInfo, DensityAxisInfo, DensityEstimate, DensityInfo,
                       DensityReport, FieldStatistics, PassStatistics, PatchInfo, QualitySchedule,
                       RenderError, SceneInfo)
from ._image import Image
from ._render import Camera, Render
from ._scene import HIT, RAY, Scene, rays
from ._schedule import quality_schedule

__all__ = [
    "Axis", "BasisCheck", "BasisFlags", "BasisInfo", "Camera", "Cancelled", "CoefficientForm",
    "Combination", "DIRECTION_SAMPLE", "Density", "DensityAxisInfo", "DensityEstimate",
    "DensityInfo", "DensityReport", "DensitySamples", "Device", "DirectLight", "Error", "Estimator",
    "Field", "FieldStatistics", "FileError", "FilmLayer", "Guide", "HIT", "HemisphereMap",
    "INVALID_ID", "Image", "InvalidArgument", "InvalidOperation", "LibraryNotFound", "LightChoice",
    "LightSample", "LogFunction", "MOST_DIMENSIONS", "MOST_LIGHTS", "OutOfMemory", "PATCH_BACK",
    "PATH_VERTEX", "PassStatistics", "PatchInfo", "Patches", "PluginABIError", "PluginError",
    "PluginLoadError", "PluginNameTaken", "PluginSelfTestFailed", "Points", "Preset", "Progress",
    "ProgressFunction", "ProgressLike", "Quality", "QualitySchedule", "RAY", "Records",
    "RefitStatus", "Render", "RenderError", "Result", "Roulette", "Sampler", "Scene", "SceneInfo",
    "Severity", "Structure", "Target", "Unsupported", "check_basis", "library_path",
    "library_version", "quality_schedule", "rays", "result_string",
]

__version__ = f"{_c.AWD_VERSION_MAJOR}.{_c.AWD_VERSION_MINOR}.{_c.AWD_VERSION_PATCH}"
