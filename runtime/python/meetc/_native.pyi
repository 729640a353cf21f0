# The compiled module, runtime/python/*.cpp. Arrays have the types that the package's own code has given them.
from typing import Any

import numpy as np
from numpy.typing import NDArray

_Ints = NDArray[np.int32]
_Longs = NDArray[np.int64]
_Bools = NDArray[np.bool_]

version: str
pybind11: tuple[int, int]
with_cuda: bool

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
    def poses(self, still_first: bool, poses: NDArray[np.float64], any: bool) -> _Longs: ...

_Arrays = tuple[NDArray[np.float32], NDArray[Any] | None, NDArray[np.float64] | None]  # numbers, index, pose

def contacts(
    a: _Arrays, b: _Arrays, predicate: str, pairs: _Ints, wide: bool, embedded: bool, threads: int
) -> dict[str, Any]: ...
def exact_point(a: NDArray[np.float32], b: NDArray[np.float32], label: int) -> list[list[str]]: ...
def self_pairs(
    set: Prepared,
    numbers: NDArray[np.float32],
    index: NDArray[Any] | None,
    owner: NDArray[np.uint32] | None,
    merge: bool,
    threads: int,
) -> tuple[_Ints, _Ints]: ...
# Kind, numbers, index, owner, items, pose, name, the numbers that float32 moved, how far at most, notes.
_Side = tuple[
    str,
    NDArray[np.float32],
    NDArray[Any] | None,
    NDArray[np.uint32] | None,
    int,
    NDArray[np.float64] | None,
    str,
    int,
    float,
    list[str],
]

def page_of_two(
    a: _Side,
    b: _Side | None,
    predicate: str,
    turned: bool,
    precision: str,
    pairs: _Ints,
    elements: _Ints,
    threads: int,
) -> bytes: ...
def page_of_one(a: _Side, merged: bool, pairs: _Ints, elements: _Ints, threads: int) -> bytes: ...
def page_of_bodies(
    shapes: list[_Side],
    bodies: list[tuple[str, int, NDArray[np.float64]]],
    frames: list[
        tuple[
            str,
            list[tuple[int, NDArray[np.float64]]],
            list[tuple[int, int, int]],
            list[tuple[int, int, str, str]],
        ]
    ],
    precision: str,
) -> bytes: ...
def polygon_starts(flat: _Longs, least: int) -> _Longs: ...
def cut_polygons(
    points: NDArray[np.float32], corners: NDArray[np.uint32], counts: NDArray[np.uint32], threads: int
) -> tuple[NDArray[np.uint32], NDArray[np.uint32], list[str]]: ...

class SetThere:  # the rest is there with CUDA alone
    @property
    def elements(self) -> int: ...

class QuestionThere:
    def __init__(
        self,
        a: SetThere,
        b: SetThere,
        predicate: str,
        precision: str,
        owner_a: NDArray[np.uint32] | None,
        owner_b: NDArray[np.uint32] | None,
    ) -> None: ...
    def pairs(self, turn: bool) -> _Ints: ...
    def flags(self) -> tuple[_Bools, _Bools]: ...
    def counts(self) -> tuple[_Longs, _Longs]: ...
    def count(self) -> int: ...
    def any(self) -> bool: ...
    def first(self) -> _Ints: ...
    def poses(self, still_first: bool, poses: NDArray[np.float64], any: bool) -> _Longs: ...

class DeviceFault(RuntimeError): ...

def given(
    kind: str, numbers: tuple[int, int, int], index: tuple[int, int, int] | None, pose: NDArray[np.float64] | None
) -> SetThere: ...
def upload(set: Prepared) -> SetThere: ...
def wait_for(stream: int) -> None: ...
def device_name() -> str: ...
def from_dlpack(capsule: object) -> tuple[int, tuple[int, ...], tuple[int, ...], str, object]: ...

class World:
    def __init__(self, mode: str) -> None: ...
    def add(self, name: str, shape: Prepared, pose: NDArray[np.float64], owner: NDArray[np.uint32] | None) -> int: ...
    def move(self, body: int, pose: NDArray[np.float64]) -> None: ...
    def ignore(self, a: int, b: int, ignored: bool) -> None: ...
    def touching(self, of: list[int], precision: str, want: str, threads: int) -> list[tuple[int, int, int, _Ints]]: ...
    def nested(self, of: list[int], precision: str, threads: int) -> list[tuple[int, int, str, str]]: ...

class WorldThere:
    def __init__(self, world: World) -> None: ...
    def touching(self, of: list[int], precision: str, want: str, threads: int) -> list[tuple[int, int, int, _Ints]]: ...
    def nested(self, of: list[int], precision: str, threads: int) -> list[tuple[int, int, str, str]]: ...

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
def evaluate_columns_there(
    formula: str, operands: list[list[NDArray[np.float32]]], rows: NDArray[np.uint32] | None, wide: bool
) -> NDArray[Any]: ...
def evaluate_pairs_there(formula: str, a: SetThere, b: SetThere, pairs: NDArray[Any], wide: bool) -> NDArray[Any]: ...
def read(path: bytes, kind: str, threads: int) -> dict[str, Any]: ...
