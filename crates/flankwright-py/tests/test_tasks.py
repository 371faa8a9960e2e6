"""Tasks: the same numbers as the command, errors, batches."""

import json
import subprocess
import threading
import time
from pathlib import Path

import flankwright as fw
import numpy as np
import pytest

ROOT = Path(__file__).parents[3]
EXAMPLES = ROOT / "examples"
JOB = EXAMPLES / "twist-free-crowning.toml"


@pytest.fixture(scope="module")
def planned() -> fw.Result:
    return fw.plan(JOB)


def test_a_plan_is_that_of_the_command(planned: fw.Result, command: Path, tmp_path: Path) -> None:
    subprocess.run([command, "plan", "--quiet", JOB, "-o", tmp_path], check=True)
    told = json.loads((tmp_path / "result.json").read_text())
    for document in (told, own := json.loads(json.dumps(planned.document))):
        document.pop("timing_s")
    assert own == told
    left = planned.left
    np.testing.assert_array_equal(left.simulated, told["flanks"]["left"]["simulated_um"])
    assert left.target.shape == (left.w.size, left.z.size) and left.target.dtype == np.float64
    assert np.abs(left.deviation).max() == pytest.approx(told["flanks"]["left"]["max_deviation_um"], rel=1e-12)
    assert planned.met and planned.settings["diagonal_ratio"] == told["settings"]["diagonal_ratio"]
    assert "met" in repr(planned) and "<table>" in planned._repr_html_()


def test_files_are_those_of_the_command(planned: fw.Result, tmp_path: Path) -> None:
    written = planned.write(tmp_path / "out")
    assert written[-1].name == "report.html" and all(path.is_file() for path in written)
    simulated = fw.simulate(tmp_path / "out/settings.json")
    found, wanted = simulated.left.simulated, planned.left.simulated
    assert found is not None and wanted is not None
    np.testing.assert_allclose(found, wanted, atol=1e-3)


def test_every_process_is_planned() -> None:
    for example in ("gearbox/reference-train", "milling/blade-on-head-head", "skiving/worn-tool"):
        assert fw.plan(EXAMPLES / f"{example}.toml").document["process"]
    with pytest.raises(fw.BadInput) as caught:
        fw.simulate(EXAMPLES / "milling/blade-on-head-head.toml")
    assert caught.value.code == "process-not-available"


def test_what_cannot_be_made_is_told() -> None:
    job = fw.Job.load(JOB).replace({"target.modifications": [{"kind": "helix_crowning", "amount_um": 9000.0}]})
    with pytest.raises((fw.NotProducible, fw.BadInput)) as caught:
        fw.plan(job)
    assert caught.value.code and caught.value.way_out


def test_many_jobs_give_the_numbers_of_each() -> None:
    job = fw.Job.load(JOB)
    jobs = [job.replace({"target.modifications[0].amount_um": amount}) for amount in (5.0, 12.0, 30.0)]
    wrong = fw.Job.load(EXAMPLES / "gearbox/reference-train.toml")
    told: list[tuple[str, int, int]] = []
    found = fw.preview_many([*jobs, wrong], errors="return", progress=lambda *how: told.append(how))
    for one, alone in zip(found, jobs):
        assert isinstance(one, fw.Preview)
        np.testing.assert_array_equal(one.flanks["left"].planned, fw.preview(alone).flanks["left"].planned)
    assert isinstance(found[-1], fw.BadInput) and found[-1].code == "process-not-available"
    with pytest.raises(fw.BadInput):
        fw.preview_many([*jobs, wrong])
    assert told == [] or told[-1][0] == "jobs"
    with pytest.raises(ValueError, match="errors="):
        fw.preview_many(jobs, errors="none")  # type: ignore[call-overload]


def test_the_interpreter_goes_on_meanwhile() -> None:
    count = 0
    done = threading.Event()

    def others() -> None:
        nonlocal count
        while not done.is_set():
            count += 1
            time.sleep(0.001)

    thread = threading.Thread(target=others)
    thread.start()
    fw.plan(JOB)
    done.set()
    thread.join()
    assert count > 50, "the lock of the interpreter was held"


def test_a_listener_may_end_the_work() -> None:
    class Enough(Exception):
        pass

    def listener(stage: str, done: int, total: int) -> None:
        raise Enough(stage)

    with pytest.raises(Enough):
        fw.explore(EXAMPLES / "catalogue-free-diameter.toml", progress=listener)


@pytest.mark.parametrize("file", sorted((ROOT / "tests/reference").glob("*.json")), ids=lambda file: file.stem)
def test_references_are_verified_as_by_the_command(command: Path, file: Path) -> None:
    own = fw.verify(file)
    told = json.loads(subprocess.run([command, "verify", "--json", file], check=True, stdout=subprocess.PIPE).stdout)
    assert own == told and own["failed"] == 0 and own["files"][0]["checks"] > 0


def test_a_measurement_is_judged_by_its_job() -> None:
    result = fw.inspect(EXAMPLES / "inspection/measured.csv", job=EXAMPLES / "inspection/measured.toml")
    assert result.status == "missed"
    with pytest.raises(fw.BadInput):
        fw.inspect("none.mka")
    with pytest.raises(TypeError):
        fw.inspect()
