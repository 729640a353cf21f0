"""The class World."""

from __future__ import annotations

import threading
from collections.abc import Iterable, Iterator, Sequence
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from meetc import _arrays, _native
from meetc._errors import InputError
from meetc._queries import pairs
from meetc._set import Set, as_set
from meetc._types import Bools, Doubles, Ints, Longs, Meshlike, Precision

Mode = Literal["solid", "surface"]

_IDENTITY: Doubles = np.eye(4)[:3].reshape(12)


class World:
    """Bodies with names and poses, and which of them touch.

        world = meetc.World()
        world.add("arm", mesh)
        world.add("floor", floor, pose)      # 4x4 or 3x4
        world.move("arm", pose)
        world.touching()                     # [("arm", "floor")]

    A body's set is prepared once; moving it costs nothing until something is asked, and then only the elements that come near
    another body are moved. Answers are those of sets that were prepared in the poses. Meshes are surfaces: a body inside
    another one does not touch it. Spheres are balls, or in a World(mode="surface") their surfaces.

    Several threads may use a world; they take turns.
    """

    def __init__(self, *, mode: Mode = "solid", precision: Precision = "certified", threads: int = 0) -> None:
        if mode not in get_args(Mode):
            raise InputError(f"mode: {mode!r} is unknown; known: {', '.join(get_args(Mode))}", value=mode)
        if precision not in get_args(Precision):
            known = ", ".join(get_args(Precision))
            raise InputError(f"precision: {precision!r} is unknown; known: {known}", value=precision)
        self._mode, self._precision, self._threads = mode, precision, _arrays.require_threads(threads)
        self._sets: dict[str, Set] = {}
        self._poses: dict[str, Doubles] = {}
        self._allowed: set[frozenset[str]] = set()  # pairs; of one name: with every other body
        self._lock = threading.Lock()
        self._native: _native.World | None = None  # made when it is asked, and again after bodies came or went

    def add(self, name: str, body: Meshlike, pose: ArrayLike | None = None) -> None:
        """Adds a body. Its pose is that of the set where none is given."""
        if not isinstance(name, str) or not name:
            raise TypeError("name: a text is needed that is not empty")
        shape = as_set(body, name, self._threads)
        if (shape.kind, self._mode) in (("sphere", "solid"), ("ball", "surface")):
            other = "surface" if self._mode == "solid" else "solid"
            raise InputError(f"{name}: it has elements of kind {shape.kind}, for a World(mode={other!r})", array=name)
        own = shape._pose if shape._pose is not None else _IDENTITY
        at = own if pose is None else _arrays.poses(pose, "pose", False)[0]
        with self._lock:
            if name in self._sets:
                raise InputError(f"name: {name!r} is taken", value=name)
            self._sets[name], self._poses[name] = shape._without_pose(), at
            self._native = None

    def move(self, name: str, pose: ArrayLike) -> None:
        """Puts a body into a pose, which takes the place of the one before."""
        at = _arrays.poses(pose, "pose", False)[0]
        with self._lock:
            self._require(name)
            self._place(name, at)

    def remove(self, name: str) -> None:
        """Takes a body out. Pairs that were allowed hold again for a later body of its name."""
        with self._lock:
            self._require(name)
            del self._sets[name], self._poses[name]
            self._native = None

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
            self._native = None

    def pose(self, name: str) -> Doubles:
        """The pose of a body, 4x4."""
        self._require(name)
        return np.vstack([self._poses[name].reshape(3, 4), [0, 0, 0, 1]])

    def touching(self, name: str | None = None) -> list[tuple[str, str]]:
        """The pairs of bodies that touch, in the order in which they were added; with a name, those of that body."""
        if name is not None:
            self._require(name)
        names = list(self._sets)
        found = [(names[a], names[b]) for a, b, _ in self._ask(False)]
        return [pair for pair in found if name is None or name in pair]

    def any(self) -> bool:
        """Whether any two bodies touch. The search ends at the first that are found."""
        return bool(self._ask(True))

    def matrix(self) -> Longs:
        """For each two bodies, in the order in which they were added, the number of pairs of their elements that touch."""
        out = np.zeros((len(self), len(self)), np.int64)
        for a, b, count in self._ask(False):
            out[a, b] = out[b, a] = count
        return out

    def pairs(self, a: str, b: str) -> Ints:
        """The pairs of elements of two bodies that touch, (k, 2), also where they may touch."""
        self._require(a)
        self._require(b)
        return pairs(
            self._sets[a].at(self.pose(a)), self._sets[b].at(self.pose(b)), precision=self._precision, threads=self._threads
        )

    def over(self, poses: ArrayLike, names: Sequence[str]) -> Bools:
        """For each frame of poses, (frames, len(names), 4, 4) or (…, 3, 4), whether any two bodies touch: (frames,).

        Each frame puts the named bodies into its poses; afterwards they are where they were.
        """
        array = _arrays.as_array(poses, "poses")
        names = list(names)
        if array.ndim != 4 or array.shape[1] != len(names):
            raise InputError(
                f"poses: its shape is {_arrays.shape_text(array.shape)}, not (frames, {len(names)}, 4, 4) or (…, 3, 4)",
                array="poses",
            )
        for name in names:
            self._require(name)
        matrices = _arrays.poses(array.reshape(-1, *array.shape[2:]), "poses", True).reshape(len(array), len(names), 12)
        with self._lock:
            before = dict(self._poses)
            try:
                out = np.zeros(len(array), np.bool_)
                for frame, places in enumerate(matrices):
                    for name, at in zip(names, places):
                        self._place(name, at)
                    out[frame] = bool(self._found(True))
            finally:
                for name in names:
                    self._place(name, before[name])
        return out

    def __len__(self) -> int:
        return len(self._sets)

    def __contains__(self, name: object) -> bool:
        return name in self._sets

    def __iter__(self) -> Iterator[str]:
        """The names, in the order in which the bodies were added."""
        return iter(list(self._sets))

    def __repr__(self) -> str:
        return f"<meetc.World: {len(self)} {'body' if len(self) == 1 else 'bodies'}>"

    def _require(self, name: str) -> None:
        if name not in self._sets:
            raise InputError(f"there is no body {name!r}; there are: {', '.join(self._sets) or 'none'}", value=name)

    def _place(self, name: str, at: Doubles) -> None:
        self._poses[name] = at
        if self._native is not None:
            self._native.move(list(self._sets).index(name), at)

    def _ask(self, any: bool) -> list[tuple[int, int, int]]:
        with self._lock:
            return self._found(any)

    def _found(self, any: bool) -> list[tuple[int, int, int]]:
        try:
            if self._native is None:
                self._native = self._made()
            return self._native.touching(self._precision, any, self._threads)
        except (_native.Fault, ValueError) as error:
            raise InputError(str(error)) from None

    def _made(self) -> _native.World:
        made = _native.World(self._mode)
        names = list(self._sets)
        for name in names:
            shape = self._sets[name]
            made.add(name, shape._ready, self._poses[name], shape._source.owner)
        for i, a in enumerate(names):
            for j, b in enumerate(names[:i]):
                if not self._allowed.isdisjoint((frozenset([a]), frozenset([b]), frozenset([a, b]))):
                    made.ignore(i, j, True)
        return made
