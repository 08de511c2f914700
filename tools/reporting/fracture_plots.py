# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Plots of cracks whose bonds open, from the rows of their tables."""

from test_openings import LENGTH

from .plots import COLORS, MARKERS, plt


def save(figure, path):
    figure.savefig(path, dpi=90, bbox_inches="tight", pil_kwargs={"optimize": True})
    plt.close(figure)


def finish(ax, x, y, legend=True):
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    ax.grid(True, color="0.9", lw=0.6)
    if legend:
        ax.legend(fontsize=8, frameon=False)


def band(ax, low, high, text, vertical=False):
    """A bar, grey."""
    (ax.axvspan if vertical else ax.axhspan)(low, high, color="0.92", zorder=0, label=text)


def of(rows, name):
    return [float(row[name]) for row in rows]


def groups(rows, *names):
    """Rows by the values of some parameters."""
    found = {}
    for row in rows:
        found.setdefault(tuple(row[name] for name in names), []).append(row)
    return found


def energy(rows, _, path):
    name = "energy of the crack/(G area)"
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 4), gridspec_kw={"wspace": 0.25})
    plain = [row for row in rows if row["spacing"] == "0.0015"]
    places = {body: k for k, body in enumerate(dict.fromkeys(row["body"] for row in plain))}
    band(left, 0.95, 1.05, "bar", vertical=True)
    for k, ((plane,), some) in enumerate(groups(plain, "plane").items()):
        left.plot(of(some, name), [places[row["body"]] for row in some], MARKERS[k], color=COLORS[k],
                  ms=5, label=f"plane {plane}" if plane else "3-D, bar 0.08")
    left.set_yticks(list(places.values()))
    left.set_yticklabels(list(places), fontsize=8)
    left.invert_yaxis()
    left.set_xlim(0.92, 1.2)
    finish(left, name, "")
    left.set_title(f"spacing {1.5e-3 / LENGTH:.2f} l", fontsize=10)
    band(right, 0.95, 1.05, "bar")
    right.axvline(0.3, color="0.5", lw=0.8, ls=":", label="warned beyond")
    for k, body in enumerate(("square 0", "hex 15")):
        some = sorted((float(row["spacing"]) / LENGTH, float(row[name])) for row in rows
                      if row["body"] == body and row["plane"] == "strain")
        right.plot(*zip(*some), MARKERS[k] + "-", color=COLORS[k], ms=5, label=body)
    right.set_ylim(0.9, 1.1)
    finish(right, "spacing/l", name)
    save(figure, path)


def plates(rows, _, path):
    figure, ax = plt.subplots(figsize=(6.4, 4))
    band(ax, 0.96, 1.04, "bar")
    name = "peak/finite elements"
    lattices = list(dict.fromkeys(row["lattice"] for row in rows))
    lengths = sorted({float(row["a/l"]) for row in rows})
    for j, lattice in enumerate(lattices):
        for k, a in enumerate(lengths):
            some = [row for row in rows if row["lattice"] == lattice and float(row["a/l"]) == a]
            x = [float(row["spacing/l"]) + 0.008 * (k - 0.5 * (len(lengths) - 1)) for row in some]
            ax.plot(x, of(some, name), MARKERS[j], color=COLORS[k], ms=5)
    for j, lattice in enumerate(lattices):
        ax.plot([], [], MARKERS[j], color="0.4", ms=5, label=lattice)
    for k, a in enumerate(lengths):
        ax.plot([], [], "-", color=COLORS[k], label=f"a/l {a:g}")
    ax.set_xlim(0.05, 0.35)
    finish(ax, "spacing/l", name, legend=False)
    ax.legend(fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1.01, 0.5))
    save(figure, path)


