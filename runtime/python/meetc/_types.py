"""The types of arguments and results."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from meetc._set import Set

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Bools = NDArray[np.bool_]
Floats = NDArray[np.float32]
Doubles = NDArray[np.float64]

Kind = Literal["triangle", "segment", "point", "sphere", "ball", "box"]
Precision = Literal["certified", "exact", "fp32", "fp64", "fp64x2"]


class HasFaces(Protocol):
    """trimesh.Trimesh, and all that looks like it."""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class HasPoints(Protocol):
    """pyvista.PolyData, and all that looks like it: faces are (M, 3), or flat with the number of corners before each."""

    @property
    def points(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class _ByInterface(Protocol):
    @property
    def __cuda_array_interface__(self) -> Any: ...


class _ByDLPack(Protocol):
    def __dlpack__(self, *, stream: Any = ...) -> Any: ...


OnDevice = Union[_ByInterface, _ByDLPack]  # the arrays of CuPy, PyTorch, Warp, Numba

Meshlike = Union["Set", HasFaces, HasPoints, "tuple[ArrayLike, ArrayLike]"]


class Rounded(NamedTuple):
    """The moves of numbers by rounding to float32."""

    numbers: int  #: how many numbers
    largest: float  #: how far at most


class Formula(NamedTuple):
    """A formula that evaluate() knows."""

    name: str
    operands: tuple[tuple[str, tuple[str, ...]], ...]  #: for each the kind, and the names of its numbers in order
    values: tuple[str, ...]  #: the names of the columns of the result
