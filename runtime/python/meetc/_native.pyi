# The compiled module, runtime/python/*.cpp. Arrays have the types that the package's own code has given them.
from typing import Any

import numpy as np
from numpy.typing import NDArray

_Ints = NDArray[np.int32]
_Longs = NDArray[np.int64]
_Bools = NDArray[np.bool_]

version: str

class Fault(ValueError):
    kind: str  # view, index, value, moved or rule
    element: int
    field: int
    value: float
    index: int
    rule: str

class FileFault(ValueError): ...

class Prepared:
    @property
    def elements(self) -> int: ...
    def bounds(self) -> NDArray[np.float32]: ...

class Question:
    def __init__(
        self,
        a: Prepared,
        b: Prepared,
        predicate: str,
        precision: str,
        owner_a: NDArray[np.uint32] | None,
        owner_b: NDArray[np.uint32] | None,
        threads: int,
    ) -> None: ...
    def pairs(self, turn: bool) -> _Ints: ...
    def flags(self) -> tuple[_Bools, _Bools]: ...
    def counts(self) -> tuple[_Longs, _Longs]: ...
    def count(self) -> int: ...
    def any(self) -> bool: ...
    def first(self) -> _Ints: ...
    def poses(
        self,
        still_first: bool,
        numbers: NDArray[np.float32],
        index: NDArray[Any] | None,
        poses: NDArray[np.float64],
        any: bool,
    ) -> _Longs: ...

class World:
    def __init__(self, mode: str) -> None: ...
    def add(self, name: str, shape: Prepared, pose: NDArray[np.float64], owner: NDArray[np.uint32] | None) -> int: ...
    def move(self, body: int, pose: NDArray[np.float64]) -> None: ...
    def ignore(self, a: int, b: int, ignored: bool) -> None: ...
    def touching(self, precision: str, any: bool, threads: int) -> list[tuple[int, int, int]]: ...

def prepare(
    kind: str,
    numbers: NDArray[np.float32],
    index: NDArray[Any] | None,
    pose: NDArray[np.float64] | None,
    threads: int,
) -> Prepared: ...
def predicates() -> list[tuple[str, str, str, str, bool]]: ...
def kinds() -> list[tuple[str, str]]: ...
def formulas() -> list[tuple[str, list[tuple[str, str]], str]]: ...
def evaluate_columns(
    formula: str,
    operands: list[list[NDArray[np.float32]]],
    rows: NDArray[np.uint32] | None,
    wide: bool,
    threads: int,
) -> NDArray[Any]: ...
def evaluate_pairs(
    formula: str, a: Prepared, b: Prepared, pairs: NDArray[Any], wide: bool, threads: int
) -> NDArray[Any]: ...
def read(path: bytes, kind: str, threads: int) -> dict[str, Any]: ...
