"""Faces as one flat array, the number of corners before each face, as VTK and PyVista have them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from meetc import _arrays, _native
from meetc._errors import InputError
from meetc._types import Floats


class Triangles(NamedTuple):
    corners: NDArray[Any]
    owner: NDArray[np.uint32] | None  # the face of each triangle, where one was cut
    faces: int
    notes: tuple[str, ...]


def triangles_of(faces: NDArray[Any], vertices: Floats, threads: int) -> Triangles:
    """The triangles of flat faces. Faces with more corners are cut as `meet collide` cuts those of a file."""
    if faces.size == 0:
        raise InputError("faces: it is empty", array="faces")
    if faces.dtype.kind == "f":
        raise TypeError(f"faces: indices are integers, not {faces.dtype}")
    starts, counts = _parts(faces)
    is_corner = np.ones(len(faces), np.bool_)
    is_corner[starts] = False
    corners = faces[is_corner]
    if int(corners.min()) < 0 or int(corners.max()) >= len(vertices):
        raise _wrong(faces, np.flatnonzero(is_corner)[(corners < 0) | (corners >= len(vertices))][0], len(vertices))
    if (counts == 3).all():
        return Triangles(np.ascontiguousarray(corners.reshape(-1, 3).astype(np.uint32)), None, len(counts), ())
    _require_finite(vertices, corners, counts)
    found, owner, notes = _native.cut_polygons(
        np.ascontiguousarray(vertices), corners.astype(np.uint32), counts.astype(np.uint32), threads
    )
    return Triangles(found, owner, len(counts), tuple(f"faces: {note}" for note in notes))


def _parts(faces: NDArray[Any]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The places of the counts, and the counts."""
    flat = np.ascontiguousarray(faces, np.int64)
    places = _native.polygon_starts(flat, 3)
    starts, at = places[:-1], int(places[-1])
    if at < len(faces):
        found, left = int(faces[at]), len(faces) - at - 1
        why = "a face has 3 corners or more" if found < 3 else f"{left} numbers follow it"
        raise InputError(f"faces[{at}] is {found}, and {why}", array="faces", row=at, value=found)
    return starts, flat[starts]


def _wrong(faces: NDArray[Any], at: np.intp, below: int) -> InputError:
    found = int(faces[at])
    why = "an index is at least 0" if found < 0 else f"vertices has {below} rows"
    return InputError(f"faces[{at}] is {found}, and {why}", array="faces", row=int(at), value=found)


def _require_finite(vertices: Floats, corners: NDArray[Any], counts: NDArray[np.int64]) -> None:
    bad = ~np.isfinite(vertices).all(axis=1)[corners]
    if bad.any():
        corner = int(np.argmax(bad))
        row, face = int(corners[corner]), int(np.searchsorted(np.cumsum(counts), corner, side="right"))
        k = int(np.argmin(np.isfinite(vertices[row])))
        value = float(vertices[row, k])
        text = f"vertices[{row}, {k}] is {value} (a corner of face {face})"
        raise InputError(text, array="vertices", row=row, element=face, value=value)
