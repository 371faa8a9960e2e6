"""Values of users as the library takes them: NumPy's as those of JSON, rows of samples, whole and finite numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import bad_input

Word = TypeVar("Word", bound=str)


def plain(value: Any, path: str = "") -> Any:
    """The same without arrays and NumPy's numbers; ``path`` is where it stands.

    Raises:
        BadInput: a number that is not finite.
    """
    if isinstance(value, Mapping):
        return {str(key): plain(inner, f"{path}.{key}" if path else str(key)) for key, inner in value.items()}
    if isinstance(value, (np.ndarray, np.generic)):
        return plain(value.tolist(), path)
    if isinstance(value, (list, tuple)):
        return [plain(inner, f"{path}[{k}]") for k, inner in enumerate(value)]
    if isinstance(value, float):
        return finite(path, value)
    return value


def finite(field: str, value: float) -> float:
    """A finite number.

    Raises:
        BadInput: another one.
    """
    number = float(value)
    if not math.isfinite(number):
        raise bad_input("a number is not finite", field=field, value=value, allowed="finite numbers", way_out="give one")
    return number


def whole(field: str, given: ArrayLike) -> NDArray[np.int64]:
    """Whole numbers in one axis.

    Raises:
        BadInput: others, or of another shape.
    """
    values = np.asarray(given)
    if values.ndim != 1 or (values.size and not np.issubdtype(values.dtype, np.integer)):
        raise bad_input(
            f"{field} are whole numbers in one axis",
            field=field,
            value=f"{values.dtype} of shape {values.shape}",
            allowed="integers in one axis",
            way_out="round them, and give a flat list",
        )
    return values.astype(np.int64)


def one_of(field: str, value: Word, *allowed: Word) -> Word:
    """One of some words.

    Raises:
        BadInput: another one.
    """
    if value not in allowed:
        words = ", ".join(allowed)
        raise bad_input(f"there is no {field} {value!r}", field=field, value=value, allowed=words, way_out="choose one of these")
    return value


def in_rows(field: str, given: Mapping[str, ArrayLike]) -> tuple[list[str], NDArray[np.float64], bool]:
    """Names, their values with a row for each sample, and whether all were single numbers.

    Raises:
        BadInput: values of more than one axis, or not finite.
        ValueError: values of different lengths.
    """
    arrays = {name: np.asarray(value, dtype=np.float64) for name, value in given.items()}
    for name, values in arrays.items():
        wrong = np.flatnonzero(~np.isfinite(values))
        if wrong.size:
            raise bad_input(
                "a value is not finite",
                field=name,
                value=values.ravel()[wrong[0]],
                allowed="finite numbers",
                way_out="leave the sample out",
                sample=int(wrong[0]),
            )
    wide = np.broadcast_arrays(*arrays.values()) if arrays else []
    shape = wide[0].shape if wide else ()
    if len(shape) > 1:
        raise bad_input("samples stand in one axis", field=field, value=shape, allowed="(sample,)", way_out="give flat arrays")
    rows = np.empty((shape[0] if shape else 1, len(arrays)))
    for column, values in enumerate(wide):
        rows[:, column] = values
    return list(arrays), rows, not shape


def in_places(first: ArrayLike, second: ArrayLike) -> tuple[tuple[NDArray[np.float64], NDArray[np.float64]], tuple[int, ...]]:
    """Two coordinates, broadcast, one place after the other; and the shape of both."""
    one, other = np.broadcast_arrays(np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64))
    return (np.ascontiguousarray(one).ravel(), np.ascontiguousarray(other).ravel()), one.shape
