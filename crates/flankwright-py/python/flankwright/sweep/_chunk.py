"""One chunk of a sweep: from changes to columns. Runs in any process; the same chunk gives the same bits everywhere."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from .. import _core
from .._errors import FlankwrightError
from .._forward import Forward
from .._jobs import Job
from .._tasks import plan_many, preview_many, simulate_many
from ._outputs import Columns, Output, columns, of_result

Task = Literal["preview", "plan", "simulate"]
_TASKS: dict[Task, Callable[..., list[Any]]] = {"preview": preview_many, "plan": plan_many, "simulate": simulate_many}


def evaluate(
    model: Job | Forward,
    task: Task,
    changes: Sequence[Mapping[str, Any]],
    outputs: Mapping[str, Output],
    threads: int | None = None,
) -> Columns:
    """The columns of a chunk, with the code of its error for every sample that was refused (else an empty word)."""
    if threads is not None:
        _core.use_threads(threads)
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
            errors[k] = error.code
    values: dict[str, list[Any]] = {name: [None] * len(changes) for name in outputs}
    for k, result in zip(places, _TASKS[task](jobs, errors="return")):
        if isinstance(result, FlankwrightError):
            errors[k] = result.code
            continue
        for name, output in outputs.items():
            values[name][k] = of_result(output, result)
    return columns(values, errors)


def _of_forward(model: Forward, changes: Sequence[Mapping[str, Any]], outputs: Mapping[str, Output]) -> Columns:
    for name, output in outputs.items():
        if isinstance(output, str):
            raise ValueError(f"{name!r}: outputs of a forward model are functions of its flanks (flank, profile, helix)")
    flanks, errors = _flanks(model, changes)
    values = {
        name: [output(of) if of is not None and callable(output) else None for of in flanks]
        for name, output in outputs.items()
    }
    return columns(values, errors)


def _flanks(
    model: Forward, changes: Sequence[Mapping[str, Any]]
) -> tuple[list[NDArray[np.float64] | None], list[str]]:
    """The flanks of all samples, ``None`` with the code of its error for one that has none."""
    together = {name: np.array([change[name] for change in changes]) for name in changes[0]}
    try:
        return list(model(together)), [""] * len(changes)
    except FlankwrightError:
        # One of them has no result: which, and with which error, each tells alone. What they give is the same.
        pass
    flanks: list[NDArray[np.float64] | None] = [None] * len(changes)
    errors = [""] * len(changes)
    for k, change in enumerate(changes):
        try:
            flanks[k] = model(change)
        except FlankwrightError as error:
            errors[k] = error.code
    return flanks, errors
