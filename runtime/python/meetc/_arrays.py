"""Turns what a user gives into arrays that the compiled module takes, and names what is wrong with it.

float32 numbers at any positive row stride and int32 or uint32 indices go in as they are. Other numbers are rounded once to
float32, and it is counted how many of them that moves, and how far.
"""

from __future__ import annotations

import sys
import warnings
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from meetc._errors import InputError, MeetWarning, RoundedWarning
from meetc._types import Doubles, Floats, Rounded

NOT_MOVED = Rounded(0, 0.0)
HOSTS = (1, 3, 11)  # DLPack's numbers of memory that the host reads: its own, and that pinned for CUDA and ROCm
MOST = 2**31 - 1  # elements, since -1 stands for none in int32


def shape_text(shape: tuple[int, ...]) -> str:
    return "(" + ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "") + ")"


def _on_device(value: Any) -> bool:
    """Whether an array says by the CUDA array interface, or by DLPack, that the host cannot read it."""
    if hasattr(value, "__array_interface__"):
        return False
    if hasattr(value, "__cuda_array_interface__"):
        return True
    return hasattr(value, "__dlpack_device__") and value.__dlpack_device__()[0] not in HOSTS


def as_array(value: Any, name: str) -> NDArray[Any]:
    """Any array-like as an array of numbers; a device's array is refused rather than copied unseen."""
    if _on_device(value):
        raise TypeError(f"{name}: it lies on a device, and this build has the CPU alone; copy it to the host first")
    by_dlpack = hasattr(value, "__dlpack__") and not hasattr(value, "__array__") and not hasattr(value, "__len__")
    try:
        array = np.from_dlpack(value) if by_dlpack else np.asarray(value)
    except ValueError:
        raise InputError(f"{name}: its rows have different lengths", array=name) from None
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: an array of numbers is needed, not of {array.dtype}")
    return array


def at_row(name: str, index: tuple[int, ...]) -> str:
    return f"{name}[{', '.join(map(str, index))}]"


def first_where(bad: NDArray[np.bool_]) -> tuple[int, ...]:
    return tuple(int(i) for i in np.unravel_index(int(np.argmax(bad)), bad.shape))


def require_finite(array: NDArray[Any], name: str) -> None:
    finite = np.isfinite(array)
    if not finite.all():
        index = first_where(~finite)
        value = float(array[index])
        raise InputError(f"{at_row(name, index)} is {value}", array=name, row=index[0] if index else 0, value=value)


def round_once(array: NDArray[Any], name: str) -> tuple[Floats, Rounded]:
    """The numbers in float32, and what that has moved. They must be finite, before and after."""
    if array.dtype == np.float32:
        return array, NOT_MOVED  # the compiled module finds what is not finite
    require_finite(array, name)
    with np.errstate(over="ignore"):
        small: Floats = array.astype(np.float32, order="C")
    if not np.isfinite(small).all():
        index = first_where(~np.isfinite(small))
        value = float(array[index])
        raise InputError(
            f"{at_row(name, index)} is {value}, beyond float32", array=name, row=index[0] if index else 0, value=value
        )
    if array.dtype.kind in "iu" and (big := (array > 2**53) | (array < -(2**53))).any():
        index = first_where(big)  # the move would not be a double
        value = int(array[index])
        raise InputError(f"{at_row(name, index)} is {value}, beyond 2^53", array=name, row=index[0], value=value)
    moved = small.astype(np.float64) - array.astype(np.float64)
    count = int(np.count_nonzero(moved))
    return small, Rounded(count, float(np.abs(moved).max()) if count else 0.0)


def numbers(value: ArrayLike, name: str, widths: tuple[int, ...]) -> tuple[Floats, Rounded]:
    """Rows of float32. The last of the widths is that of a row; those before it are the shape of a
    row of more dimensions: (3, 3, 9) takes (n, 3, 3) and (n, 9)."""
    array = as_array(value, name)
    wide = widths[-1]
    shapes = [(wide,)] + ([widths[:-1]] if len(widths) > 1 else [])
    if array.size == 0:
        raise InputError(f"{name}: it is empty", array=name)
    if array.ndim == 0 or array.shape[1:] not in shapes:
        wanted = " or ".join("(n, " + ", ".join(map(str, s)) + ")" for s in reversed(shapes))
        raise InputError(f"{name}: its shape is {shape_text(array.shape)}, not {wanted}", array=name)
    if array.shape[0] > MOST:
        raise InputError(f"{name}: it has {array.shape[0]} rows, more than 2^31 - 1", array=name)
    small, rounded = round_once(array, name)
    if not small.dtype.isnative:
        small = small.astype(np.float32)
    if small.ndim == 3:
        small = small.reshape(small.shape[0], wide)
    if small.strides[1] != 4 or (small.shape[0] > 1 and small.strides[0] < 4 * wide):
        small = np.ascontiguousarray(small)
    return small, rounded


