"""A CollisionManager with the names and signatures of trimesh.collision's, and proved answers.

Meshes are surfaces, as there: a mesh inside another one does not touch it. Depths, normals, points and distances are not
computed; asking for one raises NotImplementedError, which names what to call instead.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from typing import Any, Literal, NoReturn, overload

import numpy as np
from numpy.typing import ArrayLike

from meetc import _queries
from meetc._errors import InputError
from meetc._set import Set, as_set
from meetc._types import Meshlike

__all__ = ["CollisionManager", "ContactData"]

Data = list["ContactData"]
_Named = list[tuple[Any, Set]]
_Pair = tuple[tuple[Any, Any], Set, Set]
Names = set[Any]
Pairs = set[tuple[Any, Any]]


class ContactData:
    """Two triangles that touch: `names`, the names of their objects, and index(name), the triangle of each."""

    def __init__(self, names: tuple[Any, Any], triangles: tuple[int, int]) -> None:
        self.names = set(names)
        self._index: dict[Any, int] = dict(zip(names, triangles))

    def index(self, name: Any) -> int:
        """The number of the triangle of the object with this name."""
        return self._index[name]

    def __repr__(self) -> str:
        return "ContactData(" + ", ".join(f"{name!r}: {i}" for name, i in self._index.items()) + ")"

    @property
    def point(self) -> NoReturn:
        raise NotImplementedError("point: call index(name), which has the two triangles that touch")

    @property
    def normal(self) -> NoReturn:
        raise NotImplementedError("normal: call index(name), which has the two triangles that touch; they define none")

    @property
    def depth(self) -> NoReturn:
        raise NotImplementedError("depth: call index(name), which has the two triangles that touch; they define none")


class CollisionManager:
    """Named meshes in poses, and which of them touch.

    A mesh is prepared for each pose that it is given. One manager is for one thread at a time.
    """

    def __init__(self) -> None:
        self._sets: dict[Hashable, Set] = {}

    def add_object(self, name: Hashable, mesh: Meshlike, transform: ArrayLike | None = None) -> None:
        """Adds a mesh in a pose, 4x4; one that has this name is replaced."""
        found = _triangles(mesh)
        self._sets[name] = found if transform is None else found.at(transform)

    def remove_object(self, name: Hashable) -> None:
        """Removes the mesh of this name."""
        self._require(name)
        del self._sets[name]

    def set_transform(self, name: Hashable, transform: ArrayLike) -> None:
        """Moves the mesh of this name to a pose, 4x4."""
        self._require(name)
        self._sets[name] = self._sets[name].at(transform)

    @overload
    def in_collision_single(
        self, mesh: Meshlike, transform: ArrayLike | None = ..., return_names: Literal[False] = ...,
        return_data: Literal[False] = ...,
    ) -> bool: ...
    @overload
    def in_collision_single(
        self, mesh: Meshlike, transform: ArrayLike | None = ..., *, return_names: Literal[True],
        return_data: Literal[False] = ...,
    ) -> tuple[bool, Names]: ...
    @overload
    def in_collision_single(
        self, mesh: Meshlike, transform: ArrayLike | None = ..., return_names: Literal[False] = ..., *,
        return_data: Literal[True],
    ) -> tuple[bool, Data]: ...
    @overload
    def in_collision_single(
        self, mesh: Meshlike, transform: ArrayLike | None = ..., *, return_names: Literal[True],
        return_data: Literal[True],
    ) -> tuple[bool, Names, Data]: ...
    def in_collision_single(
        self, mesh: Meshlike, transform: ArrayLike | None = None, return_names: bool = False, return_data: bool = False
    ) -> Any:
        """Whether a mesh in a pose touches any of the manager's, and the names of those that it touches."""
        other = _triangles(mesh)
        if transform is not None:
            other = other.at(transform)
        todo = _near(list(self._sets.items()), [("__external", other)])
        return _answer(todo, lambda names: names[0], return_names, return_data)

    @overload
    def in_collision_internal(
        self, return_names: Literal[False] = ..., return_data: Literal[False] = ...
    ) -> bool: ...
    @overload
    def in_collision_internal(
        self, return_names: Literal[True], return_data: Literal[False] = ...
    ) -> tuple[bool, Pairs]: ...
    @overload
    def in_collision_internal(
        self, return_names: Literal[False] = ..., *, return_data: Literal[True]
    ) -> tuple[bool, Data]: ...
    @overload
    def in_collision_internal(
        self, return_names: Literal[True], return_data: Literal[True]
    ) -> tuple[bool, Pairs, Data]: ...
    def in_collision_internal(self, return_names: bool = False, return_data: bool = False) -> Any:
        """Whether any two of the manager's meshes touch, and the pairs of their names, each sorted."""
        all_: _Named = list(self._sets.items())
        todo = _near(all_, all_)
        return _answer(todo, _sorted, return_names, return_data)

    @overload
    def in_collision_other(
        self, other_manager: CollisionManager, return_names: Literal[False] = ..., return_data: Literal[False] = ...
    ) -> bool: ...
    @overload
    def in_collision_other(
        self, other_manager: CollisionManager, return_names: Literal[True], return_data: Literal[False] = ...
    ) -> tuple[bool, Pairs]: ...
    @overload
    def in_collision_other(
        self, other_manager: CollisionManager, return_names: Literal[False] = ..., *, return_data: Literal[True]
    ) -> tuple[bool, Data]: ...
    @overload
    def in_collision_other(
        self, other_manager: CollisionManager, return_names: Literal[True], return_data: Literal[True]
    ) -> tuple[bool, Pairs, Data]: ...
    def in_collision_other(
        self, other_manager: CollisionManager, return_names: bool = False, return_data: bool = False
    ) -> Any:
        """Whether a mesh of this manager touches one of another, and the pairs (name here, name there)."""
        todo = _near(list(self._sets.items()), list(other_manager._sets.items()))
        return _answer(todo, lambda names: names, return_names, return_data)

    def min_distance_single(
        self, mesh: Meshlike, transform: ArrayLike | None = None, return_name: bool = False, return_data: bool = False
    ) -> NoReturn:
        """Not computed: in_collision_single says whether the distance is 0."""
        raise NotImplementedError("min_distance_single: call in_collision_single, which says whether the distance is 0")

    def min_distance_internal(
        self, name: Any = None, return_names: bool = False, return_data: bool = False
    ) -> NoReturn:
        """Not computed: in_collision_internal says whether the distance is 0."""
        raise NotImplementedError(
            "min_distance_internal: call in_collision_internal, which says whether the distance is 0"
        )

    def min_distance_other(
        self, other_manager: CollisionManager, return_names: bool = False, return_data: bool = False
    ) -> NoReturn:
        """Not computed: in_collision_other says whether the distance is 0."""
        raise NotImplementedError("min_distance_other: call in_collision_other, which says whether the distance is 0")

    def _require(self, name: Hashable) -> None:
        if name not in self._sets:
            known = ", ".join(repr(n) for n in self._sets)
            raise InputError(f"{name!r} is not in the collision manager; there are: {known or 'none'}", value=name)


