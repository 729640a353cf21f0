"""Queries: which elements of two sets touch."""

from __future__ import annotations

from typing import Literal, NamedTuple, get_args, overload

import numpy as np
from numpy.typing import ArrayLike

from meetc import _arrays, _native
from meetc._errors import InputError
from meetc._set import Set, as_set
from meetc._types import Bools, Ints, Longs, Meshlike, Precision


class _Asked(NamedTuple):
    """Two sets, and the predicate that takes them, perhaps in the other order."""

    a: Set
    b: Set
    predicate: str
    turned: bool
    precision: str
    threads: int

    def question(self) -> _native.Question:
        first, second = (self.b, self.a) if self.turned else (self.a, self.b)
        return _native.Question(
            first._ready,
            second._ready,
            self.predicate,
            self.precision,
            first._source.owner,
            second._source.owner,
            self.threads,
        )


def _mode(kind: str) -> str:
    return {"ball": "solid", "sphere": "surface"}.get(kind, "")


def _find(a: str, b: str) -> tuple[str, bool]:
    """The predicate for two kinds, and whether it takes them in the other order."""
    modes = {_mode(a), _mode(b)} - {""}
    wanted = tuple("sphere" if kind == "ball" else kind for kind in (a, b))
    known = []
    for name, mode, first, second, _ in _native.predicates():
        if (first, second) in (wanted, wanted[::-1]) and modes <= {mode, ""}:
            return name, (first, second) != wanted
        known.append(" with ".join("ball" if k == "sphere" and mode == "solid" else k for k in (first, second)))
    raise InputError(f"there is no predicate for {a} with {b}; there are: {', '.join(known)}")


def _ask(a: object, b: object, precision: str, threads: int) -> _Asked:
    threads = _arrays.require_threads(threads)
    if precision not in get_args(Precision):
        raise InputError(
            f"precision: {precision!r} is unknown; known: {', '.join(get_args(Precision))}", value=precision
        )
    first = as_set(a, "a", threads)
    second = first if b is a else as_set(b, "b", threads)
    return _Asked(first, second, *_find(first.kind, second.kind), precision, threads)


def pairs(a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0) -> Ints:
    """All pairs of elements that touch, (k, 2), sorted by the first, then by the second.

    Elements that share a single point touch; a mesh is a surface. `certified` and `exact` are right for every finite
    float32 input; fp32, fp64 and fp64x2 take computed signs as they are. A set against itself gives every ordered pair
    (i, j), i = j included. Other threads of Python run meanwhile, and Ctrl-C ends the query.
    """
    asked = _ask(a, b, precision, threads)
    return asked.question().pairs(asked.turned)


def count(a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0) -> int:
    """The number of pairs that touch. It needs no memory for them."""
    return _ask(a, b, precision, threads).question().count()


def touches(a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0) -> bool:
    """Whether any pair touches. The search ends at the first that is found."""
    return _ask(a, b, precision, threads).question().any()


def hits(
    a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0
) -> tuple[Bools, Bools]:
    """For each element of a, and for each of b, whether it touches the other set."""
    asked = _ask(a, b, precision, threads)
    of_a, of_b = asked.question().flags()
    return (of_b, of_a) if asked.turned else (of_a, of_b)


def counts(
    a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0
) -> tuple[Longs, Longs]:
    """For each element of a, and for each of b, the number of elements of the other set that it touches."""
    asked = _ask(a, b, precision, threads)
    of_a, of_b = asked.question().counts()
    return (of_b, of_a) if asked.turned else (of_a, of_b)


def first(segments: Set, mesh: Meshlike, *, precision: Precision = "certified", threads: int = 0) -> Ints:
    """For each segment the triangle that it meets first on its way from start to end, -1 for none: (n,).

    Of triangles that it meets at one point, it is the one with the least number. Set.rays makes segments of rays.
    """
    asked = _ask(segments, mesh, precision, threads)
    if (asked.a.kind, asked.b.kind) != ("segment", "triangle"):
        raise InputError(f"first: it is asked of segments and triangles, not of {asked.a.kind} and {asked.b.kind}")
    if asked.a._source.owner is not None:
        raise InputError("first: the segments are parts of polylines, which have no first triangle", array="segments")
    return asked.question().first()


@overload
def over_poses(
    a: Meshlike,
    b: Meshlike,
    poses: ArrayLike,
    *,
    want: Literal["count"] = ...,
    precision: Precision = ...,
    threads: int = ...,
) -> Longs: ...
@overload
def over_poses(
    a: Meshlike,
    b: Meshlike,
    poses: ArrayLike,
    *,
    want: Literal["any"],
    precision: Precision = ...,
    threads: int = ...,
) -> Bools: ...
def over_poses(
    a: Meshlike,
    b: Meshlike,
    poses: ArrayLike,
    *,
    want: Literal["count", "any"] = "count",
    precision: Precision = "certified",
    threads: int = 0,
) -> Longs | Bools:
    """For each pose of b, (n, 4, 4) or (n, 3, 4), the number of pairs that touch, or with want="any" whether one does.

    A pose takes the place of b's own, as in b.at(pose). A pose in which the boxes are apart costs next to nothing.
    """
    if want not in ("count", "any"):
        raise InputError(f"want: {want!r} is unknown; known: count, any", value=want)
    asked = _ask(a, b, precision, threads)
    matrices = _arrays.poses(poses, "poses", True)
    question = asked._replace(b=asked.b._without_pose()).question()
    try:
        found = question.poses(not asked.turned, matrices, want == "any")
    except _native.Fault as fault:
        raise InputError(str(fault), array="poses", element=fault.element, value=fault.value) from None
    except ValueError as error:
        raise InputError(f"poses: {error}", array="poses") from None
    return found.astype(np.bool_) if want == "any" else found

