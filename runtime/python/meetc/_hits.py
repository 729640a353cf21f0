"""The triangles that segments and rays meet, and the points in which they do."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Literal, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from meetc._asked import Asked, ask
from meetc._contacts import contacts_of, exact_point
from meetc._device import Collidable, Device, DeviceSet, elements_there, question, require_device
from meetc._errors import InputError
from meetc._set import Set
from meetc._types import Doubles, Ints, Kind, Meshlike, Precision


class HitPoints(NamedTuple):
    """The points in which segments meet triangles, by segment, and for each in the order along it."""

    points: Doubles  #: (k, 3), each coordinate the exact one, rounded once
    segments: Ints  #: (k,)
    triangles: Ints  #: (k,): of several triangles at one point, the one with the least number


def _ask(what: str, segments: object, mesh: object, precision: str, threads: int) -> Asked:
    asked = ask(segments, mesh, precision, threads)
    _require_kinds(what, [asked.a.kind, asked.b.kind])
    if asked.a._source.owner is not None:
        raise InputError(f"{what}: the segments are parts of polylines, which have no first triangle", array="segments")
    return asked


def _require_kinds(what: str, kinds: list[Kind]) -> None:
    if kinds != ["segment", "triangle"]:
        raise InputError(f"{what}: it is asked of segments and triangles, not of {kinds[0]} and {kinds[1]}")


@overload
def first(
    segments: Set | DeviceSet,
    mesh: Collidable,
    *,
    points: Literal[False] = ...,
    precision: Precision = ...,
    threads: int = ...,
    device: Device = ...,
) -> Ints: ...
@overload
def first(
    segments: Set,
    mesh: Meshlike,
    *,
    points: Literal[True],
    precision: Precision = ...,
    threads: int = ...,
    device: Device = ...,
) -> tuple[Ints, Doubles]: ...
def first(
    segments: Set | DeviceSet,
    mesh: Collidable,
    *,
    points: bool = False,
    precision: Precision = "certified",
    threads: int = 0,
    device: Device = "cpu",
) -> Ints | tuple[Ints, Doubles]:
    """For each segment the triangle that it meets first on its way from start to end, -1 for none: (n,).

    Of triangles that it meets at one point, it is the one with the least number. Set.rays makes segments of rays. With
    points=True the answer is a tuple: the triangles, and the points at which they are met, (n, 3), each coordinate the exact
    one, rounded once to double, and NaN where there is none. With device="cuda", or a DeviceSet, triangles are found on the
    device; points are the host's.
    """
    if isinstance(segments, DeviceSet) or isinstance(mesh, DeviceSet):
        if points:
            raise TypeError("first: points are found of sets whose arrays lie on the host")
        kinds = [of.kind if isinstance(of, (Set, DeviceSet)) else "triangle" for of in (segments, mesh)]
        _require_kinds("first", kinds)
        return question(segments, mesh, precision, threads, "cuda")[0].first()
    on_device = require_device(device)
    asked = _ask("first", segments, mesh, precision, threads)
    if not points:
        return question(asked.a, asked.b, precision, threads, device)[0].first()
    triangles = elements_there(asked).first() if on_device else asked.of_elements().question().first()
    met = np.flatnonzero(triangles >= 0).astype(np.int32)
    found = contacts_of(asked, np.stack([met, triangles[met]], axis=1), True)
    offsets, corners = found["corners"]
    there = np.flatnonzero(np.diff(offsets))  # a plain precision may name a triangle that is not met
    out = np.full((len(triangles), 3), np.nan)
    out[met[there]] = found["points"][corners[offsets[there]]]
    triangles[met] = asked.b._source.items_of(triangles[met])
    return triangles, out


def hit_points(segments: Set, mesh: Meshlike, *, threads: int = 0) -> HitPoints:
    """All points in which segments meet triangles, as trimesh.ray's intersects_location has them.

        points, segment, triangle = meetc.hit_points(meetc.Set.rays(origins, directions, through=mesh), mesh)

    A point in which a segment meets several triangles, as on their common edge, is there once. Where a segment lies in a
    triangle's plane, both ends of what they have in common are there. Points of a segment are in the order along it.
    """
    asked = _ask("hit_points", segments, mesh, "certified", threads)
    pairs = asked.of_elements().question().pairs(False)
    found = contacts_of(asked, pairs, True)
    offsets, nodes = found["corners"]
    of_pair = np.repeat(np.arange(len(pairs)), np.diff(offsets))
    segment, triangle = pairs[of_pair, 0], pairs[of_pair, 1]

    # The least triangle of each segment's corners of one name: the sort is stable, and triangles rise.
    order = np.lexsort((nodes, segment))
    order = order[_begins(segment[order], nodes[order])]
    segment, triangle, nodes = segment[order], triangle[order], nodes[order]

    # Each coordinate rises or falls along a segment, and so do the rounded ones.
    rows = found["rows"][0].astype(np.float64)
    way = np.sign(rows[:, 3:] - rows[:, :3])[np.searchsorted(np.unique(pairs[:, 0]), segment)]
    x, y, z = (found["points"][nodes] * way).T
    order = np.lexsort((triangle, z, y, x, segment))
    segment, triangle, nodes = segment[order], triangle[order], nodes[order]
    points: Doubles = found["points"][nodes]
    kept = _distinct(segment, triangle, nodes, points, way[order], found)
    return HitPoints(points[kept], segment[kept], asked.b._source.items_of(triangle[kept]))


def _begins(*keys: NDArray[Any]) -> NDArray[np.intp]:
    """The first rows of runs of equal keys."""
    new = np.zeros(len(keys[0]), np.bool_)
    new[:1] = True
    for key in keys:
        new[1:] |= key[1:] != key[:-1]
    return np.flatnonzero(new)


def _distinct(
    segment: Ints, triangle: Ints, nodes: Ints, points: Doubles, way: Doubles, found: dict[str, Any]
) -> NDArray[np.intp]:
    """The rows of distinct points, in their order. Rounded points that are equal need not be, and are compared as fractions."""
    begins = _begins(segment, *points.T)
    sizes = np.diff(np.append(begins, len(segment)))
    several = np.flatnonzero(sizes > 1)
    rows, runs = begins[sizes == 1].tolist(), np.flatnonzero(sizes == 1).tolist()
    for run in several.tolist():
        begin = int(begins[run])
        signs = [int(sign) for sign in way[begin]]
        at: dict[tuple[Fraction, ...], int] = {}  # the first row of each point, which has the least triangle
        for row in range(begin, begin + int(sizes[run])):
            exact = exact_point(found["rows"], found["sources"][nodes[row]])
            at.setdefault(tuple(x * sign for x, sign in zip(exact, signs)), row)
        rows += [at[place] for place in sorted(at)]
        runs += [run] * len(at)
    return np.array(rows, np.intp)[np.argsort(runs, kind="stable")]
