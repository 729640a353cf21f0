"""Where the elements of two sets meet: points, segments and polygons, and the polylines and patches that they make."""

from __future__ import annotations

import operator
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from meetc import _native
from meetc._asked import Asked, ask
from meetc._errors import InputError
from meetc._types import Bools, Floats, Ints, Longs, Meshlike


@dataclass(frozen=True, eq=False, repr=False)
class Lines:
    """Lists of nodes, one after another. List i, lines[i], is nodes[offsets[i]:offsets[i + 1]].

    A node is a row of Contacts.points, so that points[lines[i]] has the coordinates.
    """

    offsets: Longs  #: (n + 1,)
    nodes: Ints  #: rows of Contacts.points
    closed: Bools  #: (n,): whether the first node follows the last one. It is not repeated

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __getitem__(self, i: int) -> Ints:
        at = operator.index(i)
        if not -len(self) <= at < len(self):
            raise IndexError(f"there is no list {at}; there are {len(self)}")
        begin, end = self.offsets[at % len(self) :][:2]
        return self.nodes[begin:end]

    def __iter__(self) -> Iterator[Ints]:
        return (self[i] for i in range(len(self)))

    def __repr__(self) -> str:
        return f"<meetc.Lines: {len(self):,} of {len(self.nodes):,} nodes, {int(self.closed.sum()):,} closed>"


@dataclass(frozen=True, eq=False, repr=False)
class Contacts:
    """Where pairs of triangles, or of segments and triangles, meet.

    Corners of a contact are named by the vertices, edges and faces on which they lie; corners of one name are one node, a row
    of `points`. Names, codes and their order are exact. Each coordinate is the exact one, rounded once, to the nearest number
    and of two to the even one; exact(i) has it as fractions. Where a mesh crosses itself, several nodes may be one point.
    """

    pairs: Ints  #: (k, 2): elements of a and b, sorted: triangles, also where a face was cut into several
    faces: Ints  #: (k, 2): the same as pairs() names them, which are the faces
    codes: NDArray[np.uint64]  #: (k,): which parts of both elements meet; of a segment and a triangle in this order
    offsets: Longs  #: (k + 1,): the nodes of pair i are corners[offsets[i]:offsets[i + 1]]
    corners: Ints  #: nodes: one is a point, two are a segment, three to six a polygon
    points: NDArray[Any]  #: (n, 3): x, y, z of each node, in double, or in float32 where it is asked for
    on_a: NDArray[Any]  #: (n,): the part of a on which a node lies: element, dimension (0 vertex, 1 edge, 2 face), carrier
    on_b: NDArray[Any]  #: (n,): the same of b
    pieces: Ints  #: (m, 2): segments of two nodes, none twice
    patch_pairs: Ints  #: for each patch the row of `pairs` that overlaps there
    single_nodes: Ints  #: nodes on no piece and no patch
    _lines: Lines = field(repr=False)
    _patches: Lines = field(repr=False)
    _rows: tuple[Floats, Floats] = field(repr=False)
    _sources: Ints = field(repr=False)

    @property
    def shape(self) -> NDArray[np.uint8]:
        """(k,): what each pair has in common: 1 a point, 2 a segment, 3 a polygon."""
        dimension = (self.codes >> np.uint64(3)) & np.uint64(3)
        return np.where(self.codes == 0, 0, dimension + np.uint64(1)).astype(np.uint8)

    @property
    def coplanar(self) -> Bools:
        """(k,): whether the pair lies in one plane."""
        flat: Bools = (self.codes >> np.uint64(5)) & np.uint64(1) == 1
        return flat

    def lines(self) -> Lines:
        """The polylines that the pieces make: chains between ends and branch points, and loops, which are closed."""
        return self._lines

    def patches(self) -> Lines:
        """The polygons in which pairs in one plane overlap, counter-clockwise from the tip of a's normal."""
        return self._patches

    def exact(self, i: int) -> tuple[Fraction, Fraction, Fraction]:
        """The coordinates of point i as fractions."""
        at = operator.index(i)
        if not -len(self.points) <= at < len(self.points):
            raise IndexError(f"exact: there is no point {at}; there are {len(self.points)}")
        return exact_point(self._rows, self._sources[at])

    def __len__(self) -> int:
        """The number of pairs."""
        return len(self.pairs)

    def _counts(self) -> list[tuple[str, str]]:
        lines, closed = len(self._lines), int(self._lines.closed.sum())
        return [
            ("pairs", f"{len(self):,}"),
            ("points", f"{len(self.points):,} in {self.points.dtype}"),
            ("lines", f"{lines:,}, {closed:,} closed"),
            ("patches", f"{len(self._patches):,}"),
        ]

    def __repr__(self) -> str:
        sizes = (len(self), len(self.points), len(self._lines), len(self._patches))
        nouns = (("pair", "s"), ("point", "s"), ("line", "s"), ("patch", "es"))
        text = ", ".join(f"{n:,} {noun}{'' if n == 1 else more}" for n, (noun, more) in zip(sizes, nouns))
        return f"<meetc.Contacts: {text}>"

    def _repr_html_(self) -> str:
        cells = "".join(f"<tr><th>{name}</th><td>{value}</td></tr>" for name, value in self._counts())
        return f"<table><caption>meetc.Contacts</caption>{cells}</table>"


