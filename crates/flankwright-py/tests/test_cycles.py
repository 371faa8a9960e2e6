"""Cycles from stock to cost: the wheel's figures are those of the command, and a measured blank goes into a job."""

from pathlib import Path

import flankwright as fw
import pytest

CYCLES = Path(__file__).parents[3] / "examples/cycles"


@pytest.mark.parametrize("name", ["ev-gear", "truck-gear", "spur-gear"])
def test_a_cycle_has_its_times_and_costs(name: str) -> None:
    planned = fw.plan(CYCLES / f"{name}.toml")
    assert planned.met
    removal = planned.document["removal"]
    time, cycles = removal["part_time"], removal["cycles"]
    assert time["grinding_by_law_s"] == pytest.approx(time["grinding_s"], rel=0.01)
    assert removal["cost_per_part"]["total"] > 0
    assert cycles["fastest"]["part_s"] <= cycles["standard"]["part_s"]
    # What the strokes take is what stood there.
    taken = sum(stroke["volume_mm3"] for stroke in removal["strokes"])
    assert taken == pytest.approx(removal["stock"]["volume_mm3"], rel=1e-4)
    assert all(stroke["nearest_limit"]["share"] <= 1.0 for stroke in removal["strokes"] if stroke["volume_mm3"] > 0)


def test_a_blank_is_taken_as_it_was_measured() -> None:
    removal = fw.plan(CYCLES / "measured-blank.toml").document["removal"]
    least, most = removal["stock"]["least_um"]["left"], removal["stock"]["largest_um"]["left"]
    assert 80.0 < least < 110.0 < most < 130.0
    assert removal["dressing"]["speed_ratio"] < 0.0 < removal["dressing"]["overlap"]
