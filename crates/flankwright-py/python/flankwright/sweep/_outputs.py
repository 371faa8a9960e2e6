"""What is kept of every sample: entries of documents, or what functions make of a result."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import _paths

Columns = dict[str, NDArray[Any]]
"""Values of outputs over the samples, and ``error``."""

Output = str | Callable[[Any], Any]
"""A path in the document of a result, or a function of the result (for a forward model: of the flanks of one sample)."""

Outputs = Mapping[str, Output] | Sequence[str]
"""Outputs by name; paths alone are their own names."""


def named(outputs: Outputs) -> dict[str, Output]:
    """Outputs by name.

    Raises:
        ValueError: there are none, or a name is that of the column of errors.
    """
    found: dict[str, Output] = {}
    found.update(outputs if isinstance(outputs, Mapping) else {path: path for path in outputs})
    if not found:
        raise ValueError("a sweep has at least one output")
    if "error" in found:
        raise ValueError("'error' is the column of refused samples: choose another name")
    slashed = [name for name in found if "/" in name]
    if slashed:
        raise ValueError(f"{slashed[0]!r} has a slash, by which Zarr divides groups: choose another name")
    return found


def of_result(output: Output, result: Any) -> Any:
    """The value of an output."""
    return _paths.get(result.document, output) if isinstance(output, str) else output(result)


def columns(values: Mapping[str, Sequence[Any]], errors: Sequence[str]) -> Columns:
    """Values of each output as arrays, and the codes of errors. Samples without a value are NaN, or an empty word; an output that no sample
    has is left out, because its shape is unknown.

    Raises:
        ValueError: values of different shapes.
    """
    found = {name: _column(name, of) for name, of in values.items() if any(value is not None for value in of)}
    return {**found, "error": np.array(errors, dtype=np.str_)}


def joined(parts: Sequence[Columns], names: Iterable[str]) -> Columns:
    """Columns of several chunks one after the other, all of these names and the errors."""
    return {name: np.concatenate(_filled(name, parts)) for name in (*names, "error")}


class Shapes:
    """What the columns of a sweep have in common: one shape and one kind of values for all chunks."""

    def __init__(self) -> None:
        self._known: dict[str, tuple[tuple[int, ...], bool]] = {}

    def check(self, part: Columns) -> None:
        """Takes a chunk in.

        Raises:
            ValueError: it has values of other shapes than those before, or numbers where they have words.
        """
        for name, values in part.items():
            found = (values.shape[1:], values.dtype.kind in "UOT")
            first = self._known.setdefault(name, found)
            if found != first:
                kinds = ["words" if words else f"numbers of the shape {shape}" for shape, words in (first, found)]
                raise ValueError(f"the output {name!r} has {kinds[0]} for some samples and {kinds[1]} for others")


def _filled(name: str, parts: Sequence[Columns]) -> list[NDArray[Any]]:
    like = next((part[name] for part in parts if name in part), np.empty(0))
    empty = "" if like.dtype.kind == "U" else np.nan
    return [part[name] if name in part else np.full((len(part["error"]), *like.shape[1:]), empty) for part in parts]


def _column(name: str, values: Sequence[Any]) -> NDArray[Any]:
    given = [value for value in values if value is not None]
    if all(isinstance(value, str) for value in given):
        return np.array(["" if value is None else value for value in values], dtype=np.str_)
    arrays = [np.asarray(value, dtype=np.float64) for value in given]
    shape = arrays[0].shape
    if any(array.shape != shape for array in arrays):
        raise ValueError(f"the output {name!r} has values of different shapes: {sorted({a.shape for a in arrays})}")
    filled = np.full((len(values), *shape), np.nan)
    rows = [k for k, value in enumerate(values) if value is not None]
    filled[rows] = arrays
    return filled
