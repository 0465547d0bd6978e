# SPDX-License-Identifier: Apache-2.0
"""Films, densities and error curves as matplotlib shows them.

matplotlib is not needed by the rest of the package. Every function draws into `ax`, or into new
axes of a new figure, and returns the axes: ax.figure.savefig(path), or matplotlib.pyplot.show().
"""
import importlib
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _check
from ._arrays import DOUBLE, FLOAT, as_array, packed, shaped
from ._field import Field
from ._render import Render


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    try:
        pyplot = importlib.import_module("matplotlib.pyplot")
    except ImportError as error:
        raise ImportError("awd.plot wants matplotlib: apt-get install python3-matplotlib, or "
                          "pip install matplotlib") from error
    return pyplot.subplots()[1]


def srgb(film: npt.ArrayLike, exposure: float = 0.0) -> npt.NDArray[np.float64]:
    """Linear radiance (height, width, 3) as sRGB from 0 to 1, times 2^exposure and clipped; what is
    not a number is black."""
    given = shaped(as_array(film, FLOAT, "film"), (-1, -1, 3), "film")
    with np.errstate(over="ignore", invalid="ignore"):
        linear = given.astype(np.float64) * np.exp2(_check.number(exposure, "exposure"))
    linear = np.clip(np.nan_to_num(linear, nan=0.0, posinf=1.0), 0.0, 1.0)
    low, high = 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055
    return np.where(linear <= 0.0031308, low, high)


def show_film(film: Union[Render, npt.ArrayLike], exposure: float = 0.0, ax: Any = None) -> Any:
    """A render's film, or an array (height, width, 3) of linear RGB, in `exposure` stops."""
    pixels = srgb(film.film() if isinstance(film, Render) else film, exposure)
    ax = _axes(ax)
    ax.imshow(pixels, interpolation="nearest")
    ax.set_axis_off()
    return ax


def hemisphere(n: int) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.bool_]]:
    """Directions over the disk that an equal-area map makes of the hemisphere about z: (n, n, 3),
    x to the right and y upwards, and which of the n x n are within it, (n, n)."""
    n = _check.integer(n, "n", 4096, 2)
    middle = (np.arange(n) + 0.5) * (2.0 / n) - 1.0
    x, y = np.meshgrid(middle, -middle)
    square = x * x + y * y  # = 1 - cos(theta)
    inside = square < 1.0
    cosine = np.where(inside, 1.0 - square, 1.0)
    # sin(theta) = r sqrt(1 + cos(theta)) with r = sqrt(1 - cos(theta))
    scale = np.where(inside, np.sqrt(1.0 + cosine), 0.0)
    directions = np.stack([x * scale, y * scale, cosine], -1)
    return directions.astype(np.float32), inside


def pdf_on_hemisphere(field: Field, patch: int, n: int = 256,
                      normal: _check.Vector = (0.0, 0.0, 1.0)) -> npt.NDArray[np.float32]:
    """A patch's pdf in solid angle, 1/sr, over the disk of hemisphere(n) about the normal: (n, n),
    NaN outside of it. The disk's right and up are the tangents that rotate with the normal from x
    and y at normal z."""
    _check.instance(field, Field, "field")
    directions, inside = hemisphere(n)
    known = np.array(_check.vector(normal, "normal"))
    length = np.linalg.norm(known)
    if not 0.0 < length < np.inf:
        raise ValueError(f"normal is {tuple(known)}: it must have a direction")
    known /= length
    turned = (directions[inside].astype(np.float64) @ _rotation(known)).astype(np.float32)
    pdfs = np.full(inside.shape, np.nan, np.float32)
    pdfs[inside] = field.pdf(patch, known, turned)
    return pdfs


def _rotation(normal: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Rows: what x, y and z become by the rotation that takes z to the normal."""
    x, y, z = normal
    if z < -0.999999:
        return np.diag([1.0, -1.0, -1.0])
    a = 1.0 / (1.0 + z)
    return np.array([[1.0 - x * x * a, -x * y * a, -x], [-x * y * a, 1.0 - y * y * a, -y],
                     [x, y, z]])


def show_pdf(field: Field, patch: int, n: int = 256, normal: _check.Vector = (0.0, 0.0, 1.0),
             ax: Any = None) -> Any:
    """A patch's pdf on the hemisphere, as a disk in which equal areas are equal solid angles: the
    normal in the middle, the horizon at the rim; see pdf_on_hemisphere()."""
    pdfs = pdf_on_hemisphere(field, patch, n, normal)
    ax = _axes(ax)
    image = ax.imshow(pdfs, extent=(-1.0, 1.0, -1.0, 1.0), vmin=0.0, interpolation="nearest")
    ax.figure.colorbar(image, ax=ax, label="pdf, 1/sr")
    ax.set_axis_off()
    return ax


def show_error(samples: npt.ArrayLike, errors: npt.ArrayLike, label: Optional[str] = None,
               ax: Any = None) -> Any:
    """Errors (n,) over samples or seconds (n,), both on logarithmic axes, and from the first point
    on the slope -1/2 of independent samples."""
    x = packed(samples, DOUBLE, (-1,), "samples")
    y = packed(errors, DOUBLE, x.shape, "errors")
    ax = _axes(ax)
    ax.loglog(x, y, marker="o", label=label)
    good = (x > 0.0) & (y > 0.0) & np.isfinite(x) & np.isfinite(y)
    if good.any():
        first, ends = np.argmax(good), np.array([x[good].min(), x[good].max()])
        ax.loglog(ends, y[first] * np.sqrt(x[first] / ends), color="grey", linewidth=0.8,
                  linestyle="--")
    ax.set_xlabel("samples")
    ax.set_ylabel("error")
    if label is not None:
        ax.legend()
    return ax
