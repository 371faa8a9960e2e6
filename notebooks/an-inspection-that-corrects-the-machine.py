# %% [markdown]
# # Measure, explain, correct, measure again
#
# A machine is not what it should be: its radial feed is tapered and bent, the workpiece's angle runs off, crossing angle and dressing axes are off a
# little. Gears come out of it, are measured with some noise, and every tooth differs a little from the others. Which part of the deviation do all
# teeth share, which settings remove it, and what is left then? The example injects these deviations, so that what is found can be compared with
# what was put in.

# %%
import flankwright as fw
import matplotlib.pyplot as plt
import numpy as np
from flankwright import plots

job = fw.Job.load("../examples/inspection/closed-loop.toml")
job["inspection.simulated"]

# %%
found = fw.inspect(job=job)
rounds = found.document["rounds"]
found

# %% [markdown]
# ## What was measured before and after the correction

# %%
figure, axes = plt.subplots(2, len(rounds), figsize=(4.6 * len(rounds), 6.4), layout="constrained", squeeze=False)
largest = max(np.abs(np.array(of["measured_um"]) - of["target_um"]).max() for of in rounds[0]["flanks"].values())
levels = np.linspace(-largest, largest, 13)
for column, one in enumerate(rounds):
    for row, (name, flank) in enumerate(one["flanks"].items()):
        ax = axes[row][column]
        deviation = np.array(flank["measured_um"]) - flank["target_um"]
        filled = ax.contourf(flank["z_mm"], flank["w_mm"], np.clip(deviation, -largest, largest), levels=levels, cmap=plots.COLOURS)
        rms = np.sqrt(np.mean(deviation**2))
        ax.set(title=f"round {one['round']}, {name} flank: rms {rms:.2f} µm", xlabel="z [mm]", ylabel="w [mm]")
figure.colorbar(filled, ax=axes, label="measured less target, normal [µm]")
figure.suptitle("Mean of the teeth, as a surface through the measured lines")
plt.show()

# %% [markdown]
# ## Which part all teeth share
#
# A characteristic is corrected only if the teeth share it beyond chance; what goes around the gear once (run-out) is no fault of the settings.

# %%
for of in rounds[0]["characteristics"]:
    print(f"{of['flank'] or '':6s}{of['characteristic']:6s} {of['common_um']:+7.3f} ± {of['uncertainty_um']:.3f} µm   {of['decision']}")

# %% [markdown]
# ## What the referee says that the correction leaves
#
# Nothing is recommended that rays of the corrected machine do not confirm.

# %%
proof = rounds[0]["correction"]["proof"]
for name, of in proof.items():
    print(f"{name}: rms {of['before']['rms_um']:.2f} -> {of['after']['rms_um']:.2f} µm, largest {of['before']['largest_um']:.2f} -> {of['after']['largest_um']:.2f} µm")

# %%
assert found.met
assert all(of["after"]["rms_um"] < 0.5 * of["before"]["rms_um"] for of in proof.values())
