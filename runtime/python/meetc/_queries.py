"""Queries: which elements of two sets touch."""

from __future__ import annotations

from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from meetc import _arrays, _native
from meetc._asked import ask
from meetc._device import Collidable, Device, over_poses_there, question, require_device
from meetc._errors import InputError
from meetc._types import Bools, Ints, Longs, Meshlike, Precision


def pairs(
    a: Collidable, b: Collidable, *, precision: Precision = "certified", threads: int = 0, device: Device = "cpu"
) -> Ints:
    """All pairs of elements that touch, (k, 2), sorted by the first, then by the second.

    Elements that share a single point touch; a mesh is a surface. `certified` and `exact` are right for every finite
    float32 input; fp32, fp64 and fp64x2 take computed signs as they are. A set against itself gives every ordered pair
    (i, j), i = j included. Other threads of Python run meanwhile, and Ctrl-C ends the query. With device="cuda", or a
    DeviceSet, the query runs on the device, to which a Set is uploaded once.
    """
    of, turned = question(a, b, precision, threads, device)
    return of.pairs(turned)


def count(
    a: Collidable, b: Collidable, *, precision: Precision = "certified", threads: int = 0, device: Device = "cpu"
) -> int:
    """The number of pairs that touch. It needs no memory for them."""
    return question(a, b, precision, threads, device)[0].count()


def touches(
    a: Collidable, b: Collidable, *, precision: Precision = "certified", threads: int = 0, device: Device = "cpu"
) -> bool:
    """Whether any pair touches. The search ends at the first that is found."""
    return question(a, b, precision, threads, device)[0].any()


def hits(
    a: Collidable, b: Collidable, *, precision: Precision = "certified", threads: int = 0, device: Device = "cpu"
) -> tuple[Bools, Bools]:
    """For each element of a, and for each of b, whether it touches the other set."""
    of, turned = question(a, b, precision, threads, device)
    of_a, of_b = of.flags()
    return (of_b, of_a) if turned else (of_a, of_b)


def counts(
    a: Collidable, b: Collidable, *, precision: Precision = "certified", threads: int = 0, device: Device = "cpu"
) -> tuple[Longs, Longs]:
    """For each element of a, and for each of b, the number of elements of the other set that it touches."""
    of, turned = question(a, b, precision, threads, device)
    of_a, of_b = of.counts()
    return (of_b, of_a) if turned else (of_a, of_b)


@overload
def over_poses(
    a: Meshlike,
    b: Meshlike,
    poses: ArrayLike,
    *,
    want: Literal["count"] = ...,
    precision: Precision = ...,
    threads: int = ...,
    device: Device = ...,
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
    device: Device = ...,
) -> Bools: ...
def over_poses(
    a: Meshlike,
    b: Meshlike,
    poses: ArrayLike,
    *,
    want: Literal["count", "any"] = "count",
    precision: Precision = "certified",
    threads: int = 0,
    device: Device = "cpu",
) -> Longs | Bools:
    """For each pose of b, (n, 4, 4) or (n, 3, 4), the number of pairs that touch, or with want="any" whether one does.

    A pose takes the place of b's own, as in b.at(pose). A pose in which the boxes are apart costs next to nothing. With
    device="cuda" the device takes many poses at once, where elements are not parts of faces.
    """
    if want not in ("count", "any"):
        raise InputError(f"want: {want!r} is unknown; known: count, any", value=want)
    there = require_device(device)
    asked = ask(a, b, precision, threads)
    matrices = _arrays.poses(poses, "poses", True)
    asked = asked._replace(b=asked.b._without_pose())
    try:
        if there:
            found = over_poses_there(asked, not asked.turned, matrices, want == "any")
        else:
            found = asked.question().poses(not asked.turned, matrices, want == "any")
    except InputError:
        raise
    except _native.Fault as fault:
        raise InputError(str(fault), array="poses", element=fault.element, value=fault.value) from None
    except ValueError as error:
        raise InputError(f"poses: {error}", array="poses") from None
    return found.astype(np.bool_) if want == "any" else found

