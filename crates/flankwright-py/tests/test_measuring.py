"""A skiving tool at its light barrier, asked directly, beside the result of its job."""

from pathlib import Path
from typing import Any, Literal

import flankwright as fw
import numpy as np
import pytest

JOB = Path(__file__).parents[3] / "examples/skiving/external-stepped.toml"
FLANKS: tuple[Literal["left", "right"], ...] = ("left", "right")


@pytest.fixture(scope="module")
def tool() -> fw.ToolMeasurement:
    return fw.ToolMeasurement(JOB)


@pytest.fixture(scope="module")
def found() -> Any:
    return fw.plan(JOB).document["measurement"]


@pytest.fixture(scope="module")
def evaluation(tool: fw.ToolMeasurement) -> fw.Evaluation:
    assert tool.deviations is not None
    return tool.evaluate(tool.deviations)


def test_deviations_and_what_they_say_are_those_of_the_result(
    tool: fw.ToolMeasurement, evaluation: fw.Evaluation, found: Any
) -> None:
    assert tool.deviations is not None
    assert evaluation.clocking_deg == pytest.approx(found["clocking_deg"], rel=1e-12)
    for k, flank in enumerate(FLANKS):
        np.testing.assert_allclose(tool.deviations[k], found["deviation_um"][flank], atol=1e-9)
        np.testing.assert_allclose(evaluation.profile_um[k], found["profile"]["track_mean_um"][flank], atol=1e-9)
    np.testing.assert_allclose(evaluation.single_pitch_um, found["pitch"]["single_um"], atol=1e-9)
    np.testing.assert_allclose(evaluation.eccentricity_um, found["mounting"]["eccentricity_um"], atol=1e-9)
    np.testing.assert_allclose(evaluation.wobble_urad, found["mounting"]["wobble_urad"], atol=1e-9)
    change = found["correction"]
    assert evaluation.setting["centre_distance"] == pytest.approx(change["centre_distance_um"] * 1e-3, rel=1e-9)
    assert evaluation.setting["crossed_axes_angle_deg"] == pytest.approx(change["crossed_axes_angle_deg"], rel=1e-9)
    assert evaluation.setting["tool_angle_deg"] == pytest.approx(change["tool_angle_deg"], rel=1e-9)


def test_what_remains_is_what_the_change_leaves(tool: fw.ToolMeasurement, evaluation: fw.Evaluation) -> None:
    for k, flank in enumerate(FLANKS):
        by = tool.sensitivities(flank)
        moved = sum(by[name] * change for name, change in evaluation.setting.items())
        np.testing.assert_allclose(evaluation.workpiece_um[k] + moved, evaluation.remaining_um[k], atol=1e-9)
    assert np.sqrt(np.mean(evaluation.remaining_um**2)) < np.sqrt(np.mean(evaluation.workpiece_um**2))


def test_repetitions_scatter_as_the_result_says(tool: fw.ToolMeasurement, found: Any) -> None:
    other = fw.ToolMeasurement(tool.job.replace({"measuring.seed": 7}))
    assert other.deviations is not None
    # Equal but for rounding.
    np.testing.assert_allclose(tool.repeat([7])[0], other.deviations, rtol=0.0, atol=1e-9)
    many = tool.repeat(range(200))
    assert many.shape == (200, 2, tool.tracks().place.size, tool.teeth)
    scatter = many.std(axis=0, ddof=1).mean(axis=2)
    for k, flank in enumerate(FLANKS):
        # 200 repetitions of 50 teeth: the mean of the standard deviations is known to some 1 %; that steps of the encoder are no normal noise
        # takes the rest.
        np.testing.assert_allclose(scatter[k], found["sigma_um"][flank], rtol=0.1)


def test_what_is_wrong_is_told(tool: fw.ToolMeasurement) -> None:
    with pytest.raises(fw.BadInput, match="flank, track"):
        tool.evaluate(np.zeros((2, 3)))
    with pytest.raises(fw.BadInput, match="allowed: \\(2, "):
        tool.evaluate(np.zeros((2, 3, 4)))
    with pytest.raises(fw.BadInput, match="finite"):
        tool.evaluate(np.full((2, tool.tracks().place.size, tool.teeth), np.nan))
    with pytest.raises(fw.BadInput, match="negative"):
        tool.repeat([-1])
    with pytest.raises(fw.BadInput, match="skiving-tool-measuring"):
        fw.ToolMeasurement(JOB.parents[1] / "twist-free-crowning.toml")
    bare = fw.ToolMeasurement(tool.job.replace({"tool_errors": None}))
    assert bare.deviations is None
    with pytest.raises(fw.BadInput, match="tool_errors"):
        bare.repeat([1])
