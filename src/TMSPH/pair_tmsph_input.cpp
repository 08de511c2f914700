/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What pair style tmsph reads: its keywords, coefficients and restarts.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "citeme.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "tmsph_doubts.h"
#include "tmsph_faces.h"
#include "tmsph_last_force.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace TMSPH;

static const char CITE_TMSPH[] =
    "pair_style tmsph command: doi:10.1007/s00603-021-02737-z\n\n"
    "@Article{Mu2022,\n"
    " author = {Mu, Dianrui and Zhang, Dongyu and Tang, Aiping and Qu, Haigang and Li, Zhiming},\n"
    " title = {Numerical Simulation of Rock Thermal Fracture Considering Friction Effect in the "
    "Framework of Smooth Particle Hydrodynamics Based on Total {L}agrangian Formula},\n"
    " journal = {Rock Mechanics and Rock Engineering},\n"
    " year = {2022},\n"
    " volume = {55},\n"
    " pages = {1663--1685}\n"
    "}\n\n";

/* ---------------------------------------------------------------------- */

PairTMSPH::PairTMSPH(LAMMPS *lmp) :
    Pair(lmp), TMSPHMaterials(lmp), TMSPHNotes(lmp), the_box(lmp), ghosts(lmp, this),
    rows(lmp, ghosts, the_box), averaging(lmp, *this, ghosts),
    coupling(lmp, *this, averaging, ghosts), pressed(lmp, *this, ghosts),
    run_report(lmp, *this, *this, *this)
{
  if (lmp->citeme) lmp->citeme->add(CITE_TMSPH);
  single_enable = 0;
  writedata = 0;
  manybody_flag = 1;
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;

  // LAMMPS's default minimizer judges steps by energies, to 1e-8 energy units, which is far too
  // coarse for what is not atoms. A min_style of the input comes later and stays.

  char *style = (char *) "tmsph/lbfgs";
  if (strcmp(update->minimize_style, "cg") == 0 && update->minimize_map->count(style))
    update->create_minimize(1, &style, 0);
}

/* ---------------------------------------------------------------------- */

PairTMSPH::~PairTMSPH()
{
  if (modify->nfix && modify->get_fix_by_id(FixTMSPHBond::ID)) modify->delete_fix(FixTMSPHBond::ID);
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::allocate()
{
  allocated = 1;
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) setflag[i][j] = 0;
  allocate_materials();
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::settings(int narg, char **arg)
{
  chosen.read(lmp, narg, arg);
  run_report.forget_timestep();
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::coeff(int narg, char **arg)
{
  if (narg < 3) utils::missing_cmd_args(FLERR, "pair_coeff for pair style tmsph", error);
  if (!allocated) allocate();
  run_report.forget_timestep();
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);

  const auto bond = [=](bool bonds) {
    for (int i = ilo; i <= ihi; i++)
      for (int j = jlo; j <= jhi; j++)
        if (i != j) {
          set_bonded(i, j, bonds);
          setflag[std::min(i, j)][std::max(i, j)] = 1;
        } else if (!bonds && ilo == ihi && jlo == jhi)
          error->all(FLERR,
                     "Pair_coeff {} {} none would leave a material without bonds: give 'none' to "
                     "two different types",
                     i, j);
  };
  const auto elastic = [=](TMSPHValues &values) {
    const Material m = read_material(values);
    int count = 0;
    for (int i = std::max(ilo, jlo); i <= std::min(ihi, jhi); i++) {
      set_material(i, m);
      setflag[i][i] = 1;
      count++;
    }
    if (!count)
      error->all(FLERR,
                 "Pair_coeff {} {} elastic: a material belongs to one type, give it as 'pair_coeff "
                 "{} {} elastic'; between types use 'bonded' or 'none'",
                 arg[0], arg[1], arg[0], arg[0]);
  };
  TMSPHWords(lmp, "pair_coeff I J",
             {{"elastic", "E nu [keywords]", elastic},
              {"bonded", "", [&](TMSPHValues &) { bond(true); }},
              {"none", "", [&](TMSPHValues &) { bond(false); }}})
      .read_only(arg + 2, arg + narg);
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::init_style()
{
  if (!utils::strmatch(atom->get_style(), "^tmsph"))
    error->all(FLERR, "Pair style tmsph needs 'atom_style tmsph', not '{}'", atom->get_style());
  if (domain->triclinic)
    error->all(FLERR, "Pair style tmsph needs an orthogonal box: the box is triclinic");
  // forces are pressure times area, accelerations are force over mass: no factors between
  if (force->nktv2p != 1.0 || force->ftm2v != 1.0)
    error->all(FLERR,
               "Pair style tmsph cannot use units {}, whose pressure is not a force over an area: "
               "use si, cgs, micro, nano or lj",
               update->unit_style);
  if (domain->dimension == 3 && chosen.plane == Plane::STRESS)
    error->all(FLERR, "Pair_style tmsph plane stress needs dimension 2: remove it in 3-D");

  if (neighbor->skin > horizon() && comm->me == 0)
    error->warning(FLERR,
                   "The neighbor skin {} is longer than the horizon {}: lists and ghosts are "
                   "needlessly many; set for instance 'neighbor {:.2g} bin'",
                   neighbor->skin, horizon(), 0.3 * horizon());    // 0.3 sigma is usual in LAMMPS

  init_materials(setflag);
  on.law = chosen.law;
  averaging.init();
  coupling.init();
  pressed.init();
  on.thermal = expands() ? chosen.thermal : ThermalStrain::NONE;
  on.hourglass = chosen.hourglass > 0.0;
  on.viscosity = viscous();
  viscosity.alpha1 = chosen.alpha1;
  viscosity.alpha2 = chosen.alpha2;
  viscosity.smoothing_length = horizon() / support_in_smoothing_lengths(chosen.kernel);
  comm_forward = domain->dimension == 2 ? Rows<2>::FORCE : Rows<3>::FORCE;    // the longest
  prepared.forget();
  forget_participants();

  bond_fix = dynamic_cast<FixTMSPHBond *>(modify->get_fix_by_id(FixTMSPHBond::ID));
  if (!bond_fix)
    bond_fix = dynamic_cast<FixTMSPHBond *>(
        modify->add_fix(fmt::format("{} all tmsph/bond", FixTMSPHBond::ID)));
  if (!bond_fix->formed()) check_reach(lmp, horizon());
  complete_particles(bond_fix->formed());
  the_box.init();
  TMSPHFaces::provide(lmp);
  TMSPHLastForce::put_last(lmp);
}

/* ---------------------------------------------------------------------- */

double PairTMSPH::init_one(int /*i*/, int /*j*/)
{
  return horizon();
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::write_restart_settings(FILE *fp)
{
  chosen.write_restart(fp);
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::read_restart_settings(FILE *fp)
{
  chosen.read_restart(lmp, fp);
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  write_materials(fp, setflag);
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  read_materials(fp, setflag);
}
