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
#include "fix_tmsph_bond.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "tmsph_last_force.h"
#include "tmsph_restart.h"
#include "tmsph_version.h"
#include "update.h"

#include <algorithm>
#include <cmath>
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

// grows when what restart files hold of this style changes

static constexpr int RESTART_FORMAT = 3;

// with the zeros behind it

static constexpr int VERSION_LENGTH = 16;
static_assert(sizeof(VERSION) <= VERSION_LENGTH, "the version fits into restart files");

/* ---------------------------------------------------------------------- */

PairTMSPH::PairTMSPH(LAMMPS *lmp) :
    Pair(lmp), cutoff(0.0), kernel(WendlandC2()), plane(Plane::STRAIN),
    thermal_mode(ThermalStrain::BOND), hourglass(0.1), dilatation(Dilatation::AUTO),
    bond_fix(nullptr),
    coefficients(0), coefficients_at_estimate(-1), bonds_at_estimate(0),
    mass_at_estimate(0.0), stiffness_at_estimate(0.0), stable_dt(0.0), intact_dt(0.0),
    reported(false), reported_timestep(false), stepped(false), box_moves(false), the_box(lmp),
    prepared_version(-1), averaging(false), coupling(false),
    what_to_send(FORCE_ROWS)
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
  if (modify->nfix && modify->get_fix_by_id(FixTMSPHBond::ID))
    modify->delete_fix(FixTMSPHBond::ID);
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
  materials.assign(n, Material());
  are_bonded.assign(n, std::vector<char>(n, 1));
}

/* ----------------------------------------------------------------------
   looks a word up in a table, or stops with the words that would do
------------------------------------------------------------------------- */

