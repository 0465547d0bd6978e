# SPDX-License-Identifier: Apache-2.0
"""The settings that are chosen from a list, and other constants. Wherever one is asked for, its
name serves too, in any case and with "-" for "_": guide="cosine"."""
from enum import IntEnum, IntFlag

from . import _c as c

INVALID_ID = c.AWD_INVALID_ID
"""No mesh, triangle, material, patch or component."""
PATCH_BACK = c.AWD_PATCH_BACK
"""Set in the number of a patch: its back side, a patch of its own."""
MOST_DIMENSIONS = c.AWD_MAX_DIMENSIONS
"""Of a density."""
MOST_LIGHTS = c.AWD_MOST_FIELD_LIGHTS
"""That a field tells apart."""


class Result(IntEnum):
    """How a call of the library ended."""

    SUCCESS = c.AWD_SUCCESS
    ERROR_UNKNOWN = c.AWD_ERROR_UNKNOWN
    ERROR_INVALID_ARGUMENT = c.AWD_ERROR_INVALID_ARGUMENT
    ERROR_INVALID_OPERATION = c.AWD_ERROR_INVALID_OPERATION
    ERROR_OUT_OF_MEMORY = c.AWD_ERROR_OUT_OF_MEMORY
    ERROR_UNSUPPORTED = c.AWD_ERROR_UNSUPPORTED
    ERROR_CANCELLED = c.AWD_ERROR_CANCELLED
    ERROR_IO = c.AWD_ERROR_IO
    ERROR_PLUGIN_LOAD = c.AWD_ERROR_PLUGIN_LOAD
    ERROR_PLUGIN_ABI = c.AWD_ERROR_PLUGIN_ABI
    ERROR_PLUGIN_NAME_TAKEN = c.AWD_ERROR_PLUGIN_NAME_TAKEN
    ERROR_PLUGIN_SELF_TEST = c.AWD_ERROR_PLUGIN_SELF_TEST


class Severity(IntEnum):
    """Of a log message."""

    INFO = c.AWD_LOG_INFO
    WARNING = c.AWD_LOG_WARNING
    ERROR = c.AWD_LOG_ERROR


class BasisFlags(IntFlag):
    """Of a basis family."""

    ORTHOGONAL = c.AWD_BASIS_ORTHOGONAL
    PERIODIC = c.AWD_BASIS_PERIODIC
    NESTED = c.AWD_BASIS_NESTED


class Preset(IntEnum):
    """A group of settings. PAPER: Pietrek and Peter 1999 to the letter."""

    DEFAULT = c.AWD_PRESET_DEFAULT
    PAPER = c.AWD_PRESET_PAPER


class Target(IntEnum):
    """What a density becomes proportional to: the mean of |f|, or sqrt(E[f^2])."""

    DEFAULT = c.AWD_TARGET_DEFAULT
    MEAN = c.AWD_TARGET_MEAN
    RMS = c.AWD_TARGET_RMS


class Estimator(IntEnum):
    """How coefficients come from samples; awd/types.h has the formulas."""

    DEFAULT = c.AWD_ESTIMATOR_DEFAULT
    PAPER = c.AWD_ESTIMATOR_PAPER
    MIXTURE = c.AWD_ESTIMATOR_MIXTURE
    RATIO = c.AWD_ESTIMATOR_RATIO
    QUASI = c.AWD_ESTIMATOR_QUASI
    REFIT = c.AWD_ESTIMATOR_REFIT
    LUMPED = c.AWD_ESTIMATOR_LUMPED


class Combination(IntEnum):
    """How passes make one result."""

    DEFAULT = c.AWD_COMBINE_DEFAULT
    COUNT = c.AWD_COMBINE_COUNT
    CROSS_VARIANCE = c.AWD_COMBINE_CROSS_VARIANCE
    EXPERIENCE = c.AWD_COMBINE_EXPERIENCE


class RefitStatus(IntEnum):
    """How a refit ended."""

    NONE = c.AWD_REFIT_NONE
    CONVERGED = c.AWD_REFIT_CONVERGED
    LIMIT = c.AWD_REFIT_LIMIT
    FAILED = c.AWD_REFIT_FAILED


class Structure(IntEnum):
    """Of a density: a tensor product of bases, or a tree of boxes."""

    DEFAULT = c.AWD_STRUCTURE_DEFAULT
    GRID = c.AWD_STRUCTURE_GRID
    TREE = c.AWD_STRUCTURE_TREE


class Sampler(IntEnum):
    """How a density draws points."""

    DEFAULT = c.AWD_SAMPLER_DEFAULT
    INVERSE_CDF = c.AWD_SAMPLER_INVERSE_CDF
    COMPONENT = c.AWD_SAMPLER_COMPONENT


class CoefficientForm(IntEnum):
    """In which basis coefficients are told."""

    SCALING = c.AWD_COEFFICIENTS_SCALING
    ORTHONORMAL = c.AWD_COEFFICIENTS_ORTHONORMAL


class HemisphereMap(IntEnum):
    """From the unit square to directions."""

    DEFAULT = c.AWD_MAP_DEFAULT
    SPHERICAL = c.AWD_MAP_SPHERICAL
    CONCENTRIC_COSINE = c.AWD_MAP_CONCENTRIC_COSINE
    CYLINDRICAL = c.AWD_MAP_CYLINDRICAL
    COSINE = c.AWD_MAP_COSINE


class Patches(IntEnum):
    """Which patches there are: the library's own, or those of the host."""

    DEFAULT = c.AWD_PATCHES_DEFAULT
    SPATIAL = c.AWD_PATCHES_SPATIAL
    HOST = c.AWD_PATCHES_HOST


class Guide(IntEnum):
    """Where indirect rays go."""

    ADAPTIVE = c.AWD_GUIDE_ADAPTIVE
    COSINE = c.AWD_GUIDE_COSINE
    UNIFORM = c.AWD_GUIDE_UNIFORM


class DirectLight(IntEnum):
    """How light is found."""

    DEFAULT = c.AWD_DIRECT_DEFAULT
    AREA = c.AWD_DIRECT_AREA
    WEIGHTED = c.AWD_DIRECT_WEIGHTED
    NONE = c.AWD_DIRECT_NONE


class Roulette(IntEnum):
    """How long paths live."""

    DEFAULT = c.AWD_ROULETTE_DEFAULT
    ALBEDO = c.AWD_ROULETTE_ALBEDO
    THROUGHPUT = c.AWD_ROULETTE_THROUGHPUT
    ADJOINT = c.AWD_ROULETTE_ADJOINT


class Points(IntEnum):
    """What paths are drawn from."""

    DEFAULT = c.AWD_POINTS_DEFAULT
    RANDOM = c.AWD_POINTS_RANDOM
    SOBOL = c.AWD_POINTS_SOBOL


class LightChoice(IntEnum):
    """Which light a shadow ray goes to."""

    DEFAULT = c.AWD_LIGHTS_DEFAULT
    POWER = c.AWD_LIGHTS_POWER
    LEARNED = c.AWD_LIGHTS_LEARNED


class Quality(IntEnum):
    """How good an image must be: an error of 0.5, 0.25, 0.1 or 0.05 of its mean radiance."""

    DRAFT = c.AWD_QUALITY_DRAFT
    NORMAL = c.AWD_QUALITY_NORMAL
    FINE = c.AWD_QUALITY_FINE
    REFERENCE = c.AWD_QUALITY_REFERENCE


class FilmLayer(IntEnum):
    """What a film holds of a pixel."""

    RADIANCE = c.AWD_FILM_RADIANCE
    VARIANCE = c.AWD_FILM_VARIANCE
