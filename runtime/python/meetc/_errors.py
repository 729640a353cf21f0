"""The exceptions and warnings of the package, and the one place that writes their lines."""

from __future__ import annotations


class MeetError(Exception):
    """The base class of this package's own exceptions."""


class InputError(MeetError, ValueError):
    """Bad input: one line that names the array or file, the row and the value.

    The attributes say the same to a program; each is None where it does not apply.
    """

    def __init__(
        self,
        message: str,
        *,
        array: str | None = None,
        row: int | None = None,
        element: int | None = None,
        value: object = None,
    ) -> None:
        super().__init__(message)
        self.array = array  #: the name of the argument, such as "vertices"
        self.row = row  #: the row of that array, from 0
        self.element = element  #: the number of the element, such as the face
        self.value = value  #: what stands there

    def __reduce__(self) -> tuple[object, ...]:
        return (_input_error, (str(self), self.array, self.row, self.element, self.value))


def _input_error(message: str, array: str | None, row: int | None, element: int | None, value: object) -> InputError:
    return InputError(message, array=array, row=row, element=element, value=value)


class DeviceError(MeetError, RuntimeError):
    """A CUDA device is missing or has failed, or this build has none."""


class MeetWarning(UserWarning):
    """The input is taken, but its user should know how: a file's left-out parts, a polygon that is not planar."""


class RoundedWarning(MeetWarning):
    """float32 does not hold some numbers of the input; the answer is exact for the rounded ones."""