template <class T>
static T one_of(Error *error, const char *keyword, const char *word,
                const std::vector<std::pair<std::string, T>> &table)
{
  std::string known;
  for (const auto &[name, value] : table) {
    if (name == word) return value;
    known += (known.empty() ? "" : " or ") + name;
  }
  error->all(FLERR, "Unknown value '{}' of pair_style tmsph {}: use {}", word, keyword, known);
  return T();
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::settings(int narg, char **arg)
{
  if (narg < 1) utils::missing_cmd_args(FLERR, "pair_style tmsph", error);
  cutoff = utils::numeric(FLERR, arg[0], false, lmp);
  coefficients++;
  if (cutoff <= 0.0)
    error->all(FLERR, "Horizon {} of pair_style tmsph must be positive: about 3 particle spacings",
               arg[0]);
  kernel = WendlandC2();
  plane = Plane::STRAIN;
  thermal_mode = ThermalStrain::BOND;
  on.law = StVenantKirchhoff();
  hourglass = 0.1;
  dilatation = Dilatation::AUTO;
  viscosity = Viscosity();

  for (int iarg = 1; iarg < narg;) {
    const std::string word = arg[iarg];
    const int values = word == "viscosity" ? 2 : 1;
    const auto known = {"kernel",    "plane",     "law",       "thermal",
                        "hourglass", "viscosity", "dilatation"};
    if (std::find(known.begin(), known.end(), word) == known.end())
      error->all(FLERR,
                 "Unknown pair_style tmsph keyword '{}': use kernel, plane, law, hourglass, "
                 "viscosity, thermal or dilatation",
                 word);
    if (iarg + values >= narg) utils::missing_cmd_args(FLERR, "pair_style tmsph " + word, error);
    const char *value = arg[iarg + 1];
    if (word == "kernel")
      kernel = one_of<Kernel>(error, "kernel", value, kernels());
    else if (word == "plane")
      plane =
          one_of<Plane>(error, "plane", value,
                        {{"strain", Plane::STRAIN}, {"stress", Plane::STRESS}});
    else if (word == "law")
      on.law = one_of<ElasticLaw>(error, "law", value, alternatives<ElasticLaw>());
    else if (word == "thermal")
      thermal_mode = one_of<ThermalStrain>(
          error, "thermal", value,
          {{"bond", ThermalStrain::BOND}, {"strain", ThermalStrain::CONSTITUTIVE}});
    else if (word == "dilatation")
      dilatation = one_of<Dilatation>(error, "dilatation", value,
                                      {{"auto", Dilatation::AUTO},
                                       {"plain", Dilatation::PLAIN},
                                       {"averaged", Dilatation::AVERAGED}});
    else if (word == "hourglass") {
      hourglass = utils::numeric(FLERR, value, false, lmp);
      if (hourglass < 0.0)
        error->all(FLERR, "Pair_style tmsph hourglass {} must not be negative: 0.1 is usual",
                   value);
    } else {
      viscosity.alpha1 = utils::numeric(FLERR, value, false, lmp);
      viscosity.alpha2 = utils::numeric(FLERR, arg[iarg + 2], false, lmp);
      if (viscosity.alpha1 < 0.0 || viscosity.alpha2 < 0.0)
        error->all(FLERR, "Pair_style tmsph viscosity {} {} must not be negative: 1 2 is usual",
                   value, arg[iarg + 2]);
    }
    iarg += 1 + values;
  }
}

/* ----------------------------------------------------------------------
   pair_coeff I I elastic E nu density rho [expansion alpha] [reference T0] [horizon delta]
   pair_coeff I J bonded|none
------------------------------------------------------------------------- */

void PairTMSPH::coeff(int narg, char **arg)
{
  if (narg < 3) utils::missing_cmd_args(FLERR, "pair_coeff for pair style tmsph", error);
  if (!allocated) allocate();
  coefficients++;
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);

  const std::string what = arg[2];
  if (what == "bonded" || what == "none") {
    if (narg > 3)
      error->all(FLERR, "Unexpected word '{}' after pair_coeff ... {}: remove it", arg[3], what);
    for (int i = ilo; i <= ihi; i++)
      for (int j = jlo; j <= jhi; j++)
        if (i != j) {
          are_bonded[i][j] = are_bonded[j][i] = what == "bonded";
          setflag[std::min(i, j)][std::max(i, j)] = 1;
        } else if (what == "none" && ilo == ihi && jlo == jhi)
          error->all(FLERR,
                     "Pair_coeff {} {} none would leave a material without bonds: give 'none' to "
                     "two different types",
                     i, j);
    return;
  }
  if (what != "elastic")
    error->all(FLERR,
               "Unknown word '{}' in pair_coeff for pair style tmsph: use 'elastic E nu density "
               "rho', 'bonded' or 'none'",
               what);
  if (narg < 5) utils::missing_cmd_args(FLERR, "pair_coeff ... elastic", error);

  Material m;
  m.young = utils::numeric(FLERR, arg[3], false, lmp);
  m.poisson = utils::numeric(FLERR, arg[4], false, lmp);
  for (int iarg = 5; iarg < narg; iarg += 2) {
    const std::string word = arg[iarg];
    double *value = word == "density" ? &m.density
        : word == "expansion"         ? &m.expansion
        : word == "reference"         ? &m.reference_temperature
        : word == "horizon"           ? &m.horizon
                                      : nullptr;
    if (!value)
      error->all(FLERR,
                 "Unknown keyword '{}' in pair_coeff ... elastic: use density, expansion, "
                 "reference or horizon",
                 word);
    if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "pair_coeff ... elastic " + word, error);
    *value = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    if (value == &m.horizon && !(m.horizon > 0.0 && m.horizon <= cutoff))
      error->all(FLERR, "Horizon {} in pair_coeff must be positive and not above that of "
                        "pair_style tmsph, {}: give the largest there", arg[iarg + 1], cutoff);
  }
  if (m.young <= 0.0)
    error->all(FLERR, "Young's modulus {} in pair_coeff must be positive", arg[3]);
  if (m.poisson <= -1.0 || m.poisson >= 0.5)
    error->all(FLERR, "Poisson's ratio {} in pair_coeff must lie between -1 and 0.5", arg[4]);
  if (m.density <= 0.0)
    error->all(FLERR,
               "Density {} in pair_coeff ... elastic must be positive: add 'density rho' with the "
               "density at rest",
               m.density);

  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = std::max(jlo, i); j <= jhi; j++)
      if (i == j) {
        materials[i] = m;
        setflag[i][i] = 1;
        count++;
      }
  if (!count)
    error->all(FLERR,
               "Pair_coeff {} {} elastic: a material belongs to one type, give it as 'pair_coeff "
               "{} {} elastic'; between types use 'bonded' or 'none'",
               arg[0], arg[1], arg[0], arg[0]);
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
  if (domain->dimension == 3 && plane == Plane::STRESS)
    error->all(FLERR, "Pair_style tmsph plane stress needs dimension 2: remove it in 3-D");

  if (neighbor->skin > cutoff && comm->me == 0)
    error->warning(FLERR,
                   "The neighbor skin {} is longer than the horizon {}: lists and ghosts are "
                   "needlessly many; set for instance 'neighbor {:.2g} bin'",
                   neighbor->skin, cutoff, 0.3 * cutoff);

  bool expands = false;
  for (int i = 1; i <= atom->ntypes; i++) {
    Material &m = materials[i];
    if (!setflag[i][i])    // of a hybrid, whose other styles know nothing of bonds
      error->all(FLERR,
                 "Type {} has no material: give it one with 'pair_coeff {} {} elastic E nu density "
                 "rho'",
                 i, i, i);
    if (m.horizon > cutoff)
      error->all(FLERR,
                 "Horizon {} of type {} in pair_coeff is above that of pair_style tmsph, {}: give "
                 "the largest there",
                 m.horizon, i, cutoff);
    m.elastic = elastic_constants(domain->dimension, plane, m.young, m.poisson, m.expansion);
    expands = expands || m.expansion != 0.0;
  }
  init_dilatation();
  on.thermal = expands ? thermal_mode : ThermalStrain::NONE;
  on.hourglass = hourglass > 0.0;
  on.viscosity = viscosity.alpha1 > 0.0 || viscosity.alpha2 > 0.0;
  viscosity.smoothing_length = cutoff / support_in_smoothing_lengths(kernel);
  comm_forward = domain->dimension == 2 ? Rows<2>::FORCE : Rows<3>::FORCE;    // the longest
  prepared_version = surfaces.version = -1;
  forget_participants();

  bond_fix = dynamic_cast<FixTMSPHBond *>(modify->get_fix_by_id(FixTMSPHBond::ID));
  if (!bond_fix)
    bond_fix = dynamic_cast<FixTMSPHBond *>(
        modify->add_fix(fmt::format("{} all tmsph/bond", FixTMSPHBond::ID)));
  if (!bond_fix->formed()) check_reach();
  complete_particles();
  the_box.init();
  TMSPHLastForce::put_last(lmp);
}

