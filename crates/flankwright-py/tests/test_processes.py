"""Beside the interpreter: other processes, interruptions, what is not installed."""

import copy
import multiprocessing
import pickle
import subprocess
import sys
import threading
import time
from pathlib import Path

import flankwright as fw
import numpy as np
import pytest
from flankwright import sweep

EXAMPLES = Path(__file__).parents[3] / "examples"
DEVIATIONS = {"radial_feed_0_um": np.linspace(-1.0, 1.0, 20)}


@pytest.fixture(scope="module")
def forward() -> fw.Forward:
    return fw.Forward(EXAMPLES / "twist-free-crowning.toml", profile_points=5, helix_points=5)


def _ask(forward: fw.Forward, told: "multiprocessing.connection.Connection") -> None:
    told.send(forward(DEVIATIONS))


def test_a_forked_process_computes(forward: fw.Forward) -> None:
    here = forward(DEVIATIONS)
    fork = multiprocessing.get_context("fork")
    ours, theirs = fork.Pipe()
    child = fork.Process(target=_ask, args=(forward, theirs))
    child.start()
    assert ours.poll(60), "the child computes nothing"
    np.testing.assert_array_equal(ours.recv(), here)
    child.join()


def test_what_is_raised_ends_the_work(forward: fw.Forward) -> None:
    # Far more than a second of work.
    many = {"radial_feed_0_um": np.linspace(-1.0, 1.0, 200_000)}
    asked: list[float] = []

    def told(*_: object) -> None:
        asked.append(time.monotonic())
        if len(asked) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        forward(many, progress=told)
    assert time.monotonic() - asked[-1] < 10.0
    jobs = [fw.Job.load(EXAMPLES / "twist-free-crowning.toml")] * 400
    asked.clear()
    with pytest.raises(KeyboardInterrupt):
        fw.preview_many(jobs, progress=told)
    assert time.monotonic() - asked[-1] < 3.0


def test_python_goes_on_meanwhile(forward: fw.Forward) -> None:
    counted, ended = [0], threading.Event()

    def count() -> None:
        while not ended.is_set():
            counted[0] += 1
            time.sleep(1e-3)

    beside = threading.Thread(target=count)
    beside.start()
    forward({"radial_feed_0_um": np.linspace(-1.0, 1.0, 5000)})
    ended.set()
    beside.join()
    assert counted[0] > 20


def test_the_first_refused_sample_is_told(forward: fw.Forward) -> None:
    angles = np.zeros(400)
    angles[[37, 150, 390]] = 60.0
    for _ in range(5):
        with pytest.raises(fw.FlankwrightError) as caught:
            forward({"crossing_angle_deg": angles})
        assert caught.value.findings[0]["sample"] == 37
    flanks, refused = forward.each({"crossing_angle_deg": angles})
    assert sorted(refused) == [37, 150, 390] and np.isnan(flanks[[37, 150, 390]]).all()
    assert np.isfinite(np.delete(flanks, [37, 150, 390], axis=0)).all()


def test_bodies_go_to_other_processes() -> None:
    gear = fw.Gear(31, 2.5, (20.0, 22.0), 15.0, over_balls=(4.5, 87.9))
    worm = gear.worm(2, pitch_diameter=240.0)
    relief = fw.Modification({"kind": "helix_crowning", "amount_um": 20}, gear, start_diameter=76, end_diameter=84, z=(-15, 15))
    w = gear.length_of_roll(gear.pitch_diameter)
    for made in (pickle.loads(pickle.dumps(gear)), copy.deepcopy(gear)):
        assert made == gear and hash(made) == hash(gear) and made.profile_shift == gear.profile_shift
    assert (gear.teeth, gear.normal_module, gear.helix_angle_deg) == (31, 2.5, 15.0)
    again = pickle.loads(pickle.dumps(worm))
    np.testing.assert_array_equal(again.points(30.0, 1.0), worm.points(30.0, 1.0))
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(relief))(w, 10.0), relief(w, 10.0))


