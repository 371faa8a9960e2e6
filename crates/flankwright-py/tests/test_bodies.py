"""Bodies, modifications and the forward model."""

from pathlib import Path

import flankwright as fw
import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[3] / "examples"


def test_a_gear_has_the_figures_of_its_drawing() -> None:
    gear = fw.Gear(19, 3.5, 17.5, -35.0)
    assert gear.pitch_diameter == pytest.approx(19 * 3.5 / np.cos(np.radians(35)), rel=1e-14)
    w = gear.length_of_roll(80.0)
    assert gear.diameter(w) == pytest.approx(80.0, rel=1e-14)
    assert w == pytest.approx(np.sqrt(80.0**2 - gear.base_diameter() ** 2) / 2, rel=1e-14)
    again = fw.Gear(19, 3.5, 17.5, -35.0, span=(4, gear.span(4)))
    assert again.profile_shift == pytest.approx(0.0, abs=1e-12)
    balls = fw.Gear(19, 3.5, 17.5, -35.0, over_balls=(6.0, gear.over_balls(6.0)))
    assert balls.profile_shift == pytest.approx(0.0, abs=1e-12)
    with pytest.raises(TypeError, match="one of"):
        fw.Gear(19, 3.5, profile_shift=0.1, span=(3, 20.0))
    with pytest.raises(fw.BadInput):
        fw.Gear(0, 3.5)


def test_points_lie_on_the_involute() -> None:
    gear = fw.Gear(31, 2.0, (20.0, 25.0), 15.0)
    for flank in ("left", "right"):
        w, z = np.linspace(2.0, 9.0, 5)[:, None], np.linspace(-10.0, 10.0, 7)
        points, normals = gear.points(w, z, flank), gear.normals(w, z, flank)
        assert points.shape == normals.shape == (5, 7, 3)
        radius = np.hypot(points[..., 0], points[..., 1])
        np.testing.assert_allclose(radius, np.hypot(gear.base_diameter(flank) / 2, np.broadcast_to(w, (5, 7))), rtol=1e-13)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=-1), 1.0, rtol=1e-14)
    with pytest.raises(fw.BadInput):
        gear.base_diameter("upper")  # type: ignore[arg-type]


def test_a_worm_meshes_with_its_gear() -> None:
    worm = fw.Gear(31, 2.0, 20.0, 15.0).worm(threads=2, pitch_diameter=250.0)
    assert worm.pitch_diameter == pytest.approx(250.0)
    # Both have the normal module of the rack: sin of the lead angle = threads m_n / d.
    assert np.cos(np.radians(worm.helix_angle_deg)) == pytest.approx(2 * 2.0 / 250.0, rel=1e-12)
    with pytest.raises(fw.BadInput):
        fw.Gear(31, 2.0).worm()


def test_a_modification_is_what_its_entry_says() -> None:
    gear = fw.Gear(31, 2.0, 20.0, 15.0)
    field = {"start_diameter": 61.5, "end_diameter": 67.0, "z": (-10.0, 10.0)}
    crowning = fw.Modification({"kind": "helix_crowning", "amount_um": 20}, gear, **field)  # type: ignore[arg-type]
    w = gear.length_of_roll(64.0)
    values = crowning(w, np.array([-10.0, 0.0, 10.0]), direction="transverse")
    np.testing.assert_allclose(values, [-20.0, 0.0, -20.0], atol=1e-12)
    cos = np.cos(np.radians(gear.base_helix_angle_deg()))
    np.testing.assert_allclose(crowning(w, 10.0), -20.0 * cos, rtol=1e-13)
    both = fw.Modification(
        [{"kind": "helix_crowning", "amount_um": 20}, {"kind": "helix_slope", "amount_um": 6}],
        gear,
        **field,  # type: ignore[arg-type]
    )
    assert both(w, 10.0) != pytest.approx(float(crowning(w, 10.0)))
    with pytest.raises(fw.BadInput):
        fw.Modification({"kind": "none"}, gear, **field)  # type: ignore[arg-type]


def test_the_forward_model_gives_the_planned_flank_and_its_sensitivities() -> None:
    job = fw.Job.load(EXAMPLES / "twist-free-crowning.toml").replace({"grid": {"profile_points": 9, "helix_points": 9}})
    forward, planned = fw.Forward(job), fw.preview(job)
    nominal = forward()
    for k, flank in enumerate(forward.flanks):
        np.testing.assert_allclose(nominal[k], planned.flanks[flank].planned, atol=1e-6)
        np.testing.assert_allclose(forward.w[k], planned.flanks[flank].w, atol=1e-12)
    # A deviation of the centre distance moves both flanks alike: to first order sin(alpha_n) of it.
    off = forward({"radial_feed_0_um": np.array([1.0, -1.0])})
    assert off.shape == (2, 2, 9, 9)
    moved = (off[0] - off[1]) / 2
    np.testing.assert_allclose(moved, moved.mean(), atol=0.02)
    assert moved.mean() == pytest.approx(np.sin(np.radians(17.5)), abs=0.01)
    # The same sample has the same bits alone and among others.
    many = forward({"radial_feed_0_um": np.full(50, 1.0), "crossing_angle_deg": np.linspace(0.0, 1e-3, 50)})
    np.testing.assert_array_equal(many[0], off[0])
    assert forward.to_xarray(many).dims == ("sample", "flank", "profile", "helix")
    with pytest.raises(fw.BadInput) as caught:
        forward({"none": 1.0})
    assert "radial_feed_0_um" in str(caught.value.allowed)
    with pytest.raises(fw.BadInput) as caught:
        forward({"radial_feed_0_um": np.array([0.0, np.nan])})
    assert caught.value.findings[0]["sample"] == 1
    with pytest.raises(fw.BadInput):
        fw.Forward(EXAMPLES / "gearbox/reference-train.toml")
