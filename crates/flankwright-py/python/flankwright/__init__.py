"""Gear teeth: which flank is wanted, what every machine axis must do for it, and what comes out.

>>> import flankwright as fw
>>> job = fw.Job.template("generating-grinding")
>>> result = fw.plan(job)
>>> result.status
'met'

Lengths are mm, angles degrees where a name ends in ``_deg``, deviations um and normal to the flank, positive = material left, unless a name says
otherwise.
"""

from . import sweep
from ._blank import BlankStock, FlankStock, blank_stock
from ._bodies import Gear, Modification, Worm
from ._core import VERSION as __version__
from ._dressing import DressedWorm, Dresser, Meridian
from ._errors import BadInput, FlankwrightError, InternalError, NotProducible
from ._forward import Forward
from ._gearbox import Gearbox, Pulses
from ._jobs import Derived, Job, Quantity, Remark, schema
from ._measuring import Evaluation, ToolMeasurement, Tracks
from ._milling import CutterPath, Milling
from ._results import Flanks, FlankValues, Result
from ._tangential import TangentialModel
from ._tasks import (
    Preview,
    explore,
    inspect,
    plan,
    plan_many,
    preview,
    preview_many,
    simulate,
    simulate_many,
    verify,
)

__all__ = [
    "BadInput",
    "BlankStock",
    "CutterPath",
    "Derived",
    "DressedWorm",
    "Dresser",
    "Evaluation",
    "FlankStock",
    "FlankValues",
    "Flanks",
    "FlankwrightError",
    "Forward",
    "Gear",
    "Gearbox",
    "InternalError",
    "Job",
    "Meridian",
    "Milling",
    "Modification",
    "NotProducible",
    "Preview",
    "Pulses",
    "Quantity",
    "Remark",
    "Result",
    "TangentialModel",
    "ToolMeasurement",
    "Tracks",
    "Worm",
    "__version__",
    "blank_stock",
    "explore",
    "inspect",
    "plan",
    "plan_many",
    "preview",
    "preview_many",
    "schema",
    "simulate",
    "simulate_many",
    "sweep",
    "verify",
]
