"""The class World."""

from __future__ import annotations

import threading
from collections.abc import Generator, Iterable, Iterator, Sequence
from contextlib import closing
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike

from meetc import _arrays
from meetc._bodies import Bodies, Touching, Want
from meetc._device import Device
from meetc._errors import InputError
from meetc._queries import pairs
from meetc._report import BodiesFrame, Report, of_bodies
from meetc._set import Set, as_set
from meetc._types import Bools, Doubles, Ints, Longs, Meshlike, Precision

Mode = Literal["solid", "surface"]

_IDENTITY: Doubles = np.eye(4)[:3].reshape(12)


def pose_of(shape: Set, pose: ArrayLike | None) -> Doubles:
    """Twelve numbers: the pose, or that of the set where none is given."""
    if pose is not None:
        at: Doubles = _arrays.poses(pose, "pose", False)[0]
        return at
    return _IDENTITY if shape._pose is None else shape._pose


class Nested(NamedTuple):
    """Bodies that do not touch, of which one lies inside the other; see World.nested()."""

    inside: list[tuple[str, str]]  #: the inner body, and the outer one
    overlapping: list[tuple[str, str]]  #: a part of one lies inside the other, another part of it does not
    unknown: list[tuple[str, str, str]]  #: two bodies, and why it is unknown


