# %% [markdown]
# # What the axes may be off, over a worm's life
#
# A worm is dressed again and again and becomes smaller. Each time its lead angle, the crossing angle and the dressing motion follow from its new
# diameter. How much of the tolerance do the axes of the machine use up, at the beginning and at the end of its life?
#
# Five things are off at random: the crossing angle of worm and gear, taper and straightness of the radial feed, the crossing angle of the dresser
# and its offset. Each of 100 000 samples is the exact contact of a dressed worm and the gear on a grid of 9 x 9 points of both flanks.

# %%
import time

import flankwright as fw
import matplotlib.pyplot as plt
import numpy as np

job = fw.Job.load("../examples/twist-free-crowning.toml")
largest = job["worm.tip_diameter"]
diameters = np.linspace(largest, 0.82 * largest, 8)
forwards = [fw.Forward(job.replace({"worm.tip_diameter": d})) for d in diameters]

# %% [markdown]
# Standard deviations as a machine in good order has them:

# %%
OFF = {
    "crossing_angle_deg": 2e-4,
    "radial_feed_1_um": 0.5,
    "radial_feed_2_um": 0.3,
    "dressing_gamma_deg": 2e-4,
    "dressing_v_ya_um": 2.0,
}
COUNT = 100_000 // len(diameters)


def sampled(seed: int) -> dict[str, np.ndarray]:
    random = np.random.default_rng(seed)
    return {name: sigma * random.standard_normal(COUNT) for name, sigma in OFF.items()}


# %% [markdown]
# What an inspection sheet would say of each flank: slopes, crownings and twist as the least squares of a plane with its squares and its product.

# %%
x, y = np.meshgrid(np.linspace(-1, 1, 9), np.linspace(-1, 1, 9), indexing="ij")
terms = np.stack([np.ones_like(x), x, y, 1 - x**2, 1 - y**2, x * y], axis=-1).reshape(81, 6)
to_terms = np.linalg.pinv(terms)
SYMBOLS = {"fHα": 2.0, "fHβ": 2.0, "Cα": 1.0, "Cβ": 1.0, "twist": 4.0}


def characteristics(deviation: np.ndarray) -> dict[str, np.ndarray]:
    found = deviation.reshape(*deviation.shape[:2], 81) @ to_terms.T
    return {symbol: factor * found[..., k + 1] for k, (symbol, factor) in enumerate(SYMBOLS.items())}


# %%
begun = time.perf_counter()
scatter = []
for k, forward in enumerate(forwards):
    scatter.append({symbol: of.std(axis=0) for symbol, of in characteristics(forward.deviations(sampled(k))).items()})
elapsed = time.perf_counter() - begun
print(f"{COUNT * len(diameters)} pairs of flanks in {elapsed:.1f} s: {1e6 * elapsed / (COUNT * len(diameters)):.0f} µs each")

# %%
figure, ax = plt.subplots(figsize=(7.5, 4.5), layout="constrained")
for symbol, style in zip(SYMBOLS, ["o-", "s--", "^-.", "d:", "x-"]):
    ax.plot(diameters, [3 * of[symbol][0] for of in scatter], style, color="black", markersize=4, label=f"{symbol}, left flank")
ax.set(
    title="Three standard deviations of what is ground, over the worm's diameter",
    xlabel="tip diameter of the worm [mm]",
    ylabel="3 σ [µm]",
)
ax.invert_xaxis()
ax.grid(True, color="0.85")
ax.legend()
plt.show()

# %% [markdown]
# Which axis matters: the flank is linear in small deviations, so that one unit of each tells its share.

# %%
shares = {}
for name, sigma in OFF.items():
    one = forwards[0]({name: np.array([0.0, sigma])})
    shares[name] = {symbol: float(abs(of[0, 0])) for symbol, of in characteristics((one[1] - one[0])[None]).items()}
for name, of in shares.items():
    print(f"{name:22s}" + "".join(f"{symbol:>8s} {value:6.3f}" for symbol, value in of.items()) + "  µm for one σ")

# %%
# The squares of the shares make the scatter: the samples say the same as the linear model.
for symbol in SYMBOLS:
    linear = np.sqrt(sum(of[symbol] ** 2 for of in shares.values()))
    assert abs(scatter[0][symbol][0] / linear - 1) < 0.03, (symbol, scatter[0][symbol][0], linear)
