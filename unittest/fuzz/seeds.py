# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The valid inputs that fuzz.py mutates: tiny bodies and few steps, which together use every
command of the package."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "verification"))
import tmsph_testing as t

DX = 1e-3


def data(cells, kind, types):
    cloud = t.lattice(kind, cells, DX)
    cloud.type = 1 + (t.np.arange(len(cloud)) * types) // len(cloud)
    text = cloud.data(20.0)
    return text.replace(" 1 atom types", f" {types} atom types")


def with_masses(text, density=2700.0):
    """The same data file with the masses of the particles given."""
    head, rows = text.split("Atoms # tmsph\n\n")
    lines = []
    for row in rows.splitlines():
        words = row.split()
        words[3] = f"{density * float(words[2]):.17g}"
        lines.append(" ".join(words))
    return head + "Atoms # tmsph\n\n" + "\n".join(lines) + "\n"


def head(dimension, more=""):
    boundary = "s s p" if dimension == 2 else "s s s"
    return (f"units si\ndimension {dimension}\nboundary {boundary}\natom_style tmsph\n"
            f"comm_modify cutoff 7e-3\n{more}read_data cloud.data\n")


WATCH = """compute p all tmsph/property/atom ux uy temperature damage nbond sxx syy sxy s1 \
vonmises radius
compute c all tmsph/crack
compute tip all tmsph/crack/tip 1 0.5 0 open 0.5 cut yes window 5
compute d all tmsph/dt
compute b all tmsph/bond/local id1 id2 state length stretch only all
dump f all custom 2 out.dump id type x y z vx vy c_p[*]
dump l all local 5 out.bonds index c_b[*]
thermo_style custom step temp pe press c_c[1] c_d c_tip[5]
thermo 2
"""

FRACTURE = head(2) + """pair_style tmsph 3.015e-3 kernel wendland plane strain law almansi \
hourglass 0.1 viscosity 1.0 2.0 thermal bond
pair_coeff 1 1 elastic 40e9 0.30 density 2700 expansion 1.5e-5 reference 20.0
pair_coeff 2 2 elastic 20e9 0.20 density 2700 expansion 1.0e-5 reference 20.0
pair_coeff 1 2 bonded
timestep 1e-8
tmsph/cut all line 0.002 0.003 0.005 0.003
tmsph/cut all arc 0.003 0.003 0.001 30 150
fix rock all tmsph/hoekbrown strength 1 150e6 strength 2 120e6 mi * 8 gsi * 100 \
disturbance * 0 weibull * 10 4711 principal inplane
fix touch all tmsph/contact friction * * 0.3 method kernel law implicit self yes stiffness 1.0
fix heat all tmsph/heat conductivity 1 table rock.table k conductivity 2 2.1 \
specific/heat * 850 contact * * 2000 friction yes viscous yes source 1 1e6 subcycle rkl2 every 1 \
time/scale 1e3
fix air all tmsph/heat/boundary convection 25.0 20.0 cracks yes
fix move all nve
velocity all set 1.0 0.0 0.0
""" + WATCH + "run 6\nwrite_data end.data\n"

WALLS = head(2) + """pair_style tmsph 3.015e-3 kernel cubic plane stress hourglass 0.2
pair_coeff * * elastic 20e9 0.2 density 2700
timestep 1e-8
velocity all set 0.0 -5.0 0.0
fix heat all tmsph/heat conductivity * orthotropic 3 2 30 specific/heat * 850 every 2 time/scale 10
variable down equal -1.0*step
fix floor all tmsph/wall line -0.01 0 0.02 0 friction 0.3 law penalty stiffness 0.5
fix slope all tmsph/wall polyline file slope.txt side both friction 0.1
fix box all tmsph/wall polyline 3 -0.002 0 -0.002 0.01 0.009 0.01 side both rotation 0 0 10
fix jaw all tmsph/wall arc 0.003 0.012 0.004 -180 0 load NULL -20 mass 0.005
fix top all tmsph/wall line 0.01 0.009 -0.01 0.009 velocity 0 v_down
fix move all nve
""" + WATCH + "run 6\n"