/* ---------------------------------------------------------------------- */

double PairTMSPH::init_one(int /*i*/, int /*j*/)
{
  return cutoff;
}

/* ---------------------------------------------------------------------- */

std::string PairTMSPH::features() const
{
  std::string text = domain->dimension == 3 ? "3-D"
      : plane == Plane::STRAIN              ? "plane strain"
                                            : "plane stress";
  text += std::visit([](auto law) { return fmt::format(", {}", law.TITLE); }, on.law);
  if (on.thermal == ThermalStrain::BOND) text += ", thermal bonds";
  if (on.thermal == ThermalStrain::CONSTITUTIVE) text += ", thermal strain";
  if (averaging) text += ", averaged dilatation";
  if (coupling) text += ", coupled interfaces";
  if (on.hourglass) text += fmt::format(", hourglass {}", hourglass);
  if (on.viscosity) text += fmt::format(", viscosity {} {}", viscosity.alpha1, viscosity.alpha2);
  if (break_test) text += fmt::format(", breaking with {} doubles more per ghost", stress_size());
  if (contact)
    text += fmt::format(", contact with {} doubles more per ghost", contact->doubles_per_ghost());
  const int pressed = break_test ? doubles_of_pressed() : 0;
  if (pressed) text += fmt::format(", pressed surfaces with {} doubles more per ghost", pressed);
  return text;
}

/* ----------------------------------------------------------------------
   density times volume is the mass; a mass that was given must agree, at the
   start of each run: 'set' and pair_coeff may have changed them. A temperature
   that was not given is the reference temperature. Before the fixes are
   initialized: some of LAMMPS's take the masses there.
------------------------------------------------------------------------- */

