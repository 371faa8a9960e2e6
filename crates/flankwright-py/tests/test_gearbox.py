"""The electronic gearbox asked directly, beside the result of its job, down to its pulses."""

from pathlib import Path
from typing import Any

import flankwright as fw
import numpy as np
import pytest

JOB = Path(__file__).parents[3] / "examples/gearbox/feed-to-and-fro.toml"


@pytest.fixture(scope="module")
def gearbox() -> fw.Gearbox:
    return fw.Gearbox(JOB)


@pytest.fixture(scope="module")
def found() -> Any:
    return fw.plan(JOB).document


def test_coupling_budget_and_errors_are_those_of_the_result(gearbox: fw.Gearbox, found: Any) -> None:
    assert gearbox.coupling == found["coupling"]
    of_job = found["budget"]
    budget = gearbox.budget(of_job["speed_mm_per_min"], of_job["acceleration_mm_per_s2"])
    for name in ("quantisation", "truncation", "synchronisation", "acceleration"):
        assert float(budget[name]) == pytest.approx(of_job[f"{name}_um"], rel=1e-12)
    assert float(budget["flank_um"]) == pytest.approx(of_job["flank_um"], rel=1e-12)
    assert float(budget["greatest_speed"]) == pytest.approx(found["settings"]["greatest_speed_mm_per_min"], rel=1e-12)
    errors = gearbox.errors()
    whole = found["along_feed"]["whole"]
    assert float(errors["along_feed"].sel(bound="greatest").max()) == pytest.approx(whole["greatest_um"], abs=1e-9)
    assert float(errors["along_feed"].sel(bound="least").min()) == pytest.approx(whole["least_um"], abs=1e-9)
    at_flank = found["angle"]["flank"]
    assert float(errors["at_flank"].sel(bound="greatest").max()) == pytest.approx(at_flank["greatest_um"], abs=1e-9)


def test_a_budget_falls_with_the_speed_as_it_should(gearbox: fw.Gearbox) -> None:
    budget = gearbox.budget([[100.0], [400.0]], [0.0, 100.0, 200.0])
    assert budget["flank_um"].shape == (2, 3)
    # The staircase does not know of speed; what a spacing is off by an acceleration goes with 1/v^2, as long as it is not at its bound.
    assert np.ptp(budget["quantisation"].values) == 0
    acceleration = budget["acceleration"].values
    np.testing.assert_allclose(acceleration[1, 2], 2 * acceleration[1, 1], rtol=1e-12)


def test_pulses_turn_the_workpiece_by_the_exact_ratio(gearbox: fw.Gearbox, found: Any) -> None:
    pulses = gearbox.pulses()
    counted = found["pulses"]
    assert {kind: int((pulses.kind == kind).sum()) for kind in "RZK"} == {
        "R": counted["references"],
        "Z": counted["intermediates"],
        "K": counted["corrections"],
    }
    assert int(pulses.sign.sum()) == counted["net_pulses"]
    parts = counted["rotation_workpiece_pulses"] * 16 + counted["rotation_rest_parts"]
    assert int(pulses.turned.sum()) == parts
    # By hand: the accumulator gives whole parts of pulses times ratio, rounded down at every place.
    ratio = gearbox.coupling["coefficient"]
    places = np.cumsum(pulses.sign)
    assert np.abs(np.cumsum(pulses.turned) - places * ratio).max() <= 1.0


def test_a_train_of_pulses(gearbox: fw.Gearbox) -> None:
    ticks = np.arange(1, 41) * 1600
    pulses = gearbox.pulses(ticks)
    assert (pulses.sign == 1).all()
    steady = pulses.tick[pulses.tick > ticks[2]]
    assert set(np.diff(steady).tolist()) == {100}, "sixteen pulses an interval, equally far apart"
    there_and_back = gearbox.pulses(np.append(ticks, ticks + ticks[-1] + 5000), [1] * 40 + [-1] * 40)
    assert abs(int(there_and_back.sign.sum())) < 16


def test_what_is_wrong_is_told(gearbox: fw.Gearbox) -> None:
    with pytest.raises(fw.BadInput, match="whole numbers"):
        gearbox.pulses([0.5, 1.5])
    with pytest.raises(fw.BadInput, match="number"):
        gearbox.pulses([1, 2, 3], [1, 1])
    with pytest.raises(fw.BadInput, match="signs without ticks"):
        gearbox.pulses(signs=[1])
    with pytest.raises(fw.BadInput, match="references"):
        gearbox.pulses([5, 4])
    with pytest.raises(fw.BadInput, match="speed"):
        gearbox.budget(-1.0)
    with pytest.raises(fw.BadInput, match="electronic-gearbox"):
        fw.Gearbox(JOB.parents[1] / "twist-free-crowning.toml")
