"""Toothed bodies from drawing data, and modifications of their flanks."""

from __future__ import annotations

import functools
import json
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import bad_input
from ._values import in_places, one_of, plain

Side = Literal["left", "right"]


class Gear:
    """An involute gear, cylindrical or conical, external or internal (``teeth`` < 0), symmetric or not. Names of DIN 3960 and ISO 21771.

    Args:
        teeth: Number of teeth, negative for an internal gear.
        normal_module: Normal module, mm.
        normal_pressure_angle_deg: Normal pressure angle, degrees; a pair for left and right.
        helix_angle_deg: Helix angle at the pitch cylinder, degrees, positive = right-handed.
        profile_shift: Profile shift coefficient x.
        cone_angle_deg: Cone angle, degrees.
        normal_tooth_thickness: Normal tooth thickness at the pitch cylinder, mm, in place of the profile shift.
        span: Teeth and base tangent length (mm), in place of it.
        over_balls: Ball and measure over balls (mm), in place of it.

    Raises:
        BadInput: a body that is impossible.
        TypeError: more than one of profile shift, thickness, span and measure over balls.
    """

    __slots__ = ("_asked", "_core")

    def __init__(
        self,
        teeth: int,
        normal_module: float,
        normal_pressure_angle_deg: float | tuple[float, float] = 20.0,
        helix_angle_deg: float = 0.0,
        *,
        profile_shift: float | None = None,
        cone_angle_deg: float = 0.0,
        normal_tooth_thickness: float | None = None,
        span: tuple[int, float] | None = None,
        over_balls: tuple[float, float] | None = None,
    ) -> None:
        measures = {
            "profile_shift": profile_shift,
            "normal_tooth_thickness": normal_tooth_thickness,
            "span": span and (span[0], span[1]),
            "over_balls": over_balls and (over_balls[0], over_balls[1]),
        }
        given = {name: of for name, of in measures.items() if of is not None}
        if len(given) > 1:
            raise TypeError(f"give one of {', '.join(measures)}")
        angles = normal_pressure_angle_deg
        left, right = angles if isinstance(angles, tuple) else (angles, angles)
        # What it was made of: with this it is made again, in another process too.
        self._asked: dict[str, Any] = {
            "teeth": teeth,
            "normal_module": normal_module,
            "normal_pressure_angle_deg": (left, right),
            "helix_angle_deg": helix_angle_deg,
            "cone_angle_deg": cone_angle_deg,
            **given,
        }
        kind, of = next(iter(given.items()), ("profile_shift", 0.0))
        self._core = _core.CoreGear(
            teeth,
            normal_module,
            (math.radians(left), math.radians(right)),
            math.radians(helix_angle_deg),
            math.radians(cone_angle_deg),
            (kind, *(of if isinstance(of, tuple) else (of, 0.0))),
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return functools.partial(Gear, **self._asked), ()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Gear) and other._asked == self._asked

    def __hash__(self) -> int:
        return hash(tuple(self._asked.items()))

    @property
    def teeth(self) -> int:
        """Number of teeth, negative for an internal gear."""
        value: int = self._asked["teeth"]
        return value

    @property
    def normal_module(self) -> float:
        """Normal module m_n, mm."""
        value: float = self._asked["normal_module"]
        return value

    @property
    def normal_pressure_angle_deg(self) -> tuple[float, float]:
        """Normal pressure angle of left and right flank, degrees."""
        value: tuple[float, float] = self._asked["normal_pressure_angle_deg"]
        return value

    @property
    def helix_angle_deg(self) -> float:
        """Helix angle at the pitch cylinder, degrees, positive = right-handed."""
        value: float = self._asked["helix_angle_deg"]
        return value

    @property
    def cone_angle_deg(self) -> float:
        """Cone angle, degrees."""
        value: float = self._asked["cone_angle_deg"]
        return value

    @property
    def profile_shift(self) -> float:
        """Profile shift coefficient x."""
        return self._core.profile_shift

    @property
    def pitch_diameter(self) -> float:
        """Pitch diameter d, mm."""
        return 2 * self._core.pitch_radius

    @property
    def transverse_module(self) -> float:
        """Transverse module m_t, mm."""
        return self._core.transverse_module

    def base_diameter(self, flank: Side = "left") -> float:
        """Base diameter d_b of a flank, mm."""
        return 2 * self._core.base_radius(flank)

    def base_helix_angle_deg(self, flank: Side = "left") -> float:
        """Base helix angle beta_b of a flank, degrees."""
        return math.degrees(self._core.base_helix_angle(flank))

    def length_of_roll(self, diameter: float, flank: Side = "left") -> float:
        """Length of roll w at a diameter (mm), mm.

        Raises:
            BadInput: a diameter below the base cylinder.
        """
        return self._core.length_of_roll(flank, diameter / 2)

    def diameter(self, length_of_roll: float, flank: Side = "left") -> float:
        """Diameter at a length of roll w (mm), mm; the inverse of :meth:`length_of_roll`."""
        return 2 * self._core.radius(flank, length_of_roll)

    def span(self, teeth: int) -> float:
        """Base tangent length W_k over ``teeth`` teeth, mm.

        Raises:
            BadInput: a gear that has none: conical, or asymmetric.
        """
        if teeth < 1:
            raise bad_input("a span is over teeth", field="teeth", value=teeth, allowed="1 and more", way_out="give more")
        return self._core.span(teeth)[0]

    def over_balls(self, ball: float, z: float = 0.0) -> float:
        """Measure over (internal: between) balls in the section ``z``, mm.

        Raises:
            BadInput: a ball that does not touch both flanks.
        """
        return self._core.over_balls(ball, z)

    def points(self, w: ArrayLike, z: ArrayLike, flank: Side = "left") -> NDArray[np.float64]:
        """Points of a flank. The space between two teeth is centred on +y at z = 0; the axis of the gear is z.

        Args:
            w: Lengths of roll, mm.
            z: Axial positions, mm, broadcast against ``w``.
            flank: The flank.

        Returns:
            Points x, y, z, mm, shape of ``w`` and ``z`` and (3,).
        """
        return self._vectors(self._core.points, w, z, flank)

    def normals(self, w: ArrayLike, z: ArrayLike, flank: Side = "left") -> NDArray[np.float64]:
        """Unit normals out of the material at the places of :meth:`points`, same arguments and shape."""
        return self._vectors(self._core.normals, w, z, flank)

    @staticmethod
    def _vectors(of: Any, w: ArrayLike, z: ArrayLike, flank: Side) -> NDArray[np.float64]:
        places, shape = in_places(w, z)
        found: NDArray[np.float64] = of(flank, *places)
        return found.reshape(*shape, 3)

    def worm(
        self,
        threads: int = 1,
        *,
        pitch_diameter: float | None = None,
        tip_diameter: float | None = None,
        hand: Literal["right", "left"] = "right",
        normal_pressure_angle_deg: float | None = None,
        profile_shift: float = 0.0,
        cone_angle_deg: float = 0.0,
    ) -> Worm:
        """The worm that meshes with this gear on both flanks; one of the diameters is needed.

        Args:
            threads: Number of threads.
            pitch_diameter: Pitch diameter, mm.
            tip_diameter: Tip diameter, mm.
            hand: Its hand.
            normal_pressure_angle_deg: Normal pressure angle of its rack, degrees, where it is not that of the gear.
            profile_shift: Profile shift coefficient.
            cone_angle_deg: Cone angle, degrees.

        Raises:
            BadInput: a worm that is impossible, or does not mesh.
        """
        angle = None if normal_pressure_angle_deg is None else math.radians(normal_pressure_angle_deg)
        core = self._core.worm(
            threads,
            1.0 if one_of("hand", hand, "right", "left") == "right" else -1.0,
            pitch_diameter,
            tip_diameter,
            angle,
            profile_shift,
            math.radians(cone_angle_deg),
        )
        again = functools.partial(
            self.worm,
            threads,
            pitch_diameter=pitch_diameter,
            tip_diameter=tip_diameter,
            hand=hand,
            normal_pressure_angle_deg=normal_pressure_angle_deg,
            profile_shift=profile_shift,
            cone_angle_deg=cone_angle_deg,
        )
        return Worm(core, again)

    def __repr__(self) -> str:
        return f"<Gear: d = {self.pitch_diameter:.4f} mm, x = {self.profile_shift:.4f}>"


