"""Sweeps: any quantities of a job over grids, samples or tables, on this machine or on a Dask cluster.

>>> import flankwright as fw
>>> job = fw.Job.template("generating-grinding")
>>> samples = fw.sweep.grid({"target.tolerance_um": [1.0, 2.0]})
>>> found = fw.sweep.run(job, samples, {"ratio": "settings.diagonal_ratio"}, progress=False)
>>> found.columns["ratio"].shape
(2,)

A sweep is worked off in chunks of samples. With a folder, every finished chunk is on the disk: begun again, the sweep goes on where it was, and
no finished chunk is computed again. The numbers are the same wherever it runs.
"""

from ._outputs import Output, Outputs
from ._run import Swept, load, run
from ._samples import Samples, grid, latin_hypercube, sobol, table

__all__ = ["Output", "Outputs", "Samples", "Swept", "grid", "latin_hypercube", "load", "run", "sobol", "table"]
