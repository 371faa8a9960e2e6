"""A space milled on five axes: its flanks, the cutter at every row and column, and what the rows leave."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._extras import needed
from ._tasks import AnyJob, Progress, as_job
from ._values import in_places, one_of

if TYPE_CHECKING:
    import xarray

Array = NDArray[np.float64]

_UNITS = {
    "tip": ("mm", "tip of the cutter, on its axis"),
    "axis": ("1", "axis of the cutter, towards the shank"),
    "contact": ("mm", "point that the cutter touches"),
    "normal": ("1", "normal of the flank there, out of the material"),
    "height": ("", "height parameter of the flank, root to tip"),
    "length": ("", "length parameter of the flank"),
    "contact_height": ("mm", "height of the contact above the tip of the cutter"),
    "contact_radius": ("mm", "radius of the cutter at the contact"),
    "tilt": ("rad", "angle between axis and tangent plane within the column plane"),
    "beside_face": ("", "whether the column lies beyond the ends of the face"),
}


class CutterPath(NamedTuple):
    """A path with the cutter in the material, in straight blocks.

    Attributes:
        operation: What it does, e.g. ``left flank``.
        tip: Tip of the cutter in the space about +y, mm, shape (place, 3).
        axis: Unit axis towards the shank, same shape.
    """

    operation: str
    tip: Array
    axis: Array


class Milling:
    """The plan of one space of a gear, bevel gear or blade: rows and columns on every flank, the cutter at each of them.

    A flank is a surface over a height parameter (root to tip) and a length parameter (along the tooth), in units of that surface: mm for
    involutes, rad and mm for bevel gears, shares of a grid for blades.

    Args:
        job: A job of five-axis milling, or its file.
        progress: Called with the progress of the plan.

    Attributes:
        flanks: Names of the flanks.

    Raises:
        BadInput: a job of another process, or one at fault.
        NotProducible: this cutter cannot mill this space.
    """

    def __init__(self, job: AnyJob, *, progress: Progress | None = None) -> None:
        self.job = as_job(job)
        self._core = _core.CoreMilling(self.job._core, progress)
        self.flanks: tuple[str, ...] = tuple(self._core.flanks)

    def __reduce__(self) -> tuple[Any, ...]:
        return Milling, (self.job,)

    def _number(self, flank: str) -> int:
        return self.flanks.index(one_of("flank", flank, *self.flanks))

    def heights(self, flank: str) -> tuple[float, float]:
        """Height parameters at root and tip."""
        root, tip = self._core.range(self._number(flank))[0]
        return root, tip

    def lengths(self, flank: str) -> tuple[float, float]:
        """Length parameters at both ends of the face."""
        first, last = self._core.range(self._number(flank))[1]
        return first, last

    def points(self, height: ArrayLike, length: ArrayLike, flank: str) -> Array:
        """Points of a flank, broadcast; shape of both and (3,), mm in the space about +y."""
        return self._surface(height, length, flank)[..., :3]

    def normals(self, height: ArrayLike, length: ArrayLike, flank: str) -> Array:
        """Unit normals out of the material, as :meth:`points`."""
        return self._surface(height, length, flank)[..., 3:]

    def _surface(self, height: ArrayLike, length: ArrayLike, flank: str) -> Array:
        places, shape = in_places(height, length)
        return self._core.surface(self._number(flank), *places).reshape(*shape, 6)

    def rows(self, flank: str) -> xarray.Dataset:
        """The cutter at every row and column of a flank: ``tip``, ``axis``, ``contact``, ``normal`` over (row, column, xyz), and
        ``height``, ``length``, ``contact_height``, ``contact_radius``, ``tilt``, ``beside_face`` over (row, column); the coordinate ``lead``
        of the columns is their parameter on the guide curve. Row 0 is at the root. Needs xarray.
        """
        needed("xarray", "arrays")
        import xarray

        found = self._core.rows(self._number(flank))
        data = {
            name: (("row", "column", "xyz")[: found[name].ndim], found[name], {"units": unit, "long_name": meaning})
            for name, (unit, meaning) in _UNITS.items()
        }
        return xarray.Dataset(data, {"lead": ("column", found["lead"]), "xyz": ["x", "y", "z"]}, {"flank": flank})

    def paths(self) -> list[CutterPath]:
        """All paths of the cutter in the order of cutting: clearing, rows, fillets, bottom."""
        return [CutterPath(operation, places[:, :3], places[:, 3:]) for operation, places in self._core.paths()]

    def leaves(self, height: ArrayLike, length: ArrayLike, flank: str) -> xarray.Dataset:
        """What the rows leave on a grid, um normal to the flank, positive = material left: ``scallop`` between the rows and ``chord`` of the
        straight blocks; their sum is the deviation. NaN where no row comes by. Needs xarray.

        Args:
            height: Height parameters, shape (height,).
            length: Length parameters, shape (length,).
            flank: The flank.

        Raises:
            NotProducible: a place beyond the rows.
        """
        needed("xarray", "arrays")
        import xarray

        axes = [np.atleast_1d(np.asarray(each, dtype=np.float64)) for each in (height, length)]
        scallop, chord = self._core.predicted(self._number(flank), axes[0].tolist(), axes[1].tolist())
        data = {
            name: (("height", "length"), values * 1e3, {"units": "um"})
            for name, values in (("scallop", scallop), ("chord", chord))
        }
        return xarray.Dataset(data, {"height": axes[0], "length": axes[1]}, {"flank": flank})

    def __repr__(self) -> str:
        return f"<Milling of {self.job.name!r}: {', '.join(self.flanks)}>"