def indices(value: ArrayLike, name: str, wide: int, below: int, of: str) -> NDArray[Any]:
    """(n, wide) of int32 or uint32, each from 0 to below - 1. Others are checked, then copied."""
    array = as_array(value, name)
    if array.size == 0:
        raise InputError(f"{name}: it is empty", array=name)
    if array.dtype.kind == "f":
        raise TypeError(f"{name}: indices are integers, not {array.dtype}")
    if array.ndim != 2 or array.shape[1] != wide:
        raise InputError(f"{name}: its shape is {shape_text(array.shape)}, not (n, {wide})", array=name)
    if array.shape[0] > MOST:
        raise InputError(f"{name}: it has {array.shape[0]} rows, more than 2^31 - 1", array=name)
    if int(array.min()) < 0 or int(array.max()) >= below:
        index = first_where((array < 0) | (array >= below))
        found = int(array[index])
        why = "an index is at least 0" if found < 0 else f"{of} has {below} rows"
        raise InputError(
            f"{at_row(name, index)} is {found}, and {why}", array=name, row=index[0], element=index[0], value=found
        )
    if array.dtype.itemsize != 4 or not array.dtype.isnative:
        array = array.astype(np.uint32)
    return np.ascontiguousarray(array)


def warn(text: str, category: type[MeetWarning]) -> None:
    """Warns in the name of the line that called the package."""
    frame, level = sys._getframe(1), 2
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] == "meetc":
        frame, level = frame.f_back, level + 1
    warnings.warn(text, category, stacklevel=level)


def tell_rounding(rounded: Rounded, of: str, numbers: int) -> None:
    """Warns where rounding has moved a number."""
    if rounded.numbers:
        moved = f"float32 moved {rounded.numbers} of {numbers} numbers, by at most {rounded.largest:.3g}"
        warn(f"{of}: {moved}", RoundedWarning)


def together(*parts: Rounded) -> Rounded:
    return Rounded(sum(p.numbers for p in parts), max(p.largest for p in parts))


def poses(value: ArrayLike, name: str, several: bool) -> Doubles:
    """(n, 12) doubles of matrices 4x4 or 3x4, row by row; one matrix where not `several`."""
    array = as_array(value, name)
    if array.shape[-2:] not in ((4, 4), (3, 4)) or array.ndim != 2 + several:
        lead = "n, " if several else ""
        raise InputError(
            f"{name}: its shape is {shape_text(array.shape)}, not ({lead}4, 4) or ({lead}3, 4)", array=name
        )
    matrices: Doubles = array.astype(np.float64)
    require_finite(matrices, name)
    if not several:
        matrices = matrices[np.newaxis]

    def refuse(bad: NDArray[np.bool_], why: str, row: int | None) -> None:
        if bad.any():
            at = int(np.argmax(bad))
            index = ((at,) if several else ()) + (() if row is None else (row,))
            place = at_row(name, index) if index else name
            found = matrices[at] if row is None else matrices[at, row]
            raise InputError(f"{place} {why.format(found.tolist())}", array=name, row=at if several else row, value=found)

    if matrices.shape[1] == 4:
        refuse((matrices[:, 3] != (0, 0, 0, 1)).any(axis=1), "is {}, and the last row of a pose is [0, 0, 0, 1]", 3)
    linear = matrices[:, :3, :3]
    size = np.abs(linear).max(axis=(1, 2), initial=0)
    scaled = linear / np.where(size > 0, size, 1)[:, np.newaxis, np.newaxis]
    refuse(np.linalg.det(scaled) == 0, "is no motion: it flattens space, as its determinant is 0", None)
    return np.ascontiguousarray(matrices[:, :3].reshape(-1, 12))


def require_threads(threads: int) -> int:
    if isinstance(threads, bool) or not isinstance(threads, (int, np.integer)):
        raise TypeError(f"threads: a whole number is needed, not {type(threads).__name__}")
    if threads < 0:
        raise InputError(f"threads: {threads} is negative; 0 means all cores", value=int(threads))
    return min(int(threads), 2**20)  # the library takes fewer
