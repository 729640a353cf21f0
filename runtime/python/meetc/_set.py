"""The class Set."""

from __future__ import annotations

import html
import os
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from meetc import _arrays, _native
from meetc._errors import InputError, MeetWarning
from meetc._polygons import triangles_of
from meetc._source import WIDTHS, Source, is_mesh, mesh_of
from meetc._types import Doubles, Floats, HasFaces, HasPoints, Kind, Meshlike, Rounded

class Set:
    """Elements of one kind, ready to collide: the triangles of a mesh, segments, points, spheres or boxes.

    Set(vertices, faces)             a mesh: float (n, 3), int (m, 3)
    Set(mesh)                        an object with vertices and faces (trimesh) or points and faces (PyVista)
    Set(corners)                     triangles by themselves: (m, 3, 3) or (m, 9)
    Set(points, edges, kind="segment")
    Set.segments(start, end), Set.rays(origins, directions, through=mesh), Set.points(points),
    Set.spheres(centres, radii), Set.boxes(low, high), Set.read("file.ply")

    float32 rows of any positive stride, and int32 or uint32 indices, are read where they lie. Other numbers are copied:
    doubles are rounded once to float32, which `rounded` and a RoundedWarning tell of, and answers are exact for the
    rounded numbers. The set keeps the arrays for at() and for pickling, so do not write to them.

    `pose` is a matrix 4x4 or 3x4 that is applied in double, and rounded once. A set never changes, and several threads
    may collide it at once.
    """

    __slots__ = ("__weakref__", "_pose", "_ready", "_source", "_unposed", "name")

    _source: Source
    _ready: _native.Prepared
    _pose: Doubles | None
    _unposed: Set | None
    name: str | None  #: a name for messages and pages

    def __init__(
        self,
        vertices: ArrayLike | HasFaces | HasPoints,
        faces: ArrayLike | None = None,
        *,
        kind: Kind = "triangle",
        pose: ArrayLike | None = None,
        threads: int = 0,
        name: str | None = None,
    ) -> None:
        if kind not in WIDTHS:
            raise InputError(f"kind: {kind!r} is unknown; known: {', '.join(WIDTHS)}", value=kind)
        owner, flat = None, False
        notes: tuple[str, ...] = ()
        if faces is None and is_mesh(vertices):
            if kind != "triangle":
                raise InputError(f"kind: an object with faces is of triangles, not of kind {kind!r}", value=kind)
            vertices, faces = mesh_of(vertices)
            flat = np.ndim(faces) == 1
        if faces is None:
            rows, rounded = _arrays.numbers(cast(ArrayLike, vertices), "vertices", WIDTHS[kind])
            shape = np.shape(cast(Any, vertices))[1:]
            arrays = Source(kind, rows, None, None, len(rows), (("vertices", shape),), rounded, ())
        else:
            if kind not in ("triangle", "segment"):
                raise TypeError(f"faces: elements of kind {kind!r} have none")
            rows, rounded = _arrays.numbers(cast(ArrayLike, vertices), "vertices", (3,))
            if flat:
                index, owner, items, notes = triangles_of(cast(Any, faces), rows, _arrays.require_threads(threads))
            else:
                index = _arrays.indices(faces, "faces", 3 if kind == "triangle" else 2, len(rows), "vertices")
                items = len(index)
            arrays = Source(kind, rows, index, owner, items, (("vertices", (3,)),), rounded, notes)
        self._prepare(arrays, pose, threads, name)
        for note in notes:
            _arrays.warn(note, MeetWarning)
        _arrays.tell_rounding(rounded, "vertices", rows.size)

    def _prepare(self, arrays: Source, pose: ArrayLike | None, threads: int, name: str | None) -> None:
        threads = _arrays.require_threads(threads)
        self._source, self.name, self._unposed = arrays, name, None
        self._pose = None if pose is None else _arrays.poses(pose, "pose", False)[0]
        try:
            self._ready = _native.prepare(
                arrays.native_kind(), arrays.numbers, arrays.corners, self._pose, threads
            )
        except _native.Fault as fault:
            raise arrays.explain(fault) from None
        except ValueError as error:  # a pose that does not go with the kind
            raise InputError(f"pose: {error}", array="pose") from None

    @classmethod
    def _made(cls, arrays: Source, pose: ArrayLike | None, threads: int, name: str | None = None) -> Set:
        made = cls.__new__(cls)
        made._prepare(arrays, pose, threads, name)
        return made

    @staticmethod
    def triangles(corners: ArrayLike, *, pose: ArrayLike | None = None, threads: int = 0) -> Set:
        """Triangles by themselves: (m, 3, 3) or (m, 9)."""
        rows, rounded = _arrays.numbers(corners, "corners", (3, 3, 9))
        parts = (("corners", np.shape(cast(Any, corners))[1:]),)
        made = Set._made(Source("triangle", rows, None, None, len(rows), parts, rounded, ()), pose, threads)
        _arrays.tell_rounding(rounded, "corners", rows.size)
        return made

    @staticmethod
    def segments(start: ArrayLike, end: ArrayLike, *, pose: ArrayLike | None = None, threads: int = 0) -> Set:
        """Segments from start to end: both (n, 3)."""
        return _joined("segment", ("start", start, (3,)), ("end", end, (3,)), pose, threads)

    @staticmethod
    def rays(
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        through: Meshlike | None = None,
        length: float | None = None,
        threads: int = 0,
    ) -> Set:
        """Rays as long segments: each ends behind all of `through`, or at the distance `length`.

        The end is computed in double and rounded to float32; the answer is exact for that segment. first() then names
        what a ray meets first.
        """
        from_, rounded = _arrays.numbers(origins, "origins", (3,))
        to = _arrays.as_array(directions, "directions").astype(np.float64)
        if to.shape != from_.shape:
            raise InputError(
                f"directions: its shape is {_arrays.shape_text(to.shape)}, not {_arrays.shape_text(from_.shape)} as of origins",
                array="directions",
            )
        _arrays.require_finite(to, "directions")
        longest = np.abs(to).max(axis=1)
        if not longest.all():
            row = int(np.argmin(longest))
            raise InputError(f"directions[{row}] is zero", array="directions", row=row, value=to[row])
        if (through is None) == (length is None):
            raise TypeError("rays: give either through, the set that they are to cross, or length")
        to /= longest[:, np.newaxis]
        to /= np.linalg.norm(to, axis=1)[:, np.newaxis]
        reach: Any = length
        if through is not None:
            ends = as_set(through, "through").bounds.astype(np.float64)
            far = np.maximum(np.abs(from_ - ends[0]), np.abs(from_ - ends[1]))
            reach = 1.0625 * np.linalg.norm(far, axis=1)[:, np.newaxis] + np.finfo(np.float32).tiny
        elif not (length is not None and 0 < length < np.inf):
            raise InputError(f"length: {length} is no length above 0", value=length)
        return _joined(
            "segment", ("origins", from_, (3,)), ("directions", from_ + to * reach, (3,)), None, threads, rounded
        )

    @staticmethod
    def points(points: ArrayLike, *, pose: ArrayLike | None = None, threads: int = 0) -> Set:
        """Points: (n, 3)."""
        rows, rounded = _arrays.numbers(points, "points", (3,))
        made = Set._made(Source("point", rows, None, None, len(rows), (("points", (3,)),), rounded, ()), pose, threads)
        _arrays.tell_rounding(rounded, "points", rows.size)
        return made

    @staticmethod
    def spheres(
        centres: ArrayLike,
        radii: ArrayLike,
        *,
        solid: bool = True,
        pose: ArrayLike | None = None,
        threads: int = 0,
    ) -> Set:
        """Balls, or where they are not `solid` their surfaces: centres (n, 3); radii (n,), or one for all."""
        kind: Kind = "ball" if solid else "sphere"
        if np.ndim(cast(Any, radii)) == 0:
            radii = np.full(len(_arrays.as_array(centres, "centres")), radii)
        return _joined(kind, ("centres", centres, (3,)), ("radii", radii, ()), pose, threads)

    @staticmethod
    def boxes(low: ArrayLike, high: ArrayLike, *, pose: ArrayLike | None = None, threads: int = 0) -> Set:
        """Boxes along the axes, from their least to their greatest corner: both (n, 3)."""
        return _joined("box", ("low", low, (3,)), ("high", high, (3,)), pose, threads)

    @staticmethod
    def read(
        path: str | os.PathLike[str],
        kind: Kind | None = None,
        *,
        pose: ArrayLike | None = None,
        threads: int = 0,
    ) -> Set:
        """The elements of a .ply, .obj, .off, .stl or .csv file, as `meet collide` reads them.

        Answers are about the file's faces, also where a polygon was cut into triangles. `kind` is needed where a file
        holds several; "sphere" reads spheres as surfaces, and without it they are balls.
        """
        threads = _arrays.require_threads(threads)
        if kind is not None and kind not in WIDTHS:
            raise InputError(f"kind: {kind!r} is unknown; known: {', '.join(WIDTHS)}", value=kind)
        os.stat(path)  # which has Python's own exceptions
        name = os.fsdecode(path)
        try:
            found = _native.read(os.fsencode(path), "sphere" if kind == "ball" else kind or "", threads)
        except _native.FileFault as fault:
            raise InputError(str(fault), array=name) from None
        if not found["items"]:
            raise InputError(f"{name}: it holds no element", array=name)
        rounded = Rounded(found["moved"], found["largest"])
        own: Kind = "ball" if found["kind"] == "sphere" and kind != "sphere" else found["kind"]
        rows = found["numbers"]
        arrays = Source(
            own, rows, found["index"], found["owner"], found["items"], ((name, rows.shape[1:]),), rounded,
            tuple(found["notes"]),
        )
        made = Set._made(arrays, pose, threads, os.path.basename(name))
        for note in arrays.notes:
            _arrays.warn(note, MeetWarning)
        _arrays.tell_rounding(rounded, name, rows.size)
        return made

    def at(self, pose: ArrayLike | None, *, threads: int = 0) -> Set:
        """The same elements in a pose, which takes the place of this set's own; None: as the arrays have them."""
        if pose is None and self._pose is None:
            return self
        return Set._made(self._source, pose, threads, self.name)

    def _without_pose(self) -> Set:
        if self._unposed is None:
            self._unposed = self.at(None)
        return self._unposed

    def _as_arrays(self) -> tuple[Floats, NDArray[Any] | None, Doubles | None]:
        return self._source.numbers, self._source.corners, self._pose

    def __len__(self) -> int:
        """The number of elements that answers speak of: faces, also where these were cut into triangles."""
        return self._source.items

    @property
    def kind(self) -> Kind:
        """triangle, segment, point, ball, sphere (the surface alone) or box."""
        return self._source.kind

    @property
    def bounds(self) -> Floats:
        """A box around all elements in their pose, never too small: [least corner, greatest corner]."""
        return self._ready.bounds()

    @property
    def pose(self) -> Doubles | None:
        """The pose, 4x4; None: there is none."""
        if self._pose is None:
            return None
        return np.vstack([self._pose.reshape(3, 4), [0, 0, 0, 1]])

    @property
    def rounded(self) -> Rounded:
        """How many numbers of the input float32 could not hold, and how far rounding moved one at most."""
        return self._source.rounded

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on the input: parts of a file that are left out, polygons that are not planar or cross themselves."""
        return self._source.notes

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (tuple(self._source), self.pose, self.name))

    def __repr__(self) -> str:
        called = f" {self.name!r}" if self.name else ""
        low, high = self.bounds.tolist()
        return f"<meetc.Set{called}: {_count(len(self), self.kind)} in {low} to {high}>"

    def _repr_html_(self) -> str:
        low, high = (", ".join(f"{x:.6g}" for x in end) for end in self.bounds.tolist())
        rows = [("elements", _count(len(self), self.kind)), ("from", low), ("to", high)]
        if self.rounded.numbers:
            rows.append(("float32 moved", f"{self.rounded.numbers} numbers, by at most {self.rounded.largest:.3g}"))
        if self._pose is not None:
            rows += [("pose" if i == 0 else "", ", ".join(f"{x:.6g}" for x in self._pose[4 * i : 4 * i + 4])) for i in range(3)]
        rows += [("note", note) for note in self.notes]
        cells = "".join(f"<tr><th>{html.escape(k)}</th><td>{html.escape(v)}</td></tr>" for k, v in rows)
        return f"<table><caption>{html.escape(self.name or 'meetc.Set')}</caption>{cells}</table>"


def _restored(arrays: tuple[Any, ...], pose: Doubles | None, name: str | None) -> Set:
    return Set._made(Source(*arrays), pose, 0, name)


def _count(number: int, kind: str) -> str:
    return f"{number:,} {kind}" if number == 1 else f"{number:,} {'boxes' if kind == 'box' else kind + 's'}"


def _joined(
    kind: Kind,
    first: tuple[str, ArrayLike, tuple[int, ...]],
    second: tuple[str, ArrayLike, tuple[int, ...]],
    pose: ArrayLike | None,
    threads: int,
    before: Rounded = _arrays.NOT_MOVED,
) -> Set:
    """Rows of two arrays side by side. A ray's end is made here: what it is rounded by is no fault of the input."""
    a, rounded_a = _arrays.numbers(first[1], first[0], (3,))
    values = _arrays.as_array(second[1], second[0])
    if values.ndim == 1 and second[2] == ():
        values = values.reshape(-1, 1)
    b, rounded_b = _arrays.numbers(values, second[0], (3,) if second[2] else (1,))
    if len(a) != len(b):
        raise InputError(f"{second[0]}: it has {len(b)} rows, and {first[0]} has {len(a)}", array=second[0])
    ray = second[0] == "directions"
    rounded = before if ray else _arrays.together(rounded_a, rounded_b)
    arrays = Source(
        kind, np.hstack([a, b]), None, None, len(a), ((first[0], first[2]), (second[0], second[2])), rounded, ()
    )
    made = Set._made(arrays, pose, threads)
    _arrays.tell_rounding(rounded, first[0] if ray else f"{first[0]} and {second[0]}", a.size if ray else a.size + b.size)
    return made


def as_set(value: object, name: str, threads: int = 0) -> Set:
    """A set, a mesh or (vertices, faces) as a set."""
    if isinstance(value, Set):
        return value
    if is_mesh(value):
        return Set(cast(Any, value), threads=threads)
    if isinstance(value, tuple) and len(value) == 2:
        return Set(value[0], value[1], threads=threads)
    raise TypeError(
        f"{name}: a meetc.Set, a mesh with vertices and faces, or a tuple (vertices, faces) is needed, "
        f"not {type(value).__name__}"
    )
