"""Jobs: made, changed, refused, kept."""

import pickle
from pathlib import Path

import flankwright as fw
import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[3] / "examples"


def test_a_job_is_read_and_tells_what_follows() -> None:
    job = fw.Job.load(EXAMPLES / "twist-free-crowning.toml")
    assert (job.name, job.process) == ("twist-free-crowning", "generating-grinding")
    assert job["gear.teeth"] == 19 and job["target.modifications[0].amount_um"] == 20.0
    derived = job.check()
    assert derived["pitch_diameter_mm"].unit == "mm" if "pitch_diameter_mm" in derived else len(derived) > 10
    assert "<table>" in derived._repr_html_() and "twist-free-crowning" in job._repr_html_()


def test_entries_are_set_and_taken_out() -> None:
    job = fw.Job.load(EXAMPLES / "twist-free-crowning.toml")
    other = job.replace({"gear.teeth": np.int64(23), "target.modifications[1]": None}, target__tolerance_um=np.float64(2.5))
    assert (other["gear.teeth"], other["target.tolerance_um"], len(other["target.modifications"])) == (23, 2.5, 1)
    assert job["gear.teeth"] == 19, "the first one stays"
    longer = other.replace({"target.modifications[1]": {"kind": "profile_crowning", "amount_um": 4.0}})
    assert longer["target.modifications[1].kind"] == "profile_crowning"
    for path in ("gear..teeth", "gear.teeth[0].x", "target.modifications[7].amount_um", "", "[x]"):
        with pytest.raises(KeyError):
            job.replace({path: 1})
    with pytest.raises(KeyError):
        job["gear.none"]


def test_what_is_wrong_is_told_with_its_place() -> None:
    text = (EXAMPLES / "twist-free-crowning.toml").read_text().replace("teeth = 19", "teeth = 0")
    with pytest.raises(fw.BadInput) as caught:
        fw.Job.parse(text)
    error = caught.value
    assert isinstance(error, ValueError) and (error.field, error.exit_status) == ("gear.teeth", 2)
    assert error.way_out and error.allowed and error.findings[0]["line"] > 1
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.code) == (str(error), error.code)
    with pytest.raises(fw.BadInput, match="does not exist"):
        fw.Job.load("none.toml")
    with pytest.raises(fw.BadInput) as caught:
        fw.Job.template("hobbing")
    assert "generating-grinding" in str(caught.value.allowed)


def test_a_job_goes_through_a_pickle() -> None:
    job = fw.Job.load(EXAMPLES / "catalogue.toml")
    again = pickle.loads(pickle.dumps(job))
    assert again == job and hash(again) == hash(job) and again.source == job.source


def test_the_schema_knows_all_tables() -> None:
    assert "$defs" in fw.schema() or "oneOf" in fw.schema()


def test_a_process_that_the_registry_got_is_there_too(tmp_path: Path) -> None:
    assert "tip-chamfering" in str(fw.schema())
    job = fw.Job.template("tip-chamfering")
    assert (job.process, job["chamfer.width"]) == ("tip-chamfering", 0.3)
    result = fw.plan(job)
    result.write(tmp_path / "out")
    assert result.status == "met" and "The chamfers leave a tip land" in (tmp_path / "out" / "report.html").read_text()
    assert fw.plan(job.replace({"chamfer.width": 2.0})).status == "missed"
