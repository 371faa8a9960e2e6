"""What is done with jobs, one by one and many at once."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, Literal, overload

import numpy as np

from . import _core
from ._errors import FlankwrightError
from ._jobs import Job, Remark
from ._results import Flanks, FlankValues, Result

Progress = Callable[[str, int, int], object]
"""Called now and then with the stage, the steps of it that are done, and all of them."""

AnyJob = Job | str | os.PathLike[str]


def as_job(job: AnyJob) -> Job:
    """A job, or the file of one."""
    return job if isinstance(job, Job) else Job.load(Path(job))


def plan(job: AnyJob, *, progress: Progress | None = None) -> Result:
    """From the target to settings, motions and a proven flank; a job of the electronic gearbox is run.

    Args:
        job: A job or its file.
        progress: Called now and then with the stage, the steps of it that are done, and all of them; what it raises ends the run.

    Returns:
        Verdict, document and flanks; :meth:`Result.write` makes the files.

    Raises:
        BadInput: the job, or a file that it names, is at fault.
        NotProducible: the bodies cannot make the target. A target that is missed is no error: see :attr:`Result.status`.
    """
    return Result(_core.run("plan", as_job(job)._core, progress))


def simulate(job: AnyJob, *, progress: Progress | None = None) -> Result:
    """From the settings that stand in the job to the flank. Raises as :func:`plan`."""
    return Result(_core.run("simulate", as_job(job)._core, progress))


def explore(job: AnyJob, *, progress: Progress | None = None) -> Result:
    """Ratios, worms, dressers side by side, ranked. Raises as :func:`plan`."""
    return Result(_core.run("explore", as_job(job)._core, progress))


def inspect(
    file: str | os.PathLike[str] | None = None,
    *,
    job: AnyJob | None = None,
    from_other_end: bool = False,
    slope_signs: tuple[int, int] | None = None,
    datum_face: Literal["+z", "-z"] | None = None,
    helix_slope_over: Literal["face-width", "range"] | None = None,
    profile_slope_over: Literal["face-width", "range"] | None = None,
    tolerance_class: int | None = None,
    language: Literal["en", "de"] | None = None,
    progress: Progress | None = None,
) -> Result:
    """Evaluates a measurement: alone, against the job by which the gear was ground, or a folder of them as a series; without a file, the
    simulated machine of the job.

    Args:
        file: A file of a measuring machine, or a folder.
        job: The job.
        from_other_end: The gear was measured from the other end.
        slope_signs: Signs of helix slopes as the file names the flanks, left and right, each +1 or -1.
        datum_face: The face from which distances count, at the end of +z or of -z.
        helix_slope_over: The length to which helix slopes refer: the face width, or the evaluated range.
        profile_slope_over: The length to which profile slopes refer.
        tolerance_class: Class of ISO 1328-1 that the gear, or every gear of a folder, has to reach.
        language: Language of report, sheets and series that :meth:`Result.write` makes; without it that of the job, else English.
        progress: Called with the progress.

    What a file does not tell (the end from which it was measured, signs and lengths of slopes, the face) is not guessed: it is asked for.
    Evaluation after ISO 1328-1:2013.

    Raises:
        BadInput: the file or the job is at fault, or something has to be stated that the file does not tell.
        NotProducible: the bodies of the job cannot make its target.
        TypeError: neither file nor job, a folder with a job, statements or a class on no file.
    """
    if tolerance_class is not None and file is None:
        raise TypeError("tolerance_class judges measured files: give a file or a folder, or leave it out")
    stated = (from_other_end, slope_signs, datum_face, helix_slope_over, profile_slope_over)
    if file is None:
        if job is None:
            raise TypeError("inspect takes a file, a job that simulates its measurement, or both")
        if stated != (False, None, None, None, None):
            raise TypeError("there is no file of which something could be stated: leave the statements out, or give the file")
        told = as_job(job) if language is None else as_job(job).replace({"output.language": language})
        return Result(_core.run("inspect", told._core, progress))
    path = Path(file)
    if path.is_dir():
        if job is not None:
            raise TypeError("a folder is evaluated without a job: give the file of one gear, or leave the job out")
        return Result(_core.inspect_series(path, stated, tolerance_class, language))
    core = None if job is None else as_job(job)._core
    return Result(_core.inspect(path, core, stated, tolerance_class, language, progress))


class Preview:
    """A plan without its referee; made by :func:`preview`.

    Attributes:
        process: Process, e.g. ``generating-grinding``.
        tolerance_um: Tolerance of the job, um.
        settings: Settings, as in the result of a plan, with units in the key names.
        warnings: Remarks.
        flanks: The flanks as planned; their ``simulated`` is ``None``.
        document: All of it, with units in the key names.
    """

    def __init__(self, text: str) -> None:
        self.document: dict[str, Any] = json.loads(text)
        self.process: str = self.document["process"]
        self.tolerance_um: float = self.document["tolerance_um"]
        self.settings: dict[str, Any] = self.document["settings"]
        self.warnings = [Remark(**remark) for remark in self.document["warnings"]]
        self.flanks = Flanks(
            {
                name: FlankValues(
                    name, *(np.array(of[key]) for key in ("w_mm", "z_mm", "target_um", "planned_um"))
                )
                for name, of in self.document["flanks"].items()
            }
        )

    def __repr__(self) -> str:
        return f"<Preview: {self.process}, {', '.join(self.flanks)}>"


def preview(job: AnyJob) -> Preview:
    """A plan without its referee, in milliseconds. Raises as :func:`plan`."""
    return Preview(_core.preview(as_job(job)._core))


@overload
def plan_many(
    jobs: Iterable[AnyJob], *, errors: Literal["raise"] = "raise", progress: Progress | None = None
) -> list[Result]: ...
@overload
def plan_many(
    jobs: Iterable[AnyJob], *, errors: Literal["return"], progress: Progress | None = None
) -> list[Result | FlankwrightError]: ...
def plan_many(
    jobs: Iterable[AnyJob], *, errors: Literal["raise", "return"] = "raise", progress: Progress | None = None
) -> Any:
    """Plans many jobs on all cores; results in the order of the jobs, whatever the number of cores.

    Args:
        jobs: Jobs or their files.
        errors: ``return`` puts the exception of a job in the place of its result.
        progress: Called with the number that is done.

    Returns:
        Results, and exceptions where they are returned; as many as there are jobs.

    Raises:
        FlankwrightError: the first one, unless they are returned.
    """
    return _many(lambda cores: _core.run_many("plan", cores, progress), jobs, Result, errors)


@overload
def simulate_many(
    jobs: Iterable[AnyJob], *, errors: Literal["raise"] = "raise", progress: Progress | None = None
) -> list[Result]: ...
@overload
def simulate_many(
    jobs: Iterable[AnyJob], *, errors: Literal["return"], progress: Progress | None = None
) -> list[Result | FlankwrightError]: ...
def simulate_many(
    jobs: Iterable[AnyJob], *, errors: Literal["raise", "return"] = "raise", progress: Progress | None = None
) -> Any:
    """As :func:`plan_many`, for :func:`simulate`."""
    return _many(lambda cores: _core.run_many("simulate", cores, progress), jobs, Result, errors)


@overload
def preview_many(
    jobs: Iterable[AnyJob], *, errors: Literal["raise"] = "raise", progress: Progress | None = None
) -> list[Preview]: ...
@overload
def preview_many(
    jobs: Iterable[AnyJob], *, errors: Literal["return"], progress: Progress | None = None
) -> list[Preview | FlankwrightError]: ...
def preview_many(
    jobs: Iterable[AnyJob], *, errors: Literal["raise", "return"] = "raise", progress: Progress | None = None
) -> Any:
    """As :func:`plan_many`, for :func:`preview`."""
    return _many(lambda cores: _core.preview_many(cores, progress), jobs, Preview, errors)


def _many(
    work: Callable[[list[_core.CoreJob]], Sequence[Any]], jobs: Iterable[AnyJob], made: Callable[[Any], Any], errors: str
) -> list[Any]:
    if errors not in ("raise", "return"):
        raise ValueError(f"errors={errors!r}: 'raise' or 'return'")
    results: list[Any] = []
    for job in jobs:
        try:
            results.append(as_job(job))
        except FlankwrightError as error:
            if errors == "raise":
                raise
            results.append(error)
    places = [k for k, job in enumerate(results) if isinstance(job, Job)]
    for k, one in zip(places, work([results[k]._core for k in places])):
        if isinstance(one, FlankwrightError):
            if errors == "raise":
                raise one
            results[k] = one
        else:
            results[k] = made(one)
    return results


def verify(
    files: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    *,
    data: str | os.PathLike[str] | Iterable[str | os.PathLike[str]] = (),
) -> dict[str, Any]:
    """Recomputes every expected value of reference files, as ``flankwright verify --json`` does.

    A wheel has it if it was built with the feature ``verify``: ``maturin build --release --features verify``.

    Args:
        files: Reference files.
        data: Folders with the data files that cases name.

    Returns:
        ``files``, each with the number of its checks, what failed and the worst share of a tolerance, and ``failed``: how many values failed.

    Raises:
        BadInput: a file that cannot be read or is of no known schema; a wheel without the feature.
    """
    found: dict[str, Any] = json.loads(_core.verify(_paths_of(files), _paths_of(data)))
    return found


def _paths_of(given: str | os.PathLike[str] | Iterable[str | os.PathLike[str]]) -> list[Path]:
    return [Path(given)] if isinstance(given, (str, os.PathLike)) else [Path(one) for one in given]
