"""Sweeps: samples, outputs, folders that go on where they were, a cluster of processes."""

import functools
import os
import signal
import threading
import time
from pathlib import Path
from typing import Any, Literal

import flankwright as fw
import numpy as np
import pytest
from flankwright import sweep

EXAMPLES = Path(__file__).parents[3] / "examples"
OUTPUTS: dict[str, sweep.Output] = {
    "ratio": "settings.diagonal_ratio",
    "off": "flanks.left.max_deviation_um",
    "planned": lambda preview: preview.flanks["left"].planned,
}
# How often a sample was looked at: no part of what an output computes.
CALLS: list[int] = []
NUMBERS: dict[str, sweep.Output] = {name: OUTPUTS[name] for name in ("ratio", "off")}


@pytest.fixture(scope="module")
def job() -> fw.Job:
    return fw.Job.load(EXAMPLES / "twist-free-crowning.toml").replace({"grid": {"profile_points": 5, "helix_points": 5}})


@pytest.fixture(scope="module")
def samples() -> sweep.Samples:
    return sweep.grid({"target.modifications[0].amount_um": [5.0, 10.0, 15.0], "worm.threads": [1, 2]})


def same(one: dict[str, Any], other: dict[str, Any]) -> None:
    assert one.keys() == other.keys()
    for name in one:
        np.testing.assert_array_equal(one[name], other[name], err_msg=name)


def test_samples_are_what_they_say() -> None:
    assert sweep.grid({"a": [1, 2], "b": [1.0, 2.0, 3.0]}).columns["b"].tolist() == [1.0, 2.0, 3.0] * 2
    for made in (sweep.sobol, sweep.latin_hypercube):
        points = made({"a": (0.0, 2.0), "b": (-1.0, 1.0)}, 64, seed=3)
        assert len(points) == 64 and points.digest() == made({"a": (0.0, 2.0), "b": (-1.0, 1.0)}, 64, seed=3).digest()
        assert points.columns["a"].min() >= 0.0 and abs(points.columns["a"].mean() - 1.0) < 0.1
        assert points.digest() != made({"a": (0.0, 2.0), "b": (-1.0, 1.0)}, 64, seed=4).digest()
    assert len(sweep.table({"a": ["x", "y"]})) == 2
    for wrong in ({}, {"a": [1.0], "b": [1.0, 2.0]}, {"a": [np.nan]}, {"a": [1j]}):
        with pytest.raises(ValueError):
            sweep.table(wrong)
    with pytest.raises(ValueError):
        sweep.sobol({"a": (1.0, 0.0)}, 4)


def test_a_sweep_has_the_numbers_of_each_job(job: fw.Job, samples: sweep.Samples) -> None:
    found = sweep.run(job, samples, OUTPUTS, progress=False)
    assert found["planned"].shape == (6, 5, 5) and (found["error"] == "").all()
    for k, change in enumerate(samples[0:6]):
        alone = fw.preview(job.replace(change))
        assert found["ratio"][k] == alone.settings["diagonal_ratio"]
        np.testing.assert_array_equal(found["planned"][k], alone.flanks["left"].planned)
    labelled = found.to_xarray()
    assert labelled["ratio"].dims == ("target.modifications[0].amount_um", "worm.threads")
    np.testing.assert_array_equal(labelled["planned"].sel({"worm.threads": 2})[1], found["planned"][3])


def test_refused_samples_stay_with_their_code(job: fw.Job) -> None:
    found = sweep.run(job, sweep.table({"worm.threads": [1, 0, 2]}), NUMBERS, progress=False)
    assert found["error"].tolist() == ["", "invalid-number", ""] and np.isnan(found["ratio"][1])


@pytest.mark.parametrize("form", ["parquet", "zarr", None])
def test_a_chunk_in_which_all_are_refused(job: fw.Job, form: Literal["parquet", "zarr"] | None, tmp_path: Path) -> None:
    wanted = NUMBERS if form == "parquet" else OUTPUTS
    kept: dict[str, Any] = {} if form is None else {"folder": tmp_path / "x", "form": form}
    found = sweep.run(job, sweep.table({"worm.threads": [0, 0, 1, 2]}), wanted, chunk=2, progress=False, **kept)
    assert found["error"].tolist() == ["invalid-number"] * 2 + [""] * 2
    for name in wanted:
        assert np.isnan(found[name][:2]).all() and np.isfinite(found[name][2:]).all()
    none = sweep.run(job, sweep.table({"worm.threads": [0]}), wanted, progress=False)
    assert all(np.isnan(none[name]).all() for name in wanted)


