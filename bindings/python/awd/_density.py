# SPDX-License-Identifier: Apache-2.0
import ctypes
from dataclasses import dataclass
from typing import Any, List, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _arrays, _check
from . import _c as c
from ._arrays import DOUBLE, UINT, address
from ._callbacks import ProgressLike
from ._device import Device
from ._enums import CoefficientForm, Combination, Estimator, Sampler, Structure, Target
from ._figures import DensityAxisInfo, DensityEstimate, DensityInfo, DensityReport, figures
from ._field import buffer_of
from ._library import check, lib
from ._objects import Object, Use, bytes_of, described


@dataclass(frozen=True)
class Axis:
    """One axis of a density; None is the default."""

    basis: Optional[str] = None
    """family; "linear-bspline" on a grid, "haar" in a tree"""
    start_level: Optional[int] = None
    max_level: Optional[int] = None
    """beyond which it never refines"""


class DensitySamples(NamedTuple):
    points: npt.NDArray[np.float64]
    """(n, dimensions), in [0,1)"""
    pdfs: npt.NDArray[np.float64]
    """(n,), bit for bit what pdf() says of the points"""
    components: npt.NDArray[np.uint32]
    """(n,), INVALID_ID unless the sampler is COMPONENT"""


class Density(Object):
    """An adaptive density on [0,1]^d: a pdf that learns |f| from samples of f.

    A pass: draw points with sample(), evaluate f there, tell with record(), and adapt(). In
    between the density is frozen, so that the mean of f/p is unbiased.

    dimensions: 1 to 6. axes: one for each dimension, or None.
    tau: floor of coefficients; 0: the default; negative: none. shrinkage: likewise.
    pass_samples: to be expected in a pass; max_coefficients, refit_bytes: limits; 0: the default.
    awd/density.h tells the rest. Unsupported: there is no such basis, refit module or solver, or a
    tree is asked of a family that is not nested.

    sample(), pdf() and looks at coefficients may run in many threads at once, but not while the
    density adapts; the others are exclusive: fork() makes one for each thread that records. Inputs
    are float64; other numbers are converted, which copies them.
    """

    _kind = "Density"
    _dimensions = 0
    _uniforms = 0

    def __init__(self, device: Device, dimensions: int, *,
                 structure: Union[Structure, str] = Structure.DEFAULT,
                 axes: Optional[Sequence[Axis]] = None,
                 estimator: Union[Estimator, str] = Estimator.DEFAULT,
                 target: Union[Target, str] = Target.DEFAULT,
                 sampler: Union[Sampler, str] = Sampler.DEFAULT,
                 combination: Union[Combination, str] = Combination.DEFAULT,
                 tau: float = 0.0, shrinkage: float = 0.0, pass_samples: int = 0,
                 max_coefficients: int = 0, refit_solver: Optional[str] = None,
                 refit_bytes: int = 0) -> None:
        _check.instance(device, Device, "device")
        desc = described(c.AWDDensityDesc)
        desc.dimensions = _check.integer(dimensions, "dimensions", c.AWD_MAX_DIMENSIONS, 1)
        desc.structure = _check.enumerated(structure, Structure, "structure")
        desc.estimator = _check.enumerated(estimator, Estimator, "estimator")
        desc.target = _check.enumerated(target, Target, "target")
        desc.sampler = _check.enumerated(sampler, Sampler, "sampler")
        desc.combination = _check.enumerated(combination, Combination, "combination")
        desc.tau = _check.number(tau, "tau")
        desc.shrinkage = _check.number(shrinkage, "shrinkage")
        desc.passSamples = _check.integer(pass_samples, "pass_samples", _check.UINT64)
        desc.maxCoefficients = _check.integer(max_coefficients, "max_coefficients", _check.UINT64)
        desc.refitSolver = _check.optional_text(refit_solver, "refit_solver")
        desc.refitBytes = _check.integer(refit_bytes, "refit_bytes", _check.UINT64)
        if axes is not None:
            desc.axes = _axes(axes, desc.dimensions)
        handle = c.AWDDensity()
        with Use(shared=(device,)):
            check(lib.awdNewDensity(device._handle, ctypes.byref(desc), ctypes.byref(handle)))
            self._own(handle, device._callbacks)
        self._learn_shape()

    @classmethod
    def load(cls, device: Device, data: Any) -> "Density":
        """From the bytes of save(). Damaged ones are a FileError."""
        _check.instance(device, Device, "device")
        known = buffer_of(data)
        handle = c.AWDDensity()
        with Use(shared=(device,)):
            check(lib.awdLoadDensity(device._handle, address(known), known.nbytes,
                                     ctypes.byref(handle)))
            made = cls._make(handle, device)
        made._learn_shape()
        return made

    def _learn_shape(self) -> None:
        info = self.info()
        self._dimensions, self._uniforms = info.dimensions, info.uniforms

    @property
    def dimensions(self) -> int:
        return self._dimensions

    @property
    def uniforms(self) -> int:
        """Per point that sample() wants: `dimensions`, and one more first if the sampler is
        COMPONENT."""
        return self._uniforms

    def save(self) -> bytes:
        """All that the density is and has recorded. Exclusive."""
        return self._bytes(lib.awdSaveDensity)

    def fork(self) -> "Density":
        """A density of the same p and with no samples, for another thread to record with."""
        handle = c.AWDDensity()
        with Use(shared=(self,)):
            check(lib.awdForkDensity(self._handle, ctypes.byref(handle)))
            made = type(self)._make(handle, self)
        made._learn_shape()
        return made

    def join(self, fork: "Density") -> None:
        """Takes what was recorded by a fork of this density, or of the one that this is a fork of;
        the fork takes over p and has no samples. Exclusive for both."""
        _check.instance(fork, Density, "fork")
        with Use(exclusive=(self, fork)):
            check(lib.awdJoinDensity(self._handle, fork._handle))

    def sample(self, uniforms: npt.ArrayLike) -> DensitySamples:
        """Draws points by uniforms in [0,1), (n, uniforms)."""
        u = _arrays.packed(uniforms, DOUBLE, (-1, self._uniforms), "uniforms")
        drawn = DensitySamples(np.empty((len(u), self._dimensions)), np.empty(len(u)),
                               np.empty(len(u), np.uint32))
        with Use(shared=(self,)):
            check(lib.awdSampleDensity(self._handle, len(u), address(u), address(drawn.points),
                                       address(drawn.pdfs), address(drawn.components)))
        return drawn

    def pdf(self, points: npt.ArrayLike,
            out: Optional[npt.NDArray[np.float64]] = None) -> npt.NDArray[np.float64]:
        """p at points (n, dimensions) of [0,1]^d: float64 (n,)."""
        x = _arrays.packed(points, DOUBLE, (-1, self._dimensions), "points")
        pdfs = _arrays.output(out, DOUBLE, (len(x),))
        with _arrays.packed_output(pdfs) as written, Use(shared=(self,)):
            check(lib.awdGetDensityPdf(self._handle, len(x), address(x), address(written)))
        return pdfs if out is None else out

    def record(self, points: npt.ArrayLike, values: npt.ArrayLike,
               pdfs: Optional[npt.ArrayLike] = None,
               components: Optional[npt.ArrayLike] = None) -> None:
        """Tells the values f (n,) at points (n, dimensions). pdfs (n,): with what density each was
        drawn; None: p itself. components (n,): of the sampler COMPONENT. Zeros belong in; NaN and
        infinity count as rejected samples of value 0. Exclusive."""
        x = _arrays.packed(points, DOUBLE, (-1, self._dimensions), "points")
        f = _arrays.packed(values, DOUBLE, (len(x),), "values")
        p = None if pdfs is None else _arrays.packed(pdfs, DOUBLE, (len(x),), "pdfs")
        j = None
        if components is not None:
            j = _arrays.packed(components, UINT, (len(x),), "components")
        with Use(exclusive=(self,)):
            check(lib.awdRecordDensity(
                self._handle, len(x), address(x), None if p is None else address(p),
                None if j is None else address(j), address(f)))

    def adapt(self, *, progress: ProgressLike = None) -> DensityReport:
        """Ends a pass: p becomes what the samples say. A failure changes nothing. Only the
        estimator REFIT takes long enough to tell of its progress. Exclusive."""
        report = described(c.AWDDensityReport)
        adapted: List[DensityReport] = []

        def adapt() -> None:
            check(lib.awdAdaptDensity(self._handle, ctypes.byref(report)))
            adapted.append(figures(DensityReport, report))  # its message lives until the next adapt

        self._long(progress, (self,), (), adapt)
        return adapted[0]

    def refine(self, axis: Optional[int] = None) -> None:
        """The same p one level finer along an axis; None: along all. Exclusive."""
        number = c.AWD_ALL_AXES if axis is None else _check.integer(axis, "axis",
                                                                    c.AWD_MAX_DIMENSIONS - 1)
        with Use(exclusive=(self,)):
            check(lib.awdRefineDensity(self._handle, number))

    def estimate(self) -> DensityEstimate:
        """Of int f, by all that was recorded. Exclusive."""
        estimate = described(c.AWDDensityEstimate)
        with Use(exclusive=(self,)):
            check(lib.awdGetDensityEstimate(self._handle, ctypes.byref(estimate)))
        return figures(DensityEstimate, estimate)

    def info(self) -> DensityInfo:
        """Exclusive."""
        info = described(c.AWDDensityInfo)
        with Use(exclusive=(self,)):
            check(lib.awdGetDensityInfo(self._handle, ctypes.byref(info)))
        return figures(DensityInfo, info)

    def axis_info(self, axis: int) -> DensityAxisInfo:
        number = _check.integer(axis, "axis")
        info = described(c.AWDDensityAxisInfo)
        with Use(shared=(self,)):
            check(lib.awdGetDensityAxisInfo(self._handle, number, ctypes.byref(info)))
            return figures(DensityAxisInfo, info)

    def coefficients(self, form: Union[CoefficientForm, str] = CoefficientForm.SCALING
                     ) -> npt.NDArray[np.float64]:
        """All of them: of a grid with the last axis running fastest, of a tree leaf by leaf."""
        known = _check.enumerated(form, CoefficientForm, "form")
        with Use(exclusive=(self,)):
            info = described(c.AWDDensityInfo)
            check(lib.awdGetDensityInfo(self._handle, ctypes.byref(info)))
            coefficients = np.empty(info.coefficients)
            check(lib.awdGetDensityCoefficients(self._handle, known, address(coefficients),
                                                coefficients.size))
        return coefficients

    def set_coefficients(self, coefficients: npt.ArrayLike) -> None:
        """Makes p the density of these scaling coefficients (n,), divided by their integral;
        finite, none negative, as many as there are now. Not after samples have been recorded. Exclusive."""
        known = _arrays.packed(coefficients, DOUBLE, (-1,), "coefficients")
        with Use(exclusive=(self,)):
            check(lib.awdSetDensityCoefficients(self._handle, address(known), len(known)))

    def integral(self, lower: Optional[npt.ArrayLike] = None,
                 upper: Optional[npt.ArrayLike] = None) -> float:
        """Of p over the box from lower to upper, (dimensions,) each in [0,1]; None: 0 and 1."""
        low = np.zeros(self._dimensions) if lower is None else lower
        high = np.ones(self._dimensions) if upper is None else upper
        a = _arrays.packed(low, DOUBLE, (self._dimensions,), "lower")
        b = _arrays.packed(high, DOUBLE, (self._dimensions,), "upper")
        integral = ctypes.c_double()
        with Use(shared=(self,)):
            check(lib.awdGetDensityIntegral(self._handle, address(a), address(b),
                                            ctypes.byref(integral)))
        return integral.value

    def leaves(self) -> npt.NDArray[np.float64]:
        """The boxes of a tree's leaves, in the order of their coefficients: (n, 2, dimensions),
        lower and upper ends."""
        return self._counted(lib.awdGetDensityLeaves, (2, self._dimensions))

    def detail_energy(self) -> npt.NDArray[np.float64]:
        """int p^2 split by wavelets, of nested families: that of the coarsest level, then that of
        the details of each rung."""
        return self._counted(lib.awdGetDensityDetailEnergy, ())

    # --- in several processes ---

    def export_statistics(self) -> bytes:
        """What was recorded since the last adapt. Exclusive."""
        return self._bytes(lib.awdExportDensityStatistics)

    def add_statistics(self, data: Any) -> None:
        """Adds what a density of the same bases and boxes has exported. Exclusive."""
        self._take(lib.awdAddDensityStatistics, data)

    def import_statistics(self, data: Any) -> None:
        """Forgets what was recorded and takes this instead. Exclusive."""
        self._take(lib.awdImportDensityStatistics, data)

    def _bytes(self, function: Any) -> bytes:
        with Use(exclusive=(self,)):
            handle = self._handle
            return bytes_of(lambda *room: function(handle, *room))

    def _take(self, function: Any, data: Any) -> None:
        known = buffer_of(data)
        with Use(exclusive=(self,)):
            check(function(self._handle, address(known), known.nbytes))

    def _counted(self, function: Any, shape: tuple[int, ...]) -> npt.NDArray[np.float64]:
        count = ctypes.c_size_t()
        with Use(exclusive=(self,)):  # so that there are as many at the second call
            check(function(self._handle, None, 0, ctypes.byref(count)))
            items = np.empty((count.value, *shape))
            check(function(self._handle, address(items), len(items), ctypes.byref(count)))
        return items


def _axes(axes: Any, dimensions: int) -> Any:
    if isinstance(axes, (str, bytes)) or not hasattr(axes, "__len__"):
        raise TypeError(f"axes is {_check.shown(axes)}: it must be a sequence of awd.Axis")
    if len(axes) != dimensions:
        raise ValueError(f"axes has {len(axes)} items, but there are {dimensions} dimensions")
    made = (c.AWDDensityAxis * dimensions)()
    for i, (to, axis) in enumerate(zip(made, axes)):
        _check.instance(axis, Axis, f"axes[{i}]")
        to.basis = _check.optional_text(axis.basis, f"axes[{i}].basis")
        to.startLevel = _check.level(axis.start_level, f"axes[{i}].start_level")
        to.maxLevel = _check.level(axis.max_level, f"axes[{i}].max_level")
    return made
