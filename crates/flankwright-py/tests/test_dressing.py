"""The dresser asked directly."""

import pickle
from pathlib import Path

import flankwright as fw
import numpy as np
import pytest

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def dresser() -> fw.Dresser:
    return fw.Dresser(ROOT / "examples/twist-free-crowning.toml")


def test_in_its_nominal_position_it_leaves_the_involute(dresser: fw.Dresser) -> None:
    for flank in ("left", "right"):
        worm = dresser.dress(flank=flank)
        assert np.abs(worm.deviation).max() < 1e-6  # um
        # The circle that was designed for a length of roll dresses it.
        np.testing.assert_allclose(worm.parameter, np.linspace(*dresser.range(flank), 33), atol=1e-9)
        # What it touches with lies on its profile.
        np.testing.assert_allclose(dresser.meridian(worm.parameter, flank).radius, worm.dresser_radius, rtol=1e-12)


def test_the_meridian_has_its_normals_across(dresser: fw.Dresser) -> None:
    t = np.linspace(*dresser.range(), 401)
    at = dresser.meridian(t)
    np.testing.assert_allclose(np.hypot(*at.normal.T), 1.0, rtol=1e-12)
    # Chords of the profile stand on the normals between them, but for its curvature.
    chords = np.stack([at.radius[2:] - at.radius[:-2], at.position[2:] - at.position[:-2]], axis=1)
    off = np.einsum("ij,ij->i", chords, at.normal[1:-1]) / np.linalg.norm(chords, axis=1)
    assert np.abs(off).max() < 1e-6
    assert dresser.meridian(t[:, None]).normal.shape == (401, 1, 2)


def test_derivatives_are_those_of_the_flank(dresser: fw.Dresser) -> None:
    at = np.array([0.4, -0.3, 0.05, 0.4])
    steps = np.array([1e-3, 1e-3, 1e-4, 1e-4])
    by = dresser.sensitivities(at, "right")
    both = np.concatenate([at + np.diag(steps), at - np.diag(steps)])
    moved = dresser.dress(both, "right").deviation
    for k, name in enumerate(fw.Dresser.AXES):
        quotient = (moved[k] - moved[4 + k]) / (2 * steps[k])
        np.testing.assert_allclose(by[name], quotient, rtol=1e-5, atol=1e-5 * np.abs(quotient).max())


def test_three_points_by_name_and_one_by_one(dresser: fw.Dresser) -> None:
    first, last = dresser.range()
    wanted = [(first, 0.0), ((first + last) / 2, -8.0), (last, 0.0)]
    found = dresser.crowning(-8.0)
    for w, f_um in wanted:
        assert dresser.dress(found, w=[w]).deviation[0] == pytest.approx(f_um, abs=1e-6)
    by_hand = dresser.solve({"left": wanted}, radius_maps={"left": [(last, last)]}, start=found * 0.5)
    np.testing.assert_allclose(by_hand, found, atol=1e-7)
    held = {"d_gamma_deg": 0.2, "d_v_yA_mm": 1.0}
    ends = dresser.solve({"left": [wanted[0], wanted[2]]}, fixed=held)
    assert ends[1] == pytest.approx(0.2, abs=1e-12) and ends[3] == pytest.approx(1.0, abs=1e-12)
    np.testing.assert_allclose(dresser.dress(ends, w=[first, last]).deviation, 0.0, atol=1e-6)


def test_it_goes_to_other_processes(dresser: fw.Dresser) -> None:
    again = pickle.loads(pickle.dumps(dresser))
    correction = dict.fromkeys(["d_gamma_deg"], 0.2)
    np.testing.assert_array_equal(again.dress(correction).deviation, dresser.dress(correction).deviation)


def test_what_is_wrong_is_told(dresser: fw.Dresser) -> None:
    with pytest.raises(fw.BadInput, match="in the order d_phi_s_deg"):
        dresser.dress([1.0, 2.0])
    with pytest.raises(fw.BadInput, match="no axis 'gamma'"):
        dresser.dress({"gamma": 1.0})
    with pytest.raises(fw.BadInput, match="there is no flank"):
        dresser.range("top")  # type: ignore[arg-type]
    with pytest.raises(fw.BadInput, match="allowed: "):
        dresser.meridian(1e6)
    with pytest.raises(fw.BadInput, match="sample 1"):
        dresser.dress([[0.0, 0.0, 0.0, 0.0], [0.0, float("nan"), 0.0, 0.0]])
    with pytest.raises(fw.BadInput, match="condition"):
        dresser.solve({"left": [(dresser.range()[0], 0.0)]})
    with pytest.raises(fw.FlankwrightError, match="remedy"):
        dresser.crowning(5000.0)
    with pytest.raises(fw.BadInput, match="generating-grinding"):
        fw.Dresser(ROOT / "examples/gearbox/feed-to-and-fro.toml")
