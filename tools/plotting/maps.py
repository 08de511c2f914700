# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Maps of the fields of bodies: each place has the colour of the particle it belongs to."""
import textwrap

import numpy as np
from matplotlib import colors, pyplot as plt
from scipy.spatial import cKDTree

from lammps_files import stop
from . import bodies as model
from .save import save

PIXELS = 700           # along the longer side of a body
# A pixel is in the body if a particle is near, or if it is between particles: one less far than the
# corner of its cell, in 2-D at 1.41, in 3-D at 1.73, and another one, or two. Along a row of
# particles that makes a straight edge, 1.05 to 1.13 from their centres; in radii
NEAR = 1.13
BETWEEN = {2: (1.45, 1, 2.3), 3: (1.75, 2, 2.5)}    # corner, which other one, how far at most
LEVELS = 25            # colours: odd, so that zero has one between two signs
DAMAGED = 0.6          # beside a straight crack damage is 0.4, where cracks meet more
PANEL = 3.3            # width of a picture, inches


class View:
    """Where one looks: a plane body, or the section of a 3-D one across an axis."""

    def __init__(self, shown, magnify, section):
        self.flat, self.magnify = shown[0].dimension == 2, magnify
        name, _, at = (section or "z").partition("=")
        self.axis = 2 if self.flat else "xyz".index(name)
        self.plane = [k for k in range(3) if k != self.axis]
        places = np.vstack([body.places(magnify) for body in shown])
        first, last = places[:, self.axis].min(), places[:, self.axis].max()
        self.at = float(at) if at else 0.5 * (first + last)
        if not self.flat and not first <= self.at <= last:
            stop(f"--section {section} is beside the body, which is from {first:.4g} to "
                 f"{last:.4g} m there")
        edge = NEAR * max(body.radius.max() for body in shown)
        self.low = places[:, self.plane].min(axis=0) - edge
        self.high = places[:, self.plane].max(axis=0) + edge

    def owners(self, body):
        """The particle that each pixel belongs to, -1 where there is none."""
        size = (self.high - self.low).max() / PIXELS
        x, y = (np.arange(self.low[k] + 0.5 * size, self.high[k], size) for k in range(2))
        points = np.empty((len(y), len(x), 3))
        points[..., self.plane[0]], points[..., self.plane[1]] = np.meshgrid(x, y)
        points[..., self.axis] = 0.0 if self.flat else self.at
        places = body.places(self.magnify)
        if self.flat:
            places[:, 2] = 0.0
        corner, other, far = BETWEEN[body.dimension]
        reach = far * body.radius.max()
        distance, owner = cKDTree(places).query(points, 3, distance_upper_bound=reach)
        owner[np.isinf(distance)] = 0
        distance /= body.radius[owner[..., :1]]
        between = (distance[..., 0] < corner) & (distance[..., other] < far)
        return np.where((distance[..., 0] < NEAR) | between, owner[..., 0], -1)


def limits(field, values):
    """(low, high, name of the colours) for all values shown, but for a few extreme ones."""
    values = values[np.isfinite(values)]
    if field == "damage":
        return 0.0, DAMAGED, "damage"
    if model.UNIT.get(field) == "Pa" and field not in ("strength", "vonmises"):
        most = np.percentile(np.abs(values), 99.5) or 1.0
        return -most, most, "coolwarm"
    low, high = np.percentile(values, 0.1), np.percentile(values, 99.9)
    name = "inferno" if field == "temperature" else "viridis"
    return low, high if high > low else low + 1.0, name


def colours(name):
    if name == "damage":
        return colors.LinearSegmentedColormap.from_list(
            name, ["gainsboro", "orange", "red", "black"], LEVELS)
    return plt.get_cmap(name, LEVELS)


def nice(length):
    """The largest of 1, 2, 5 times a power of ten below a length."""
    power = 10.0 ** np.floor(np.log10(length))
    return power * max(k for k in (1, 2, 5) if k * power <= length)


