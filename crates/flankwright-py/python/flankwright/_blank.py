"""The stock of a measured blank: what a hobbed or pre-ground gear has over the gear of a job, tooth by tooth."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._jobs import Remark
from ._tasks import AnyJob, as_job

Array = NDArray[np.float64]


class FlankStock:
    """Stock on one flank of every tooth space, normal to the flank, beyond ``stock.allowance_um`` of the job.

    Attributes:
        name: ``left`` or ``right``.
        w: Lengths of roll, mm, shape (profile,).
        z: Axial positions, mm, shape (helix,).
        spaces: Numbers of the tooth spaces, from 0.
        stock: Amounts, um, shape (space, profile, helix).
    """

    __slots__ = ("name", "w", "z", "spaces", "stock")

    def __init__(self, name: str, w: Array, z: Array, spaces: list[int], stock: Array) -> None:
        self.name, self.w, self.z, self.spaces, self.stock = name, w, z, spaces, stock

    def __repr__(self) -> str:
        return f"<{self.name} flank: stock of {len(self.spaces)} spaces, {self.w.size} x {self.z.size} places>"


class BlankStock:
    """The stock of a measured blank; made by :func:`blank_stock`.

    Attributes:
        document: ``stock_um`` (least, mean and greatest of each flank in all), ``teeth_with_traces``, ``level_from``, ``with_pitch``.
        remarks: What to know.
        flanks: Stock of each flank that was measured, ``left`` and ``right``.
    """

    def __init__(self, core: _core.CoreBlank) -> None:
        self._core = core
        self.document: dict[str, Any] = json.loads(core.document())
        self.remarks = [Remark(**remark) for remark in self.document["remarks"]]
        self.flanks: Mapping[str, FlankStock] = {name: FlankStock(name, **of) for name, of in core.flanks().items()}

    def write(self, directory: str | os.PathLike[str]) -> list[Path]:
        """Writes ``stock.csv``, the table for the key ``stock.map`` of a job, and ``blank.json``.

        Returns:
            The paths, the table first.

        Raises:
            OSError: they cannot be written.
        """
        return self._core.write(Path(directory))

    def __repr__(self) -> str:
        told = [f"{name} {of[0]:.1f} to {of[2]:.1f} um" for name, of in self.document["stock_um"].items() if of]
        return f"<BlankStock: {', '.join(told)}>"


def blank_stock(
    file: str | os.PathLike[str],
    job: AnyJob,
    *,
    from_other_end: bool = False,
    slope_signs: tuple[int, int] | None = None,
    datum_face: Literal["+z", "-z"] | None = None,
    helix_slope_over: Literal["face-width", "range"] | None = None,
    profile_slope_over: Literal["face-width", "range"] | None = None,
) -> BlankStock:
    """The stock that a measured blank has over the gear of a job, as ``flankwright inspect FILE --job JOB --blank`` finds it.

    Traces tell the shape of each flank; the level comes from the span or the size over balls in the file, else from ``stock.allowance_um``
    of the job, that of each tooth from its pitch.

    Args:
        file: The measurement of the hobbed or pre-ground gear.
        job: The job of generating grinding by which it is going to be ground.
        from_other_end: The gear was measured from the other end.
        slope_signs: Signs of helix slopes as the file names the flanks, left and right, each +1 or -1.
        datum_face: The face from which distances count, at the end of +z or of -z.
        helix_slope_over: The length to which helix slopes refer: the face width, or the evaluated range.
        profile_slope_over: The length to which profile slopes refer.

    Raises:
        BadInput: the file or the job is at fault, it is another gear, or nothing tells the level.
    """
    stated = (from_other_end, slope_signs, datum_face, helix_slope_over, profile_slope_over)
    return BlankStock(_core.CoreBlank(Path(file), as_job(job)._core, stated))
