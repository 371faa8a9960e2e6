"""The flank of a process whose axes are off, for thousands of sets of deviations."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import bad_input
from ._jobs import Job
from ._tasks import AnyJob, Progress, as_job

if TYPE_CHECKING:
    import xarray


class Forward:
    """A planned process of generating grinding, ready to be run with deviations. Bodies, plan and grid are made once; every sample is the
    exact contact of tool and gear, without a referee.

    Args:
        job: A job; one with settings is taken as it stands, any other is planned first.
        profile_points: Points along the profile.
        helix_points: Points along the helix.

    Raises:
        BadInput: a job of another process, bodies from a catalogue, a tool that is dressed in several strokes, a ratio that varies.
        NotProducible: the bodies cannot make the target.

    Attributes:
        job: The job.
        points: Points along profile and helix.
        flanks: Names of the flanks, in the order of the axis ``flank``.
        w: Lengths of roll, mm, shape (flank, profile).
        z: Axial positions, mm, shape (helix,).
        target: What is wanted, um, normal, positive = material left, shape (flank, profile, helix).
    """

    def __init__(self, job: AnyJob, *, profile_points: int = 9, helix_points: int = 9) -> None:
        self.job = as_job(job)
        self.points = (profile_points, helix_points)
        self._core = _core.CoreForward(self.job._core, self.points)
        self.flanks: tuple[str, ...] = tuple(self._core.flanks)
        grids = [self._core.grid(k) for k in range(len(self.flanks))]
        self.w = np.stack([grid["w"] for grid in grids])
        self.z: NDArray[np.float64] = grids[0]["z"]
        self.target = np.stack([grid["target"] for grid in grids])

    def __reduce__(self) -> tuple[Any, ...]:
        # A worker that gets it again and again plans it once.
        return _again, (self.job, self.points)

    @staticmethod
    def names() -> list[str]:
        """Names of what may be off, with their units, e.g. ``radial_feed_1_um``: coefficient of q in the centre distance, where q runs from
        -1 to 1 over the face width.
        """
        return _core.CoreForward.names()

    def __call__(
        self, deviations: Mapping[str, ArrayLike] | None = None, *, progress: Progress | None = None
    ) -> NDArray[np.float64]:
        """The flanks under deviations, on all cores.

        Args:
            deviations: Values by name, broadcast against each other: shape (sample,) or single numbers. Those that are not named are zero.
            progress: Told how many are done.

        Returns:
            Flanks, normal, um, positive = material left; shape (sample, flank, profile, helix), without ``sample`` where all values are single.

        Raises:
            BadInput: an unknown name, a value that is not finite, values of more than one axis.
            ValueError: values of different lengths.
            NotProducible: no contact is found, with the number of the sample.
        """
        given = {name: np.asarray(value, dtype=np.float64) for name, value in (deviations or {}).items()}
        wide = np.broadcast_arrays(*given.values()) if given else []
        shape = wide[0].shape if wide else ()
        if len(shape) > 1:
            raise bad_input(
                "samples stand in one axis", field="deviations", value=shape, allowed="(sample,)", way_out="give flat arrays"
            )
        count = shape[0] if shape else 1
        samples = np.empty((count, len(given)))
        for column, values in enumerate(wide):
            samples[:, column] = values
        found = self._core.evaluate(list(given), samples, progress)
        return found if shape else found[0]

    def deviations(
        self, deviations: Mapping[str, ArrayLike] | None = None, *, progress: Progress | None = None
    ) -> NDArray[np.float64]:
        """What calling it returns, less the target: um, positive = material left; raises the same."""
        return self(deviations, progress=progress) - self.target

    def to_xarray(self, flanks: NDArray[np.float64]) -> xarray.DataArray:
        """Flanks of this model with labels: ``sample`` (where there are several), ``flank``, ``profile``, ``helix``; ``w`` and ``z`` in mm."""
        import xarray

        sample = ("sample",) if flanks.ndim == 4 else ()
        return xarray.DataArray(
            flanks,
            dims=(*sample, "flank", "profile", "helix"),
            coords={
                "flank": list(self.flanks),
                "w": (("flank", "profile"), self.w, {"units": "mm", "long_name": "length of roll"}),
                "z": ("helix", self.z, {"units": "mm", "long_name": "axial position"}),
            },
            attrs={"units": "um", "long_name": "flank, normal, positive = material left"},
        )


@functools.lru_cache(maxsize=4)
def _again(job: Job, points: tuple[int, int]) -> Forward:
    return Forward(job, profile_points=points[0], helix_points=points[1])
