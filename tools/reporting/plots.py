# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Plots of error against run time."""

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#8c564b", "#7f7f7f",
          "#9467bd", "#17becf", "#bcbd22", "#d62728", "#2ca02c", "#ff9896"]
MARKERS = "osv^D<>pXh*P"


def front(points):
    """The (time, error) that no other point beats in both, by time."""
    best, chosen = float("inf"), []
    for time, error in sorted(points):
        if error < best:
            best = error
            chosen.append((time, error))
    return chosen


def error_against_time(path, title, curves, error_name, default, mark=None, note=""):
    """curves: {label: [(time, error)]}; the default is thick and black. The Pareto front is the
    grey staircase. mark: an error to draw a line at."""
    figure, ax = plt.subplots(figsize=(7.4, 4.2))
    stairs = front([p for points in curves.values() for p in points])
    if stairs:
        ax.step(*zip(*stairs), where="post", color="0.82", lw=7, solid_capstyle="round",
                label="Pareto front", zorder=1)
    others = [label for label in curves if label != default]
    for k, label in enumerate(others):
        ax.plot(*zip(*curves[label]), color=COLORS[k % len(COLORS)],
                marker=MARKERS[k % len(MARKERS)], ms=4.5, lw=1.1, label=label, zorder=2)
    if default in curves:
        ax.plot(*zip(*curves[default]), color="k", marker="o", ms=7, lw=2.2, zorder=3,
                label=default)
    ax.set_xscale("log")
    ax.set_yscale("log")
    if mark:
        ax.axhline(mark, color="0.5", lw=0.8, ls=":")
        ax.annotate(f"{100 * mark:g} %" if mark > 1e-4 else f"{mark:g}", (1.0, mark),
                    xycoords=("axes fraction", "data"), xytext=(-3, 2), textcoords="offset points", ha="right", fontsize=7.5,
                    color="0.35")
    ax.grid(True, which="major", color="0.9", lw=0.6)
    ax.set_xlabel("run time, seconds of one core" + note)
    ax.set_ylabel(error_name)
    ax.set_title(title, fontsize=11)
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=8, frameon=False)
    figure.savefig(path, dpi=90, bbox_inches="tight", pil_kwargs={"optimize": True})
    plt.close(figure)
