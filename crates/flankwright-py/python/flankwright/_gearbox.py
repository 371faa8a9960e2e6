"""The electronic gearbox of a slide and a workpiece: coupling, budget, errors, pulses."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import bad_input
from ._extras import needed
from ._tasks import AnyJob, as_job
from ._values import whole

if TYPE_CHECKING:
    import xarray

Array = NDArray[np.float64]


class Pulses(NamedTuple):
    """Pulses in their order; shape (pulse,) each.

    Attributes:
        tick: Tick of the clock, from 1.
        sign: 1 or -1.
        kind: ``R`` of the scale, ``Z`` inserted at the spacing of the interval before, ``K`` inserted at the clock's pace.
        turned: Parts of a workpiece pulse by which it turned the workpiece.
    """

    tick: NDArray[np.uint64]
    sign: NDArray[np.int64]
    kind: NDArray[np.character]
    turned: NDArray[np.int64]


class Gearbox:
    """The electronic gearbox of a job: pulses of the slide's scale, refined and counted into the additional rotation of the workpiece.

    Args:
        job: A job of the electronic gearbox, or its file.

    Attributes:
        clock: Clock, Hz.
        coupling: What the lead asks for and what the coupling makes of it, with units in the names.

    Raises:
        BadInput: a job of another process, or one at fault.
    """

    def __init__(self, job: AnyJob) -> None:
        self.job = as_job(job)
        self._core = _core.CoreGearbox(self.job._core)
        self.clock: float = self._core.clock
        self.coupling: dict[str, Any] = json.loads(self._core.coupling())

    def __reduce__(self) -> tuple[Any, ...]:
        return Gearbox, (self.job,)

    def budget(self, speed_mm_per_min: ArrayLike, acceleration_mm_per_s2: ArrayLike = 0.0) -> xarray.Dataset:
        """The budget of the errors: ``quantisation``, ``truncation``, ``synchronisation``, ``acceleration`` along the feed (um),
        ``flank_um`` normal to the flank, and ``greatest_speed`` (mm/min) from which pulses come late. Speeds and accelerations are broadcast;
        variables have their shape, axes ``dim_0``, ``dim_1``, ... Needs xarray.

        Raises:
            BadInput: a speed or an acceleration beyond its range.
        """
        needed("xarray", "arrays")
        import xarray

        wide = np.broadcast_arrays(
            np.asarray(speed_mm_per_min, dtype=np.float64), np.asarray(acceleration_mm_per_s2, dtype=np.float64)
        )
        drives = np.stack([wide[0].ravel() / 60.0, wide[1].ravel()], axis=1)
        found = self._core.budget(drives).reshape(*wide[0].shape, -1)
        axes = tuple(f"dim_{k}" for k in range(wide[0].ndim))
        data = {}
        for k, name in enumerate(_core.CoreGearbox.budget_names()):
            factor, unit = {"flank_um": (1.0, "um"), "greatest_speed": (60.0, "mm/min")}.get(name, (1e3, "um"))
            data[name] = (axes, found[..., k] * factor, {"units": unit})
        return xarray.Dataset(data, {"speed_mm_per_min": (axes, wide[0]), "acceleration_mm_per_s2": (axes, wide[1])})

    def errors(self) -> xarray.Dataset:
        """Errors over the motion of the job, least and greatest (``bound``) in every stretch of time: ``along_feed`` (um) and ``at_flank``
        (um, what the additional rotation is off), over (time, bound). Empty for a train of pulses without a motion. Needs xarray.
        """
        needed("xarray", "arrays")
        import xarray

        found = self._core.errors()
        at_flank = found[:, 3:5] * self.coupling["flank_um_per_rad"]
        data = {
            "along_feed": (("time", "bound"), found[:, 1:3] * 1e3, {"units": "um"}),
            "at_flank": (("time", "bound"), at_flank, {"units": "um"}),
        }
        return xarray.Dataset(data, {"time": ("time", found[:, 0], {"units": "s"}), "bound": ["least", "greatest"]})

    def pulses(
        self, ticks: ArrayLike | None = None, signs: ArrayLike | None = None, *, last_tick: int | None = None
    ) -> Pulses:
        """Every pulse that reference pulses cause, and by how much it turns the workpiece.

        Args:
            ticks: Ticks of the reference pulses, rising; without them those of the job.
            signs: Their signs, 1 or -1; without them all 1.
            last_tick: Up to which tick the gearbox runs; without it that of the last reference pulse, or of the job.

        Raises:
            BadInput: reference pulses that cannot be, another number of signs, a last tick before the last of them.
        """
        if ticks is None:
            if signs is not None:
                raise bad_input(
                    "signs without ticks", field="ticks", value=None, allowed="whole numbers", way_out="give both, or none"
                )
            references = self._core.references()
            times, senses, last = references[0].astype(np.int64), references[1], references[2]
        else:
            times = whole("ticks", ticks)
            senses = np.ones(times.size, dtype=np.int64) if signs is None else whole("signs", signs)
            if (times < 0).any():
                raise bad_input(
                    "ticks count from 1", field="ticks", value=times.min(), allowed=">= 1", way_out="count from the start"
                )
            last = int(times.max(initial=0))
        latest = int(times.max(initial=0))
        if last_tick is not None and last_tick < latest:
            raise bad_input(
                "reference pulses come after the last tick",
                field="last_tick",
                value=last_tick,
                allowed=f">= {latest}",
                way_out="leave these pulses out, or run longer",
            )
        found = self._core.pulses(times.tolist(), senses.tolist(), last if last_tick is None else last_tick)
        return Pulses(found["tick"], found["sign"], found["kind"].view("S1").astype("U1"), found["turned"])

    def __repr__(self) -> str:
        return f"<Gearbox of {self.job.name!r}: clock {self.clock:g} Hz>"