QUASISTATIC = head(2) + """pair_style tmsph 3.015e-3 kernel quintic thermal strain
pair_coeff * * elastic 40e9 0.30 density 2700 expansion 1.5e-5 reference 20
timestep 1.0
variable T equal 20+20*time
group left id 1:12
fix hot all tmsph/heat/boundary temperature v_T
fix rock all tmsph/hoekbrown strength * 20e6 mi * 8 weibull * 5 4711
""" + WATCH + """tmsph/quasistatic 3 change 30.0 residual 1e-3 1e-2 breaking 0.9 jump no \
evaluations 400
min_style tmsph/lbfgs
min_modify dmax 1e-6 memory 5
minimize 0 1e-3 50 100
"""

SEGMENTS = head(2) + """pair_style tmsph 3.015e-3
pair_coeff 1 1 elastic 40e9 0.3 density 2700
pair_coeff 2 2 elastic 20e9 0.2 density 2700 horizon 2.1e-3
pair_coeff 1 2 none
timestep 1e-8
group low type 1
velocity low set 0 3 0
fix touch all tmsph/contact friction 1 2 0.3 method segment law paper
fix move all nve
""" + WATCH + "run 6\nwrite_restart mid.restart\nrun 2\n"

RESTART = SEGMENTS + """clear
read_restart mid.restart
comm_modify cutoff 7e-3
fix touch all tmsph/contact friction 1 2 0.3 method segment law paper
fix move all nve
""" + WATCH + "run 4\n"

SOLID = head(3) + """pair_style tmsph 2.1e-3 law svk dilatation averaged viscosity 1.0 2.0
pair_coeff * * elastic 40e9 0.3 density 2700 expansion 1e-5 reference 20
timestep 1e-8
tmsph/cut all disc 0.002 0.002 0.002 0 0 1 0.0015
tmsph/cut all polygon 4 0 0 0.003 0.002 0 0.003 0.002 0.002 0.003 0 0.002 0.003
region ball sphere 0.002 0.002 0.002 0.01
fix rock all tmsph/hoekbrown strength * 100e6 mi * 8 principal all
fix touch all tmsph/contact friction * * 0.3 surface ball
fix base all tmsph/wall plane 0 0 0 0 0 1 friction 0.3 velocity 0 0 1
fix heat all tmsph/heat conductivity * orthotropic 3 2 1 0 0 1 30 specific/heat * \
table rock.table c subcycle explicit
fix sun all tmsph/heat/boundary flux 1e5 region ball
fix sky all tmsph/heat/boundary radiation 5.1e-8 -20 zero -273.15 area 1e-4
fix move all nve
velocity all set 0 0 -2
""" + WATCH + "run 4\n"

TABLE = "# a property table\nk\n0 3.0\n100 2.5\n500 2.0\n\nc\n0 800\n200 950\n"
SLOPE = "# two points or more\n-0.003 -0.001\n0.004 -0.0005\n0.012 0.002\n"

PLATE = data((6, 6), "square", 1)
SEEDS = {
    "fracture": (FRACTURE, {"cloud.data": with_masses(data((6, 6), "square", 2)),
                            "rock.table": TABLE}),
    "walls": (WALLS, {"cloud.data": PLATE, "slope.txt": SLOPE}),
    "quasistatic": (QUASISTATIC, {"cloud.data": data((6, 3), "hex", 1)}),
    "segments": (SEGMENTS, {"cloud.data": data((6, 8), "square", 2)}),
    "restart": (RESTART, {"cloud.data": data((6, 8), "square", 2)}),
    "solid": (SOLID, {"cloud.data": data((4, 4, 4), "sc", 1), "rock.table": TABLE}),
}