class Worm:
    """A worm that meshes with a gear; made by :meth:`Gear.worm`."""

    __slots__ = ("_again", "_core")

    def __init__(self, core: _core.CoreWorm, again: Callable[[], Worm]) -> None:
        self._core, self._again = core, again

    def __reduce__(self) -> tuple[Any, ...]:
        return self._again, ()

    @property
    def pitch_diameter(self) -> float:
        """Pitch diameter d_S, mm."""
        return 2 * self._core.pitch_radius

    @property
    def tip_diameter(self) -> float:
        """Tip diameter, mm."""
        return 2 * self._core.tip_radius

    @property
    def helix_angle_deg(self) -> float:
        """Helix angle at the pitch cylinder, degrees."""
        return math.degrees(self._core.helix_angle)

    @property
    def crossed_axes_angle_deg(self) -> float:
        """Crossed-axes angle gamma of worm and gear, degrees."""
        return math.degrees(self._core.crossed_axes_angle)

    def points(self, w: ArrayLike, z: ArrayLike, flank: Side = "left") -> NDArray[np.float64]:
        """Points of a flank of the worm, as :meth:`Gear.points`."""
        return Gear._vectors(self._core.gear().points, w, z, flank)

    def normals(self, w: ArrayLike, z: ArrayLike, flank: Side = "left") -> NDArray[np.float64]:
        """Unit normals out of the worm's material, as :meth:`Gear.normals`."""
        return Gear._vectors(self._core.gear().normals, w, z, flank)

    def __repr__(self) -> str:
        return f"<Worm: d_S = {self.pitch_diameter:.4f} mm, gamma = {self.crossed_axes_angle_deg:.4f} deg>"


