"""Pictures in the conventions of inspection sheets, with matplotlib: nets, maps, profile and helix diagrams. Ochre is material left, blue is
material removed; lines are solid above zero and dashed below, so that they read in black and white.

Every function returns a figure that no window holds: a notebook shows it, ``figure.savefig("flank.png")`` keeps it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ._extras import needed
from ._results import Array, Flanks, FlankValues, Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

needed("matplotlib", "plots")
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402

Shown = Literal["target", "planned", "simulated", "deviation"]
__all__ = ["COLOURS", "contour", "diagrams", "net"]

COLOURS = LinearSegmentedColormap.from_list("flank", ("#1f4e79", "#9dc3e6", "#ffffff", "#f3d19c", "#b45f06"))
"""From material removed (blue) to material left (ochre); for matplotlib, around zero."""
_TITLES: Mapping[str, str] = {
    "target": "Target",
    "planned": "Planned",
    "simulated": "Simulated (referee)",
    "deviation": "Deviation from the target",
}


def _values(flank: FlankValues, shown: Shown) -> Array:
    if shown not in _TITLES:
        raise ValueError(f"a flank has no values {shown!r}: choose among {', '.join(_TITLES)}")
    values: Array | None = getattr(flank, shown)
    if values is None:
        raise ValueError(f"the {flank.name} flank has no values {shown!r}: plan the job with its referee")
    return values


def _flanks(of: Result | Flanks | FlankValues) -> list[FlankValues]:
    if isinstance(of, FlankValues):
        return [of]
    found = list((of.flanks if isinstance(of, Result) else of).values())
    if not found:
        raise ValueError("there are no flanks: the result is not that of a ground gear")
    return found


def contour(of: Result | Flanks | FlankValues, shown: Shown = "deviation", *, levels: int = 11) -> Figure:
    """Contour maps over axial position and length of roll.

    Args:
        of: A result, its flanks, or one of them.
        shown: What is shown: ``target``, ``planned``, ``simulated`` or ``deviation``.
        levels: About so many lines.

    Returns:
        The figure.

    Raises:
        ValueError: no flanks, or none of the values that are to be shown.
    """
    from matplotlib.ticker import MaxNLocator

    flanks = _flanks(of)
    largest = max(float(np.abs(_values(flank, shown)).max()) for flank in flanks) or 1.0
    lines = MaxNLocator(levels, symmetric=True).tick_values(-largest, largest)
    figure = _figure(figsize=(5.2 * len(flanks) + 1, 4), layout="constrained")
    axes = figure.subplots(1, len(flanks), sharey=True, squeeze=False)
    filled: Any = None
    for flank, ax in zip(flanks, axes[0]):
        values = _values(flank, shown)
        filled = ax.contourf(flank.z, flank.w, values, levels=lines, cmap=COLOURS)
        drawn = ax.contour(
            flank.z,
            flank.w,
            values,
            levels=lines,
            colors="black",
            linewidths=[1.4 if abs(level) < 1e-12 else 0.6 for level in lines],
            linestyles=["dashed" if level < 0 else "solid" for level in lines],
        )
        ax.clabel(drawn, fontsize=7)
        ax.set(title=f"{flank.name} flank", xlabel="axial position z [mm]")
    axes[0][0].set_ylabel("length of roll w [mm]")
    figure.colorbar(filled, ax=list(axes[0]), label="material left, normal [µm]")
    figure.suptitle(_TITLES[shown])
    return figure


def net(
    of: Result | Flanks | FlankValues, shown: Shown = "simulated", *, magnification: float | None = None
) -> Figure:
    """Flanks as nets over their nominal field, heights magnified.

    Args:
        of: A result, its flanks, or one of them.
        shown: What is shown: ``target``, ``planned``, ``simulated`` or ``deviation``.
        magnification: Of heights against lengths; chosen where none is given, and stated in the title.

    Returns:
        The figure.

    Raises:
        ValueError: no flanks, or none of the values that are to be shown.
    """
    flanks = _flanks(of)
    largest = max(float(np.abs(_values(flank, shown)).max()) for flank in flanks) or 1.0
    width = max(float(np.ptp(flank.z)) for flank in flanks)
    if magnification is None:
        magnification = _round(0.4 * width / (largest * 1e-3))
    figure = _figure(figsize=(5.2 * len(flanks), 4.2), layout="constrained")
    for k, flank in enumerate(flanks):
        ax: Any = figure.add_subplot(1, len(flanks), k + 1, projection="3d")
        z, w = np.meshgrid(flank.z, flank.w)
        values = _values(flank, shown)
        few = {"rcount": 13, "ccount": 17}
        ax.plot_wireframe(z, w, np.zeros_like(z), color="0.75", linewidth=0.4, **few)
        ax.plot_wireframe(z, w, values * 1e-3 * magnification, color="black", linewidth=0.7, **few)
        ax.set_box_aspect((np.ptp(flank.z), np.ptp(flank.w), 0.8 * width), zoom=0.88)
        ax.set_zlim(-0.5 * width, 0.5 * width)
        ax.set_zticks([])
        ax.set(title=f"{flank.name} flank, |f| ≤ {np.abs(values).max():.3g} µm", xlabel="z [mm]", ylabel="w [mm]")
    figure.suptitle(f"{_TITLES[shown]}, heights {magnification:g} : 1")
    return figure


def _figure(**how: Any) -> Figure:
    """A figure that notebooks show once, as what a cell returns: no window holds it."""
    import matplotlib.pyplot as plt

    figure: Figure = plt.figure(**how)
    plt.close(figure)
    return figure


def _round(value: float) -> float:
    power = 10.0 ** np.floor(np.log10(value))
    return float(max(step for step in (1, 2, 5) if step * power <= value) * power)


def diagrams(of: Result | Flanks | FlankValues, shown: Iterable[Shown] = ("target", "simulated")) -> Figure:
    """Profile and helix diagrams through the middle of the field, as on an inspection sheet: material to the right (profile) and upwards
    (helix).

    Args:
        of: A result, its flanks, or one of them.
        shown: What is drawn, each with a dash of its own: some of ``target``, ``planned``, ``simulated``, ``deviation``.

    Returns:
        The figure.

    Raises:
        ValueError: no flanks, or none of the values that are to be shown.
    """
    flanks, drawn = _flanks(of), tuple(shown)
    dashes = {"target": "--", "planned": "-.", "simulated": "-", "deviation": ":"}
    figure = _figure(figsize=(4.6 * len(flanks), 6.4), layout="constrained")
    axes = figure.subplots(2, len(flanks), squeeze=False)
    for k, flank in enumerate(flanks):
        profile, helix = axes[0][k], axes[1][k]
        for what in drawn:
            values = _values(flank, what)
            profile.plot(values[:, flank.z.size // 2], flank.w, dashes[what], color="black", label=_TITLES[what])
            helix.plot(flank.z, values[flank.w.size // 2], dashes[what], color="black", label=_TITLES[what])
        profile.set(
            title=f"{flank.name} flank: profile at z = {flank.z[flank.z.size // 2]:.2f} mm",
            xlabel="material left, normal [µm]",
            ylabel="length of roll w [mm]",
        )
        helix.set(
            title=f"helix at w = {flank.w[flank.w.size // 2]:.2f} mm",
            xlabel="axial position z [mm]",
            ylabel="material left, normal [µm]",
        )
        profile.axvline(0.0, color="0.6", linewidth=0.6)
        helix.axhline(0.0, color="0.6", linewidth=0.6)
        for ax in (profile, helix):
            ax.grid(True, linewidth=0.4, color="0.8")
        # Both sides on one scale.
        profile.sharex(axes[0][0])
        helix.sharey(axes[1][0])
    axes[0][0].legend(fontsize=8)
    return figure
