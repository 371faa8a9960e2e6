# %% [markdown]
# # Which worm, which dresser?
#
# A shop has worms and dressers, and a gear that none of them was made for. A dresser makes a worm of another diameter or module if the dressing axes
# are set differently; how far they have to go, and what of the profile is left wrong, is computed for every pair.

# %%
import flankwright as fw
import matplotlib.pyplot as plt
import numpy as np

job = fw.Job.load("../examples/catalogue.toml")
study = fw.explore(job).document
pairs = study["pairs"]
print(f"{len(pairs)} pairs of {len(study['worms'])} worms and {len(study['dressers'])} dressers; {study['ranking']}")

# %% [markdown]
# Every pair: how much of the largest axis limit it needs. What cannot be dressed at all is left white.

# %%
worms, dressers = study["worms"], study["dressers"]
share = np.full((len(worms), len(dressers)), np.nan)
for pair in pairs:
    if pair["ok"]:
        share[worms.index(pair["worm"]), dressers.index(pair["dresser"])] = 100 * pair["largest_share_of_limit"]
figure, ax = plt.subplots(figsize=(8, 5), layout="constrained")
drawn = ax.imshow(share, cmap="cividis_r", aspect="auto")
for row, column in np.argwhere(np.isfinite(share)):
    dark = share[row, column] > 0.6 * np.nanmax(share)
    ax.text(column, row, f"{share[row, column]:.0f}", ha="center", va="center", color="white" if dark else "black", fontsize=8)
ax.set(
    title="Largest share of an axis limit of dressing, for pairs that make the profile",
    xticks=range(len(dressers)),
    xticklabels=dressers,
    yticks=range(len(worms)),
    yticklabels=worms,
    xlabel="dresser",
    ylabel="worm",
)
ax.tick_params(axis="x", rotation=60)
figure.colorbar(drawn, label="share of the limit [%]")
plt.show()

# %% [markdown]
# The best pairs, and what the axes of dressing do for them:

# %%
for pair in pairs[:5]:
    left = pair["flanks"]["left"]
    print(
        f"{pair['rank']:3d} {pair['worm']:8s} {pair['dresser']:14s} share {100 * pair['largest_share_of_limit']:5.1f} %  "
        f"d_gamma {left['d_gamma_deg']:+.4f} deg  d_v_yA {left['d_v_yA_mm']:+.4f} mm  profile error {left['profile_error_um']:.1e} um"
    )

# %% [markdown]
# And why others are refused:

# %%
refused = [pair["refused"]["code"] if isinstance(pair["refused"], dict) else str(pair["refused"]) for pair in pairs if pair["refused"]]
codes, counts = np.unique(refused, return_counts=True)
dict(zip(codes.tolist(), counts.tolist()))

# %% [markdown]
# ## The plan with the best pair
#
# `plan` takes the best pair by itself and lets the referee judge it.

# %%
planned = fw.plan(job)
planned

# %%
assert planned.met
assert pairs[0]["ok"] and all(a["rank"] < b["rank"] for a, b in zip(pairs, pairs[1:]))
