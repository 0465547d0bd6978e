# SPDX-License-Identifier: Apache-2.0
"""The figures that the library tells, as frozen dataclasses with the names of the C structs' fields
in snake_case."""
import dataclasses
import re
from dataclasses import dataclass
from typing import Any, ClassVar, Mapping, Optional, Type, TypeVar

from ._enums import (BasisFlags, Combination, Estimator, RefitStatus, Result, Sampler, Structure,
                     Target)
from ._library import decoded

F = TypeVar("F")
Triple = tuple[float, float, float]


def camel(name: str) -> str:
    """rejected_nan is the field rejectedNaN, all others as one would think."""
    if name == "rejected_nan":
        return "rejectedNaN"
    return re.sub(r"_(\w)", lambda match: match[1].upper(), name)


def figures(kind: Type[F], struct: Any) -> F:
    kinds: Mapping[str, Any] = getattr(kind, "_kinds", {})
    values = {}
    for field in dataclasses.fields(kind):
        value = getattr(struct, camel(field.name))
        if field.name in kinds:
            value = kinds[field.name](value)
        elif value is None or isinstance(value, bytes):
            value = decoded(value)
        elif not isinstance(value, (int, float)):
            value = tuple(value)
        values[field.name] = value
    return kind(**values)


@dataclass(frozen=True)
class BasisInfo:
    """A family of basis functions that can be used, or a candidate that can't."""

    _kinds: ClassVar[Mapping[str, Any]] = {"status": Result, "flags": BasisFlags}
    name: str
    summary: str
    file: str
    """absolute path; "" when registered from memory"""
    status: Result
    """SUCCESS: it can be used"""
    flags: BasisFlags
    message: str
    """why not; "" when it can be used"""
    order: int
    """polynomial degree + 1"""
    min_level: int
    max_level: int


@dataclass(frozen=True)
class BasisCheck:
    """One check of a family's self-test."""

    _kinds: ClassVar[Mapping[str, Any]] = {"status": Result}
    family: str
    name: str
    """of the check, such as "partition of unity" """
    message: str
    """what is wrong and where; "" when all is well"""
    worst: float
    """largest figure met"""
    limit: float
    """that no figure may exceed"""
    status: Result
    index: int
    """of the family in its module"""


@dataclass(frozen=True)
class SceneInfo:
    """Figures of a committed scene."""

    triangles: int
    skipped: int
    """of these, without area"""
    lights: int
    patches: int
    meshes: int
    materials: int
    lower: Triple
    upper: Triple


@dataclass(frozen=True)
class FieldStatistics:
    """What a field holds, and what its last pass brought."""

    patches: int
    """that have ever had a sample"""
    coefficients: int
    bytes: int
    samples: int
    """recorded by the pass that the last adapt ended"""
    rejected: int
    saturated: int
    kept: int
    refit_failed: int
    refit_limited: int
    refit_iterations: int
    capped: int
    rejected_nan: int
    rejected_infinite: int
    rejected_negative: int
    rejected_pdf: int


@dataclass(frozen=True)
class PatchInfo:
    """What a patch knows."""

    basis: str
    level: int
    axis_count: int
    """functions per axis; axis_count^2 coefficients"""
    samples: int
    """recorded since the last adapt"""
    learned: int
    """samples of the pass that last changed the density; 0: start density"""


@dataclass(frozen=True)
class DensityReport:
    """What an adapt made of a pass."""

    _kinds: ClassVar[Mapping[str, Any]] = {"estimator": Estimator, "kept": bool,
                                           "refit_status": RefitStatus}
    samples: int
    rejected: int
    coefficients: int
    negative: int
    coarsened: int
    split: int
    tau: float
    estimator: Estimator
    kept: bool
    """the samples were of no use, p is as it was"""
    estimated_levels: int
    refit_status: RefitStatus
    refit_iterations: int
    refit_at_bound: int
    refit_lambda: float
    refit_objective: float
    refit_message: str


@dataclass(frozen=True)
class DensityEstimate:
    """The estimate of int f over [0,1]^d by all passes."""

    integral: float
    standard_error: float
    samples: int
    passes: int


@dataclass(frozen=True)
class DensityInfo:
    """What a density is, its defaults settled, and what it holds."""

    _kinds: ClassVar[Mapping[str, Any]] = {
        "structure": Structure, "estimator": Estimator, "target": Target, "sampler": Sampler,
        "combination": Combination}
    dimensions: int
    structure: Structure
    estimator: Estimator
    target: Target
    sampler: Sampler
    combination: Combination
    uniforms: int
    """per point that sample() wants"""
    coefficients: int
    leaves: int
    bytes: int
    samples: int
    """recorded since the last adapt"""
    rejected: int
    learned: int
    passes: int


@dataclass(frozen=True)
class DensityAxisInfo:
    _kinds: ClassVar[Mapping[str, Any]] = {"flags": BasisFlags}
    basis: str
    level: int
    max_level: int
    count: int
    """functions along this axis, of the grid or of one leaf"""
    cells: int
    order: int
    flags: BasisFlags


@dataclass(frozen=True)
class PassStatistics:
    """Figures of one pass, or of all."""

    cpu_seconds: float
    wall_seconds: float
    samples_per_pixel: int
    samples: int
    """camera paths"""
    rays: int
    """traced, shadow rays included"""
    shadow_rays: int
    patches: int
    coefficients: int
    bytes: int
    rejected_samples: int


@dataclass(frozen=True)
class RenderError:
    """How far a film is from the truth, relative to its brightness; the true figure lies between
    lower and upper 95 times of 100."""

    error: float
    lower: float
    upper: float


@dataclass(frozen=True)
class QualitySchedule:
    """What a quality promises: this error, or that it had so many samples per pixel."""

    error: float
    total_samples: int


def optional(value: float) -> Optional[float]:
    """-1, the library's "nothing is known", as None."""
    return None if value < 0 else value