def test_a_job_finds_its_files_from_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(EXAMPLES)
    job = fw.Job.load("twist-free-crowning.toml")
    assert [path.name for path in job.files()] == ["eight-axis.toml"]
    kept = pickle.dumps(job)
    monkeypatch.chdir(tmp_path)
    again: fw.Job = pickle.loads(kept)
    assert [path.name for path in again.files()] == ["eight-axis.toml"]


WITHOUT = """
import sys
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("xarray", "matplotlib", "scipy", "pyarrow", "zarr", "tqdm", "distributed", "dask"):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
sys.meta_path.insert(0, Absent())
import flankwright as fw
from flankwright import sweep
job = fw.Job.template()
result = sweep.run(job, sweep.grid({"target.tolerance_um": [1.0]}), ["settings.diagonal_ratio"])
for ask in (lambda: fw.preview(job).flanks.to_xarray(), lambda: sweep.sobol({"a": (0, 1)}, 2), lambda: __import__("flankwright.plots"),
            lambda: sweep.run(job, result.samples, ["settings.diagonal_ratio"], folder=sys.argv[1])):
    try:
        ask()
    except ModuleNotFoundError as error:
        print(error)
"""


def test_what_is_not_installed_is_told(tmp_path: Path) -> None:
    asked = [sys.executable, "-c", WITHOUT, str(tmp_path / "sweep")]
    told = subprocess.run(asked, check=True, capture_output=True, text=True).stdout.splitlines()
    assert told == [
        "this needs xarray: pip install 'flankwright[arrays]'",
        "this needs scipy: pip install 'flankwright[sweep]'",
        "this needs matplotlib: pip install 'flankwright[plots]'",
        "this needs pyarrow: pip install 'flankwright[sweep]'",
    ]
    assert not (tmp_path / "sweep").exists()


def test_words_that_are_none_are_refused() -> None:
    gear = fw.Gear(31, 2.5, 20.0, 15.0)
    with pytest.raises(fw.BadInput, match="allowed: right, left"):
        gear.worm(2, pitch_diameter=240.0, hand="Right")  # type: ignore[arg-type]
    field = {"start_diameter": 76.0, "end_diameter": 84.0, "z": (-15.0, 15.0)}
    crowning = fw.Modification({"kind": "helix_crowning", "amount_um": 20}, gear, **field)  # type: ignore[arg-type]
    with pytest.raises(fw.BadInput, match="allowed: normal, transverse"):
        crowning(20.0, 0.0, direction="Normal")  # type: ignore[arg-type]
    with pytest.raises(fw.BadInput, match="no entry is for this flank"):
        fw.Modification({"kind": "helix_crowning", "amount_um": 20, "flank": "right"}, gear, **field)  # type: ignore[arg-type]
    with pytest.raises(fw.BadInput, match="amount_um"):
        fw.Modification({"kind": "helix_crowning", "amount_um": float("nan")}, gear, **field)  # type: ignore[arg-type]
    with pytest.raises(fw.BadInput, match="field: target.tolerance_um"):
        fw.Job.template().replace({"target.tolerance_um": float("inf")})
    with pytest.raises(TypeError, match="statements"):
        fw.inspect(job=fw.Job.template(), slope_signs=(1, 1))
    with pytest.raises(ValueError, match="errors="):
        fw.plan_many([], errors="none")  # type: ignore[call-overload]
    results = fw.preview_many([fw.Job.template(), "nowhere.toml"], errors="return")
    assert isinstance(results[0], fw.Preview) and isinstance(results[1], fw.BadInput)
    assert sweep.table({"x": [1, "auto"]})[0:2] == [{"x": 1}, {"x": "auto"}]
    whole = sweep.sobol({"x": (1, 3), "y": (0.0, 1.0)}, 64, whole=["x"])
    assert set(whole.columns["x"].tolist()) == {1, 2, 3} and whole.columns["x"].dtype.kind == "i"
