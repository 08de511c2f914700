# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Bodies without a lattice: particles at random places, spread by tmsph/relax over regions."""

import numpy as np

from tmsph_testing import HORIZON, Cloud, Script


class Body:
    """A region with particles of a type."""

    def __init__(self, name, shape, particles, before=""):
        self.name, self.shape, self.particles, self.before = name, shape, particles, before


class Relaxed:
    """low, high: corners of the box. cloud: what came out. log: of the run. more: commands before
    tmsph/relax. horizon: 3.015 spacings if it is not given."""

    def __init__(self, bodies, low, high, periodic="", words="", more="", ranks=1, seed=4711,
                 horizon=None):
        d = len(low)
        self.size = np.prod(np.array(high) - low)
        self.spacing = (self.size / sum(body.particles for body in bodies)) ** (1 / d)
        box = [f"{a:.17g} {b:.17g}" for a, b in zip(low, high)]
        box += [f"{-0.5 * self.spacing:.17g} {0.5 * self.spacing:.17g}"] * (3 - d)
        boundary = " ".join("p" if axis in periodic or k >= d else "f"
                            for k, axis in enumerate("xyz"))
        script = Script(f"units si\ndimension {d}\nboundary {boundary}\natom_style tmsph\n"
                        f"region box block {' '.join(box)} units box\n"
                        f"create_box {len(bodies)} box")
        for k, body in enumerate(bodies, 1):
            script.add(f"{body.before}\nregion {body.name} {body.shape} units box\n"
                       f"create_atoms {k} random {body.particles} {seed + k} {body.name}")
        script.add(f"pair_style tmsph {horizon or HORIZON * self.spacing:.17g}\n"
                   f"pair_coeff * * elastic 1 0.3 density 1\n{more}")
        script.add(f"tmsph/relax all {' '.join('region ' + body.name for body in bodies)} {words}\n"
                   "reset_atoms id sort yes\n"
                   "compute V all tmsph/property/atom volume\nrun 0")
        script.snapshot("cloud", "type x y z c_V")
        self.run = script.run(ranks)
        self.frame = self.run.frame("cloud")
        self.cloud = Cloud(self.frame("x y z")[:, :d], 1.0, self.spacing, periodic,
                           (np.array(low), np.array(high)))
        self.cloud.type = self.frame["type"].astype(int)
        self.cloud.volume = self.frame["c_V"]
