"""The flank of a process whose axes are off, for thousands of sets of deviations."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import FlankwrightError
from ._extras import needed
from ._jobs import Job
from ._tasks import AnyJob, Progress, as_job
from ._values import in_rows

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
        BadInput: a job of another process, or bodies from a catalogue.
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
            progress: Called with the number that is done.

        Returns:
            Flanks, normal, um, positive = material left; shape (sample, flank, profile, helix), without ``sample`` where all values are single.

        Raises:
            BadInput: an unknown name, a value that is not finite, values of more than one axis.
            ValueError: values of different lengths.
            NotProducible: no contact is found, with the number of the sample.
        """
        names, samples, single = in_rows("deviations", deviations or {})
        found, _ = self._core.evaluate(names, samples, progress)
        return found[0] if single else found

    def each(
        self, deviations: Mapping[str, ArrayLike], *, progress: Progress | None = None
    ) -> tuple[NDArray[np.float64], dict[int, FlankwrightError]]:
        """The flanks under many sets of deviations, of which some may be refused.

        Args:
            deviations: As for calling it, at least one of shape (sample,).
            progress: Called with the number that is done.

        Returns:
            The flanks as calling it returns them, NaN for samples that have none, and the exceptions of those by their numbers.

        Raises:
            BadInput: an unknown name, values of more than one axis.
            ValueError: values of different lengths.
        """
        names, samples, _ = in_rows("deviations", deviations)
        found, refused = self._core.evaluate(names, samples, progress, True)
        return found, dict(refused)

    def deviations(
        self, deviations: Mapping[str, ArrayLike] | None = None, *, progress: Progress | None = None
    ) -> NDArray[np.float64]:
        """What calling it returns, less the target: um, positive = material left; raises the same."""
        return self(deviations, progress=progress) - self.target

    def to_xarray(self, flanks: NDArray[np.float64]) -> xarray.DataArray:
        """Flanks of this model with labels: ``sample`` (where there are several), ``flank``, ``profile``, ``helix``; ``w`` and ``z`` in mm."""
        needed("xarray", "arrays")
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
