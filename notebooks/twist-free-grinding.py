# %% [markdown]
# # Crowning without twist
#
# A helical gear is crowned by moving the worm towards it and away again while it feeds along the face. Along the face the flank becomes what was
# wanted. Across it, it is twisted: the contact lines of worm and gear lie slantwise on the flank, so that one position of the worm grinds points of
# different heights and different axial positions at the same time.

# %%
import flankwright as fw
import matplotlib.pyplot as plt
import numpy as np
from flankwright import plots

conventional = fw.plan("../examples/radial-feed-crowning.toml")
conventional

# %% [markdown]
# What the referee found, rays of the gear shortened by the worm, for a helix crowning of 20 µm by the radial feed alone:

# %%
plots.net(conventional)

# %%
plots.contour(conventional, "simulated")

# %%
flank = conventional.document["flanks"]["left"]
twist = flank["simulated_characteristics"]
{key: round(value, 3) for key, value in twist.items() if isinstance(value, float)}

# %% [markdown]
# ## The diagonal ratio
#
# The worm can shift along its own axis while it feeds, by the diagonal ratio $K = z_{V1}/z_{V2}$. Then each place of the worm meets its own place of
# the gear, and what is dressed into the worm along its width comes out along the face of the gear. Lines of the worm become lines of the flank, and
# their direction depends on $K$: for cylinders
#
# $$K = -\frac{\cos\beta_{b1}}{\cos\beta_{b2}}\,\frac{\tan\rho_1 - s\tan\beta_{b1}}{\tan\rho_2 - s\tan\beta_{b2}}.$$
#
# A worm whose modification needs no part that is linear in the roll length is dressed most easily; that is the ratio which the plan chooses.

# %%
job = fw.Job.load("../examples/twist-free-crowning.toml")
free = fw.plan(job)
free

# %%
plots.net(free)

# %%
plots.diagrams(free)

# %% [markdown]
# The deviation from the target is a few nanometres on this scale; it is what the dressed worm leaves, not what the formulas leave out.

# %%
plots.contour(free, "deviation")

# %% [markdown]
# ## Which ratios would do
#
# The same job over the diagonal ratio: what is left of the target, planned without the referee. Ratios that these bodies cannot run are refused,
# each with its code.

# %%
ratios = np.concatenate([np.linspace(-2.4, -0.4, 21), np.linspace(0.4, 1.4, 11)])
samples = fw.sweep.grid({"grinding.diagonal_ratio": ratios})
swept = fw.sweep.run(
    job,
    samples,
    {"off": "flanks.left.max_deviation_um", "length": "settings.worm_length_mm"},
    progress=False,
)
codes, counts = np.unique(swept["error"], return_counts=True)
dict(zip(codes.tolist(), counts.tolist()))

# %%
figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(7, 5), layout="constrained")
above.semilogy(ratios, swept["off"], "k.")
above.set(ylabel="largest deviation [µm]", title="Helix crowning 20 µm without twist, over the diagonal ratio")
below.plot(ratios, swept["length"], "k.")
below.set(xlabel="diagonal ratio K", ylabel="worm length used [mm]")
for ax in (above, below):
    ax.axvline(free.settings["diagonal_ratio"], color="0.6", linestyle="--", label="chosen")
    ax.grid(True, color="0.85")
above.legend()
plt.show()

# %%
# What is told here has to be so.
assert free.met and np.abs(free.left.deviation).max() < 0.05
assert abs(twist["twist_corner_um"]) > 20.0
