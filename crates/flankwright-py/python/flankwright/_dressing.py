"""The dresser of a worm: its profile, what it leaves in a position, and the position in which it leaves what is wanted."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._bodies import Side
from ._errors import BadInput, bad_input
from ._tasks import AnyJob, Progress, as_job
from ._values import finite, one_of

Array = NDArray[np.float64]
Points = Sequence[tuple[float, float]]

AXES = ("d_phi_s_deg", "d_gamma_deg", "d_d_mm", "d_v_yA_mm")
"""Components of a dressing correction: worm angle, crossing angle, centre distance, tangential offset."""

_UNITS = np.array([math.pi / 180, math.pi / 180, 1.0, 1.0])


class Meridian(NamedTuple):
    """A dresser's profile in its axial section.

    Attributes:
        radius: mm, shape of the parameters.
        position: Along the dresser's axis, mm, same shape.
        normal: Outward unit normal, radial and axial part, that shape and (2,).
    """

    radius: Array
    position: Array
    normal: Array


class DressedWorm(NamedTuple):
    """A worm flank as a dresser in one position leaves it, all along the worm; shape (correction, roll) each, without ``correction`` for a
    single one.

    Attributes:
        deviation: Normal to the worm's flank, um, positive = material left.
        position: Where on the worm's axis the dresser touches while the worm stands at v_zS = 0, mm.
        dresser_radius: Radius of the dresser's circle that dresses this length of roll, mm.
        parameter: Parameter of the dresser's profile there, mm.
    """

    deviation: Array
    position: Array
    dresser_radius: Array
    parameter: Array


class Dresser:
    """The disc dresser of a job of generating grinding: both profiles conjugate to the unmodified worm, in exact line contact.

    A position of the dresser is a correction of its nominal kinematics by the four :data:`AXES`. Lengths of roll are those of the worm.

    Args:
        job: A job of generating grinding with a dresser, or its file.

    Raises:
        BadInput: a job of another process, a tool that is not dressed.
        NotProducible: bodies that do not go together.
    """

    AXES = AXES

    def __init__(self, job: AnyJob) -> None:
        self.job = as_job(job)
        self._core = _core.CoreDresser(self.job._core)

    def __reduce__(self) -> tuple[Any, ...]:
        return Dresser, (self.job,)

    def range(self, flank: Side = "left") -> tuple[float, float]:
        """Lengths of roll of the worm that generate the gear's usable flank, w_NfS and w_NaS, mm."""
        return self._core.range(flank)

    def parameters(self, flank: Side = "left") -> tuple[float, float]:
        """Between which parameters the profile exists, mm: the length of roll that a parameter was designed to dress."""
        return self._core.interval(flank)

    def kinematics(self, flank: Side = "left") -> dict[str, float]:
        """Nominal kinematics: ``phi_s_deg`` at v_zS = 0, ``gamma_deg``, ``d_mm``, ``v_yA_mm``, and the screw parameter ``p_mm_per_rad``."""
        phi, gamma, d, v_ya, p = self._core.chain(flank)
        angles = {"phi_s_deg": math.degrees(phi), "gamma_deg": math.degrees(gamma)}
        return {**angles, "d_mm": d, "v_yA_mm": v_ya, "p_mm_per_rad": p}

    def meridian(self, t: ArrayLike, flank: Side = "left") -> Meridian:
        """The profile in the axial section at parameters ``t`` (mm).

        Raises:
            BadInput: a parameter beyond :meth:`parameters`.
        """
        given = np.asarray(t, dtype=np.float64)
        found = self._core.meridian(flank, np.ascontiguousarray(given).ravel()).reshape(*given.shape, 4)
        return Meridian(found[..., 0], found[..., 1], found[..., 2:])

    def dress(
        self,
        corrections: ArrayLike | Mapping[str, float] | None = None,
        flank: Side = "left",
        *,
        w: ArrayLike | None = None,
        progress: Progress | None = None,
    ) -> DressedWorm:
        """The worm's flank in one position of the dresser, or in many, on all cores.

        Args:
            corrections: The four :data:`AXES` in their units, shape (4,) or (correction, 4), or by name; nothing is the nominal position.
            flank: The flank.
            w: Lengths of roll, mm, shape (roll,); without them 33 over :meth:`range`.
            progress: Called with the number that is done.

        Raises:
            BadInput: corrections of another shape, or not finite.
            NotProducible: no contact there, or a length of roll that the profile does not reach, with the number of the correction.
        """
        given = _correction(corrections)
        if given.ndim not in (1, 2) or given.shape[-1] != 4:
            raise _misshapen("corrections", given, "(4,) or (correction, 4)")
        found = self._core.dressed(flank, np.atleast_2d(given * _UNITS), self._rolls(flank, w), progress)
        values = found if given.ndim == 2 else found[0]
        return DressedWorm(values[..., 0] * 1e3, values[..., 1], values[..., 2], values[..., 3])

    def sensitivities(
        self,
        correction: ArrayLike | Mapping[str, float] | None = None,
        flank: Side = "left",
        *,
        w: ArrayLike | None = None,
    ) -> dict[str, Array]:
        """Exact derivatives of the worm's flank by each axis in one position: for each of :data:`AXES` an array of shape (roll,), um per
        degree or um per mm. Arguments and errors as :meth:`dress`.
        """
        given = _correction(correction)
        if given.shape != (4,):
            raise _misshapen("correction", given, "(4,)")
        found = self._core.sensitivities(flank, _four(given * _UNITS), self._rolls(flank, w))
        return {name: found[k] * _UNITS[k] * 1e3 for k, name in enumerate(AXES)}

    def crowning(self, amount_um: float, flank: Side = "left") -> Array:
        """The correction of the three-point method: ``amount_um`` (normal, positive = material left) in the middle of the worm's used
        profile, nothing at both ends, and the upper end of the profile dressed by the circle that was designed for it.

        Returns:
            The four :data:`AXES` in their units.

        Raises:
            NotProducible: this dresser cannot, with the share of the amount that was reached.
        """
        found: Array = np.array(self._core.crowned(flank, amount_um * 1e-3)) / _UNITS
        return found

    def solve(
        self,
        points: Mapping[Side, Points],
        *,
        radius_maps: Mapping[Side, Points] | None = None,
        fixed: Mapping[str, float] | None = None,
        start: ArrayLike | Mapping[str, float] | None = None,
    ) -> Array:
        """The correction in which four conditions hold: pitch points on one flank or both, radius maps, and axes that stay where they are.

        Args:
            points: For each flank pairs of length of roll (mm) and modification (um, normal).
            radius_maps: For each flank pairs of profile parameter and the length of roll that it shall dress (mm).
            fixed: Values of axes by name (:data:`AXES`), in their units.
            start: Where the search begins, as for :meth:`dress`.

        Returns:
            The four :data:`AXES` in their units.

        Raises:
            BadInput: not four conditions in all.
            NotProducible: conditions that depend on each other, or cannot be met, with the share of the way that was reached.
        """
        conditions: list[tuple[str, str, float, float]] = []
        for side, pairs in points.items():
            conditions += [("point", side, float(w), float(f_um) * 1e-3) for w, f_um in pairs]
        for side, pairs in (radius_maps or {}).items():
            conditions += [("map", side, float(t), float(w)) for t, w in pairs]
        for name, value in (fixed or {}).items():
            axis = _axis(name)
            conditions.append(("fixed", name, float(axis), float(value) * float(_UNITS[axis])))
        begin = _correction(start)
        if begin.shape != (4,):
            raise _misshapen("start", begin, "(4,)")
        found: Array = np.array(self._core.solved(conditions, _four(begin * _UNITS))) / _UNITS
        return found

    def _rolls(self, flank: Side, w: ArrayLike | None) -> list[float]:
        given = np.linspace(*self.range(flank), 33) if w is None else np.asarray(w, dtype=np.float64)
        if given.ndim != 1:
            raise bad_input(
                "lengths of roll stand in one axis", field="w", value=given.shape, allowed="(roll,)", way_out="give a flat list"
            )
        rolls: list[float] = given.tolist()
        return rolls

    def __repr__(self) -> str:
        return f"<Dresser of {self.job.name!r}>"


def _axis(name: str) -> int:
    return AXES.index(one_of("axis", name, *AXES))


def _misshapen(field: str, given: Array, allowed: str) -> BadInput:
    return bad_input(
        "a correction has four components",
        field=field,
        value=given.shape,
        allowed=allowed,
        way_out=f"give the axes in the order {', '.join(AXES)}, or by name",
    )


def _correction(given: ArrayLike | Mapping[str, float] | None) -> Array:
    if given is None:
        return np.zeros(4)
    if isinstance(given, Mapping):
        found = np.zeros(4)
        for name, value in given.items():
            found[_axis(name)] = finite(name, value)
        return found
    return np.asarray(given, dtype=np.float64)


def _four(values: Array) -> tuple[float, float, float, float]:
    a, b, c, d = values.tolist()
    return a, b, c, d