def _triangles(mesh: Meshlike) -> Set:
    found = as_set(mesh, "mesh")
    if found.kind != "triangle":
        raise InputError(f"mesh: its elements are of kind {found.kind}, not triangles", array="mesh", value=found.kind)
    return found


def _sorted(names: tuple[Any, Any]) -> tuple[Any, Any]:
    a, b = sorted(names)
    return a, b


def _near(a: _Named, b: _Named) -> Iterable[_Pair]:
    """The pairs of sets whose boxes touch; of one list with itself, each once."""
    if not a or not b:
        return
    boxes = Set.boxes(*np.stack([s.bounds for _, s in a], axis=1))
    others = boxes if a is b else Set.boxes(*np.stack([s.bounds for _, s in b], axis=1))
    for i, j in _queries.pairs(boxes, others).tolist():
        if a is not b or i < j:
            yield (a[i][0], b[j][0]), a[i][1], b[j][1]


def _answer(
    todo: Iterable[_Pair], key: Callable[[tuple[Any, Any]], Any], with_names: bool, with_data: bool
) -> Any:
    """trimesh's results: a bool, or a tuple of it with the names, the data, or both."""
    hit, names, data = False, set(), []
    for pair, a, b in todo:
        if with_data:
            found = _queries.pairs(a, b)
            touch = len(found) > 0
            data += [ContactData(pair, (i, j)) for i, j in found.tolist()]
        else:
            touch = _queries.touches(a, b)
        hit |= touch
        if touch:
            names.add(key(pair))
            if not (with_names or with_data):
                return True
    return (hit, *([names] if with_names else []), *([data] if with_data else [])) if with_names or with_data else hit
