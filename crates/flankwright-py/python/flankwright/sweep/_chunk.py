"""One chunk of a sweep: from changes to columns. Runs in any process; the same chunk gives the same bits everywhere."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NamedTuple

from .. import _core
from .._errors import FlankwrightError
from .._forward import Forward
from .._jobs import Job
from .._tasks import plan_many, preview_many, simulate_many
from ._outputs import Columns, Output, columns, of_result

Task = Literal["preview", "plan", "simulate"]
TASKS: dict[Task, Callable[..., list[Any]]] = {"preview": preview_many, "plan": plan_many, "simulate": simulate_many}

# Errors of the machine on which a sample is worked on, not of the sample.
_ELSEWHERE = {"unreadable-file", "internal-error"}


class Sender(NamedTuple):
    """Who sends a chunk to a worker.

    Attributes:
        version: Version of the package there.
        process: Its process.
    """

    version: str
    process: int


def evaluate(
    model: Job | Forward,
    task: Task,
    changes: Sequence[Mapping[str, Any]],
    outputs: Mapping[str, Output],
    sender: Sender | None = None,
) -> Columns:
    """The columns of a chunk, with the code of its error for every sample that was refused (else an empty word).

    Raises:
        FlankwrightError: a file that is not there, or a fault of the program: these are no properties of a sample.
        RuntimeError: a worker with another version of the package.
    """
    if sender is not None:
        _on_worker(sender)
    if isinstance(model, Forward):
        return _of_forward(model, changes, outputs)
    errors: list[str] = [""] * len(changes)
    jobs: list[Job] = []
    places: list[int] = []
    for k, change in enumerate(changes):
        try:
            jobs.append(model.replace(change))
            places.append(k)
        except FlankwrightError as error:
            errors[k] = _code(error)
    values: dict[str, list[Any]] = {name: [None] * len(changes) for name in outputs}
    for k, result in zip(places, TASKS[task](jobs, errors="return")):
        if isinstance(result, FlankwrightError):
            errors[k] = _code(result)
            continue
        for name, output in outputs.items():
            values[name][k] = of_result(output, result)
    return columns(values, errors)


def _on_worker(sender: Sender) -> None:
    if sender.version != _core.VERSION:
        raise RuntimeError(f"this worker has flankwright {_core.VERSION}, the sweep {sender.version}: install the same")
    if sender.process == os.getpid():
        return
    from distributed import get_worker

    worker: Any = get_worker()
    _core.use_threads(worker.state.nthreads)


def _code(error: FlankwrightError) -> str:
    if error.code in _ELSEWHERE:
        raise error
    return error.code


def _of_forward(model: Forward, changes: Sequence[Mapping[str, Any]], outputs: Mapping[str, Output]) -> Columns:
    together = {name: [change[name] for change in changes] for name in changes[0]}
    flanks, refused = model.each(together)
    errors = [_code(refused[k]) if k in refused else "" for k in range(len(changes))]
    values = {
        name: [output(of) if not error and callable(output) else None for of, error in zip(flanks, errors)]
        for name, output in outputs.items()
    }
    return columns(values, errors)
