# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Break events as acoustic emission is reported: clusters in time and space with magnitudes, their b-value,
and the way of the front of a crack. For cracks.py."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree


def clusters(place, when, radius, window):
    """The number of the cluster of each event, in the order in which they begin. Two events belong
    together if they are within the radius and the window of each other, or are linked by others that are.

    place: (events, dimension); when: (events,), of the same kind as window"""
    pairs = cKDTree(place).query_pairs(radius, output_type="ndarray")
    pairs = pairs[np.abs(when[pairs[:, 0]] - when[pairs[:, 1]]) <= window]
    links = coo_matrix((np.ones(len(pairs)), pairs.T), shape=(len(place),) * 2)
    _, label = connected_components(links, directed=False)
    begin = np.full(label.max() + 1, np.inf)
    np.minimum.at(begin, label, when)
    rank = np.empty(len(begin), int)
    rank[np.argsort(begin, kind="stable")] = np.arange(len(begin))
    return rank[label]


def describe(label, place, when, energy):
    """A row for each cluster: number of events, begin, duration, centre by energy, energy, magnitude, the
    logarithm to base 10 of that."""
    count = np.bincount(label)
    begin, end = np.full(len(count), np.inf), np.full(len(count), -np.inf)
    np.minimum.at(begin, label, when)
    np.maximum.at(end, label, when)
    total = np.bincount(label, energy)
    with np.errstate(divide="ignore", invalid="ignore"):
        centre = np.stack([np.bincount(label, energy * x) / total for x in place.T], 1)
        magnitude = np.log10(total)
    return count, begin, end - begin, centre, total, magnitude


def b_value(magnitude, complete=None):
    """b of log10 N(>= M) = a - b M by maximum likelihood, with its standard error and the magnitude from
    which on the list counts as complete: given, or where most clusters are, in bins of 0.1 (Aki, Bull. Earthq.
    Res. Inst. 43 (1965) 237; Wiemer, Wyss, Bull. Seism. Soc. Am. 90 (2000) 859). None for fewer than ten."""
    magnitude = magnitude[np.isfinite(magnitude)]
    if complete is None and len(magnitude):
        bins = np.floor(magnitude / 0.1).astype(int)
        complete = 0.1 * (np.bincount(bins - bins.min()).argmax() + bins.min())
    above = magnitude[magnitude >= complete] if len(magnitude) else magnitude
    if len(above) < 10 or above.mean() <= complete:
        return None
    b = np.log10(np.e) / (above.mean() - complete)
    return b, b / np.sqrt(len(above)), complete


def front(place, when, start):
    """How far the events have come from a point: times at which one is farther than all before, and
    distances."""
    distance = np.linalg.norm(place - start, axis=1)
    order = np.lexsort((-distance, when))
    farthest = np.maximum.accumulate(distance[order])
    new = np.concatenate([[True], np.diff(farthest) > 0])
    return when[order][new], farthest[new]


def front_speed(when, distance):
    """Slope of a straight line through the middle half of the way; None where that has no duration."""
    low, high = np.quantile([distance[0], distance[-1]], (0.25, 0.75))
    part = (distance >= low) & (distance <= high)
    if np.count_nonzero(part) < 2 or np.ptp(when[part]) == 0:
        return None
    return np.polyfit(when[part], distance[part], 1)[0]