class World:
    """Bodies with names and poses, and which of them touch.

        world = meetc.World()
        world.add("arm", mesh)
        world.add("floor", floor, pose)      # 4x4 or 3x4
        world.move("arm", pose)
        world.touching()                     # [("arm", "floor")]

    A body's set is prepared once; moving it costs nothing until something is asked, and then only the elements that come near
    another body are moved. Answers are those of sets that were prepared in the poses. Meshes are surfaces: a body inside
    another one does not touch it; nested() tells of it. Spheres are balls, or in a World(mode="surface") their surfaces.

    Several threads may use a world; they take turns. With device="cuda" the bodies lie on the device, where they are moved and
    collided; the answers are the same.
    """

    def __init__(
        self, *, mode: Mode = "solid", precision: Precision = "certified", threads: int = 0, device: Device = "cpu"
    ) -> None:
        if mode not in get_args(Mode):
            raise InputError(f"mode: {mode!r} is unknown; known: {', '.join(get_args(Mode))}", value=mode)
        if precision not in get_args(Precision):
            known = ", ".join(get_args(Precision))
            raise InputError(f"precision: {precision!r} is unknown; known: {known}", value=precision)
        self._mode, self._precision, self._threads = mode, precision, _arrays.require_threads(threads)
        self._allowed: set[frozenset[str]] = set()  # pairs; of one name: with every other body
        self._device: Device = device
        self._bodies = Bodies(mode, self._may_touch, device)
        self._lock = threading.Lock()

    def add(self, name: str, body: Meshlike, pose: ArrayLike | None = None) -> None:
        """Adds a body. Its pose is that of the set where none is given."""
        if not isinstance(name, str) or not name:
            raise TypeError("name: a text is needed that is not empty")
        shape = as_set(body, name, self._threads)
        if (shape.kind, self._mode) in (("sphere", "solid"), ("ball", "surface")):
            other = "surface" if self._mode == "solid" else "solid"
            raise InputError(f"{name}: it has elements of kind {shape.kind}, for a World(mode={other!r})", array=name)
        at = pose_of(shape, pose)
        with self._lock:
            if name in self._bodies.sets:
                raise InputError(f"name: {name!r} is taken", value=name)
            self._bodies.add(name, shape, at)

    def move(self, name: str, pose: ArrayLike) -> None:
        """Puts a body into a pose, which takes the place of the one before."""
        at = _arrays.poses(pose, "pose", False)[0]
        with self._lock:
            self._require(name)
            self._bodies.move(name, at)

    def remove(self, name: str) -> None:
        """Takes a body out. Pairs that were allowed hold again for a later body of its name."""
        with self._lock:
            self._require(name)
            self._bodies.remove(name)

    def allow(self, a: str | Iterable[str], b: str | Iterable[str] | None = None, allowed: bool = True) -> None:
        """Leaves out the pairs of a body of a and one of b, which may touch; without b, all pairs of a body of a.

        Names of bodies that are added later may be given. With allowed=False the pairs are asked about again.
        """
        of_a = [a] if isinstance(a, str) else list(a)
        of_b: list[str | None] = [None] if b is None else [b] if isinstance(b, str) else list(b)
        with self._lock:
            for x in of_a:
                for y in of_b:
                    pair = frozenset([x]) if y is None or y == x else frozenset([x, y])
                    (self._allowed.add if allowed else self._allowed.discard)(pair)
            self._bodies.forget()

    def pose(self, name: str) -> Doubles:
        """The pose of a body, 4x4."""
        self._require(name)
        return np.vstack([self._bodies.poses[name].reshape(3, 4), [0, 0, 0, 1]])

    def touching(self, name: str | None = None) -> list[tuple[str, str]]:
        """The pairs of bodies that touch, in the order in which they were added; with a name, those of that body."""
        if name is not None:
            self._require(name)
        return [(a, b) for a, b, _, _ in self._ask("count", () if name is None else (name,))]

    def nested(self, name: str | None = None) -> Nested:
        """The bodies that lie inside a closed mesh without touching it; with a name, those of its pairs.

        A mesh holds the points around which it goes once, by its winding number: its normals point outwards, those of a cavity
        into the cavity. Where a mesh is open, or goes around a point some other number of times, it is unknown. The answer is
        exact. A mesh alone holds other bodies, and they may be of any kind.
        """
        if name is not None:
            self._require(name)
        with self._lock:
            found = self._bodies.nested(() if name is None else (name,), self._precision, self._threads)
        out = Nested([], [], [])
        for a, b, how, why in found:
            if how == "unknown":
                out.unknown.append((a, b, why))
            elif how == "overlapping":
                out.overlapping.append((a, b))
            else:
                out.inside.append((a, b) if how == "a inside b" else (b, a))
        return out

    def any(self) -> bool:
        """Whether any two bodies touch. The search ends at the first that are found."""
        return bool(self._ask("any"))

    def matrix(self) -> Longs:
        """For each two bodies, in the order in which they were added, the number of pairs of their elements that touch."""
        out = np.zeros((len(self), len(self)), np.int64)
        place = {name: i for i, name in enumerate(self)}
        for a, b, count, _ in self._ask("count"):
            out[place[a], place[b]] = out[place[b], place[a]] = count
        return out

    def pairs(self, a: str, b: str) -> Ints:
        """The pairs of elements of two bodies that touch, (k, 2), also where they may touch."""
        self._require(a)
        self._require(b)
        of = self._bodies.sets
        one, other = of[a].at(self.pose(a)), of[b].at(self.pose(b))
        return pairs(one, other, precision=self._precision, threads=self._threads, device=self._device)

    def over(self, poses: ArrayLike, names: Sequence[str]) -> Bools:
        """For each frame of poses, (frames, len(names), 4, 4) or (…, 3, 4), whether any two bodies touch: (frames,).

        Each frame puts the named bodies into its poses; afterwards they are where they were.
        """
        names = list(names)
        matrices = self._matrices(poses, names)
        with self._lock, closing(self._moved(matrices, names)) as frames:
            found = [bool(self._found("any")) for _ in frames]
        return np.array(found, np.bool_)

    def report(self, poses: ArrayLike | None = None, names: Sequence[str] = ()) -> Report:
        """A page on which the bodies are looked at: which of them touch, and which lie inside others.

        With poses and names, as over() takes them, a slider goes through the frames, whose names are their numbers from 0. The
        page is that of `meet collide --world cell.json --poses poses.npy --report`.
        """
        names = list(names)
        if poses is None and names:
            raise InputError("names: the bodies of no poses; name poses as well", array="names", value=names)
        matrices = np.empty((1, 0, 12)) if poses is None else self._matrices(poses, names)
        if len(matrices) == 0:
            raise InputError("poses: it has no frame", array="poses")
        nested = self._mode == "solid" and self._precision in ("certified", "exact")
        with self._lock:
            keys = list(self._bodies.sets)
            sets = [self._bodies.sets[key] for key in keys]
            places = [self._bodies.poses[key] for key in keys]
            number = {key: i for i, key in enumerate(keys)}
            frames: list[BodiesFrame] = []
            with closing(self._moved(matrices, names)) as moved:
                for frame, at in enumerate(moved):
                    touching = [(number[a], number[b], count) for a, b, count, _ in self._found("count")]
                    inside = self._bodies.nested((), self._precision, self._threads) if nested else []
                    frames.append(
                        BodiesFrame(
                            "" if poses is None else str(frame),
                            [(number[name], place) for name, place in zip(names, at)],
                            touching,
                            [(number[a], number[b], how, why) for a, b, how, why in inside],
                        )
                    )
        return of_bodies([str(key) for key in keys], sets, places, frames, self._precision)

    def _repr_html_(self) -> str:
        return self.report()._repr_html_()

    def _matrices(self, poses: ArrayLike, names: list[str]) -> Doubles:
        """(frames, names, 12)."""
        array = _arrays.as_array(poses, "poses")
        if array.ndim != 4 or array.shape[1] != len(names):
            raise InputError(
                f"poses: its shape is {_arrays.shape_text(array.shape)}, not (frames, {len(names)}, 4, 4) or (…, 3, 4)",
                array="poses",
            )
        for name in names:
            self._require(name)
        return _arrays.poses(array.reshape(-1, *array.shape[2:]), "poses", True).reshape(len(array), len(names), 12)

    def _moved(self, matrices: Doubles, names: list[str]) -> Generator[Doubles, None, None]:
        """The poses of each frame, in which the bodies stand meanwhile; once it is closed, they are where they were."""
        before = dict(self._bodies.poses)
        try:
            for places in matrices:
                for name, at in zip(names, places):
                    self._bodies.move(name, at)
                yield places
        finally:
            for name in names:
                self._bodies.move(name, before[name])

    def __len__(self) -> int:
        return len(self._bodies.sets)

    def __contains__(self, name: object) -> bool:
        return name in self._bodies.sets

    def __iter__(self) -> Iterator[str]:
        """The names, in the order in which the bodies were added."""
        return iter([str(name) for name in self._bodies.sets])

    def __repr__(self) -> str:
        return f"<meetc.World: {len(self)} {'body' if len(self) == 1 else 'bodies'}>"

    def _require(self, name: str) -> None:
        if name not in self:
            raise InputError(f"there is no body {name!r}; there are: {', '.join(self) or 'none'}", value=name)

    def _may_touch(self, a: str, b: str) -> bool:
        return not self._allowed.isdisjoint((frozenset([a]), frozenset([b]), frozenset([a, b])))

    def _ask(self, want: Want, of: Iterable[str] = ()) -> Touching:
        with self._lock:
            return self._found(want, of)

    def _found(self, want: Want, of: Iterable[str] = ()) -> Touching:
        return self._bodies.touching(want, of, self._precision, self._threads)