@pytest.mark.parametrize("form", ["parquet", "zarr"])
def test_a_finished_chunk_is_never_computed_again(
    job: fw.Job, samples: sweep.Samples, tmp_path: Path, form: Any
) -> None:
    outputs = NUMBERS if form == "parquet" else OUTPUTS
    whole = sweep.run(job, samples, outputs, progress=False)
    calls = CALLS
    calls.clear()

    def counted(preview: fw.Preview) -> float:
        CALLS.append(1)
        if len(CALLS) == 4:
            raise KeyboardInterrupt
        return float(preview.settings["diagonal_ratio"])

    wanted: dict[str, sweep.Output] = {**outputs, "counted": counted}
    folder = tmp_path / "sweep"
    with pytest.raises(KeyboardInterrupt):
        sweep.run(job, samples, wanted, folder=folder, form=form, chunk=2, progress=False)
    assert len(sweep.load(folder)["ratio"]) == 2, "the chunk that was finished"
    found = sweep.run(job, samples, wanted, folder=folder, form=form, chunk=2, progress=False)
    # Two of the first chunk, two until the interruption, four of the rest.
    assert len(calls) == 2 + 2 + 4
    for name in outputs:
        np.testing.assert_array_equal(found[name], whole[name])
    there = sweep.load(folder)
    assert there.pop("sample").tolist() == list(range(6))
    same(there, found.columns)
    sweep.run(job, samples, wanted, folder=folder, form=form, chunk=2, progress=False)
    assert len(calls) == 8
    assert not [path for path in folder.rglob("*.part")]
    with pytest.raises(ValueError, match="another sweep"):
        sweep.run(job.replace({"target.tolerance_um": 3.0}), samples, wanted, folder=folder, form=form, chunk=2, progress=False)


def test_parquet_keeps_no_arrays(job: fw.Job, samples: sweep.Samples, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="Zarr keeps arrays"):
        sweep.run(job, samples, OUTPUTS, folder=tmp_path / "x", progress=False)


def test_a_forward_model_is_swept(job: fw.Job) -> None:
    forward = fw.Forward(job, profile_points=5, helix_points=5)
    samples = sweep.latin_hypercube({"radial_feed_0_um": (-2.0, 2.0), "crossing_angle_deg": (-1e-3, 1e-3)}, 40)
    found = sweep.run(forward, samples, {"largest": lambda flanks: np.abs(flanks).max()}, chunk=16, progress=False)
    whole = forward(samples.columns)
    np.testing.assert_array_equal(found["largest"], np.abs(whole).max(axis=(1, 2, 3)))
    # One that cannot be ground does not take the others with it.
    angles = np.append(samples.columns["crossing_angle_deg"][:4], 60.0)
    beside = sweep.run(forward, sweep.table({"crossing_angle_deg": angles}), {"first": lambda flanks: flanks[0]}, progress=False)
    assert (beside["error"][:4] == "").all() and beside["error"][4] != ""
    np.testing.assert_array_equal(beside["first"][:4], forward({"crossing_angle_deg": angles[:4]})[:, 0])
    assert np.isnan(beside["first"][4]).all()


