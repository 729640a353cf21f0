"""Where the elements of two sets meet: points, segments and polygons, and the polylines and patches that they make."""

from __future__ import annotations

import operator
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt
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


@dataclass(frozen=True)
class Root:
    """rational + factor * sqrt(radicand): a coordinate where a segment meets a sphere."""

    rational: Fraction
    factor: Fraction
    radicand: int

    def __float__(self) -> float:
        """Right up to 2**-1200 before it is rounded."""
        square = self.factor**2 * self.radicand
        size = Fraction(isqrt((square.numerator << 2400) // square.denominator), 1 << 1200)
        return float(self.rational + (size if self.factor > 0 else -size))


@dataclass(frozen=True, eq=False, repr=False)
class Contacts:
    """Where pairs of triangles, of segments and triangles, or of spheres and segments, meet; witnesses of other spheres.

    Corners of a contact are named by the vertices, edges and faces on which they lie; corners of one name are one node, a row
    of `points`. Names, codes and their order are exact. Each coordinate is the exact one, rounded once, to the nearest number
    and of two to the even one; exact(i) has it as a fraction, or on a sphere as a Root. Where a mesh is not embedded, several
    nodes may be one point. A sphere with a sphere or a triangle has a witness: one point that lies on both, up to 2**-46 of
    the sum of their radii and of the greatest difference of their coordinates along each axis, before it is rounded.
    """

    pairs: Ints  #: (k, 2): elements of a and b, sorted: triangles, also where a face was cut into several
    faces: Ints  #: (k, 2): the same as pairs() names them, which are the faces
    codes: NDArray[np.uint64]  #: (k,): which parts of both elements meet; of a segment and a triangle in this order
    offsets: Longs  #: (k + 1,): the nodes of pair i are corners[offsets[i]:offsets[i + 1]]
    corners: Ints  #: nodes: one is a point, two are a segment, three to six a polygon
    points: NDArray[Any]  #: (n, 3): x, y, z of each node, in double, or in float32 where it is asked for
    on_a: NDArray[Any]  #: (n,): where on a a node lies: element, dimension (0 vertex, 1 edge, 2 face, 3 in a ball), carrier
    on_b: NDArray[Any]  #: (n,): the same of b
    pieces: Ints  #: (m, 2): segments of two nodes, none twice
    patch_pairs: Ints  #: for each patch the row of `pairs` that overlaps there
    single_nodes: Ints  #: nodes on no piece and no patch
    witness_pairs: Ints  #: (w,): rows of `pairs`, each of which has a witness
    witnesses: NDArray[Any]  #: (w, 3)
    embedded: bool | None  #: with check_embedded: whether both meshes are embedded, so that no two nodes are one point
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

    def exact(self, i: int) -> tuple[Fraction | Root, Fraction | Root, Fraction | Root]:
        """The coordinates of point i: fractions, or roots where a segment meets a sphere."""
        at = operator.index(i)
        if not -len(self.points) <= at < len(self.points):
            raise IndexError(f"exact: there is no point {at}; there are {len(self.points)}")
        x, y, z = map(_exact, exact_words(self._rows, self._sources[at]))
        return x, y, z

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
            *([("witnesses", f"{len(self.witnesses):,}")] if len(self.witnesses) else []),
            *([("embedded", "yes" if self.embedded else "no")] if self.embedded is not None else []),
        ]

    def __repr__(self) -> str:
        parts = [(len(self), "pair", "s"), (len(self.points), "point", "s"), (len(self._lines), "line", "s")]
        parts.append((len(self._patches), "patch", "es"))
        if len(self.witnesses):
            parts[1:] = [(len(self.witnesses), "witness", "es")]
        text = ", ".join(f"{n:,} {noun}{'' if n == 1 else more}" for n, noun, more in parts)
        return f"<meetc.Contacts: {text}>"

    def _repr_html_(self) -> str:
        cells = "".join(f"<tr><th>{name}</th><td>{value}</td></tr>" for name, value in self._counts())
        return f"<table><caption>meetc.Contacts</caption>{cells}</table>"


def contacts(
    a: Meshlike, b: Meshlike, *, dtype: DTypeLike = np.float64, check_embedded: bool = False, threads: int = 0
) -> Contacts:
    """Where each pair of triangles, of a segment and a triangle, or of a sphere and a segment, meets.

    That is a point, two points, a segment or a polygon. A sphere with a sphere or a triangle has a witness, one point. Pairs are
    those of pairs(a, b), exact for the float32 numbers of the sets. Points are doubles, or with dtype=np.float32 floats; a
    witness beyond their range is infinite. With check_embedded, the answer also tells of two meshes whether both are embedded:
    whether self_pairs() finds nothing in them, and all their faces have area. Depths and normals are not invented.

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
            f"contacts: it is asked of two meshes, of segments and a mesh, or of spheres with spheres, segments or a mesh, "
            f"not of {asked.a.kind} and {asked.b.kind}"
        )
    if check_embedded and (asked.a.kind, asked.b.kind) != ("triangle", "triangle"):
        raise InputError(f"check_embedded: it is asked of two meshes, not of {asked.a.kind} and {asked.b.kind}")
    pairs = asked.of_elements().question().pairs(False)
    if asked.turned:
        pairs = pairs[np.lexsort((pairs[:, 0], pairs[:, 1]))]
    found = contacts_of(asked, pairs, type_ == np.float64, bool(check_embedded))
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
        witness_pairs=found["witness_pairs"],
        witnesses=found["witnesses"],
        embedded=found["embedded"],
        _lines=Lines(lines, line_nodes, found["closed"]),
        _patches=Lines(patches, patch_nodes, np.ones(len(patches) - 1, np.bool_)),
        _rows=found["rows"],
        _sources=found["sources"],
    )


def contacts_of(asked: Asked, pairs: Ints, wide: bool, embedded: bool = False) -> dict[str, Any]:
    """The contacts of pairs of elements, in the order of the predicate's kinds."""
    first, second = asked.in_order()
    return _native.contacts(
        first._as_arrays(), second._as_arrays(), asked.predicate, pairs, wide, embedded, asked.threads
    )


def exact_words(rows: tuple[Floats, Floats], source: Ints) -> list[list[str]]:
    """Numerator, denominator, root and radicand of the coordinates of a node.

    The node is told by the rows of elements and its source: two rows and a label.
    """
    a, b, label = source.tolist()
    return _native.exact_point(rows[0][a], rows[1][b], label)


def exact_point(rows: tuple[Floats, Floats], source: Ints) -> tuple[Fraction, Fraction, Fraction]:
    """The point of a node of segments and triangles."""
    x, y, z = (Fraction(int(above), int(below)) for above, below, _, _ in exact_words(rows, source))
    return x, y, z


def _exact(words: list[str]) -> Fraction | Root:
    above, below, root, radicand = map(int, words)
    rational = Fraction(above, below)
    return Root(rational, Fraction(root, below), radicand) if root else rational


def _items(pairs: Ints, asked: Asked) -> Ints:
    if asked.a._source.owner is None and asked.b._source.owner is None:
        return pairs
    return np.stack([asked.a._source.items_of(pairs[:, 0]), asked.b._source.items_of(pairs[:, 1])], axis=1)