def draw_body(ax, view, body, colour_of, pieces):
    owner = view.owners(body)
    picture = np.ones(owner.shape + (4,))
    picture[owner >= 0] = colour_of(owner[owner >= 0])
    ax.imshow(picture, origin="lower", interpolation="nearest",
              extent=(view.low[0], view.high[0], view.low[1], view.high[1]))
    size = view.high - view.low
    margin = (0.08 if len(pieces) else 0.02) * size.max()
    low, high = view.low - margin, view.high + margin
    for a, b in model.lines(pieces, view.axis, view.at):
        ax.plot((a[view.plane[0]], b[view.plane[0]]), (a[view.plane[1]], b[view.plane[1]]),
                color="dimgray", lw=3, solid_capstyle="butt")
    bar = nice(0.3 * size[0])
    below = low[1] - 0.03 * size.max()
    ax.plot((view.low[0], view.low[0] + bar), (below, below), color="black", lw=3,
            solid_capstyle="butt")
    factor, unit = model.scaled("m", bar)
    ax.text(view.low[0] + bar + 0.02 * size.max(), below, f"{bar * factor:g} {unit}", va="center")
    ax.set_xlim(low[0], high[0])
    ax.set_ylim(below - 0.04 * size.max(), high[1])
    ax.set_aspect("equal")
    ax.axis("off")


def draw(figure, view, shown, field, bounds, unit, titles, caption, walls):
    """One field of these bodies, side by side, with one bar of colours."""
    low, high, name = bounds
    factor, unit = model.scaled(unit, max(abs(low), abs(high)))
    norm, cmap = colors.Normalize(low * factor, high * factor), colours(name)
    axes = figure.subplots(1, len(shown), squeeze=False)[0]
    for ax, body, title in zip(axes, shown, titles):
        values = body.columns[field] * factor
        near = min(walls, key=lambda step: abs(step - body.step), default=None)
        draw_body(ax, view, body, lambda owner: cmap(norm(values[owner])),
                  walls[near] if walls else [])
        ax.set_title(title, fontsize="medium")
    below = min(body.columns[field].min() for body in shown) < low
    above = max(body.columns[field].max() for body in shown) > high
    extend = ("neither", "min", "max", "both")[below + 2 * above]
    bar = figure.colorbar(plt.cm.ScalarMappable(norm, cmap), ax=list(axes), pad=0.02, shrink=0.8,
                          extend=extend, aspect=40 if len(shown) > 2 else 25,
                          location="bottom" if is_wide(view, len(shown)) else "right")
    bar.set_label(model.LONG.get(field, field) + (f", {unit}" if unit else ""))
    wide = int(figure.get_figwidth() * 13)
    figure.supxlabel("\n".join(textwrap.wrap(caption, wide)), fontsize="small")


def is_wide(view, count):
    """The bar of colours is then below."""
    size = view.high - view.low
    return count * size[0] > 1.5 * size[1]


def figure_for(view, count):
    size = view.high - view.low
    width = PANEL * max(1.0, min(2.0, size[0] / size[1])) if count < 3 else PANEL
    height = width * size[1] / size[0]
    if height > 5.5:
        width, height = width * 5.5 / height, 5.5
    wide = is_wide(view, count)
    return plt.figure(figsize=(max(width * count, 2.5) + (0.3 if wide else 1.5),
                               max(height, 1.2) + (1.7 if wide else 1.0)),
                      layout="constrained")


def draw_map(path, *arguments):
    view, shown = arguments[:2]
    figure = figure_for(view, len(shown))
    draw(figure, *arguments)
    save(figure, path)


def draw_movie(path, view, shown, field, bounds, unit, titles, caption, walls):
    from matplotlib.animation import FFMpegWriter
    if not FFMpegWriter.isAvailable():
        print(f"no movie {path}: ffmpeg is not installed")
        return
    figure = figure_for(view, 1)
    figure.get_layout_engine().set(rect=(0, 0, 1, 0.92))    # room for titles of two lines
    even = "pad=ceil(iw/2)*2:ceil(ih/2)*2"
    writer = FFMpegWriter(fps=8, extra_args=["-pix_fmt", "yuv420p", "-vf", even])
    with writer.saving(figure, path, 120):
        for body, title in zip(shown, titles):
            figure.clear()
            draw(figure, view, [body], field, bounds, unit, [title], caption, walls)
            writer.grab_frame()
    plt.close(figure)
    print(path)
