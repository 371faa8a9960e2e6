"""A skiving tool measured at a light barrier in the machine: what it would be measured as, and what that says."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._bodies import Side
from ._errors import bad_input
from ._tasks import AnyJob, Progress, as_job
from ._values import whole

Array = NDArray[np.float64]

_DEGREE = math.pi / 180


class Tracks(NamedTuple):
    """Where a flank's edge is measured; shape (track,) each, vectors with (3,).

    Attributes:
        place: Along the edge, -1 to 1.
        w: Length of roll of the workpiece's flank that is made there, mm.
        lever: Way of the normal for a turn of the tool, mm/rad.
        point: Virtual contact point in the tool, mm.
        normal: Its normal out of the tool's material.
    """

    place: Array
    w: Array
    lever: Array
    point: Array
    normal: Array


class Evaluation(NamedTuple):
    """What deviations say. Flanks in the order left, right.

    Attributes:
        clocking_deg: How far the whole tool is turned against its index.
        single_pitch_um: f_p of the teeth, shape (tooth,).
        cumulative_pitch_um: F_p,k of the teeth, shape (tooth,).
        thickness_um: Deviation of the teeth's thickness, shape (tooth,).
        eccentricity_um: In x and y of the spindle, shape (2,).
        wobble_urad: About x and y of the spindle, shape (2,).
        profile_um: Deviation of the edge averaged over the teeth, without clocking and mounting, shape (flank, track).
        workpiece_um: What the workpiece's flank will deviate by, shape (flank, track).
        setting: The change of the machine's setting that answers it, by name (mm, degrees).
        limited: Settings that ended at their limits.
        remaining_um: What the workpiece's flank will deviate by after it, shape (flank, track).
    """

    clocking_deg: float
    single_pitch_um: Array
    cumulative_pitch_um: Array
    thickness_um: Array
    eccentricity_um: Array
    wobble_urad: Array
    profile_um: Array
    workpiece_um: Array
    setting: dict[str, float]
    limited: tuple[str, ...]
    remaining_um: Array


class ToolMeasurement:
    """Edges, measuring tracks and poses of a skiving tool, and the tool as the job measures it: its readings, or those that the tool of
    ``[tool_errors]`` would give.

    Args:
        job: A job of measuring a skiving tool, or its file.

    Attributes:
        teeth: Number of teeth of the tool.
        deviations: What the job measures, normal to the edge, um, positive = material beyond it, shape (flank, track, tooth); ``None`` where
            it measures nothing.

    Raises:
        BadInput: a job of another process, or one at fault.
        NotProducible: a tool that cannot be measured like that.
    """

    def __init__(self, job: AnyJob) -> None:
        self.job = as_job(job)
        self._core = _core.CoreMeasuring(self.job._core)
        self.teeth: int = self._core.teeth
        measured = self._core.deviations
        self.deviations: Array | None = None if measured is None else measured * 1e3

    def __reduce__(self) -> tuple[Any, ...]:
        return ToolMeasurement, (self.job,)

    @staticmethod
    def settings() -> tuple[str, ...]:
        """Names of the settings, with their units: mm, and degrees where a name ends in ``_deg``."""
        return tuple(_core.CoreMeasuring.settings())

    def tracks(self, flank: Side = "left") -> Tracks:
        """Where a flank's edge is measured."""
        return Tracks(**self._core.tracks(flank))

    def sensitivities(self, flank: Side = "left") -> dict[str, Array]:
        """Change of the workpiece's flank at the tracks by each setting: arrays of shape (track,), um per mm or um per degree."""
        found = self._core.sensitivities(flank)
        return {name: found[k] * 1e3 * _unit(name) for k, name in enumerate(self.settings())}

    def repeat(self, seeds: Sequence[int] | ArrayLike, *, progress: Progress | None = None) -> Array:
        """The tool measured again and again, each time with the noise that begins at a seed, on all cores.

        Returns:
            Deviations normal to the edge, um, positive = material beyond it, shape (seed, flank, track, tooth).

        Raises:
            BadInput: a job that measures nothing.
        """
        numbers = whole("seeds", list(seeds) if isinstance(seeds, range) else seeds).tolist()
        if any(seed < 0 for seed in numbers):
            raise bad_input(
                "a seed is negative", field="seeds", value=min(numbers), allowed="0 and more", way_out="give other numbers"
            )
        return self._core.repeated(numbers, progress) * 1e3

    def evaluate(self, deviations: ArrayLike) -> Evaluation:
        """What deviations say of the tool, of the workpiece and of the setting.

        Args:
            deviations: um, normal to the edge, shape (flank, track, tooth).

        Raises:
            BadInput: another shape, or numbers that are not finite.
        """
        given = np.asarray(deviations, dtype=np.float64)
        if given.ndim != 3:
            raise bad_input(
                "deviations stand over flank, track and tooth",
                field="deviations",
                value=given.shape,
                allowed="(flank, track, tooth)",
                way_out="take one measurement of many, e.g. repeated[0]",
            )
        found = self._core.evaluated(np.ascontiguousarray(given) * 1e-3)
        change = {name: float(found["change"][k]) / _unit(name) for k, name in enumerate(self.settings())}
        return Evaluation(
            clocking_deg=math.degrees(found["clocking"]),
            single_pitch_um=found["single_pitch"] * 1e3,
            cumulative_pitch_um=found["cumulative_pitch"] * 1e3,
            thickness_um=found["thickness"] * 1e3,
            eccentricity_um=found["eccentricity"] * 1e3,
            wobble_urad=found["wobble"] * 1e6,
            profile_um=found["profile"] * 1e3,
            workpiece_um=found["workpiece"] * 1e3,
            setting=change,
            limited=tuple(found["limited"]),
            remaining_um=found["residual"] * 1e3,
        )

    def __repr__(self) -> str:
        return f"<ToolMeasurement of {self.job.name!r}: {self.teeth} teeth>"


def _unit(name: str) -> float:
    """One unit of a setting in mm or rad."""
    return _DEGREE if name.endswith("_deg") else 1.0