def bend(rows, curves, path):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), gridspec_kw={"wspace": 0.25})
    curves = [row for row in curves if row["lattice"] == "square 0"]
    for k, ((spacing,), points) in enumerate(groups(curves, "spacing/l").items()):
        for (source,), some in groups(points, "curve").items():
            exact = source != "tmsph"
            left.plot([1e3 * float(row["x"]) for row in some], [1e-3 * float(row["y"]) for row in some],
                      color=COLORS[k], lw=1.0 if exact else 1.4, ls="--" if exact else "-",
                      label=None if exact else f"spacing {spacing} l")
    left.plot([], [], "--", color="0.4", lw=1, label="finite elements")
    left.set_ylim(bottom=0)
    finish(left, "opening of the notch, micrometres", "load, kN per m of thickness")
    band(right, 0.92, 1.08, "bar of the branch")
    band(right, 0.96, 1.04, "bar of the peak")
    right.patches[-1].set_color("0.84")
    names = ("peak/finite elements", "lowest load behind it/finite elements", "highest load behind it/finite elements")
    for j, ((lattice,), some) in enumerate(groups(rows, "lattice").items()):
        some = sorted(some, key=lambda row: float(row["spacing/l"]))
        for k, name in enumerate(names):
            right.plot(of(some, "spacing/l"), of(some, name), MARKERS[j] + "-", color=COLORS[k], ms=5, lw=0.8)
    for j, lattice in enumerate(dict.fromkeys(row["lattice"] for row in rows)):
        right.plot([], [], MARKERS[j], color="0.4", label=lattice)
    for k, label in enumerate(("peak", "lowest of the branch", "highest of the branch")):
        right.plot([], [], "-", color=COLORS[k], label=label)
    finish(right, "spacing/l", "load/that of the finite elements")
    save(figure, path)


def kalthoff(rows, _, path):
    figure, ax = plt.subplots(figsize=(6.4, 3.8))
    band(ax, 62, 75, "bar")
    band(ax, 65, 75, "experiment")
    ax.patches[-1].set_color("0.84")
    places = {lattice: k for k, lattice in enumerate(dict.fromkeys(row["lattice"] for row in rows))}
    for k, ((strength, dx), some) in enumerate(groups(rows, "strength", "dx").items()):
        ax.plot([places[row["lattice"]] + 0.08 * (k - 1) for row in some], of(some, "angle of the crack"), MARKERS[k],
                color=COLORS[k], ms=6, label=f"{1e-9 * float(strength):g} GPa, spacing {1e3 * float(dx):g} mm")
    ax.set_xticks(list(places.values()))
    ax.set_xticklabels(list(places))
    ax.set_ylim(50, 80)
    finish(ax, "lattice", "degrees from the notch")
    save(figure, path)


def at_once(rows, _, path, opening=()):
    """opening: rows of the plates whose bonds open."""
    figure, ax = plt.subplots(figsize=(6, 3.8))
    band(ax, 0.96, 1.04, "bar")
    name = "peak/finite elements"
    seen = {(row["a/l"], row["lattice"]) for row in rows}
    for k, (kind, table) in enumerate((("at once", rows), ("opening", opening))):
        table = [row for row in table if (row["a/l"], row["lattice"]) in seen]
        for j, ((a, lattice), some) in enumerate(groups(table, "a/l", "lattice").items()):
            points = sorted(zip(of(some, "spacing/l"), of(some, name)))
            ax.plot(*zip(*points), MARKERS[j] + "-", color=COLORS[k], ms=5, lw=1, label=f"{kind}, a/l {a}, {lattice}")
    ax.set_xlim(left=0)
    ax.set_ylim(bottom=0)
    finish(ax, "spacing/l", name, legend=False)
    ax.legend(fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1.01, 0.5))
    save(figure, path)


def bars(rows, _, path):
    figure, ax = plt.subplots(figsize=(5, 1.8))
    band(ax, 0.99, 1.01, "bar", vertical=True)
    ax.plot(of(rows, "peak/strength"), range(len(rows)), "o", color=COLORS[0], ms=6)
    ax.set_yticks(range(len(rows)))
    ax.set_yticklabels([row["bar"] for row in rows], fontsize=8)
    ax.set_ylim(len(rows) - 0.5, -0.5)
    ax.set_xlim(0.98, 1.02)
    finish(ax, "largest load/(strength section)", "", legend=False)
    save(figure, path)


def gains(path, named, bar):
    """named: titles and values."""
    figure, ax = plt.subplots(figsize=(6.4, 0.5 + 0.5 * len(named)))
    for k, (title, values) in enumerate(named):
        ax.plot([max(value, 1e-9) for value in values], [k] * len(values), "o", color=COLORS[0], ms=4, alpha=0.6)
    ax.axvline(bar, color="0.3", lw=1, label="bar")
    ax.set_yticks(range(len(named)))
    ax.set_yticklabels([title for title, _ in named], fontsize=8)
    ax.set_ylim(len(named) - 0.5, -0.5)
    ax.set_xscale("log")
    ax.set_xlim(5e-10, 1e-3)
    finish(ax, "energy gained by updates/dissipated (none: at 1e-9)", "")
    save(figure, path)


PICTURES = {"fracture_energy": energy, "fracture_plates": plates, "fracture_bars": bars, "fracture_bend": bend,
            "fracture_kalthoff": kalthoff, "fracture_at_once": at_once}
