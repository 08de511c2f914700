# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""examples/uniaxial: between platens with friction the specimen starts to break where its weakest
particle does. The smallest of n draws of a Weibull distribution of scale s and modulus w is itself
Weibull distributed, with the scale s n^(-1/w) and the same modulus: three seeds lie between its
quantiles of 0.1 and 99.9 percent. Without friction the first row is torn sideways, and it breaks
below all of them."""

from tmsph_testing import *

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ("examples/uniaxial/in.uniaxial", "potentials/granite.tmsph")    # it includes the second
STRENGTH, MODULUS, PARTICLES = 200.0, 15, 25 * 50    # MPa


def first_break(friction, seed):
    """In MPa."""
    scene = Script(f"variable friction index {friction}\nvariable seed index {seed}\n"
                   "shell cd examples/uniaxial\ninclude in.uniaxial\nshell cd ../..",
                   {name: (ROOT / name).read_text() for name in EXAMPLE})
    log = scene.run().log
    return float(re.findall(r"^First break at ([\d.]+) MPa", log, re.M)[0])


def quantile(share):
    return STRENGTH * PARTICLES ** (-1 / MODULUS) * (-np.log(1 - share)) ** (1 / MODULUS)


report = Report()
low, high = quantile(0.001), quantile(0.999)
for seed in (4711, 1, 2):
    report.within(f"first break, friction 0.2, seed {seed}, MPa", first_break(0.2, seed), low, high)
report.within("first break, no friction, MPa", first_break(0.0, 4711), 0.25 * low, low)
report.finish()
