"""Which values a sweep takes."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._extras import needed
from .._values import plain


class Samples:
    """Values by path of a job's key (or by name of a deviation), all equally many.

    Args:
        columns: Numbers or words by path, each of shape (sample,), in the units of the keys.
        shape: The shape of a grid.

    Raises:
        ValueError: columns of different lengths, values that are not finite or neither numbers nor words.

    Attributes:
        columns: One array of shape (sample,) for each path.
        shape: The shape of a grid in the order of its paths, else (sample,).
    """

    def __init__(self, columns: Mapping[str, ArrayLike], shape: tuple[int, ...] | None = None) -> None:
        self.columns: dict[str, NDArray[Any]] = {path: _column(values) for path, values in columns.items()}
        if not self.columns:
            raise ValueError("samples have at least one column")
        if any(values.size == 0 for values in self.columns.values()):
            raise ValueError("samples have at least one row")
        lengths = {path: values.shape for path, values in self.columns.items()}
        first = next(iter(lengths.values()))
        if any(len(of) != 1 or of != first for of in lengths.values()):
            raise ValueError(f"columns have the shapes {lengths}: give arrays of one axis, all equally long")
        for path, values in self.columns.items():
            if values.dtype.kind == "f" and not np.isfinite(values).all():
                raise ValueError(f"{path!r} has values that are not finite")
            if values.dtype.kind not in "biufUO":
                raise ValueError(f"{path!r} has values of the type {values.dtype}: give numbers or words")
        self.is_grid = shape is not None
        self.shape = shape or first
        if int(np.prod(self.shape)) != first[0]:
            raise ValueError(f"a grid of the shape {self.shape} has not {first[0]} samples")

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    def __getitem__(self, part: slice) -> list[dict[str, Any]]:
        """The samples of a part, each as changes by path, as :meth:`flankwright.Job.replace` takes them."""
        columns = {path: plain(values[part]) for path, values in self.columns.items()}
        return [dict(zip(columns, row)) for row in zip(*columns.values())]

    def chunks(self, size: int) -> Iterator[slice]:
        """Parts of so many samples, in order."""
        for begin in range(0, len(self), size):
            yield slice(begin, min(begin + size, len(self)))

    def digest(self) -> str:
        """A hash (SHA-256) by which the same samples are known again."""
        digest = hashlib.sha256()
        for path, values in self.columns.items():
            kept = values.astype("<f8").tobytes() if values.dtype.kind in "biuf" else json.dumps(plain(values)).encode()
            digest.update(json.dumps([path, values.dtype.kind, len(values)]).encode() + kept)
        return digest.hexdigest()

    def __repr__(self) -> str:
        return f"<Samples: {' x '.join(map(str, self.shape))} of {', '.join(self.columns)}>"


def _column(values: ArrayLike) -> NDArray[Any]:
    """A copy of values as an array; numbers beside words stay numbers."""
    column = np.array(values)
    if column.dtype.kind != "U" or all(isinstance(value, str) for value in np.ravel(np.array(values, dtype=object))):
        return column
    return np.array(values, dtype=object)


def grid(axes: Mapping[str, ArrayLike]) -> Samples:
    """Every combination; the last path runs fastest.

    Args:
        axes: Values by path, each of shape (values,), in the units of the keys.

    Raises:
        ValueError: an axis without values, or with more than one axis of its own.
    """
    values = [_column(of) for of in axes.values()]
    if any(of.ndim != 1 or of.size == 0 for of in values):
        raise ValueError("every axis of a grid is an array of one axis with at least one value")
    wide = np.meshgrid(*values, indexing="ij")
    shape = tuple(of.size for of in values)
    return Samples({path: of.ravel() for path, of in zip(axes, wide)}, shape)


def table(columns: Any) -> Samples:
    """The rows of a table.

    Args:
        columns: Columns of shape (row,) by path, or anything with columns, such as a data frame.

    Raises:
        ValueError: columns of different lengths, or values that are no samples.
    """
    if not isinstance(columns, Mapping):
        columns = {str(name): np.asarray(columns[name]) for name in columns.columns}
    return Samples(columns)


def sobol(
    ranges: Mapping[str, Sequence[float]], count: int, *, seed: int = 0, whole: Collection[str] = ()
) -> Samples:
    """Points of a scrambled Sobol sequence.

    Args:
        ranges: Least and largest value by path, in the units of the keys.
        count: How many points; powers of two are balanced.
        seed: Start of the scrambling; the same seed gives the same points.
        whole: Paths that take whole numbers, from the least to the largest, each as often as the others.

    Raises:
        ValueError: a range that is not two finite numbers in order.
    """
    import warnings

    needed("scipy", "sweep")
    from scipy.stats import qmc

    with warnings.catch_warnings():
        # That only powers of two are balanced is said above.
        warnings.simplefilter("ignore", UserWarning)
        points = qmc.Sobol(len(ranges), rng=np.random.default_rng(seed)).random(count)
    return _scaled(ranges, points, whole)


def latin_hypercube(
    ranges: Mapping[str, Sequence[float]], count: int, *, seed: int = 0, whole: Collection[str] = ()
) -> Samples:
    """Points of a Latin hypercube: every range is cut into as many parts as there are points, and each part has one.

    Args:
        ranges: Least and largest value by path, in the units of the keys.
        count: How many points.
        seed: Start of the drawing; the same seed gives the same points.
        whole: Paths that take whole numbers, from the least to the largest, each as often as the others.

    Raises:
        ValueError: a range that is not two finite numbers in order.
    """
    needed("scipy", "sweep")
    from scipy.stats import qmc

    points = qmc.LatinHypercube(len(ranges), rng=np.random.default_rng(seed)).random(count)
    return _scaled(ranges, points, whole)


def _scaled(
    ranges: Mapping[str, Sequence[float]], points: NDArray[np.float64], whole: Collection[str]
) -> Samples:
    columns: dict[str, NDArray[Any]] = {}
    unknown = sorted(set(whole) - set(ranges))
    if unknown:
        raise ValueError(f"{unknown[0]!r} is whole, but has no range")
    for k, (path, (low, high)) in enumerate(ranges.items()):
        if not (np.isfinite(low) and np.isfinite(high) and low <= high):
            raise ValueError(f"{path!r} has the range {low} to {high}: give two finite numbers in order")
        if path in whole:
            if int(low) != low or int(high) != high:
                raise ValueError(f"{path!r} has the range {low} to {high}: give two whole numbers")
            columns[path] = (int(low) + np.floor((high - low + 1) * points[:, k])).astype(np.int64)
        else:
            columns[path] = low + (high - low) * points[:, k]
    return Samples(columns)
