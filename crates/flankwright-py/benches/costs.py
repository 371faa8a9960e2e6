"""What the package costs over the library, and what a cluster costs over one process; all in one run.

    python benches/costs.py [PLANS] [FORWARD SAMPLES]

Prints the overhead of a call of ``plan`` over the library, the time of forward evaluations of 9 x 9 points on both flanks, the throughput of a sweep
of plans in this process and on a local Dask cluster of two workers of one core each, and how far memory grows with the number of samples and with the
size of a chunk.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import flankwright as fw
import numpy as np
from flankwright import sweep

JOB = Path(__file__).parents[3] / "examples/twist-free-crowning.toml"
OUTPUTS = {"ratio": "settings.diagonal_ratio", "off": "flanks.left.max_deviation_um"}
# What a worker may take more for a sweep sixteen times as long, MiB: samples and results, which are asked for whole, and what the allocator keeps.
GROWTH = 40


def swept_job() -> fw.Job:
    return fw.Job.load(JOB).replace({"grid": {"profile_points": 5, "helix_points": 5}})


def samples(count: int) -> sweep.Samples:
    bounds = {"target.modifications[0].amount_um": (5.0, 25.0), "worm.tip_diameter": (185.0, 215.0)}
    return sweep.latin_hypercube(bounds, count, seed=1)


def overhead() -> None:
    jobs = {"generating grinding": fw.Job.load(JOB), "electronic gearbox": fw.Job.template("electronic-gearbox")}
    for name, job in jobs.items():
        fw.plan(job)
        costs = []
        for _ in range(30):
            begun = time.perf_counter()
            result = fw.plan(job)
            costs.append(1e3 * (time.perf_counter() - begun - result.seconds))
        begun = time.perf_counter()
        result.document, result.flanks  # noqa: B018
        read = 1e3 * (time.perf_counter() - begun)
        print(
            f"plan, {name}: {statistics.median(costs):.3f} ms over the library's {1e3 * result.seconds:.1f} ms "
            f"(at most {max(costs):.3f} ms; limit 2 ms); reading document and flanks {read:.2f} ms"
        )


def forward(count: int) -> None:
    model = fw.Forward(fw.Job.load(JOB))
    random = np.random.default_rng(0)
    deviations = {name: random.normal(0.0, 1.0, count) for name in ("radial_feed_0_um", "radial_feed_1_um", "work_angle_1_arcsec")}
    begun = time.perf_counter()
    flanks = model(deviations)
    took = time.perf_counter() - begun
    print(f"{count} forward evaluations {flanks.shape[1:]}: {took:.1f} s on {os.cpu_count()} cores")


def cluster(count: int) -> None:
    from distributed import Client, LocalCluster

    job, points = swept_job(), samples(count)
    chunk = 128
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as local,
        Client(local) as client,
    ):
        # Both begin warm: modules are loaded, threads are there.
        sweep.run(job, samples(64), OUTPUTS, chunk=16, client=client, progress=False)
        begun = time.perf_counter()
        there = sweep.run(job, points, OUTPUTS, chunk=chunk, client=client, progress=False)
        on_cluster = time.perf_counter() - begun
    sweep.run(job, samples(64), OUTPUTS, progress=False)
    begun = time.perf_counter()
    here = sweep.run(job, points, OUTPUTS, chunk=chunk, progress=False)
    in_process = time.perf_counter() - begun
    if (here["error"] != "").any():
        raise SystemExit(f"refused: {np.unique(here['error'])}")
    same = all(np.array_equal(here[name], there[name], equal_nan=name != "error") for name in here.columns)
    print(
        f"{count} plans: {count / in_process:.1f} a second in this process, {count / on_cluster:.1f} on two workers: "
        f"{100 * in_process / on_cluster:.0f} % (limit 85); {'the same bits' if same else 'NOT THE SAME'}"
    )


def memory() -> None:
    """Peak memory of processes of their own."""
    taken = {}
    for count, chunk in ((256, 64), (4096, 64), (4096, 1024)):
        asked = [sys.executable, __file__, "--memory", str(count), str(chunk)]
        taken[count, chunk] = float(subprocess.run(asked, check=True, capture_output=True, text=True).stdout)
    for (count, chunk), peak in taken.items():
        print(f"{count} plans in chunks of {chunk}: at most {peak:.0f} MiB")
    if taken[4096, 64] - taken[256, 64] > GROWTH:
        raise SystemExit("memory grows with the number of samples")


def peak(count: int, chunk: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        outputs = {**OUTPUTS, "planned": lambda preview: preview.flanks["left"].planned}
        sweep.run(
            swept_job(), samples(count), outputs, folder=folder, form="zarr", chunk=chunk, progress=False, load=False
        )
    # Linux: the peak of this process alone; getrusage hands on that of the one that began it.
    told = Path("/proc/self/status").read_text(encoding="utf-8").split("VmHWM:")[1]
    print(int(told.split()[0]) / 1024)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--memory"]:
        peak(int(sys.argv[2]), int(sys.argv[3]))
    else:
        given = [int(word) for word in sys.argv[1:]]
        overhead()
        forward(given[1] if len(given) > 1 else 100_000)
        cluster(given[0] if given else 10_000)
        memory()
