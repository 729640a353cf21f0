"""Sets in poses, by keys: what World and the CollisionManager rest on."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from typing import Any, Literal, TypeVar

from meetc import _native
from meetc._device import Device, faults, require_device
from meetc._errors import InputError
from meetc._set import Set
from meetc._types import Doubles, Ints

Want = Literal["any", "count", "pairs"]
# Two keys, the body that was added earlier first, and the number of their pairs, of elements of the one and the other.
Touching = list[tuple[Any, Any, int, Ints]]
Answer = TypeVar("Answer")


class Bodies:
    """Each set is prepared once; moving it costs nothing until it is asked what touches."""

    def __init__(
        self, mode: str, ignored: Callable[[Any, Any], bool] = lambda a, b: False, device: Device = "cpu"
    ) -> None:
        self._mode, self._ignored, self._on_device = mode, ignored, require_device(device)
        self.sets: dict[Hashable, Set] = {}  # without a pose
        self.poses: dict[Hashable, Doubles] = {}  # twelve numbers
        self._native: _native.World | None = None  # made when it is asked, and again after bodies came or went
        self._there: _native.WorldThere | None = None  # of that one, on a device

    def add(self, key: Hashable, shape: Set, at: Doubles) -> None:
        self.sets[key], self.poses[key] = shape._without_pose(), at
        self.forget()

    def remove(self, key: Hashable) -> None:
        del self.sets[key], self.poses[key]
        self.forget()

    def forget(self) -> None:
        """Other pairs are ignored from now on."""
        self._native = self._there = None

    def move(self, key: Hashable, at: Doubles) -> None:
        self.poses[key] = at
        if self._native is not None:
            self._native.move(list(self.sets).index(key), at)

    def touching(self, want: Want, of: Iterable[Hashable] = (), precision: str = "certified", threads: int = 0) -> Touching:
        """The bodies that touch. With `of`, only pairs of one of these and another one.

        want: "any" is one such pair, or none; "count" has the numbers of pairs of elements, and "pairs" these too.
        """
        keys = list(self.sets)
        found = self._ask(lambda world: world.touching([keys.index(key) for key in of], precision, want, threads))
        return [(keys[a], keys[b], count, pairs) for a, b, count, pairs in found]

    def nested(self, of: Iterable[Hashable], precision: str, threads: int) -> list[tuple[Any, Any, str, str]]:
        """Two bodies that do not touch, how the one lies in the other, and the reason where that is unknown."""
        keys = list(self.sets)
        found = self._ask(lambda world: world.nested([keys.index(key) for key in of], precision, threads))
        return [(keys[a], keys[b], how, why) for a, b, how, why in found]

    def _ask(self, question: Callable[[_native.World | _native.WorldThere], Answer]) -> Answer:
        try:
            if self._native is None:
                self._native = self._made(list(self.sets))
            if not self._on_device:
                return question(self._native)
            with faults():
                if self._there is None:
                    self._there = _native.WorldThere(self._native)
                return question(self._there)
        except (_native.Fault, ValueError) as error:
            raise InputError(str(error)) from None

    def _made(self, keys: list[Hashable]) -> _native.World:
        made, names = _native.World(self._mode), set[str]()
        for number, key in enumerate(keys):
            shape, name = self.sets[key], str(key)
            if not name or name in names:  # keys that differ may have one text
                name = f"{name} (number {number})"
            names.add(name)
            made.add(name, shape._ready, self.poses[key], shape._source.owner)
        for i, a in enumerate(keys):
            for j, b in enumerate(keys[:i]):
                if self._ignored(a, b):
                    made.ignore(i, j, True)
        return made