class Modification:
    """What a flank should be, as an entry of ``target.modifications`` says it; several are added. Called with places, it gives their values.

    Args:
        specs: An entry or several (those of the other flank are left out), with the keys of a job file, e.g.
            ``{"kind": "helix_crowning", "amount_um": 20}``. Amounts are material removed, um, as there.
        gear: The gear.
        start_diameter: Start of the evaluation (root side), mm.
        end_diameter: End of the evaluation (tip side), mm.
        z: Evaluated axial range, begin and end, mm.
        flank: The flank.

    Raises:
        BadInput: a modification that is impossible, with its key.
    """

    __slots__ = ("_again", "_core")

    def __init__(
        self,
        specs: Mapping[str, Any] | Sequence[Mapping[str, Any]],
        gear: Gear,
        *,
        start_diameter: float,
        end_diameter: float,
        z: tuple[float, float],
        flank: Side = "left",
    ) -> None:
        given = [specs] if isinstance(specs, Mapping) else list(specs)
        terms = [term for term in given if term.get("flank", "both") in ("both", flank)]
        if not terms:
            told = ", ".join(str(term["flank"]) for term in given)
            raise bad_input(
                "no entry is for this flank", field="specs", value=told, allowed=f"{flank}, both", way_out="take another flank"
            )
        first, last = z
        self._again = functools.partial(
            Modification, plain(given), gear, start_diameter=start_diameter, end_diameter=end_diameter, z=(first, last), flank=flank
        )
        spec = terms[0] if len(terms) == 1 else {"kind": "sum", "children": terms}
        roll = sorted(gear.length_of_roll(d, flank) for d in (start_diameter, end_diameter))
        self._core = _core.CoreModification(
            json.dumps(plain(spec)),
            (roll[0], roll[1]),
            (float(first), float(last)),
            gear.base_diameter(flank) / 2,
            math.radians(gear.base_helix_angle_deg(flank)),
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return self._again, ()

    def __call__(
        self, w: ArrayLike, z: ArrayLike, *, direction: Literal["normal", "transverse"] = "normal"
    ) -> NDArray[np.float64]:
        """Material that is left; a crowning is negative.

        Args:
            w: Lengths of roll, mm.
            z: Axial positions, mm, broadcast against ``w``.
            direction: Normal to the flank, or in the transverse section as ISO 1328 counts it.

        Returns:
            Values, um, positive = material left, shape of ``w`` and ``z``.

        Raises:
            BadInput: a place beyond the modification.
        """
        places, shape = in_places(w, z)
        values = self._core.values(*places).reshape(shape)
        is_normal = one_of("direction", direction, "normal", "transverse") == "normal"
        return values * (1e3 * (self._core.normal_factor if is_normal else 1.0))
