"""Where a mesh crosses itself."""

from __future__ import annotations

from typing import Literal, overload

import numpy as np
from numpy.typing import NDArray

from meetc import _arrays, _native
from meetc._errors import InputError, MeetWarning
from meetc._set import as_set
from meetc._types import Ints, Meshlike


@overload
def self_pairs(
    mesh: Meshlike, *, merge: bool = ..., return_without_area: Literal[False] = ..., threads: int = ...
) -> Ints: ...
@overload
def self_pairs(
    mesh: Meshlike, *, merge: bool = ..., return_without_area: Literal[True], threads: int = ...
) -> tuple[Ints, Ints]: ...
def self_pairs(
    mesh: Meshlike, *, merge: bool = True, return_without_area: bool = False, threads: int = 0
) -> Ints | tuple[Ints, Ints]:
    """The pairs of faces i < j that meet beyond their common corners, (k, 2), sorted: where a mesh crosses itself.

    Corners with equal coordinates are one, or with merge=False those of one index alone, so that sheets that lie on each
    other meet. A face that is there twice is a pair. Faces without area are the segments or points that they are, and their
    pairs count; a MeetWarning names them, or with return_without_area=True they are the second part of the answer. Pairs
    within a polygon that was cut into triangles do not count. Answers are exact for the float32 numbers of the set.
    """
    threads = _arrays.require_threads(threads)
    of = as_set(mesh, "mesh", threads)
    if of.kind != "triangle":
        raise InputError(f"mesh: its elements are of kind {of.kind}, not triangles", array="mesh", value=of.kind)
    source = of._source
    pairs, flat = _native.self_pairs(of._ready, source.numbers, source.corners, source.owner, bool(merge), threads)
    if source.owner is not None:
        pairs = np.unique(source.items_of(pairs), axis=0)
        flat = _whole(flat, source.owner, len(of))
    if return_without_area:
        return pairs, flat
    if len(flat):
        _arrays.warn(f"mesh: {_told(flat)}", MeetWarning)
    return pairs


def _whole(triangles: Ints, owner: NDArray[np.uint32], faces: int) -> Ints:
    """The faces of which all triangles are among these."""
    left = np.bincount(owner, minlength=faces) - np.bincount(owner[triangles], minlength=faces)
    return np.flatnonzero(left == 0).astype(np.int32)


def _told(faces: Ints) -> str:
    some = ", ".join(map(str, faces[:8].tolist())) + (f" and {len(faces) - 8:,} more" if len(faces) > 8 else "")
    if len(faces) == 1:
        return f"1 face has no area: {some}; it is the segment or point that it is"
    return f"{len(faces):,} faces have no area: {some}; they are the segments or points that they are"
