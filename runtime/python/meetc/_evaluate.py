"""The values of a formula, such as B and B squared of a meet."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from meetc import _arrays, _native
from meetc._device import Device, faults, require_device, uploaded
from meetc._errors import InputError
from meetc._set import Set
from meetc._types import Floats, Formula


def formulas() -> tuple[Formula, ...]:
    """The formulas that evaluate() knows: those of the shipped scene."""
    return tuple(
        Formula(name, tuple((kind, tuple(numbers.split(","))) for kind, numbers in operands), tuple(values.split(",")))
        for name, operands, values in _native.formulas()
    )


def formula(text: str) -> Formula:
    """The formula with this text, whatever its spaces."""
    wanted = "".join(text.split())
    known = formulas()
    for found in known:
        if "".join(found.name.split()) == wanted:
            return found
    raise InputError(f"formula: {text!r} is unknown; known: {', '.join(f.name for f in known)}", value=text)


def evaluate(
    formula_text: str,
    *operands: Set | ArrayLike | Mapping[str, ArrayLike],
    rows: ArrayLike | None = None,
    dtype: DTypeLike = np.float32,
    threads: int = 0,
    device: Device = "cpu",
) -> dict[str, NDArray[Any]]:
    """The values of a formula, one array for each coefficient: float32, or with dtype=np.float64 double.

    An operand is an array (n, numbers), one object (numbers,) for all, or a mapping of columns; formula(text) names the
    numbers and the values. Without `rows`, value i takes row i of every operand. With rows, (m, operands), value i takes
    row rows[i, k] of operand k. Two operands may be sets; rows are then pairs, as pairs() returns them.
    With device="cuda" they are computed on the device: the same numbers as on a processor with the fused multiply-add.
    """
    found = formula(formula_text)
    threads = _arrays.require_threads(threads)
    type_ = np.dtype(dtype)
    if type_ not in (np.float32, np.float64):
        raise TypeError(f"dtype: values are float32 or float64, not {type_}")
    wide = type_ == np.float64
    if len(operands) != len(found.operands):
        raise InputError(f"{found.name}: it takes {len(found.operands)} operands, and here are {len(operands)}")
    there = require_device(device)
    if any(isinstance(o, Set) for o in operands):
        values = _on_sets(found, operands, rows, wide, threads, there)
    else:
        values = _on_columns(found, operands, rows, wide, threads, there)
    return dict(zip(found.values, values))


def _on_sets(
    found: Formula, operands: tuple[Any, ...], rows: ArrayLike | None, wide: bool, threads: int, there: bool
) -> NDArray[Any]:
    if len(operands) != 2 or not all(isinstance(o, Set) for o in operands):
        raise TypeError(f"{found.name}: where an operand is a set, there are two, and both are sets")
    if rows is None:
        raise TypeError(f"{found.name}: rows: pairs of elements of the two sets are needed, such as pairs(a, b)")
    for (kind, _), operand in zip(found.operands, operands):
        if operand._source.native_kind() != kind:
            raise InputError(f"{found.name}: it takes a {kind}, and the set has elements of kind {operand.kind}")
        if operand._source.owner is not None:
            raise InputError(f"{found.name}: the set's faces are polygons, and a formula takes elements")
    pairs = _rows(rows, 2, [len(o) for o in operands])
    if there:
        with faults():
            return _native.evaluate_pairs_there(found.name, uploaded(operands[0]), uploaded(operands[1]), pairs, wide)
    return _native.evaluate_pairs(found.name, operands[0]._ready, operands[1]._ready, pairs, wide, threads)


def _on_columns(
    found: Formula, operands: tuple[Any, ...], rows: ArrayLike | None, wide: bool, threads: int, there: bool
) -> NDArray[Any]:
    def values(of: list[list[Floats]], at: NDArray[np.uint32] | None) -> NDArray[Any]:
        if there:
            with faults():
                return _native.evaluate_columns_there(found.name, of, at, wide)
        return _native.evaluate_columns(found.name, of, at, wide, threads)

    columns = [_columns(operand, k, names) for k, (operand, (_, names)) in enumerate(zip(operands, found.operands))]
    if rows is not None:
        objects = [len(c[0]) if c[0].ndim else 1 for c in columns]
        shaped = [[np.atleast_1d(x) for x in c] for c in columns]
        return values(shaped, _rows(rows, len(columns), objects))
    lengths = {len(x) for c in columns for x in c if x.ndim}
    if len(lengths) > 1:
        raise InputError(f"{found.name}: the operands have different numbers of rows: {sorted(lengths)}")
    length = lengths.pop() if lengths else 1
    spread = [[np.broadcast_to(x, (length,)) for x in c] for c in columns]
    return values(spread, None)


def _columns(operand: Any, k: int, names: tuple[str, ...]) -> list[Floats]:
    """A column for each number, of one dimension, or of none where it is the same for all objects."""
    called = f"operand {k}"
    if isinstance(operand, Mapping):
        if set(operand) != set(names):
            raise InputError(f"{called}: its columns are {', '.join(operand)}, not {', '.join(names)}", array=called)
        columns = [_arrays.as_array(operand[name], f"{called}: {name}") for name in names]
        for name, column in zip(names, columns):
            if column.ndim > 1:
                raise InputError(f"{called}: {name}: a column has one dimension, not {column.ndim}", array=called)
        if len({len(c) for c in columns if c.ndim}) > 1:
            raise InputError(f"{called}: its columns have different lengths", array=called)
        if any(c.ndim for c in columns):
            length = max(len(c) for c in columns if c.ndim)
            columns = [np.broadcast_to(c, (length,)) for c in columns]
    else:
        array = _arrays.as_array(operand, called)
        if array.ndim not in (1, 2) or array.shape[-1] != len(names):
            raise InputError(
                f"{called}: its shape is {_arrays.shape_text(array.shape)}, not (n, {len(names)}): {', '.join(names)}",
                array=called,
            )
        columns = [array[..., i] for i in range(len(names))]
    return [c if _fits(c) else np.array(c, np.float32) for c in columns]


def _fits(column: NDArray[Any]) -> bool:
    return column.dtype == np.float32 and column.dtype.isnative and all(s % 4 == 0 for s in column.strides)


def _rows(value: ArrayLike, wide: int, objects: list[int]) -> NDArray[np.uint32]:
    array = _arrays.as_array(value, "rows")
    if array.dtype.kind == "f":
        raise TypeError(f"rows: they are integers, not {array.dtype}")
    if array.ndim != 2 or array.shape[1] != wide:
        raise InputError(f"rows: its shape is {_arrays.shape_text(array.shape)}, not (n, {wide})", array="rows")
    bad = (array < 0) | (array >= np.array(objects))
    if bad.any():
        i, k = _arrays.first_where(bad)
        raise IndexError(f"rows[{i}, {k}] is {int(array[i, k])}, and operand {k} has {objects[k]} rows")
    return np.ascontiguousarray(array.astype(np.uint32, copy=False))
