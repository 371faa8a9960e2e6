"""Tangential dressing: which flank the motions of dresser, worm and gear leave, and how it depends on each of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._bodies import Side
from ._errors import bad_input
from ._tasks import AnyJob, Progress, as_job
from ._values import finite, in_rows


class TangentialModel:
    """The forward model of tangential dressing for one flank of a job: exact contact of dresser, worm and gear.

    A design variable is a coefficient of a power of a channel's abscissa, named by channel and exponent: ``Fz2`` is the tangential shift of the
    dresser over the square of its position on the worm. Values are mm (``gA``: rad; ``kap``: mm/mm). :meth:`channels` tells them all.

    Args:
        job: A job of tangential dressing, or its file.
        flank: The flank.
        points: Points each way.
        equidistant_radii: Points at equidistant radii, as the source of the method has it; else equidistant in roll length.

    Attributes:
        w: Lengths of roll, mm, shape (profile,).
        z: Axial positions, mm, shape (helix,).
        radii: Radii of the lengths of roll, mm, shape (profile,).
        target: What the job wants, um, shape (profile, helix).
        job: The job.
        flank: The flank.

    Raises:
        BadInput: a job of another process, or a flank that it does not grind.
    """

    def __init__(
        self, job: AnyJob, flank: Side = "right", *, points: int = 9, equidistant_radii: bool = False
    ) -> None:
        self.job, self.flank = as_job(job), flank
        self._how = (points, equidistant_radii)
        self._core = _core.CoreTangential(self.job._core, flank, points, equidistant_radii)
        self.w, self.z, self.radii = self._core.w, self._core.z, self._core.radii
        self.target = self._core.target

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.job, self.flank, *self._how)

    @staticmethod
    def channels() -> dict[str, tuple[str, str]]:
        """Channels by name: their meaning, and the unit of a coefficient."""
        return {name: (meaning, unit) for name, meaning, unit in _core.CoreTangential.channels()}

    def __call__(
        self, variables: Mapping[str, ArrayLike] | None = None, *, progress: Progress | None = None
    ) -> NDArray[np.float64]:
        """The flank under values of design variables, on all cores.

        Args:
            variables: Values by name, broadcast against each other: shape (sample,) or single numbers. Those that are not named are zero.
            progress: Called with the number that is done.

        Returns:
            Deviation from the involute as the job measures it, um, positive = material left; shape (sample, profile, helix), without ``sample``
            where all values are single.

        Raises:
            BadInput: an unknown name, values that are not finite or of more than one axis.
            ValueError: values of different lengths.
            NotProducible: the flank is undercut, or lies beyond the tool, with the number of the sample.
        """
        names, samples, single = in_rows("variables", variables or {})
        found = self._core.evaluate(names, samples, progress)
        return found[0] if single else found

    def sensitivities(
        self, names: Sequence[str], at: Mapping[str, float] | None = None
    ) -> dict[str, NDArray[np.float64]]:
        """Exact derivatives of the flank by design variables.

        Args:
            names: The variables.
            at: Values at which they are taken, mm (``gA``: rad; ``kap``: 1); all others are zero.

        Returns:
            For each name an array of shape (profile, helix), um per mm (``gA``: per rad; ``kap``: per 1).

        Raises:
            BadInput: an unknown name, a value that is not finite.
            NotProducible: the flank is undercut there, or lies beyond the tool.
        """
        there = {name: finite(f"at[{name!r}]", value) for name, value in (at or {}).items()}
        every = [*names, *(name for name in there if name not in names)]
        found = self._core.sensitivities(every, [float(there.get(name, 0.0)) for name in every])
        return {name: found[k] for k, name in enumerate(names)}


def _again(job: Any, flank: Side, points: int, radii: bool) -> TangentialModel:
    return TangentialModel(job, flank, points=points, equidistant_radii=radii)
