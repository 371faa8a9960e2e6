"""Works a sweep off: here, or on a cluster."""

from __future__ import annotations

import hashlib
import inspect as python
import json
import os
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._forward import Forward
from .._jobs import Job
from .._tasks import AnyJob, as_job
from ._chunk import Task, evaluate
from ._folder import Folder, Form, read
from ._outputs import Columns, Output, Outputs, joined, named
from ._samples import Samples

if TYPE_CHECKING:
    import xarray
    from distributed import Client

# Samples of a chunk: some seconds of previews, few enough that an interruption loses little.
CHUNK = 256


class Swept:
    """What a sweep has found; ``found["name"]`` is a column.

    Attributes:
        samples: The samples.
        columns: Outputs by name, shape (sample, ...), and ``error``: the code of the error of a refused sample, else an empty word.
    """

    def __init__(self, samples: Samples, columns: Columns) -> None:
        self.samples, self.columns = samples, columns

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

    def to_xarray(self) -> xarray.Dataset:
        """Labelled arrays: over the paths of a grid, else over ``sample``; axes of an output of its own follow as ``NAME_0``, ``NAME_1``."""
        import xarray

        shape, paths = self.samples.shape, list(self.samples.columns)
        is_grid = len(shape) == len(paths) and len(shape) > 1
        dims = tuple(paths) if is_grid else ("sample",)
        data = {}
        for name, values in self.columns.items():
            inner = tuple(f"{name}_{k}" for k in range(values.ndim - 1))
            data[name] = ((*dims, *inner), values.reshape(*(shape if is_grid else (len(self.samples),)), *values.shape[1:]))
        if is_grid:
            columns = self.samples.columns
            coordinates = {path: columns[path].reshape(shape)[_along(k, len(shape))] for k, path in enumerate(paths)}
        else:
            coordinates = {path: ("sample", values) for path, values in self.samples.columns.items()}
        return xarray.Dataset(data, coordinates)

    def __repr__(self) -> str:
        refused = int((self.columns["error"] != "").sum())
        return f"<Swept: {len(self.samples)} samples, {refused} refused, {', '.join(self.columns)}>"


def _along(axis: int, axes: int) -> tuple[Any, ...]:
    return tuple(slice(None) if k == axis else 0 for k in range(axes))


def run(
    model: AnyJob | Forward,
    samples: Samples,
    outputs: Outputs,
    *,
    task: Task = "preview",
    folder: str | os.PathLike[str] | None = None,
    form: Form = "parquet",
    chunk: int = CHUNK,
    client: Client | None = None,
    progress: bool = True,
    load: bool = True,
) -> Swept:
    """Works a sweep off.

    Args:
        model: A job whose entries are replaced by the samples, or a forward model whose deviations they are.
        samples: From :func:`grid`, :func:`sobol`, :func:`latin_hypercube` or :func:`table`.
        outputs: What is kept of each sample: paths in the document of its result, or functions of the result; for a forward model functions of
            its flanks, an array of shape (flank, profile, helix). Numbers, words, or arrays that have the same shape for every sample.
        task: ``preview`` (plan without a referee), ``plan`` or ``simulate``.
        folder: Where finished chunks are kept. Begun again with the same arguments, the sweep goes on where it was.
        form: ``parquet`` for numbers and words, ``zarr`` for arrays as well.
        chunk: Samples of a chunk; no more than a few chunks are in memory at a time, if they are kept in a folder and not loaded.
        client: A client of a Dask cluster; without it, all cores of this machine.
        progress: Shows a bar.
        load: Returns all columns; without it, those of no sample (they are in the folder).

    Returns:
        A row for every sample. A sample that was refused has no values (NaN, an empty word) and the code of its error.

    Raises:
        ValueError: arguments that contradict each other, or a folder with another sweep.
        BadInput: a forward model that is asked for deviations it does not know.
    """
    if chunk < 1:
        raise ValueError(f"chunk = {chunk}: give 1 or more")
    if not load and folder is None:
        raise ValueError("load=False keeps nothing without a folder")
    wanted = named(outputs)
    of = model if isinstance(model, Forward) else as_job(model)
    kept = None if folder is None else Folder(Path(folder), _asked(of, task, wanted), samples, chunk, form)
    parts = list(samples.chunks(chunk))
    missing = [part for part in parts if kept is None or not kept.has(part)]
    held: dict[int, Columns] = {}
    with _bar(progress, len(samples), sum(part.stop - part.start for part in parts if part not in missing)) as told:
        for part, columns in _worked_off(of, task, samples, wanted, missing, client):
            if kept is None:
                held[part.start] = columns
            else:
                kept.put(part, columns)
            told(part.stop - part.start)
    if not load:
        return Swept(samples, {"error": np.array([], dtype=np.str_)})
    return Swept(samples, kept.get() if kept is not None else joined([held[part.start] for part in parts], wanted))


