"""Queries: which elements of two sets touch."""

from __future__ import annotations

from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from meetc import _arrays, _native
from meetc._asked import ask
from meetc._errors import InputError
from meetc._types import Bools, Ints, Longs, Meshlike, Precision


def pairs(a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0) -> Ints:
    """All pairs of elements that touch, (k, 2), sorted by the first, then by the second.

    Elements that share a single point touch; a mesh is a surface. `certified` and `exact` are right for every finite
    float32 input; fp32, fp64 and fp64x2 take computed signs as they are. A set against itself gives every ordered pair
    (i, j), i = j included. Other threads of Python run meanwhile, and Ctrl-C ends the query.
    """
    asked = ask(a, b, precision, threads)
    return asked.question().pairs(asked.turned)


def count(a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0) -> int:
    """The number of pairs that touch. It needs no memory for them."""
    return ask(a, b, precision, threads).question().count()


def touches(a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0) -> bool:
    """Whether any pair touches. The search ends at the first that is found."""
    return ask(a, b, precision, threads).question().any()


def hits(
    a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0
) -> tuple[Bools, Bools]:
    """For each element of a, and for each of b, whether it touches the other set."""
    asked = ask(a, b, precision, threads)
    of_a, of_b = asked.question().flags()
    return (of_b, of_a) if asked.turned else (of_a, of_b)


def counts(
    a: Meshlike, b: Meshlike, *, precision: Precision = "certified", threads: int = 0
) -> tuple[Longs, Longs]:
    """For each element of a, and for each of b, the number of elements of the other set that it touches."""
    asked = ask(a, b, precision, threads)
    of_a, of_b = asked.question().counts()
    return (of_b, of_a) if asked.turned else (of_a, of_b)


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
    asked = ask(a, b, precision, threads)
    matrices = _arrays.poses(poses, "poses", True)
    question = asked._replace(b=asked.b._without_pose()).question()
    try:
        found = question.poses(not asked.turned, matrices, want == "any")
    except _native.Fault as fault:
        raise InputError(str(fault), array="poses", element=fault.element, value=fault.value) from None
    except ValueError as error:
        raise InputError(f"poses: {error}", array="poses") from None
    return found.astype(np.bool_) if want == "any" else found

