# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Wrong inputs: each ends with one error that names the word and the remedy,
within seconds, and never with a signal."""

import re
import struct

from tmsph_testing import Script, main
from wrong_inputs import ROCK, complaints, cube, plate, script, tells

# A small scene that works, in sections; a case replaces some of them

PLATE = plate(
    8, 8, 4.5,
    pair="pair_style tmsph 3.015e-3",
    coeff=ROCK,
    fix="fix 1 all nve\ntimestep 1e-8",
    **{"break": "fix hb all tmsph/hoekbrown strength * 150e6 mi * 8"},
    more="",
    run="run 10",
    after="")
CUBE = cube(PLATE)
PERIODIC = dict(PLATE, space="units si\ndimension 2\nboundary p p p")
NAN = "variable nan atom (1e308*10)-(1e308*10)\n"
NO_BOX = dict(box="", atoms="read_data cloud.data")
DATA = """cloud

4 atoms
2 atom types
0 1e-2 xlo xhi
0 1e-2 ylo yhi
-5e-4 5e-4 zlo zhi

Atoms # tmsph

1 1 {} {} 0 1e-3 1e-3 0
2 1 1e-6 0 0 2e-3 1e-3 0
3 1 1e-6 0 0 1e-3 2e-3 0
4 1 1e-6 0 0 2e-3 2e-3 0
"""
HB = "fix hb all tmsph/hoekbrown strength * 150e6 mi * 8 "
HEAT = "fix T all tmsph/heat/boundary "
CONDUCTS = "fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850 "
BAD = "fix heat all tmsph/heat "
SKIN = CONDUCTS + "\n" + HEAT
TABLE = BAD + "specific/heat * 850 conductivity * table cloud.data k"
CUT = "tmsph/cut all "
RELAX = "tmsph/relax all region "
CONTACT = "fix touch all tmsph/contact "
WALL = "fix wall all tmsph/wall "
LINE = WALL + "line 0 -9e-3 1 -9e-3 "
ELASTIC = "pair_coeff 1 1 elastic "
QUASI = "tmsph/quasistatic "
TIP = "compute tip all tmsph/crack/tip "
MINIMIZE = "\nminimize 0 1e-3 10 100"
CHANGED = "after particles were created, deleted or displaced|run 0"

# Scene, sections replaced, words that the message must hold in this order; "|" separates them

CASES = [
    (PLATE, dict(pair="pair_style tmsph"), "pair_style tmsph|missing"),
    (PLATE, dict(pair="pair_style tmsph wide"), "floating point|wide"),
    (PLATE, dict(pair="pair_style tmsph 0"), "Horizon 0|positive|3 particle spacings"),
    (PLATE, dict(pair="pair_style tmsph -3e-3"), "Horizon -3e-3|positive"),
    (PLATE, dict(pair="pair_style tmsph inf"), "inf"),
    (PLATE, dict(pair="pair_style tmsph nan"), "nan"),
    (PLATE, dict(pair="pair_style tmsph 0.9e-3"), "neighbors within the horizon 0.0009|3 particle"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 kernal cubic"), "kernal|perhaps 'kernel'|use kernel"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 kernel"), "pair_style tmsph kernel|missing"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 kernel gauss"), "gauss|kernel|use|wendland"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 plane flat"), "flat|plane|use|strain"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 law hooke"), "hooke|law|use|svk"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 thermal on"), "on|thermal|use|bond"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 hourglass -0.1"), "hourglass -0.1|negative|0.1"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 viscosity 1"), "viscosity|missing"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 viscosity 1 -2"), "viscosity 1 -2|negative|1 2"),
    (CUBE, dict(pair="pair_style tmsph 3e-3 plane stress"), "plane stress|dimension 2|remove"),
    (PLATE, dict(pair=""), "Pair_coeff|without a pair style"),
    (PLATE, dict(pair="", coeff=""), "tmsph/hoekbrown needs pair style tmsph"),
    (PLATE, dict(pair="pair_style zero 3e-3", coeff="pair_coeff * *"),
     "tmsph/hoekbrown needs pair style tmsph"),
    (PLATE, dict(coeff="pair_coeff 1 1"), "pair_coeff|missing"),
    (PLATE, dict(coeff="pair_coeff 1 1 plastic 40e9 0.3"), "plastic|use elastic, bonded or none"),
    (PLATE, dict(coeff=ELASTIC + "40e9"), "elastic|missing"),
    (PLATE, dict(coeff=ELASTIC + "0 0.3 density 2700"), "Young's modulus 0|positive"),
    (PLATE, dict(coeff=ELASTIC + "-4e9 0.3 density 2700"), "Young's modulus -4e9|positive"),
    (PLATE, dict(coeff=ELASTIC + "40e9 0.5 density 2700"),
     "Poisson's ratio 0.5|between -1 and 0.5"),
    (PLATE, dict(coeff=ELASTIC + "40e9 -1 density 2700"), "Poisson's ratio -1|between -1 and 0.5"),
    (PLATE, dict(coeff="pair_coeff * * elastic 40e9 0.49 density 2700",
                 pair="pair_style tmsph 3.015e-3 dilatation plain"),
     "Poisson's ratio 0.49 of type 1|above 0.45|lock|dilatation auto"),
    (PLATE, dict(coeff="pair_coeff * * elastic 40e9 0.49 density 2700",
                 pair="pair_style tmsph 3.015e-3 law almansi"),
     "0.49 of type 1|above 0.45|law svk"),
    (PLATE, dict(coeff="pair_coeff * * elastic 40e9 0.49999 density 2700\npair_coeff 1 2 none"),
     "0.49999 of type 1|above 0.4999|use that"),
    (PLATE, dict(coeff="pair_coeff 1 1 elastic 40e9 0.3 density 2700\n"
                       "pair_coeff 2 2 elastic 20e9 0.4995 density 2700"),
     "0.4995 of type 2|bonded to another type|above 0.499|pair_coeff I J none"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 dilatation off"), "off|dilatation|use|auto"),
    (PLATE, dict(pair="pair_style tmsph 3e-3 dilatation"), "dilatation|missing"),
    (PLATE, dict(coeff=ELASTIC + "40e9 0.3"), "Density 0|add 'density rho'"),
    (PLATE, dict(coeff=ELASTIC + "40e9 0.3 density -1"), "Density -1|positive"),
    (PLATE, dict(coeff=ELASTIC + "40e9 0.3 density"), "density|missing"),
    (PLATE, dict(coeff=ELASTIC + "40e9 0.3 density 2700 alpha 1e-5"), "alpha|use density"),
    (PLATE, dict(coeff="pair_coeff 3 3 elastic 40e9 0.3 density 2700"), "3|1-2"),
    (PLATE, dict(coeff="pair_coeff 1 2 elastic 40e9 0.3 density 2700"),
     "elastic|one type|'bonded'"),
    (PLATE, dict(coeff=ELASTIC + "40e9 0.3 density 2700"), "pair coeffs|not set"),
    (PLATE, dict(more="pair_coeff 1 1 none"), "1 1 none|two different types"),
    (PLATE, dict(more=ELASTIC + "40e9 0.3 density 2700 horizon"), "horizon|missing"),
    (PLATE, dict(more=ELASTIC + "40e9 0.3 density 2700 horizon 0"), "Horizon 0|positive"),
    (PLATE, dict(more=ELASTIC + "40e9 0.3 density 2700 horizon 1"),
     "Horizon 1|not above|pair_style"),
    (PLATE, dict(after=ELASTIC + "40e9 0.3 density 2700 horizon 2.5e-3\nrun 1"),
     "Horizon 0.0025|type 1|have formed|clear"),
    (PLATE, dict(coeff="pair_coeff * * elastic 40e9 0.3 density 2700 horizon 3e-3\n"
                       "pair_style tmsph 2.5e-3"),
     "Horizon 0.003 of type 1|above|pair_style tmsph, 0.0025|largest"),
    (PLATE, dict(pair="pair_style hybrid tmsph 3.015e-3 zero 3e-3", coeff="pair_coeff 2 2 zero\n"
                 "pair_coeff 1 2 zero\npair_coeff 1 1 tmsph elastic 40e9 0.3 density 2700"),
     "Type 2 has no material|pair_coeff 2 2 elastic"),
    (PLATE, dict(more="neigh_modify exclude type 1 2"),
     "exclude|bonds|remove it|pair_coeff I J none"),
    (PLATE, dict(more="pair_coeff 1 2 bonded 5"), "5|bonded|remove"),
    (PLATE, dict(style="atom_style atomic", volume="mass * 1"), "atom_style tmsph|atomic"),
    (PLATE, dict(style="atom_style tmsph 3"), "atom_style"),
    (PLATE, dict(style="atom_style tmsph\natom_modify id no"),
     "needs atom ids|remove 'atom_modify id no'"),
    (PLATE, dict(box="region box prism 0 8e-3 0 8e-3 -5e-4 5e-4 1e-3 0 0 units box\n"
                     "lattice custom 1e-3 a1 1 0 0 a2 0 1 0 a3 0 0 1 basis 0 0 0\n"
                     "create_box 2 box"),
     "triclinic"),
    (PLATE, dict(space=PLATE["space"].replace("units si", "units metal")),
     "units metal|use si, cgs"),
    (PLATE, dict(space=PLATE["space"].replace("units si", "units real")), "units real|use si, cgs"),
    (PLATE, dict(space=PLATE["space"].replace("units si", "units electron")),
     "units electron|use si, cgs"),
    (PLATE, dict(volume=""), "volume 0|set group all volume"),
    (PLATE, dict(more="velocity all create 300 4711"), "velocity|run 0"),
    (PLATE, dict(volume="set group all volume -1"), "volume"),
    (PLATE, dict(more="set atom 7 mass 1"), "Particle 7|mass 1|density 2700|0.0027:|leave the "
                                            "mass out"),
    (PLATE, dict(more="create_atoms 1 single 2e-3 2e-3 0 units box\nset group all volume 1e-6"),
     "stand on the same place|delete_atoms overlap"),
    (PLATE, dict(NO_BOX,  files=DATA.format("0", "0")), "volume 0|positive"),
    (PLATE, dict(NO_BOX,  files=DATA.format("1e-6", "-1")), "mass -1|or 0"),
    (PLATE, dict(NO_BOX,  files=DATA.format("1e-6", "1")), "Particle 1|mass 1|leave the mass out"),
    (PERIODIC, dict(box=PLATE["box"].replace("8e-3", "5e-3")),
     "length 0.005 in x|two horizons|enlarge"),
    (PLATE, dict(more="timestep 1e-6"), "time step 1e-06|stable one|timestep"),
    (PLATE, dict(more="timestep 2e-7", after="set group all mass 2.7e-4\n"
          "pair_coeff * * elastic 40e9 0.3 density 270\nrun 1"),
     "time step 2e-07|above the stable one|timestep"),
    (PLATE, dict(after="create_atoms 1 single 2.5e-3 2.5e-3 0 units box\n"
                       "set group all volume 1e-6\nrun 1"),
     "1 particles were created after|before the first run"),
    (PLATE, dict(more="region in block 5e-3 7e-3 5e-3 7e-3 -1e-4 1e-4 units box\n"
                     "fix in all deposit 2 1 5 77 region in", run="run 50"),
     "created|before the first run"),
    (PERIODIC, dict(box=PLATE["box"].replace("8e-3", "20e-3"),
                    after="displace_atoms all random 8e-3 8e-3 "
                    "0 5 units box\nrun 1"), "lost its bonded partner|step 10|comm_modify cutoff"),
    (PLATE, dict(more=NAN + "set atom 5 x v_nan"), "Non-numeric atom coords"),
    (PLATE, dict(after=NAN + "set atom 5 x v_nan\nrun 1"), "Non-numeric atom coords"),
    (PLATE, dict(after="velocity all set 1e300 0 0\nrun 1"), "Domain too large"),
    (PLATE, dict(after=NAN + "set atom 5 vx v_nan\nrun 5"),
     "particle 5|not a number|step 11|velocity"),
    (PLATE, dict(after=NAN + "set atom 5 temperature v_nan\nrun 5"),
     "Particle 5|temperature|nan|step 10"),
    (PLATE, {"break": "", "after": "displace_atoms all ramp x 0 -20e-3 x 0 8e-3 units box\nrun 1"},
     "turned inside out|step 10|tmsph/hoekbrown"),
    (PLATE, dict(after="write_restart r\nclear\nread_restart r\npair_style none\nfix hb "
                       "all tmsph/hoekbrown strength * 1e8 mi * 8\nrun 1"),
     "tmsph/hoekbrown needs pair style"),
    (PLATE, dict(after="pair_style tmsph 4e-3\npair_coeff * * elastic 40e9 0.3 density 2700\n"
                       "run 1"),
     "Horizon 0.004|0.003015|clear"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "run": "write_data out.data"},
     "Write_data before|temperature"),
    (PLATE, dict(more="compute p all tmsph/property/atom sxx",
                 run="write_dump all custom out.dump id c_p"), "ID p|before|run"),
    (PLATE, dict(more="compute c all tmsph/crack\nvariable c equal c_c[1]", run="print $c"), "run"),
    (PLATE, dict(more=TIP + "x", run="print $(c_tip[1])"), "run"),
    (PLATE, dict(more="compute d all tmsph/dt\nvariable d equal c_d", run="print $d"), "run"),
    (PLATE, dict(more="compute b all tmsph/bond/local id1 id2",
                 run="write_dump all local out.local c_b[1]"), "run"),
    (PLATE, dict(more="compute p all tmsph/property/atom sxx\ncompute m all reduce max c_p",
                 after="delete_atoms region right\nprint $(c_m)"),
     "tmsph/property/atom|" + CHANGED),
    (PLATE, dict(more="compute b all tmsph/bond/local length\n"
                      "compute m all reduce max c_b inputs local",
                 after="delete_atoms region right\nprint $(c_m)"), "tmsph/bond/local|" + CHANGED),
    (PLATE, dict(more="compute c all tmsph/crack",
                 after="create_atoms 1 random 900 7 box\nprint $(c_c[1])"),
     "tmsph/crack|" + CHANGED),
    (PERIODIC, dict(more="compute d all tmsph/dt",
                    after="displace_atoms all move 1e-3 0 0\nprint $(c_d)"),
     "tmsph/dt|" + CHANGED),
    (PLATE, dict(run="print $(f_hb[4])"), "Output 4 of fix tmsph/hoekbrown hb|do a run first"),
    (PLATE, dict(after="delete_atoms region right\nprint $(f_hb[4])"),
     "tmsph/hoekbrown hb|" + CHANGED),
    (PLATE, dict(more="compute p all tmsph/property/atom load\ncompute m all reduce max c_p",
                 after="unfix hb\nprint $(c_m)"),
     "load|needs a fix that breaks bonds|tmsph/hoekbrown"),
    (PLATE, dict(more="compute p all tmsph/property/atom load\ncompute m all reduce max c_p",
                 after="unfix hb\n" + HB + "\nprint $(c_m)"),
     "tmsph/hoekbrown hb|not in a run yet|run 0"),
    (PLATE, dict(more="compute p all tmsph/property/atom ux\ncompute m all reduce max c_p",
                 after="pair_style none\nprint $(c_m)"),
     "tmsph/property/atom needs pair style tmsph"),
    (PLATE, dict(more="compute c all tmsph/crack",
                 after="pair_style none\npair_style tmsph 3e-3\nprint "
                 "$(c_c[1])"), "tmsph/crack|do a run first"),
    (PLATE, dict(after="pair_style none\nprint $(f_hb[4])"),
     "tmsph/hoekbrown hb needs pair style tmsph"),
    (PLATE, dict(run="run 0", after="replicate 2 1 1\nrun 0"), "replicate"),
    (PLATE, dict(more="run_style respa 2 2 pair 2"), "respa|verlet"),
    (PLATE, dict(more="fix x all tmsph/bond"), "internal"),
    (PLATE, {"break": HB + "\nfix other all tmsph/hoekbrown strength * 150e6 mi * 8"},
     "both break bonds|single"),
    (PLATE, {"break": HB + "\nfix r all tmsph/rankine tensile * 9e6"}, "both break bonds|single"),
    (PLATE, {"break": "fix mc all tmsph/mohrcoulomb cohesion * 25e6 friction * 95 tensile * 9e6"},
     "friction 95|between 0 and 90"),
    (PLATE, {"break": "fix mc all tmsph/mohrcoulomb cohesion * 25e6 friction * 50"},
     "lacks the tensile of type 1|add 'tensile 1"),
    (PLATE, {"break": "fix r all tmsph/rankine strength * 9e6"},
     "'strength'|use tensile, energy, toughness, between, weibull, scatter, softening or principal"),
    (PLATE, {"break": "group some id 1 2\nfix hb some tmsph/hoekbrown strength * 1e6 mi * 8"},
     "all particles|group all"),
    (PLATE, {"break": "fix hb all tmsph/hoekbrown"},
     "lacks the strength of type 1|add 'strength 1"),
    (PLATE, {"break": "fix hb all tmsph/hoekbrown strength * 1e6"},
     "lacks the mi of type 1|add 'mi 1"),
    (PLATE, {"break": "fix hb all tmsph/hoekbrown strength 120e6 mi 8"},
     "strength|'120e6'|use 'strength * value'"),
    (PLATE, {"break": "fix hb all tmsph/hoekbrown strength 1 1e6 mi * 8"},
     "strength of type 2|add"),
    (PLATE, {"break": HB + "strength 3 1e6"}, "strength|'3'|1 to 2|use 'strength * value'"),
    (PLATE, {"break": HB + "strength 1"}, "strength|missing"),
    (PLATE, {"break": HB + "strength 1 high"}, "floating point|high"),
    (PLATE, {"break": HB + "strength 1 0"}, "strength 0|positive"),
    (PLATE, {"break": HB + "mi 1 -8"}, "mi -8|positive"),
    (PLATE, {"break": HB + "gsi 1 0"}, "gsi 0|100"),
    (PLATE, {"break": HB + "gsi 1 101"}, "gsi 101|100"),
    (PLATE, {"break": HB + "disturbance * 1.5"}, "disturbance 1.5|0 to 1"),
    (PLATE, {"break": HB + "weibull * 0 5"}, "weibull 0|at least 0.1|10 is usual"),
    (PLATE, {"break": HB + "weibull * 0.01 5"}, "weibull 0.01|at least 0.1"),
    (PLATE, {"break": HB + "weibull * 10"}, "weibull|missing"),
    (PLATE, {"break": HB + "weibull * 10 0"}, "seed 0|positive integer"),
    (PLATE, {"break": HB + "weibull * 10 1.5"}, "integer|1.5"),
    (PLATE, {"break": HB + "principal both"}, "both|inplane or all"),
    (PLATE, {"break": HB + "principal"}, "principal|missing"),
    (PLATE, {"break": HB + "weakness 1 2"}, "weakness|use strength"),
    (PLATE, dict(more="fix T all tmsph/heat/boundary"), "tmsph/heat/boundary|missing"),
    (PLATE, dict(more=HEAT + "cold 5"), "cold|temperature"),
    (PLATE, dict(more=HEAT + "temperature"), "missing"),
    (PLATE, dict(more=HEAT + "temperature warm"), "floating point|warm"),
    (PLATE, dict(more=HEAT + "temperature v_nowhere"), "nowhere|define"),
    (PLATE, dict(more="variable T string hot\n" + HEAT + "temperature v_T"),
     "T|equal or atom style"),
    (PLATE, dict(more="variable T equal 1e308*10\n" + HEAT + "temperature v_T"), "inf|variable T"),
    (PLATE, dict(more="variable T equal (1e308*10)-(1e308*10)\n" + HEAT + "temperature v_T"),
     "nan|step 0|variable T"),
    (PLATE, dict(more=HEAT + "temperature 5 where body"), "where|place"),
    (PLATE, dict(more=HEAT + "temperature 5 place"), "place|missing"),
    (PLATE, dict(more=HEAT + "temperature 5 place edge"), "edge|body"),
    (PLATE, dict(more=HEAT + "temperature -1e7", run="run 1"),
     "temperature -10000000|thermal strain|expansion"),
    (PLATE, {"style": "atom_style atomic", "volume": "mass * 1", "pair": "", "coeff": "",
             "break": "", "more": HEAT + "temperature 5"}, "tmsph/heat/boundary|atom_style tmsph"),
    (PLATE, dict(more=BAD), "lacks the conductivity of type 1|add 'conductivity 1 k'"),
    (PLATE, dict(more=BAD + "conductivity * 2.9"), "lacks the specific heat of type 1|add"),
    (PLATE, dict(more=BAD + "conductivity 1 2.9 specific/heat * 850"),
     "conductivity of type 2|add"),
    (PLATE, dict(more=BAD + "conductivity * 0 specific/heat * 850"), "conductivity 0|positive"),
    (PLATE, dict(more=BAD + "conductivity * -2 specific/heat * 850"), "conductivity -2|positive"),
    (PLATE, dict(more=BAD + "conductivity * 2 specific/heat * 0"), "specific/heat 0|positive"),
    (PLATE, dict(more=BAD + "conductivity * good"), "floating point|good"),
    (PLATE, dict(more=BAD + "conductivity *"), "tmsph/heat conductivity|missing"),
    (PLATE, dict(more=BAD + "conductivity * orthotopic 1 2 3"),
     "orthotropic or table for fix tmsph/heat conductivity|orthotopic"),
    (PLATE, dict(more=BAD + "conductivity 3 2.9"),
     "conductivity|'3'|1 to 2|use 'conductivity * value'"),
    (PLATE, dict(more=CONDUCTS + "capacity 5"), "capacity|use conductivity, specific/heat"),
    (PLATE, dict(more=CONDUCTS + "subcycle implicit"), "implicit|subcycle|explicit or rkl2"),
    (PLATE, dict(more=CONDUCTS + "subcycle"), "subcycle|missing"),
    (PLATE, dict(more=CONDUCTS + "time/scale 0"), "time/scale 0|positive"),
    (PLATE, dict(more=CONDUCTS + "every 0"), "every 0|at least 1"),
    (PLATE, dict(more=CONDUCTS + "every 1.5"), "integer|1.5"),
    (PLATE, dict(more=CONDUCTS + "source 1"), "source|missing"),
    (PLATE, dict(more=CONDUCTS + "source 1 v_nowhere"), "nowhere|source|define"),
    (PLATE, dict(more="variable q string hot\n" + CONDUCTS + "source 1 v_q"),
     "q|equal or atom style"),
    (PLATE, dict(more="variable q equal 1e308*10\n" + CONDUCTS + "source 1 v_q"),
     "temperature|no number|step 1|sources"),
    (PLATE, dict(more=CONDUCTS + "subcycle explicit time/scale 1e9"),
     "heat step 10|above the stable one|use 'subcycle rkl2'"),
    (PLATE, dict(more=CONDUCTS + "\nfix two all tmsph/heat conductivity * 1 specific/heat * 1"),
     "More than one fix tmsph/heat|single"),
    (PLATE, dict(more="group some id 1\n"
                      "fix heat some tmsph/heat conductivity * 1 specific/heat * 1"),
     "all particles|group all"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "more": CONDUCTS},
     "tmsph/heat needs pair style"),
    (PLATE, {"style": "atom_style atomic", "volume": "mass * 1", "pair": "", "coeff": "",
             "break": "", "more": CONDUCTS}, "tmsph/heat|atom_style tmsph"),
    (PLATE, dict(more=BAD + "conductivity * orthotropic 1 2"), "orthotropic|missing"),
    (PLATE, dict(more=BAD + "conductivity * orthotropic 1 0 30 specific/heat * 1"),
     "conductivity 0|positive"),
    (CUBE, dict(more=BAD + "conductivity * orthotropic 1 2 3 0 0 0 30 specific/heat * 1"),
     "axis|no length|0 0 1 0"),
    (PLATE, dict(more=BAD + "conductivity 1 orthotropic 1 2 0 conductivity 2 table cloud.data k "
                 "specific/heat * 1", files="k\n0 1\n9 2\n"), "both orthotropic|tables|numbers"),
    (PLATE, dict(more=BAD + "conductivity * table cloud.data"), "table|missing"),
    (PLATE, dict(more=BAD + "conductivity * table nowhere.txt k"), "nowhere.txt"),
    (PLATE, dict(more=TABLE, files="other\n0 1\n"), "cloud.data|no section k"),
    (PLATE, dict(more=TABLE, files="k\n"), "cloud.data|no lines 'temperature value'"),
    (PLATE, dict(more=TABLE, files="k\n0 1\n20 2\n10 3\n"), "ascend|10 comes after 20"),
    (PLATE, dict(more=TABLE, files="k\n0 1\n0 2\n"), "ascend|0 comes after 0"),
    (PLATE, dict(more=TABLE, files="k\n0 1\n20 0\n"), "value 0 at temperature 20|positive"),
    (PLATE, dict(more=TABLE, files="k\n0 1\n20 high\n"), "cloud.data|high"),
    (PLATE, dict(more=TABLE, files="k\n0 1\n20 2 3\n"), "cloud.data|temperature value|20 2 3"),
    (PLATE, dict(more=CONDUCTS + "contact 1 1 -5"), "contact -5|negative"),
    (PLATE, dict(more=CONDUCTS + "contact 1 1"), "contact|missing"),
    (PLATE, dict(more=CONDUCTS + "contact 1 1 5"), "contact|add a fix tmsph/contact"),
    (PLATE, dict(more=CONDUCTS + "friction yes"), "friction|add a fix tmsph/contact"),
    (PLATE, dict(more=HEAT + "flux 5"), "conducts heat|add a fix tmsph/heat"),
    (PLATE, dict(more=HEAT + "temperature 5 place surface"), "conducts heat|add a fix tmsph/heat"),
    (PLATE, dict(more=SKIN + "flux"), "missing"),
    (PLATE, dict(more=SKIN + "convection 5"), "convection|missing"),
    (PLATE, dict(more=SKIN + "convection -5 20"), "Coefficient -5|convection|negative"),
    (PLATE, dict(more=SKIN + "radiation 5e-8 20"), "radiation needs 'zero T'"),
    (PLATE, dict(more=SKIN + "convection 5 20 zero -273"), "convection does not use 'zero T'"),
    (PLATE, dict(more=SKIN + "flux 5 place body"), "flux|surface|remove 'place body'"),
    (PLATE, dict(more=SKIN + "temperature 5 place body area 3"), "place body|area|remove"),
    (PLATE, dict(more=SKIN + "flux 5 area 0"), "area 0|positive"),
    (PLATE, dict(more=SKIN + "flux 5 area"), "area|missing"),
    (PLATE, dict(more=SKIN + "flux 5 facing 0 1"), "facing|missing"),
    (PLATE, dict(more=SKIN + "flux 5 facing 0 up 0"), "floating point|up"),
    (PLATE, dict(more=SKIN + "flux 5 facing 0 0 1"), "facing 0 0 1|no length"),
    (PLATE, dict(more=SKIN + "temperature 5 place body facing 0 1 0"), "place body|facing|remove"),
    (PLATE, dict(more=SKIN + "flux 5 region nowhere"), "Region nowhere|define"),
    (PLATE, dict(more=SKIN + "flux 5 cracks perhaps"), "perhaps"),
    (PLATE, dict(more="group none empty\n" + CONDUCTS + "\nfix T none tmsph/heat/boundary flux 5"),
     "Group none|no particle at a surface|place body"),
    (PLATE, dict(more="region mid block 3.9e-3 4.1e-3 3.9e-3 4.1e-3 INF INF units box\n"
                      "group mid region mid\n"
                 + CONDUCTS + "\nfix T mid tmsph/heat/boundary flux 5"),
     "Group mid|no particle at a surface|place body"),
    (PLATE, dict(more="variable q atom 1e308*x*1e10\n" + SKIN + "flux v_q"), "Flux|inf|variable q"),
    (PLATE, dict(more="variable q string hot\n" + SKIN + "flux v_q"), "q|equal or atom style"),
    (PLATE, dict(more="tmsph/cut"), "tmsph/cut|missing"),
    (PLATE, dict(more=CUT), "tmsph/cut|missing"),
    (PLATE, dict(space="tmsph/cut all line 0 0 1 1"), "tmsph/cut before the simulation box"),
    (PLATE, dict(more="tmsph/cut some line 0 0 1 1"), "some|define"),
    (PLATE, dict(more=CUT + "wedge 1 2 3"), "wedge|line or arc"),
    (PLATE, dict(more=CUT + "disc 0 0 0 0 0 1 1"), "disc|dimension 3|line or arc"),
    (PLATE, dict(more=CUT + "polygon 3 0 0 0 1 0 0 0 1 0"), "polygon|dimension 3|line or arc"),
    (CUBE, dict(more=CUT + "line 0 0 1 1"), "line|dimension 2|disc or polygon"),
    (CUBE, dict(more=CUT + "arc 0 0 1 0 90"), "arc|dimension 2|disc or polygon"),
    (PLATE, dict(more=CUT + "line 0 0 1"), "tmsph/cut line|missing"),
    (PLATE, dict(more=CUT + "line 0 0 1 x"), "floating point|x"),
    (PLATE, dict(more=CUT + "line 0 0 1 1 2"), "2|line|4"),
    (PLATE, dict(more=CUT + "line 1 1 1 1"), "line|no length|different"),
    (PLATE, dict(more=CUT + "arc 0 0 0 0 90"), "Radius 0|positive"),
    (PLATE, dict(more=CUT + "arc 0 0 1e-3 90 0"), "90 to 0|larger"),
    (PLATE, dict(more=CUT + "arc 0 0 1e-3 0 400"), "0 to 400|360"),
    (CUBE, dict(more=CUT + "disc 0 0 0 0 0 0 1"), "normal|zero"),
    (CUBE, dict(more=CUT + "disc 0 0 0 0 0 1 -1"), "Radius -1|positive"),
    (CUBE, dict(more=CUT + "polygon 2 0 0 0 1 1 1"), "at least 3 corners|2"),
    (CUBE, dict(more=CUT + "polygon 3 0 0 0 1 1 1 2 2 2"), "no area"),
    (CUBE, dict(more=CUT + "polygon 4 0 0 0 1 0 0 1 1 0 0 1 1"), "not flat|triangles"),
    (CUBE, dict(more=CUT + "polygon 4 0 0 0 1 0 0 1 1 0"), "polygon|missing"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "more": CUT + "line 0 0 1 1"},
     "tmsph/cut needs pair style tmsph"),
    (PLATE, dict(coeff="", more=CUT + "line 0 0 1 1"), "pair coeff"),
    (PLATE, dict(more="tmsph/relax"), "tmsph/relax|missing"),
    (PLATE, dict(more="tmsph/relax all"), "tmsph/relax|missing"),
    (PLATE, dict(space="tmsph/relax all region 1"), "tmsph/relax before the simulation box"),
    (PLATE, dict(more="tmsph/relax some region box"), "some|define"),
    (PLATE, dict(more="group none empty\ntmsph/relax none region box"),
     "Group none of tmsph/relax has no particles"),
    (PLATE, dict(more="tmsph/relax all push 10"), "give 'region ID'"),
    (PLATE, dict(more="tmsph/relax all regions box"), "regions|perhaps 'region'"),
    (PLATE, dict(more=RELAX), "tmsph/relax region|missing"),
    (PLATE, dict(more=RELAX + "nowhere"), "region nowhere|define"),
    (PLATE, dict(more=RELAX + "box region box"), "region box|twice"),
    (PLATE, dict(more=RELAX + "box push -1"), "push -1|negative"),
    (PLATE, dict(more=RELAX + "box balance many"), "integer|many"),
    (PLATE, dict(more=RELAX + "box thickness 0"), "thickness 0|positive"),
    (CUBE, dict(more=RELAX + "box thickness 1"), "thickness|dimension 2"),
    (PLATE, dict(more="region r block 0 2e-3 0 2e-3 -1 1 units box open 1\n" + RELAX + "r"),
     "region r has open faces|without 'open'"),
    (PLATE, dict(more="region r block INF 2e-3 0 2e-3 -1 1 units box\n" + RELAX + "r"),
     "Region r|no surface in x|not periodic"),
    (PLATE, dict(more="region r sphere 2e-3 2e-3 0 1e-3 side out units box\n" + RELAX + "r"),
     "Region r|no surface in x|not periodic"),
    (PLATE, dict(more="region r block 90 91 0 1 -1 1\n" + RELAX + "r"),
     "Region r|no particles of the group"),
    (PLATE, dict(more="region r sphere 2e-3 2e-3 0 1.5e-3 units box\n" + RELAX + "box region r"),
     "Regions box and r|overlap|side out"),
    (PLATE, dict(more="create_atoms 1 single 2e-3 2e-3 0 units box\n"
                      "create_atoms 1 single 2e-3 2e-3 0 units box\nset group all volume 1e-6\n"
                 + RELAX + "box"), "same place|delete_atoms overlap"),
    (PLATE, dict(more="create_atoms 1 single 2.5e-3 2.1e-3 0 units box\n" + RELAX + "box"),
     "has a volume|has none"),
    (PLATE, dict(pair="pair_style tmsph 0.5", skin="", more=RELAX + "box"),
     "Horizon 0.5|spacings|region box|give about 3"),
    (PLATE, dict(more="run 0\n" + RELAX + "box"), "after the bonds have formed|before"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "more": RELAX + "box"},
     "tmsph/relax needs pair style tmsph"),
    (PLATE, dict(coeff="", more=RELAX + "box"), "needs pair style tmsph and its coefficients"),
    (PLATE, dict(more="compute p all tmsph/property/atom"), "tmsph/property/atom|missing"),
    (PLATE, dict(more="compute p all tmsph/property/atom ux spin"), "spin|use ux"),
    (PLATE, {"break": "", "more": "compute p all tmsph/property/atom strength"},
     "strength|needs a fix that breaks bonds|tmsph/hoekbrown"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "more": "compute p all tmsph/property/atom ux"},
     "tmsph/property/atom needs pair style tmsph"),
    (PLATE, dict(more=CONTACT + "rough 1"), "rough|use friction, law, method, self, "
                                            "stiffness or surface"),
    (PLATE, dict(more=CONTACT + "law"), "tmsph/contact law|missing"),
    (PLATE, dict(more=CONTACT + "law hertz"), "'hertz'|contact law|use implicit, penalty or paper"),
    (PLATE, dict(more=CONTACT + "method"), "tmsph/contact method|missing"),
    (PLATE, dict(more=CONTACT + "method nodes"), "'nodes'|contact method|use kernel or segment"),
    (CUBE, dict(more=CONTACT + "method segment"), "method segment|dimension 2|method kernel"),
    (PERIODIC, dict(more=CONTACT + "method segment"),
     "ghost cutoff|method segment|comm_modify cutoff"),
    (PLATE, dict(more="region r sphere 0 0 0 1\n" + CONTACT + "method segment surface r"),
     "surface|method kernel|method segment"),
    (PLATE, dict(more=CONTACT + "friction * *"), "tmsph/contact friction|missing"),
    (PLATE, dict(more=CONTACT + "friction * * -0.1"), "friction -0.1|negative"),
    (PLATE, dict(more=CONTACT + "friction * * nan"), "floating point|nan"),
    (PLATE, dict(more=CONTACT + "friction * * high"), "floating point|high"),
    (PLATE, dict(more=CONTACT + "friction 1 3 0.5"), "friction|'3'|1 to 2|use 'friction * * mu'"),
    (PLATE, dict(more=CONTACT + "friction 0.3"), "tmsph/contact friction I J mu|missing"),
    (PLATE, dict(more=BAD + "conductivity 2.9 specific/heat 850"),
     "conductivity|'2.9'|use 'conductivity * value'"),
    (PLATE, dict(more=CONDUCTS + "contact 1 3 2000"), "contact|'3'|use 'contact * * h'"),
    (PLATE, dict(more=CONTACT + "surface"), "tmsph/contact surface|missing"),
    (PLATE, dict(more=CONTACT + "surface nowhere"), "Region nowhere|does not exist|define it"),
    (PLATE, dict(more="variable go equal step\nregion gone sphere 0 0 0 1 move v_go NULL NULL\n"
                      + CONTACT + "surface gone"), "Region gone|moves|reference positions"),
    (PLATE, dict(more=CONTACT + "self"), "tmsph/contact self|missing"),
    (PLATE, dict(more=CONTACT + "self perhaps"), "perhaps"),
    (PLATE, dict(more=CONTACT + "stiffness 0"), "stiffness 0|positive|factor"),
    (PLATE, dict(more=CONTACT + "stiffness -1"), "stiffness -1|positive"),
    (PLATE, dict(more=CONTACT + "\nfix two all tmsph/contact"),
     "More than one fix tmsph/contact|single"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "more": CONTACT},
     "tmsph/contact needs pair style"),
    (PLATE, dict(more=WALL), "tmsph/wall|missing"),
    (PLATE, dict(more=WALL + "circle 0 0 1"), "circle|2-D|line, polyline or arc"),
    (PLATE, dict(more=WALL + "plane 0 0 0 0 1 0"), "plane|2-D|line, polyline or arc"),
    (CUBE, dict(more=WALL + "line 0 0 1 1"), "line|3-D|plane"),
    (PLATE, dict(more=WALL + "line 0 0 1"), "tmsph/wall line|missing"),
    (PLATE, dict(more=WALL + "line 0 0 1 up"), "floating point|up"),
    (PLATE, dict(more=WALL + "line 1 1 1 1"), "Points 1 and 2|the same"),
    (PLATE, dict(more=WALL + "polyline"), "polyline|missing"),
    (PLATE, dict(more=WALL + "polyline 1 0 0"), "1 points|at least 2"),
    (PLATE, dict(more=WALL + "polyline 3 0 0 1 1 2"), "polyline|missing"),
    (PLATE, dict(more=WALL + "polyline 3 0 0 1 1 1 1"), "Points 2 and 3|the same"),
    (PLATE, dict(more=WALL + "polyline file nowhere.txt"), "nowhere.txt"),
    (PLATE, dict(more=WALL + "polyline file cloud.data", files="0 0\n1 0 0\n"),
     "cloud.data|1 0 0|two numbers"),
    (PLATE, dict(more=WALL + "polyline file cloud.data", files="0 0\n"),
     "cloud.data|less than 2 points"),
    (PLATE, dict(more=WALL + "polyline file cloud.data", files="0 0\n1 x\n"), "cloud.data|x"),
    (PLATE, dict(more=WALL + "arc 0 0 0 0 90"), "Radius 0|positive"),
    (PLATE, dict(more=WALL + "arc 0 0 1 90 90"), "arc|no length|90"),
    (CUBE, dict(more=WALL + "plane 0 0 0 0 0 0"), "normal|no length"),
    (PLATE, dict(more=LINE + "rough 1"), "rough|use friction, side, velocity"),
    (PLATE, dict(more=LINE + "friction -1"), "friction -1|negative"),
    (PLATE, dict(more=LINE + "friction nan"), "floating point|nan"),
    (PLATE, dict(more=LINE + "friction"), "friction|missing"),
    (PLATE, dict(more=LINE + "stiffness 0"), "stiffness 0|positive|factor"),
    (PLATE, dict(more=LINE + "side left"), "left|one or both"),
    (PLATE, dict(more=LINE + "law hard"), "hard|implicit, penalty or paper"),
    (PLATE, dict(more=LINE + "velocity 1"), "velocity|missing"),
    (PLATE, dict(more=LINE + "velocity 1 fast"), "floating point|fast"),
    (PLATE, dict(more=LINE + "velocity v_nowhere 0"), "nowhere|define"),
    (PLATE, dict(more="variable V atom x\n" + LINE + "velocity 0 v_V"), "V|equal style"),
    (PLATE, dict(more="variable V equal 1e308*10\n" + LINE + "velocity 0 v_V"), "V|inf|step 0"),
    (PLATE, dict(more=LINE + "rotation 0 0"), "rotation|missing"),
    (CUBE, dict(more=WALL + "plane 0 0 0 0 0 1 rotation 0 0 0 0 0 0 1"), "axis|no length"),
    (PLATE, dict(more=LINE + "load NULL -1"), "load|missing"),
    (PLATE, dict(more=LINE + "load NULL up mass 1"),
     "floating point number, NULL or v_name for fix tmsph/wall load|up"),
    (PLATE, dict(more=LINE + "load NULL NULL mass 1"), "NULL|at least one"),
    (PLATE, dict(more=LINE + "load NULL -1 weight 1"), "mass|2 components|weight"),
    (PLATE, dict(more=LINE + "load NULL -1 mass 0"), "mass 0|positive"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "more": LINE}, "tmsph/wall needs pair style"),
    (PLATE, {"style": "atom_style atomic", "volume": "mass * 1", "pair": "", "coeff": "",
             "break": "", "more": LINE}, "tmsph/wall|atom_style tmsph"),
    (PLATE, dict(more="compute c all tmsph/crack 5"), "5|tmsph/crack|none"),
    (PLATE, dict(more=TIP), "tmsph/crack/tip direction|missing"),
    (PLATE, dict(more=TIP + "up"), "up|tmsph/crack/tip|use x, -x"),
    (PLATE, dict(more=TIP + "1 0"), "tmsph/crack/tip direction|missing"),
    (PLATE, dict(more=TIP + "1 0 up"), "floating point|tmsph/crack/tip|up"),
    (PLATE, dict(more=TIP + "0 0 0"), "tmsph/crack/tip direction 0 0 0|length"),
    (PLATE, dict(more=TIP + "inf 0 0"), "inf|tmsph/crack/tip|use x"),
    (PLATE, dict(more=TIP + "z"), "tmsph/crack/tip direction 0 0 1|plane|z must be 0"),
    (PLATE, dict(more=TIP + "x part 1"), "part|tmsph/crack/tip|use open"),
    (PLATE, dict(more=TIP + "x open"), "tmsph/crack/tip open|missing"),
    (PLATE, dict(more=TIP + "x open 0"), "tmsph/crack/tip open 0|above 0"),
    (PLATE, dict(more=TIP + "x open 1.5"), "tmsph/crack/tip open 1.5|at most 1"),
    (PLATE, dict(more=TIP + "x cut maybe"), "boolean|maybe"),
    (PLATE, dict(more=TIP + "x window 1"), "tmsph/crack/tip window 1|small|2 to 100000"),
    (PLATE, dict(more=TIP + "x window 1000000"), "tmsph/crack/tip window 1000000|large"),
    (PLATE, dict(more=TIP + "x window ten"), "integer|tmsph/crack/tip window|ten"),
    (PLATE, dict(style="atom_style tmsph\n" + TIP + "x"),
     "tmsph/crack/tip before the simulation box"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "more": TIP + "x"},
     "tmsph/crack/tip needs pair style tmsph"),
    (PLATE, dict(more="compute d all tmsph/dt 5"), "5|tmsph/dt|none"),
    (PLATE, dict(more="compute b all tmsph/bond/local"), "tmsph/bond/local|missing"),
    (PLATE, dict(more="compute b all tmsph/bond/local id1 age"), "age|use id1"),
    (PLATE, dict(more="compute b all tmsph/bond/local id1 only bent"), "bent|use all"),
    (PLATE, dict(more="compute b all tmsph/bond/local id1 only"), "only|missing"),
    (PLATE, dict(more="compute w all tmsph/wall/local"),
     "tmsph/wall/local|needs a fix tmsph/wall"),
    (PLATE, dict(more="compute w all tmsph/wall/local id"), "tmsph/wall/local|no words|id"),
    (PLATE, dict(style="atom_style tmsph\ncompute w all tmsph/wall/local"),
     "tmsph/wall/local before the simulation box"),
    (PLATE, dict(run="tmsph/quasistatic"), "tmsph/quasistatic|missing"),
    (PLATE, dict(run=QUASI + "ten"), "integer|ten"),
    (PLATE, dict(run=QUASI + "-5"), "-5|tmsph/quasistatic|negative"),
    (PLATE, dict(run=QUASI + "10 charge 1"), "charge|tmsph/quasistatic|use change"),
    (PLATE, dict(run=QUASI + "10 change"), "tmsph/quasistatic change|missing"),
    (PLATE, dict(run=QUASI + "10 change 0"), "tmsph/quasistatic change 0|positive"),
    (PLATE, dict(run=QUASI + "10 residual 0"), "tmsph/quasistatic residual 0|positive"),
    (PLATE, dict(run=QUASI + "10 residual 1e-4 -1e-3"), "tmsph/quasistatic residual|positive"),
    (PLATE, dict(run=QUASI + "10 breaking 1.5"), "tmsph/quasistatic breaking 1.5|at most"),
    (PLATE, dict(run=QUASI + "10 jump far"), "boolean|far"),
    (PLATE, dict(run=QUASI + "10 stride 0"), "tmsph/quasistatic stride 0|wall"),
    (PLATE, dict(run=QUASI + "10 evaluations 0"), "tmsph/quasistatic evaluations 0|most"),
    (PLATE, dict(space=QUASI + "10"), "tmsph/quasistatic before the simulation box"),
    (PLATE, {"pair": "", "coeff": "", "break": "", "run": QUASI + "10"},
     "tmsph/quasistatic needs pair style tmsph"),
    (PLATE, dict(more="fix m all move linear 1 0 0", run=QUASI + "10"),
     "Fix m|move|setforce|displace_atoms"),
    (PERIODIC, dict(more="fix d all deform 1 x erate 1", run=QUASI + "10"),
     "Fix d|deform|box|tmsph/quasistatic"),
    (PLATE, dict(more=LINE + "load 0 1 mass 1", run=QUASI + "10"),
     "tmsph/wall wall|load|tmsph/quasistatic|velocity"),
    (PLATE, dict(run="min_style tmsph/lbfgs\nmin_modify memory 0" + MINIMIZE), "memory 0|1 to 100"),
    (PLATE, dict(run="min_style tmsph/lbfgs\nmin_modify memory"), "min_modify memory|missing"),
    (PLATE, dict(run="min_style tmsph/lbfgs\nmin_modify dmax -1" + MINIMIZE), "dmax -1|positive"),
    (PERIODIC, dict(more="fix b all box/relax x 0", run="min_style tmsph/lbfgs" + MINIMIZE),
     "tmsph/lbfgs|box/relax"),
]


def check(report, scene, changes, words):
    files = {"cloud.data": changes["files"]} if "files" in changes else {}
    sections = dict(scene, **changes)
    sections.pop("files", None)
    run = script(sections, files).run(may_fail=True)
    errors = complaints(run, "ERROR")
    good = 0 < run.status < 128 and tells(errors, words)
    changed = "; ".join(text for key, text in changes.items() if key != "files").replace("\n", "; ")
    said = errors[0].partition("(/")[0] if len(errors) == 1 else f"{len(errors)} errors"
    report.true(changed, good, f"{said}, status {run.status}" if not good else said)


def equal_ids(report):
    """A data file that gives the particles of two corners the same id, on any number of
    processors."""
    data = script(dict(PLATE, run="run 0\nwrite_data out.data")).run(keep="out.data")
    lines = data.kept["out.data"].decode().split("Velocities")[0].splitlines()
    lines = ["64" + line[1:] if re.match("1 1 ", line) else line for line in lines]
    wrong = {"cloud.data": "\n".join(lines) + "\n"}
    scene = dict(PLATE, volume="", **NO_BOX)
    for ranks in (1, 3):
        run = script(scene, wrong).run(ranks, may_fail=True)
        errors = complaints(run, "ERROR")
        report.true(f"two particles with the same id, {ranks} processes",
                    len(errors) == 1 and re.search("have the id 64:.*reset_atoms id", errors[0])
                    and 0 < run.status < 128, errors[:1])
        scene["atoms"] = NO_BOX["atoms"] + "\nreset_atoms id"
        run = script(scene, wrong).run(ranks)
        report.true("and its remedy", run.thermo("Step")[-1] == 10, "a run of 10 steps")
        scene["atoms"] = NO_BOX["atoms"]


def other_versions(report):
    """Restart files whose records have the number of another format, one at a time."""
    fixes = "\n".join([CONTACT, LINE, CONDUCTS, HB])
    scene = dict(PLATE, run="run 1\nwrite_restart r", more=fixes)
    scene["break"] = ""
    data = script(scene).run(keep="r").kept["r"]
    formats = [struct.pack("<d", number) for number in range(2, 10)]
    places = [at for at in range(4, len(data) - 8) if data[at:at + 8] in formats
              and struct.unpack("<i", data[at - 4:at])[0] in range(24, 1000, 8)]
    refused = {}
    settings = re.search(rb"\x03\0{7}\d[^\0]{1,14}\0+" + struct.pack("<d", 3.015e-3), data).start()
    for at, other in [(settings, struct.pack("<i", 1))] + [(at, struct.pack("<d", 1.0))
                                                           for at in places]:
        file = data[:at] + other + data[at + len(other):]
        run = Script("read_restart r\n" + fixes + "\nrun 1", {"r": file}).run(may_fail=True)
        errors = complaints(run, "ERROR")
        named = re.search("written by another version of (.*): continue with that version", run.log)
        if len(errors) == 1 and named and 0 < run.status < 128:
            refused[at] = named[1]
    for style in ("contact", "wall", "heat", "hoekbrown"):
        report.true(f"a restart of another version of fix tmsph/{style}",
                    f"fix tmsph/{style}" in refused.values(), "is refused")
    report.true("and of pair style tmsph", list(refused.values()).count("pair style tmsph") == 2,
                "settings and bonds are refused")


def unchanged(report):
    works = [script(scene).run() for scene in (PLATE, CUBE, PERIODIC)]
    report.true("the scenes work unchanged", all(run.thermo("Step")[-1] == 10 for run in works),
                "a run of 10 steps")


def mistaken(report):
    for case in CASES:
        check(report, *case)


if __name__ == "__main__":
    main(unchanged, mistaken, equal_ids, other_versions)
