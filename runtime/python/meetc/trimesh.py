"""A CollisionManager with the names and signatures of trimesh.collision's, and proved answers.

Meshes are surfaces, as there: a mesh inside another one does not touch it. Depths, normals, points and distances are not
computed; asking for one raises NotImplementedError, which names what to call instead.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, Literal, NoReturn, overload

from numpy.typing import ArrayLike

from meetc import _arrays
from meetc._bodies import Bodies, Touching
from meetc._errors import InputError
from meetc._set import Set, as_set
from meetc._world import pose_of
from meetc._types import Meshlike

__all__ = ["CollisionManager", "ContactData"]

Data = list["ContactData"]
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
        raise NotImplementedError("point: call index(name), and meetc.contacts, which has the points in which triangles meet")

    @property
    def normal(self) -> NoReturn:
        raise NotImplementedError("normal: call index(name), which has the two triangles that touch; they define none")

    @property
    def depth(self) -> NoReturn:
        raise NotImplementedError("depth: call index(name), which has the two triangles that touch; they define none")


class CollisionManager:
    """Named meshes in poses, and which of them touch.

    A mesh is prepared once, in whatever poses it is put. One manager is for one thread at a time.
    """

    def __init__(self) -> None:
        self._bodies = Bodies("solid")

    def add_object(self, name: Hashable, mesh: Meshlike, transform: ArrayLike | None = None) -> None:
        """Adds a mesh in a pose, 4x4; one that has this name is replaced."""
        found = _triangles(mesh)
        self._bodies.add(name, found, pose_of(found, transform))

    def remove_object(self, name: Hashable) -> None:
        """Removes the mesh of this name."""
        self._require(name)
        self._bodies.remove(name)

    def set_transform(self, name: Hashable, transform: ArrayLike) -> None:
        """Moves the mesh of this name to a pose, 4x4."""
        self._require(name)
        self._bodies.move(name, _arrays.poses(transform, "pose", False)[0])

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
        bodies, single = _together(self), "__external"
        bodies.add((1, single), other, pose_of(other, transform))
        found = _named(bodies.touching(_want(return_names, return_data), [(1, single)]))
        return _answer(found, lambda names: names[0], return_names, return_data)

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
        return _answer(self._bodies.touching(_want(return_names, return_data)), _sorted, return_names, return_data)

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
        others = [(1, name) for name in other_manager._bodies.sets]
        found = _named(_together(self, other_manager).touching(_want(return_names, return_data), others)) if others else []
        return _answer(found, lambda names: names, return_names, return_data)

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
        if name not in self._bodies.sets:
            known = ", ".join(repr(n) for n in self._bodies.sets)
            raise InputError(f"{name!r} is not in the collision manager; there are: {known or 'none'}", value=name)


def _triangles(mesh: Meshlike) -> Set:
    found = as_set(mesh, "mesh")
    if found.kind != "triangle":
        raise InputError(f"mesh: its elements are of kind {found.kind}, not triangles", array="mesh", value=found.kind)
    return found


def _sorted(names: tuple[Any, Any]) -> tuple[Any, Any]:
    a, b = sorted(names)
    return a, b


def _together(*managers: CollisionManager) -> Bodies:
    """The bodies of managers, each by the number of its manager and its name."""
    out = Bodies("solid")
    for number, manager in enumerate(managers):
        for name, shape in manager._bodies.sets.items():
            out.add((number, name), shape, manager._bodies.poses[name])
    return out


def _named(found: Touching) -> Touching:
    return [(a[1], b[1], count, pairs) for a, b, count, pairs in found]


def _want(with_names: bool, with_data: bool) -> Literal["any", "count", "pairs"]:
    return "pairs" if with_data else "count" if with_names else "any"


def _answer(found: Touching, key: Callable[[tuple[Any, Any]], Any], with_names: bool, with_data: bool) -> Any:
    """trimesh's results: a bool, or a tuple of it with the names, the data, or both."""
    names = [{key((a, b)) for a, b, _, _ in found}] if with_names else []
    data = [[ContactData((a, b), (i, j)) for a, b, _, pairs in found for i, j in pairs.tolist()]] if with_data else []
    return (bool(found), *names, *data) if with_names or with_data else bool(found)
