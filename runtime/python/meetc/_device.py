"""Sets on a CUDA device."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Literal, NamedTuple, Union, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from meetc import _arrays, _native
from meetc._asked import Asked, ask, find, require_precision
from meetc._errors import DeviceError, InputError
from meetc._set import Set, as_set
from meetc._source import WIDTHS
from meetc._types import Bools, Doubles, Ints, Kind, Longs, Meshlike, OnDevice

CUDA = (2, 13)  # DLPack's numbers of memory of a CUDA device, and of memory that such a device shares with the host
Device = Literal["cpu", "cuda"]
Collidable = Union[Meshlike, "DeviceSet"]


def devices() -> list[str]:
    """The devices that queries can run on: "cpu", and "cuda" where this build has CUDA and there is such a device."""
    if not _native.with_cuda:
        return ["cpu"]
    try:
        _native.device_name()
    except _native.DeviceFault:
        return ["cpu"]
    return ["cpu", "cuda"]


def require_cuda(what: str) -> None:
    if not _native.with_cuda:
        raise DeviceError(f"{what}: this build has the CPU alone; one with MEETC_CUDA=ON has devices")


@contextmanager
def faults() -> Iterator[None]:
    """Errors of the device as DeviceError, and of elements that it has checked as InputError."""
    try:
        yield
    except _native.DeviceFault as fault:
        raise DeviceError(str(fault)) from None
    except _native.Fault as fault:
        raise InputError(str(fault), element=fault.element, value=fault.value) from None


class _Array(NamedTuple):
    address: int
    shape: tuple[int, ...]
    strides: tuple[int, ...]  # in bytes
    type_: str  # as NumPy writes it
    kept: object  # the memory's owner


def _by_interface(value: Any, name: str) -> _Array:
    found = value.__cuda_array_interface__
    shape, type_ = tuple(found["shape"]), str(found["typestr"])
    strides = found.get("strides")
    if strides is None:
        strides, packed = [], int(type_[2:])
        for n in reversed(shape):
            strides.insert(0, packed)
            packed *= n
    if found.get("mask") is not None:
        raise TypeError(f"{name}: it has a mask, which no set has")
    if (stream := found.get("stream")) is not None:
        _native.wait_for(stream)
    return _Array(found["data"][0], shape, tuple(strides), type_, value)


def _by_dlpack(value: Any) -> _Array:
    return _Array(*_native.from_dlpack(value.__dlpack__(stream=1)))


def there(value: Any, name: str, types: tuple[str, ...], wide: int) -> _Array:
    """An array of rows on the device. Waits for the array's stream."""
    if not _arrays.on_device(value):
        raise TypeError(f"{name}: an array on the device is needed, not {type(value).__name__}; Set takes those of the host")
    if hasattr(value, "__cuda_array_interface__"):
        found = _by_interface(value, name)
    elif (kind := value.__dlpack_device__()[0]) in CUDA:
        found = _by_dlpack(value)
        _native.wait_for(1)
    else:
        raise TypeError(f"{name}: it lies on a device of kind {kind} of DLPack, which is not CUDA")
    if found.type_ not in types:
        raise TypeError(f"{name}: on a device, numbers are of type {' or '.join(types)}, not {found.type_}")
    if len(found.shape) != 2 or found.shape[1] != wide:
        raise InputError(f"{name}: its shape is {_arrays.shape_text(found.shape)}, not (n, {wide})", array=name)
    if found.shape[0] == 0:
        raise InputError(f"{name}: it is empty", array=name)
    if found.shape[0] > _arrays.MOST:
        raise InputError(f"{name}: it has {found.shape[0]} rows, more than 2^31 - 1", array=name)
    size = int(found.type_[2:])
    if found.strides[1] != size or found.strides[0] < size * wide:
        raise InputError(f"{name}: the columns of a row are not packed", array=name)
    return found