def contacts(a: Meshlike, b: Meshlike, *, dtype: DTypeLike = np.float64, threads: int = 0) -> Contacts:
    """Where each pair of triangles, or of a segment and a triangle, meets: a point, a segment or a polygon.

    Pairs are those of pairs(a, b), exact for the float32 numbers of the sets. Points are doubles, or with dtype=np.float32
    floats. Depths and normals are not invented.

        found = meetc.contacts(a, b)
        for line in found.lines():
            found.points[line]               # (n, 3)
    """
    type_ = np.dtype(dtype)
    if type_ not in (np.float32, np.float64):
        raise TypeError(f"dtype: points are float32 or float64, not {type_}")
    asked = ask(a, b, "certified", threads)
    if not asked.meets:
        raise InputError(
            f"contacts: it is asked of triangles, or of segments and triangles, not of {asked.a.kind} and {asked.b.kind}"
        )
    pairs = asked.of_elements().question().pairs(False)
    if asked.turned:
        pairs = pairs[np.lexsort((pairs[:, 0], pairs[:, 1]))]
    found = contacts_of(asked, pairs, type_ == np.float64)
    sides = ("on_b", "on_a") if asked.turned else ("on_a", "on_b")
    named = np.ascontiguousarray(pairs[:, ::-1]) if asked.turned else pairs
    offsets, corners = found["corners"]
    lines, line_nodes = found["polylines"]
    patches, patch_nodes = found["patches"]
    return Contacts(
        pairs=named,
        faces=_items(named, asked),
        codes=found["codes"],
        offsets=offsets,
        corners=corners,
        points=found["points"],
        on_a=found[sides[0]],
        on_b=found[sides[1]],
        pieces=found["pieces"],
        patch_pairs=found["patch_pairs"],
        single_nodes=found["single_nodes"],
        _lines=Lines(lines, line_nodes, found["closed"]),
        _patches=Lines(patches, patch_nodes, np.ones(len(patches) - 1, np.bool_)),
        _rows=found["rows"],
        _sources=found["sources"],
    )


def contacts_of(asked: Asked, pairs: Ints, wide: bool) -> dict[str, Any]:
    """The contacts of pairs of elements, in the order of the predicate's kinds."""
    first, second = asked.in_order()
    return _native.contacts(first._as_arrays(), second._as_arrays(), asked.predicate, pairs, wide, asked.threads)


def exact_point(rows: tuple[Floats, Floats], source: Ints) -> tuple[Fraction, Fraction, Fraction]:
    """The point of a node, from the rows of elements and the node's source: two rows and a label."""
    a, b, label = source.tolist()
    x, y, z = (Fraction(int(above), int(below)) for above, below in _native.exact_point(rows[0][a], rows[1][b], label))
    return x, y, z


def _items(pairs: Ints, asked: Asked) -> Ints:
    if asked.a._source.owner is None and asked.b._source.owner is None:
        return pairs
    return np.stack([asked.a._source.items_of(pairs[:, 0]), asked.b._source.items_of(pairs[:, 1])], axis=1)
