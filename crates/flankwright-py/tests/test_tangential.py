"""Tangential dressing against the reference numbers of the specification."""

import json
import pickle
from pathlib import Path
from typing import Any

import flankwright as fw
import numpy as np
import pytest

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def reference() -> Any:
    return json.loads((ROOT / "tests/reference/40-tdm.json").read_text())


@pytest.fixture(scope="module")
def model() -> fw.TangentialModel:
    return fw.TangentialModel(ROOT / "examples/tangential/example-1.toml", points=5, equidistant_radii=True)


def test_the_grid_is_that_of_the_source(model: fw.TangentialModel, reference: Any) -> None:
    np.testing.assert_allclose(model.radii, reference["grid"]["R"], rtol=1e-12)
    np.testing.assert_allclose(model.z, reference["grid"]["Z"], atol=1e-12)
    assert np.abs(model()).max() < 1e-9, "without variables the flank is the involute"


def test_sensitivities_are_those_of_the_reference(model: fw.TangentialModel, reference: Any) -> None:
    wanted = reference["right"]["sensitivity_per_mm_or_rad"]
    found = model.sensitivities(list(wanted))
    # A part of the largest value, as the reference file has it.
    for name, values in wanted.items():
        values = np.array(values)
        largest = np.abs(values).max()
        np.testing.assert_allclose(
            found[name] * 1e-3, values, atol=reference["tolerance"]["sensitivity_rel_of_max"] * max(largest, 1e-3), err_msg=name
        )
    # And they are the slopes of the flank itself.
    off = model({"Fz2": np.array([1e-4, -1e-4])})
    np.testing.assert_allclose((off[0] - off[1]) / 2e-4, found["Fz2"], atol=1e-4 * np.abs(found["Fz2"]).max())


def test_table_3_is_reproduced(model: fw.TangentialModel, reference: Any) -> None:
    linear = reference["right"]["table3_linear_um"]
    names = {key: key.split("_")[1] for key in linear}
    slopes = model.sensitivities(list(names.values()))
    for key, name in names.items():
        np.testing.assert_allclose(-0.05 * slopes[name], linear[key], atol=reference["tolerance"]["table3_um"], err_msg=key)


def test_what_is_wrong_is_told(model: fw.TangentialModel) -> None:
    with pytest.raises(fw.BadInput) as caught:
        model({"Fq2": 0.1})
    assert "Fz" in str(caught.value.allowed)
    with pytest.raises(fw.BadInput):
        fw.TangentialModel(ROOT / "examples/twist-free-crowning.toml")
    with pytest.raises(fw.BadInput, match="not ground"):
        fw.TangentialModel(ROOT / "examples/tangential/example-1.toml", "left")
    with pytest.raises(fw.NotProducible) as failed:
        model({"Fp3": np.array([0.0, -0.5])})
    assert failed.value.code in ("undercut", "contact-not-found", "outside-tool") and failed.value.findings[0]["sample"] == 1
    again = pickle.loads(pickle.dumps(model))
    np.testing.assert_array_equal(again({"Fz2": 0.01}), model({"Fz2": 0.01}))
    assert fw.TangentialModel.channels()["Fz"] == ("tangential shift of the dresser", "mm")