def test_a_cluster_of_processes_gives_the_same_bits_though_a_worker_dies(
    job: fw.Job, samples: sweep.Samples, tmp_path: Path
) -> None:
    from distributed import Client, LocalCluster

    wide = sweep.grid({"target.modifications[0].amount_um": np.linspace(4.0, 20.0, 60), "worm.threads": [1, 2]})
    here = sweep.run(job, wide, OUTPUTS, chunk=8, progress=False)
    with (
        LocalCluster(  # type: ignore[no-untyped-call]
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
        Client(cluster) as client,  # type: ignore[no-untyped-call]
    ):
        killed: list[int] = []

        def first_dies() -> None:
            # As soon as one chunk is finished, and while others are not.
            while not list((tmp_path / "z").glob("chunks/*.done")):
                time.sleep(0.01)
            pid = next(iter(client.run(os.getpid).values()))
            os.kill(pid, signal.SIGKILL)
            killed.append(len(list((tmp_path / "z").glob("chunks/*.done"))))

        timer = threading.Thread(target=first_dies)
        timer.start()
        there = sweep.run(
            job, wide, OUTPUTS, folder=tmp_path / "z", form="zarr", chunk=8, client=client, progress=False
        )
        timer.join()
        assert killed[0] < 15, "the sweep was over before a worker was killed"
    same(there.columns, here.columns)


def test_what_a_folder_holds_is_known_again(job: fw.Job, tmp_path: Path) -> None:
    def output(factor: float) -> dict[str, sweep.Output]:
        return {"x": lambda preview: factor * preview.settings["diagonal_ratio"]}

    one = sweep.table({"target.tolerance_um": [1.0, 2.0]})
    first = sweep.run(job, one, output(1.0), folder=tmp_path / "x", progress=False)
    again = sweep.run(job, one, output(1.0), folder=tmp_path / "x", progress=False)
    same(first.columns, again.columns)
    with pytest.raises(ValueError, match="differs in outputs"):
        sweep.run(job, one, output(1000.0), folder=tmp_path / "x", progress=False)
    with pytest.raises(ValueError, match="cannot be known again"):
        sweep.run(job, one, {"x": functools.partial(max, threading.Lock())}, folder=tmp_path / "y", progress=False)
    # A machine that was changed in the meantime makes another sweep.
    text = (EXAMPLES.parent / "machines/eight-axis.toml").read_text()
    (tmp_path / "machine.toml").write_text(text)
    own = fw.Job.parse(job.text, tmp_path).replace({"machine.file": "machine.toml"})
    sweep.run(own, one, NUMBERS, folder=tmp_path / "z", progress=False)
    (tmp_path / "machine.toml").write_text(text + "\n")
    with pytest.raises(ValueError, match="differs in files"):
        sweep.run(own, one, NUMBERS, folder=tmp_path / "z", progress=False)


@pytest.mark.parametrize("form", ["zarr", None])
def test_outputs_of_several_shapes_are_refused(job: fw.Job, form: Any, tmp_path: Path) -> None:
    kept: dict[str, Any] = {} if form is None else {"folder": tmp_path / "x", "form": form}
    grids = sweep.table({"grid.profile_points": [5, 7]})
    with pytest.raises(ValueError, match="shape"):
        sweep.run(job, grids, OUTPUTS, chunk=1, progress=False, **kept)


def test_what_cannot_be_carried_out_leaves_no_folder(job: fw.Job, samples: sweep.Samples, tmp_path: Path) -> None:
    folder = tmp_path / "x"
    wrong: dict[str, Any]
    for wrong in ({"task": "explore"}, {"form": "csv"}, {"chunk": 0}):
        with pytest.raises(ValueError):
            sweep.run(job, samples, NUMBERS, folder=folder, progress=False, **wrong)
    with pytest.raises(fw.BadInput, match="unknown-key"):
        sweep.run(job, sweep.table({"target.none": [1.0]}), NUMBERS, folder=folder, progress=False)
    with pytest.raises(fw.BadInput, match="allowed: radial_feed_0_um"):
        sweep.run(fw.Forward(job), sweep.table({"none": [1.0]}), {"x": np.max}, folder=folder, progress=False)
    assert not folder.exists()
    # A folder in which nothing is finished is taken over.
    with pytest.raises(ValueError, match="Zarr keeps arrays"):
        sweep.run(job, samples, OUTPUTS, folder=folder, progress=False)
    sweep.run(job, samples, NUMBERS, folder=folder, progress=False)
    # A file that is not there is no property of a sample.
    with pytest.raises(fw.BadInput, match="unreadable-file"):
        sweep.run(job.replace({"machine.file": "none.toml"}), samples, NUMBERS, task="plan", progress=False)
