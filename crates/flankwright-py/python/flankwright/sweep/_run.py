"""Works a sweep off: here, or on a cluster."""

from __future__ import annotations

import hashlib
import json
import math
import operator
import os
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._errors import FlankwrightError
from .._extras import needed
from .._forward import Forward
from .._jobs import Job
from .._tasks import AnyJob, as_job
from .._values import one_of
from ._chunk import TASKS, Sender, Task, evaluate
from ._folder import FORMS, Folder, Form, read
from ._identity import identity
from ._outputs import Columns, Output, Outputs, Shapes, joined, named
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

    @property
    def is_loaded(self) -> bool:
        """Whether the columns are here; else they are in the folder, which :func:`load` reads."""
        return len(self.columns["error"]) == len(self.samples)

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

    def to_xarray(self) -> xarray.Dataset:
        """Labelled arrays: over the paths of a grid, else over ``sample``; axes of an output of its own follow as ``NAME_0``, ``NAME_1``."""
        needed("xarray", "arrays")
        import xarray

        if not self.is_loaded:
            raise ValueError("the columns are in the folder of the sweep: run it with load=True")
        shape, paths, is_grid = self.samples.shape, list(self.samples.columns), self.samples.is_grid
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
        if not self.is_loaded:
            return f"<Swept: {len(self.samples)} samples, kept in their folder>"
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
        folder: Where finished chunks are kept. Begun again with the same arguments, the sweep goes on where it was; functions are known again by
            their code and the plain values that they hold or name, the job by its text and the files that it names.
        form: ``parquet`` for numbers and words, ``zarr`` for arrays as well.
        chunk: Samples of a chunk; no more than a few chunks are in memory at a time, if they are kept in a folder and not loaded.
        client: A client of a Dask cluster; without it, all cores of this machine.
        progress: Shows a bar, where tqdm is there.
        load: Returns all columns; without it, those of no sample (they are in the folder).

    Returns:
        A row for every sample. A sample that was refused has no values (NaN, an empty word) and the code of its error.

    Raises:
        ValueError: arguments that contradict each other, outputs of several shapes, a folder with another sweep.
        BadInput: a key or a deviation that there is not, a file that a sample names and that is not there.
    """
    wanted = named(outputs)
    of = model if isinstance(model, Forward) else as_job(model)
    chunk = operator.index(chunk)
    _check(of, samples, wanted, task, form, chunk)
    if not load and folder is None:
        raise ValueError("load=False keeps nothing without a folder")
    kept = None if folder is None else Folder(Path(folder), _asked(of, task, wanted), samples, chunk, form)
    shapes = Shapes()
    if kept is not None:
        shapes.check(kept.known())
    parts = list(samples.chunks(chunk))
    missing = [part for part in parts if kept is None or not kept.has(part)]
    held: dict[int, Columns] = {}
    to_do = sum(part.stop - part.start for part in missing)
    with _bar(progress, len(samples), len(samples) - to_do) as told:
        for part, columns in _worked_off(of, task, samples, wanted, missing, client):
            shapes.check(columns)
            if kept is None:
                held[part.start] = columns
            else:
                kept.put(part, columns)
            told(part.stop - part.start)
    if not load:
        return Swept(samples, {"error": np.array([], dtype=np.str_)})
    return Swept(samples, kept.get() if kept is not None else joined([held[part.start] for part in parts], wanted))


def _check(
    model: Job | Forward, samples: Samples, outputs: dict[str, Output], task: Task, form: Form, chunk: int
) -> None:
    """Refuses what cannot be carried out, before a folder is made of it."""
    if chunk < 1:
        raise ValueError(f"chunk = {chunk}: give 1 or more")
    if task not in TASKS:
        raise ValueError(f"task = {task!r}: choose among {', '.join(TASKS)}")
    if form not in FORMS:
        raise ValueError(f"form = {form!r}: choose among {', '.join(FORMS)}")
    both = sorted(set(outputs) & set(samples.columns))
    if both:
        raise ValueError(f"{both[0]!r} is a sample and an output: give the output another name")
    if isinstance(model, Forward):
        for name in samples.columns:
            one_of("deviation", name, *Forward.names())
        return
    try:
        model.replace(samples[0:1][0])
    except FlankwrightError as error:
        # A key that no sample can have.
        if error.code == "unknown-key":
            raise


def load(folder: str | os.PathLike[str]) -> Columns:
    """The columns of all finished chunks of a folder, without computing anything.

    Args:
        folder: The folder of a sweep, finished or not.

    Returns:
        Outputs by name, shape (finished sample, ...), and ``error``, as in :attr:`Swept.columns`; ``sample``: the numbers of these samples.

    Raises:
        FileNotFoundError: the folder holds no sweep.
    """
    path = Path(folder)
    asked = json.loads((path / "sweep.json").read_text(encoding="utf-8"))
    rows, columns = read(path, asked["form"], asked["chunk"], math.prod(asked["shape"]), asked["outputs"])
    return {"sample": rows, **columns}


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
    sender = Sender(_core.VERSION, os.getpid())
    waiting = iter(parts)
    under_way: dict[Any, slice] = {}

    def submit(part: slice) -> Any:
        # The model goes with every chunk: it is small, and nothing has to be found again when a worker dies.
        future = cluster.submit(evaluate, model, task, samples[part], outputs, sender, pure=False)
        under_way[future.key] = part
        return future

    def ahead() -> Iterator[slice]:
        # A few chunks for each worker that is there now: memory is bounded, and no worker waits.
        return islice(waiting, max(0, 2 * max(1, len(cluster.nthreads())) - len(under_way)))

    running: Any = as_completed([submit(part) for part in ahead()])  # type: ignore[no-untyped-call]
    for future in running:
        yield under_way.pop(future.key), future.result()
        for part in ahead():
            running.add(submit(part))


def _asked(model: Job | Forward, task: Task, outputs: dict[str, Output]) -> dict[str, Any]:
    job = model.job if isinstance(model, Forward) else model
    points = list(model.points) if isinstance(model, Forward) else None
    return {
        "version": _core.VERSION,
        "task": "forward" if isinstance(model, Forward) else task,
        "points": points,
        "job": hashlib.sha256(job.text.encode()).hexdigest(),
        "files": [hashlib.sha256(path.read_bytes()).hexdigest() for path in job.files()],
        "outputs": {name: output if isinstance(output, str) else identity(output) for name, output in outputs.items()},
    }


class _bar:
    """A bar of progress, or none."""

    def __init__(self, shown: bool, total: int, done: int) -> None:
        self.bar: Any = None
        if shown:
            try:
                from tqdm.auto import tqdm
            except ModuleNotFoundError:
                return
            self.bar = tqdm(total=total, initial=done, unit="sample")

    def __enter__(self) -> Callable[[int], None]:
        return lambda count: self.bar.update(count) if self.bar is not None else None

    def __exit__(self, *_: object) -> None:
        if self.bar is not None:
            self.bar.close()