def load(folder: str | os.PathLike[str]) -> Columns:
    """The columns of all finished chunks of a folder, without computing anything.

    Args:
        folder: The folder of a sweep, finished or not.

    Returns:
        Outputs by name, shape (finished sample, ...), and ``error``, as in :attr:`Swept.columns`.

    Raises:
        FileNotFoundError: the folder holds no sweep.
    """
    path = Path(folder)
    asked = json.loads((path / "sweep.json").read_text(encoding="utf-8"))
    count = 1
    for length in asked["shape"]:
        count *= length
    return read(path, asked["form"], asked["chunk"], count, asked["outputs"])


def _worked_off(
    model: Job | Forward,
    task: Task,
    samples: Samples,
    outputs: dict[str, Output],
    parts: Iterable[slice],
    client: Client | None,
) -> Iterator[tuple[slice, Columns]]:
    if client is None:
        for part in parts:
            yield part, evaluate(model, task, samples[part], outputs)
        return
    from distributed import as_completed

    cluster: Any = client
    workers: dict[str, int] = cluster.nthreads()
    # A few chunks for each worker at a time: memory is bounded, and nobody waits.
    ahead, threads = 2 * max(1, len(workers)), max(workers.values(), default=1)
    waiting = iter(parts)
    under_way: dict[Any, slice] = {}

    def submit(part: slice) -> Any:
        # The model goes with every chunk: it is small, and nothing has to be found again when a worker dies.
        future = cluster.submit(evaluate, model, task, samples[part], outputs, threads, pure=False, retries=10)
        under_way[future.key] = part
        return future

    running: Any = as_completed([submit(part) for part in islice(waiting, ahead)])  # type: ignore[no-untyped-call]
    for future in running:
        yield under_way.pop(future.key), future.result()
        for part in islice(waiting, 1):
            running.add(submit(part))


def _asked(model: Job | Forward, task: Task, outputs: dict[str, Output]) -> dict[str, Any]:
    job = model.job if isinstance(model, Forward) else model
    points = list(model.points) if isinstance(model, Forward) else None
    return {
        "version": _core.VERSION,
        "task": "forward" if isinstance(model, Forward) else task,
        "points": points,
        "job": hashlib.sha256(job.text.encode()).hexdigest(),
        "outputs": {name: output if isinstance(output, str) else _source(output) for name, output in outputs.items()},
    }


def _source(function: Callable[..., Any]) -> str:
    """By which the same function is known again."""
    try:
        text = python.getsource(function)
    except (OSError, TypeError):
        text = repr(getattr(function, "__qualname__", function))
    return hashlib.sha256(text.encode()).hexdigest()


class _bar:
    """A bar of progress, or none."""

    def __init__(self, shown: bool, total: int, done: int) -> None:
        self.bar: Any = None
        if shown:
            from tqdm.auto import tqdm

            self.bar = tqdm(total=total, initial=done, unit="sample")

    def __enter__(self) -> Callable[[int], None]:
        return lambda count: self.bar.update(count) if self.bar is not None else None

    def __exit__(self, *_: object) -> None:
        if self.bar is not None:
            self.bar.close()
