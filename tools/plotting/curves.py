# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Curves of tables: each unit has its panel; and profiles of fix ave/chunk."""
import numpy as np
from matplotlib import pyplot as plt

from lammps_files import quantity
from . import bodies as model
from .save import save

MOST = 6               # profiles in a picture
EXACT = dict(color="black", ls="--", lw=1)
KIND = {"J": "energy", "J_per_m": "energy", "N": "force", "N_per_m": "force", "MPa": "stress",
        "Pa": "stress", "m_per_s": "speed", "C": "temperature", "K": "temperature"}


def text(name):
    return name.replace("_", " ")


def axis(name, values):
    """Values in readable numbers, what they are, and their unit."""
    what, unit = quantity(name)
    factor, unit = model.scaled(unit, np.abs(values).max())
    return values * factor, text(what), unit


def panels(columns):
    """Names of columns by unit, without those that are zero all the time."""
    groups = {}
    for name, values in columns.items():
        if values.any():
            groups.setdefault(quantity(name)[1], []).append(name)
    return groups


def draw_curves(path, columns, title, exact=()):
    """The first column, or the second if the first is the step, against all others, beside those of
    the same names in another table."""
    names = [name for name in columns if name.lower() != "step"]
    what, unit = quantity(names[0])
    x_factor, unit = model.scaled(unit, np.abs(columns[names[0]]).max())
    x, what = columns[names[0]] * x_factor, text(what)
    groups = panels({name: columns[name] for name in names[1:]})
    if not groups or len(x) < 2:
        return
    wide = min(len(groups), 2)
    high = -(-len(groups) // wide)
    figure, axes = plt.subplots(high, wide, squeeze=False, layout="constrained",
                                figsize=(4.6 * wide + 0.4, 3.2 * high + 0.4))
    for ax in axes.ravel()[len(groups):]:
        ax.axis("off")
    for ax, (kind, members) in zip(axes.ravel(), groups.items()):
        factor, shown = model.scaled(kind, max(np.abs(columns[name]).max() for name in members))
        for k, name in enumerate(members):    # the first is wide, as others may lie on it
            label = text(quantity(name)[0])
            style = EXACT if "exact" in label else dict(lw=max(1.2, 2.6 - k))
            ax.plot(x, columns[name] * factor, label=label, **style)
            if name in exact and names[0] in exact:
                ax.plot(exact[names[0]] * x_factor, exact[name] * factor, label=f"{label}, exact", **EXACT)
        whole = all(np.all(columns[name] == np.rint(columns[name])) for name in members)
        single = text(quantity(members[0])[0])
        ax.set_ylabel(", ".join(filter(None, ["number" if whole and len(members) > 1 else
                                              single if len(members) == 1 else KIND.get(kind, ""),
                                              shown])) or "value")
        if len(ax.lines) > 1:
            ax.legend(fontsize="small")
        ax.set_xlabel(f"{what}, {unit}" if unit else what)
        ax.locator_params(nbins=6)
        ax.grid(alpha=0.3)
    figure.suptitle(title, fontsize="medium")
    save(figure, path)


def draw_profiles(path, names, found, title):
    """The last column against the second, for some of the steps."""
    if not found:
        return
    places = np.linspace(0, len(found) - 1, min(MOST, len(found))).astype(int)
    chosen = [found[k] for k in sorted(set(places))]
    figure, ax = plt.subplots(figsize=(5, 3.6), layout="constrained")
    for step, rows in chosen:
        rows = rows[rows[:, 2] > 0]
        x, what, unit = axis(names[1], rows[:, 1])
        y, value, of = axis(names[-1], rows[:, -1])
        ax.plot(x, y, ".-", ms=3, lw=1, label=f"step {step}")
    ax.set_xlabel(f"{what}, {unit}" if unit else what)
    ax.set_ylabel(f"{value}, {of}" if of else value)
    ax.legend(fontsize="small")
    ax.grid(alpha=0.3)
    ax.set_title(title, fontsize="medium")
    save(figure, path)
