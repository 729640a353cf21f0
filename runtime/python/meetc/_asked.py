"""Two sets, and the predicate that a query asks of them."""

from __future__ import annotations

from typing import NamedTuple, get_args

from numpy.typing import NDArray
import numpy as np

from meetc import _arrays, _native
from meetc._errors import InputError
from meetc._set import Set, as_set
from meetc._types import Precision


class Asked(NamedTuple):
    """Two sets, and the predicate that takes them, perhaps in the other order."""

    a: Set
    b: Set
    predicate: str
    turned: bool
    meets: bool  # whether the predicate tells where its elements meet
    precision: str
    threads: int
    owners: bool = True  # whether answers are about the faces of a file, and not about the triangles of these

    def in_order(self) -> tuple[Set, Set]:
        """The sets in the order of the predicate's kinds."""
        return (self.b, self.a) if self.turned else (self.a, self.b)

    def of_elements(self) -> Asked:
        return self._replace(owners=False)

    def question(self) -> _native.Question:
        first, second = self.in_order()

        def owner(of: Set) -> NDArray[np.uint32] | None:
            return of._source.owner if self.owners else None

        return _native.Question(
            first._ready, second._ready, self.predicate, self.precision, owner(first), owner(second), self.threads
        )


def ask(a: object, b: object, precision: str, threads: int) -> Asked:
    threads = _arrays.require_threads(threads)
    if precision not in get_args(Precision):
        raise InputError(
            f"precision: {precision!r} is unknown; known: {', '.join(get_args(Precision))}", value=precision
        )
    first = as_set(a, "a", threads)
    second = first if b is a else as_set(b, "b", threads)
    return Asked(first, second, *_find(first.kind, second.kind), precision, threads)


def _mode(kind: str) -> str:
    return {"ball": "solid", "sphere": "surface"}.get(kind, "")


def _find(a: str, b: str) -> tuple[str, bool, bool]:
    """The predicate for two kinds, whether it takes them in the other order, and whether it tells where they meet."""
    modes = {_mode(a), _mode(b)} - {""}
    wanted = tuple("sphere" if kind == "ball" else kind for kind in (a, b))
    known = []
    for name, mode, first, second, meets in _native.predicates():
        if (first, second) in (wanted, wanted[::-1]) and modes <= {mode, ""}:
            return name, (first, second) != wanted, meets
        known.append(" with ".join("ball" if k == "sphere" and mode == "solid" else k for k in (first, second)))
    raise InputError(f"there is no predicate for {a} with {b}; there are: {', '.join(known)}")
