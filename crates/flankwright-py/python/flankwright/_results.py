"""What tasks come to: verdict, flanks, documents, files."""

from __future__ import annotations

import html
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._extras import needed
from ._jobs import Remark

if TYPE_CHECKING:
    import xarray

Array = NDArray[np.float64]


class FlankValues:
    """One flank over length of roll w and axial position z, normal to the flank, positive = material left.

    Attributes:
        name: ``left`` or ``right``.
        w: Lengths of roll, mm, shape (profile,).
        z: Axial positions, mm, shape (helix,).
        target: What is wanted, um, shape (profile, helix).
        planned: Exact contact with the tool as made, um, same shape.
        simulated: What the referee found, um, same shape; ``None`` without a simulation.
    """

    __slots__ = ("name", "w", "z", "target", "planned", "simulated")

    def __init__(
        self, name: str, w: Array, z: Array, target: Array, planned: Array, simulated: Array | None = None
    ) -> None:
        self.name, self.w, self.z = name, w, z
        self.target, self.planned, self.simulated = target, planned, simulated

    @property
    def deviation(self) -> Array:
        """Simulated (or, without a referee, planned) less target, um, shape (profile, helix)."""
        made = self.planned if self.simulated is None else self.simulated
        return made - self.target

    def __repr__(self) -> str:
        return f"<{self.name} flank: {self.w.size} x {self.z.size}, deviation <= {np.abs(self.deviation).max():.3g} um>"


class Flanks(Mapping[str, FlankValues]):
    """The flanks of a gear by name, ``left`` and ``right``, as far as they are ground; a mapping that does not change."""

    def __init__(self, flanks: Mapping[str, FlankValues]) -> None:
        self._flanks = dict(flanks)

    def __getitem__(self, name: str) -> FlankValues:
        return self._flanks[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._flanks)

    def __len__(self) -> int:
        return len(self._flanks)

    def to_xarray(self) -> xarray.DataTree:
        """The flanks as labelled arrays: a node for each flank with ``target``, ``planned`` and ``simulated`` (um) over ``w`` and ``z``
        (mm). Needs xarray 2024.10 or later.
        """
        needed("xarray", "arrays")
        import xarray

        def dataset(flank: FlankValues) -> xarray.Dataset:
            data = {
                key: (("w", "z"), values, {"units": "um", "long_name": f"{key} flank, normal, positive = material left"})
                for key in ("target", "planned", "simulated")
                if (values := getattr(flank, key)) is not None
            }
            coordinates = {
                "w": ("w", flank.w, {"units": "mm", "long_name": "length of roll"}),
                "z": ("z", flank.z, {"units": "mm", "long_name": "axial position"}),
            }
            return xarray.Dataset(data, coordinates)

        tree: xarray.DataTree = xarray.DataTree.from_dict({f"/{name}": dataset(flank) for name, flank in self.items()})
        return tree


class Result:
    """A task that was carried out, as :func:`plan`, :func:`simulate`, :func:`explore` and :func:`inspect` return it."""

    def __init__(self, core: _core.CoreResult) -> None:
        self._core = core
        self._document: dict[str, Any] | None = None
        self._flanks: Flanks | None = None

    @property
    def document(self) -> dict[str, Any]:
        """The document of ``result.json`` (or ``explore.json``), with units in the key names."""
        if self._document is None:
            self._document = json.loads(self._core.document())
        return self._document

    @property
    def status(self) -> str | None:
        """``met``, ``missed`` or ``not_judged``; ``None`` for studies, which judge no target."""
        return self._core.status

    @property
    def accepted(self) -> bool:
        """Whether the command would end with exit status 0: the target is met, or nothing was asked for."""
        return bool(self.document.get("accepted", True))

    @property
    def scope(self) -> dict[str, list[dict[str, Any]]]:
        """What the verdict covers: ``judged`` (item, status, detail) and ``not_judged`` (item, asked, why)."""
        scope: dict[str, list[dict[str, Any]]] = self.document.get("scope", {"judged": [], "not_judged": []})
        return scope

    @property
    def seconds(self) -> float:
        """How long the library worked on it, s."""
        return self._core.seconds

    @property
    def met(self) -> bool:
        """Whether the target is met within its tolerance."""
        return self.status == "met"

    @property
    def flanks(self) -> Flanks:
        """The flanks of a ground gear; empty for other processes."""
        if self._flanks is None:
            found = self._core.flanks()
            self._flanks = Flanks({name: FlankValues(name, **arrays) for name, arrays in found.items()})
        return self._flanks

    @property
    def left(self) -> FlankValues:
        """The left flank of a ground gear.

        Raises:
            KeyError: it is not ground.
        """
        return self.flanks["left"]

    @property
    def right(self) -> FlankValues:
        """The right flank of a ground gear.

        Raises:
            KeyError: it is not ground.
        """
        return self.flanks["right"]

    @property
    def settings(self) -> dict[str, Any]:
        """Settings, as in ``result.json``, with units in the key names; empty where there are none."""
        found: dict[str, Any] = self.document.get("settings", {})
        return found

    @property
    def warnings(self) -> list[Remark]:
        """Remarks: what is worth knowing and is no error."""
        return [Remark(**remark) for remark in self.document.get("warnings", [])]

    def write(self, directory: str | Path) -> list[Path]:
        """Writes report, tables, programs and documents, as the command does, each whole or not at all.

        Args:
            directory: Made if missing.

        Returns:
            Paths of the files, the report last.

        Raises:
            OSError: the directory or a file cannot be written.
        """
        return list(self._core.write(Path(directory)))

    def to_xarray(self) -> xarray.DataTree:
        """The flanks as labelled arrays, as :meth:`Flanks.to_xarray` makes them."""
        return self.flanks.to_xarray()

    def __repr__(self) -> str:
        name = self.document.get("job", "")
        return f"<Result {name!r}: {self.status or 'study'}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{name}</td><td>{np.abs(flank.deviation).max():.4f} um</td>"
            f"<td>{float(np.sqrt(np.mean(flank.deviation**2))):.4f} um</td></tr>"
            for name, flank in self.flanks.items()
        )
        head = f"<b>{html.escape(str(self.document.get('job', '')))}</b>: {html.escape(self.status or 'study')}"
        if not rows:
            return head
        return f"{head}<table><tr><th>flank</th><th>largest deviation</th><th>rms</th></tr>{rows}</table>"