class DeviceSet:
    """Elements whose arrays lie on a CUDA device: those of CuPy, PyTorch, Warp, Numba and others. Nothing is copied
    but faces in int64, which are narrowed there when the set is made.

    DeviceSet(vertices, faces)                  float32 (n, 3), int32, uint32 or int64 (m, 3)
    DeviceSet(rows, kind="sphere")              rows of the kind's own numbers

    pairs, count, touches, hits, counts and first take it in place of a Set, and find on the device what it touches. Each
    query reads the arrays anew, moves, checks and orders them: it is for sets that are collided once. The streams of the
    arrays are waited for when the set is made. Later writes to the arrays must have ended before a query.
    """

    __slots__ = ("__weakref__", "_kept", "_kind", "_pose", "_there")

    def __init__(
        self, vertices: OnDevice, faces: OnDevice | None = None, *, kind: Kind = "triangle", pose: ArrayLike | None = None
    ) -> None:
        require_cuda("DeviceSet")
        if kind not in WIDTHS:
            raise InputError(f"kind: {kind!r} is unknown; known: {', '.join(WIDTHS)}", value=kind)
        if faces is not None and kind not in ("triangle", "segment"):
            raise TypeError(f"faces: elements of kind {kind!r} have none")
        numbers = there(vertices, "vertices", ("<f4",), WIDTHS[kind][-1] if faces is None else 3)
        index = None if faces is None else there(faces, "faces", ("<i4", "<u4", "<i8"), 3 if kind == "triangle" else 2)
        self._make(kind, numbers, index, None if pose is None else _arrays.poses(pose, "pose", False)[0])

    def _make(self, kind: Kind, numbers: _Array, index: _Array | None, pose: Doubles | None) -> None:
        self._kind, self._pose, self._kept = kind, pose, (numbers, index)
        try:
            with faults():
                self._there = _native.given(
                    "sphere" if kind == "ball" else kind,
                    (numbers.address, numbers.shape[0], numbers.strides[0]),
                    None if index is None else (index.address, index.shape[0], index.strides[0]),
                    pose,
                )
        except InputError:
            raise
        except ValueError as error:  # a pose that does not go with the kind
            raise InputError(f"pose: {error}", array="pose") from None

    @classmethod
    def _made(cls, of: DeviceSet, pose: Doubles | None) -> DeviceSet:
        made = cls.__new__(cls)
        made._make(of._kind, *of._kept, pose)
        return made

    def at(self, pose: ArrayLike | None) -> DeviceSet:
        """The same elements in a pose, 4x4 or 3x4; None: as the arrays have them."""
        return DeviceSet._made(self, None if pose is None else _arrays.poses(pose, "pose", False)[0])

    def __len__(self) -> int:
        return self._there.elements

    @property
    def kind(self) -> Kind:
        """triangle, segment, point, ball, sphere (the surface alone) or box."""
        return self._kind

    def __repr__(self) -> str:
        return f"<meetc.DeviceSet: {len(self):,} of kind {self.kind}>"

class QuestionThere:
    """A question about two sets on the device; its errors are those of the package."""

    def __init__(self, of: _native.QuestionThere) -> None:
        self._of = of

    def pairs(self, turn: bool) -> Ints:
        with faults():
            return self._of.pairs(turn)

    def flags(self) -> tuple[Bools, Bools]:
        with faults():
            return self._of.flags()

    def counts(self) -> tuple[Longs, Longs]:
        with faults():
            return self._of.counts()

    def count(self) -> int:
        with faults():
            return self._of.count()

    def any(self) -> bool:
        with faults():
            return self._of.any()

    def first(self) -> Ints:
        with faults():
            return self._of.first()


def question(
    a: object, b: object, precision: str, threads: int, device: Device
) -> tuple[_native.Question | QuestionThere, bool]:
    """A question on the host, or on the device where it is asked for or a set lies there; and whether it is turned."""
    require_device(device)
    if device == "cpu" and not isinstance(a, DeviceSet) and not isinstance(b, DeviceSet):
        asked = ask(a, b, precision, threads)
        return asked.question(), asked.turned
    require_cuda("device='cuda'")
    require_precision(precision)
    threads = _arrays.require_threads(threads)
    first: Set | DeviceSet = a if isinstance(a, DeviceSet) else as_set(a, "a", threads)
    second: Set | DeviceSet = b if isinstance(b, DeviceSet) else as_set(b, "b", threads)
    if b is a:
        second = first
    predicate, turned, _ = find(first.kind, second.kind)
    one, other = (second, first) if turned else (first, second)
    with faults():
        there = _native.QuestionThere(_there(one), _there(other), predicate, precision, _owner(one), _owner(other))
    return QuestionThere(there), turned


def elements_there(asked: Asked) -> QuestionThere:
    """The same question there, whose answers are about elements, also where a set's faces were cut."""
    first, second = asked.in_order()
    with faults():
        there = _native.QuestionThere(uploaded(first), uploaded(second), asked.predicate, asked.precision, None, None)
    return QuestionThere(there)


def over_poses_there(asked: Asked, still_first: bool, matrices: NDArray[np.float64], any_pair: bool) -> Longs:
    """The number of pairs in each pose of the second set, or of the first one."""
    first, second = asked.in_order()
    of_a, of_b = _owner(first), _owner(second)
    with faults():
        # A set that is moved there, pose by pose, is one of its own.
        a = uploaded(first) if still_first else _native.upload(first._ready)
        b = _native.upload(second._ready) if still_first else uploaded(second)
        return _native.QuestionThere(a, b, asked.predicate, asked.precision, of_a, of_b).poses(still_first, matrices, any_pair)


def require_device(device: str) -> bool:
    """Whether it is the CUDA device, which then is there."""
    if device not in get_args(Device):
        raise InputError(f"device: {device!r} is unknown; known: {', '.join(get_args(Device))}", value=device)
    if device == "cuda":
        require_cuda("device='cuda'")
    return device == "cuda"


def uploaded(of: Set) -> _native.SetThere:
    """The set on the device, to which it is copied once."""
    if of._uploaded is None:
        of._uploaded = _native.upload(of._ready)
    return of._uploaded


def _there(of: Set | DeviceSet) -> _native.SetThere:
    return of._there if isinstance(of, DeviceSet) else uploaded(of)


def _owner(of: Set | DeviceSet) -> NDArray[np.uint32] | None:
    return None if isinstance(of, DeviceSet) else of._source.owner
