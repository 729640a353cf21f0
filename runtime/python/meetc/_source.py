"""The arrays of a set, and the place in them of what is wrong."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from meetc import _arrays, _native
from meetc._errors import InputError
from meetc._types import Floats, Ints, Kind, Rounded

WIDTHS: dict[str, tuple[int, ...]] = {
    "triangle": (3, 3, 9),
    "segment": (2, 3, 6),
    "point": (3,),
    "sphere": (4,),
    "ball": (4,),
    "box": (2, 3, 6),
}


class Source(NamedTuple):
    """A set is prepared from these: arrays of the caller, or copies of them in the types that are needed."""

    kind: Kind
    numbers: Floats  # rows of numbers: of elements, or of vertices where there is an index
    corners: NDArray[Any] | None
    owner: NDArray[np.uint32] | None  # the item of each element
    items: int
    parts: tuple[tuple[str, tuple[int, ...]], ...]  # the argument of each part of a row, and the shape of its row
    rounded: Rounded
    notes: tuple[str, ...]

    def items_of(self, elements: Ints) -> Ints:
        """The items of elements: faces, where these were cut into triangles."""
        return elements if self.owner is None else self.owner[elements].astype(np.int32)

    def native_kind(self) -> str:
        return "sphere" if self.kind == "ball" else self.kind

    def place(self, element: int, field: int) -> tuple[str, int, float]:
        """The name of a number of an element, as vertices[7, 2], its row and its value."""
        row = element
        if self.corners is not None:
            row, field = int(self.corners[element, field // 3]), field % 3
        value = float(self.numbers[row, field])
        for name, shape in self.parts:
            size = int(np.prod(shape, dtype=int))
            if field < size:
                inside = tuple(int(i) for i in np.unravel_index(field, shape)) if shape else ()
                return _arrays.at_row(name, (row, *inside)), row, value
            field -= size
        raise AssertionError("a field beyond the row")

    def explain(self, fault: _native.Fault) -> InputError:
        """The line that names array, row and value."""
        noun = "face" if self.corners is not None and self.kind == "triangle" else self.kind
        item = fault.element if self.owner is None else int(self.owner[fault.element])
        if fault.kind in ("value", "moved"):
            place, row, value = self.place(fault.element, fault.field)
            text = f"{place} is {value}"
            if fault.kind == "moved":
                text += f", and {fault.value} under the pose"
            if self.corners is not None:
                text += f" (a corner of {noun} {item})"
            return InputError(text, array=place[: place.index("[")], row=row, element=item, value=value)
        if fault.kind == "rule":
            row_of, values, at = self.numbers[fault.element], [], 0
            for name, shape in self.parts:
                size = int(np.prod(shape, dtype=int))
                found = row_of[at : at + size].reshape(shape).tolist()
                values.append(f"{name}[{fault.element}] is {found}")
                at += size
            return InputError(
                f"{', '.join(values)}: a {noun} needs {fault.rule}",
                array=self.parts[-1][0],
                row=fault.element,
                element=fault.element,
                value=row_of.tolist(),
            )
        return InputError(str(fault), element=fault.element)


def is_mesh(value: object) -> bool:
    """Whether it has faces, and vertices or points."""
    return hasattr(value, "faces") and (hasattr(value, "vertices") or hasattr(value, "points"))


def mesh_of(mesh: Any) -> tuple[Any, NDArray[Any]]:
    """Vertices and faces of an object that has them. The faces may be flat (_polygons.py)."""
    vertices = mesh.vertices if hasattr(mesh, "vertices") else mesh.points
    return vertices, _arrays.as_array(mesh.faces, "faces")
