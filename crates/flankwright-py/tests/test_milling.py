"""A milled space asked directly, beside the plan with its referee."""

import pickle
from pathlib import Path

import flankwright as fw
import numpy as np
import pytest

JOB = Path(__file__).parents[3] / "examples/milling/spur-module-8.toml"


@pytest.fixture(scope="module")
def milling() -> fw.Milling:
    return fw.Milling(JOB)


def test_the_cutter_touches_what_it_mills(milling: fw.Milling) -> None:
    for flank in milling.flanks:
        rows = milling.rows(flank)
        face = ~rows["beside_face"].values
        assert face.any()
        points = milling.points(rows["height"], rows["length"], flank)
        np.testing.assert_allclose(points, rows["contact"], atol=1e-9)
        np.testing.assert_allclose(milling.normals(rows["height"], rows["length"], flank), rows["normal"], atol=1e-9)
        # From the tip up the axis and out to the contact, perpendicular to the axis.
        arm = (rows["contact"] - rows["tip"]).values
        axis = rows["axis"].values
        up = np.einsum("ijk,ijk->ij", arm, axis)
        np.testing.assert_allclose(up, rows["contact_height"], atol=1e-9)
        out = np.linalg.norm(arm - up[..., None] * axis, axis=-1)
        np.testing.assert_allclose(out, rows["contact_radius"], atol=1e-9)
        assert (np.einsum("ijk,ijk->ij", arm, rows["normal"].values) < 0).all(), "the cutter stands outside the material"


def test_rows_leave_what_the_plan_says_and_the_referee_finds(milling: fw.Milling) -> None:
    result = fw.plan(JOB).document
    for flank in milling.flanks:
        of_plan = result["flanks"][flank]
        left = milling.leaves(of_plan["height"], of_plan["length"], flank)
        stock = (left["scallop"] + left["chord"]).values
        planned = np.array(of_plan["planned_um"], dtype=float).reshape(stock.shape)
        np.testing.assert_allclose(stock, planned, atol=1e-9, equal_nan=True)
        found = np.array(of_plan["simulated_um"], dtype=float).reshape(stock.shape)
        assert np.nanmax(np.abs(stock - found)) < 0.05  # um


def test_paths_are_those_of_the_rows(milling: fw.Milling) -> None:
    paths = milling.paths()
    assert all(path.tip.shape == path.axis.shape and path.tip.shape[1] == 3 for path in paths)
    for flank in milling.flanks:
        rows = milling.rows(flank)
        tips = rows["tip"].values.reshape(-1, 3)
        mine = [path for path in paths if path.operation == f"{flank} flank"]
        assert len(mine) == rows.sizes["row"]
        # Every place of the rows is on the way of the cutter.
        ways = np.concatenate([path.tip for path in mine])
        missing = [tip for tip in tips if np.linalg.norm(ways - tip, axis=1).min() > 1e-9]
        assert not missing


def test_what_is_wrong_is_told(milling: fw.Milling) -> None:
    with pytest.raises(fw.BadInput, match="allowed: left, right"):
        milling.rows("middle")
    with pytest.raises(fw.BadInput, match="five-axis-milling"):
        fw.Milling(JOB.parents[1] / "twist-free-crowning.toml")
    again: fw.Milling = pickle.loads(pickle.dumps(milling))
    np.testing.assert_array_equal(again.rows("left")["tip"], milling.rows("left")["tip"])