void PairTMSPH::complete_particles()
{
  constexpr double AGREE = 1.0e-6;
  for (int i = 0; i < atom->nlocal; i++) {
    const Material &m = materials[atom->type[i]];
    const double volume = atom->vfrac[i];
    if (!(volume > 0.0))
      error->one(FLERR,
                 "Particle {} has volume {}: give reference volumes with 'set group all volume V'",
                 atom->tag[i], volume);
    if (std::isnan(atom->temperature[i]) && !bond_fix->formed())
      atom->temperature[i] = m.reference_temperature;
    const double mass = m.density * volume;
    if (atom->rmass[i] == 0.0)
      atom->rmass[i] = mass;
    else if (!(std::fabs(atom->rmass[i] - mass) <= AGREE * mass))
      error->one(FLERR,
                 "Particle {} of type {} has mass {:.8g}, but density {:.8g} times volume {:.8g} "
                 "is {:.8g}: {}",
                 atom->tag[i], atom->type[i], atom->rmass[i], m.density, volume, mass,
                 bond_fix->formed()
                     ? "with 'set type', 'set mass' or another density in pair_coeff after the "
                       "first run change the others too; volumes stay"
                     : "correct one of them, or leave the mass out");
    const double *v = atom->v[i];
    if (!bond_fix->formed() && !std::isfinite(v[0] + v[1] + v[2]))
      error->one(FLERR,
                 "Particle {} has a velocity that is not a number: before the first run it has no "
                 "mass yet, so give 'run 0' before 'velocity ... create'",
                 atom->tag[i]);
  }
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::write_restart_settings(FILE *fp)
{
  const double list[8] = {cutoff,           (double) kernel.index(), (double) plane,
                          (double) thermal_mode, hourglass,   viscosity.alpha1,
                          viscosity.alpha2, (double) dilatation};
  const int format_and_law[2] = {RESTART_FORMAT, (int) on.law.index()};
  char version[VERSION_LENGTH] = {};
  memcpy(version, VERSION, sizeof(VERSION));
  fwrite(format_and_law, sizeof(int), 2, fp);
  fwrite(version, 1, VERSION_LENGTH, fp);
  fwrite(list, sizeof(double), 8, fp);
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::read_restart_settings(FILE *fp)
{
  double list[8];
  int format_and_law[2];
  if (comm->me == 0) utils::sfread(FLERR, format_and_law, sizeof(int), 2, fp, nullptr, error);
  MPI_Bcast(format_and_law, 2, MPI_INT, 0, world);
  check_restart_format(error, "pair style tmsph", format_and_law[0], RESTART_FORMAT);
  if (comm->me == 0) {
    char version[VERSION_LENGTH];
    utils::sfread(FLERR, version, 1, VERSION_LENGTH, fp, nullptr, error);
    utils::sfread(FLERR, list, sizeof(double), 8, fp, nullptr, error);
    version[VERSION_LENGTH - 1] = '\0';
    if (strcmp(version, VERSION) != 0)
      utils::logmesg(lmp, "  written by TMSPH {}, read by TMSPH {}\n", version, VERSION);
  }
  MPI_Bcast(list, 8, MPI_DOUBLE, 0, world);
  cutoff = list[0];
  kernel = kernels().at((size_t) list[1]).second;
  plane = (Plane) (int) list[2];
  thermal_mode = (ThermalStrain) (int) list[3];
  hourglass = list[4];
  viscosity.alpha1 = list[5];
  viscosity.alpha2 = list[6];
  dilatation = (Dilatation) (int) list[7];
  on.law = alternatives<ElasticLaw>().at(format_and_law[1]).second;
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  for (int i = 1; i <= atom->ntypes; i++) {
    const Material &m = materials[i];
    const double list[7] = {(double) setflag[i][i], m.young,     m.poisson,
                            m.density,              m.expansion, m.reference_temperature,
                            m.horizon};
    fwrite(list, sizeof(double), 7, fp);
    fwrite(are_bonded[i].data(), 1, atom->ntypes + 1, fp);
  }
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  allocate();
  for (int i = 1; i <= atom->ntypes; i++) {
    double list[7];
    if (comm->me == 0) {
      utils::sfread(FLERR, list, sizeof(double), 7, fp, nullptr, error);
      utils::sfread(FLERR, are_bonded[i].data(), 1, atom->ntypes + 1, fp, nullptr, error);
    }
    MPI_Bcast(list, 7, MPI_DOUBLE, 0, world);
    MPI_Bcast(are_bonded[i].data(), atom->ntypes + 1, MPI_CHAR, 0, world);
    setflag[i][i] = list[0] != 0.0;
    Material &m = materials[i];
    m.young = list[1];
    m.poisson = list[2];
    m.density = list[3];
    m.expansion = list[4];
    m.reference_temperature = list[5];
    m.horizon = list[6];
  }
}
