"""Pictures: that they are drawn, with titles, units and a legend. PICTURES=FOLDER keeps them."""

import os
from pathlib import Path

import flankwright as fw
import matplotlib
import pytest
from flankwright import plots

matplotlib.use("Agg")
EXAMPLES = Path(__file__).parents[3] / "examples"


@pytest.fixture(scope="module")
def planned() -> fw.Result:
    return fw.plan(EXAMPLES / "twist-free-crowning.toml")


@pytest.mark.parametrize("kind", ["contour", "net", "diagrams"])
def test_every_kind_is_drawn(planned: fw.Result, kind: str, tmp_path: Path) -> None:
    figure = getattr(plots, kind)(planned)
    texts = [text.get_text() for ax in figure.axes for text in (ax.title, ax.xaxis.label, ax.yaxis.label)]
    assert any("left flank" in text for text in texts) and any("[mm]" in text for text in texts), texts
    folder = Path(os.environ.get("PICTURES", tmp_path))
    figure.savefig(folder / f"{kind}.png", dpi=110)
    assert (folder / f"{kind}.png").stat().st_size > 10_000


def test_what_cannot_be_shown_is_told(planned: fw.Result) -> None:
    preview = fw.preview(EXAMPLES / "twist-free-crowning.toml")
    assert plots.contour(preview.flanks, "planned")
    with pytest.raises(ValueError, match="simulated"):
        plots.net(preview.flanks)
    with pytest.raises(ValueError, match="no flanks"):
        plots.contour(fw.plan(EXAMPLES / "gearbox/reference-train.toml"))
