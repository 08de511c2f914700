/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What an input says of the solids, and what follows from it for a particle.
------------------------------------------------------------------------- */

#include "tmsph_materials.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "tmsph_report.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;

// longitudinal waves in m/s: diamond has 18e3 (CRC Handbook of Chemistry and Physics, Speed of
// sound in various media), light silica aerogels have 100 (Gross, Fricke, J. Non-Cryst. Solids 145
// (1992) 217)

static constexpr double SLOWEST = 50.0, FASTEST = 20.0e3;

/* ---------------------------------------------------------------------- */

void TMSPHMaterials::allocate_materials()
{
  const int n = lammps->atom->ntypes + 1;
  materials.assign(n, Material());
  are_bonded.assign(n, std::vector<char>(n, 1));
}

/* ---------------------------------------------------------------------- */

TMSPHMaterials::Material TMSPHMaterials::read_material(TMSPHValues &values) const
{
  LAMMPS *const lmp = lammps;
  Error *const error = lmp->error;
  Material m;
  m.young = values.number();
  m.poisson = values.number();
  char **const given = values.rest();
  values.all(TMSPHWords(
      lmp, "pair_coeff ... elastic",
      {{"density", "rho", [&m](TMSPHValues &v) { m.density = v.number(); }},
       {"expansion", "alpha", [&m](TMSPHValues &v) { m.expansion = v.number(); }},
       {"reference", "T0", [&m](TMSPHValues &v) { m.reference_temperature = v.number(); }},
       {"horizon", "delta", [&](TMSPHValues &v) {
          m.horizon = v.number();
          if (!(m.horizon > 0.0 && m.horizon <= horizon()))
            error->all(FLERR,
                       "Horizon {} in pair_coeff must be positive and not above that of "
                       "pair_style tmsph, {}: give the largest there",
                       v.rest()[-1], horizon());
        }}}));
  if (m.young <= 0.0)
    error->all(FLERR, "Young's modulus {} in pair_coeff must be positive", given[-2]);
  if (m.poisson <= -1.0 || m.poisson >= 0.5)
    error->all(FLERR, "Poisson's ratio {} in pair_coeff must lie between -1 and 0.5", given[-1]);
  if (m.density <= 0.0)
    error->all(FLERR,
               "Density {} in pair_coeff ... elastic must be positive: add 'density rho' with the "
               "density at rest",
               m.density);
  return m;
}

/* ---------------------------------------------------------------------- */

void TMSPHMaterials::init_materials(int **given)
{
  some_expand = false;
  for (int i = 1; i <= lammps->atom->ntypes; i++) {
    Material &m = materials[i];
    if (!given[i][i])    // of a hybrid, whose other styles know nothing of bonds
      lammps->error->all(
          FLERR,
          "Type {} has no material: give it one with 'pair_coeff {} {} elastic E nu density rho'",
          i, i, i);
    if (m.horizon > horizon())
      lammps->error->all(FLERR,
                         "Horizon {} of type {} in pair_coeff is above that of pair_style tmsph, "
                         "{}: give the largest there",
                         m.horizon, i, horizon());
    m.elastic =
        elastic_constants(lammps->domain->dimension, chosen.plane, m.young, m.poisson, m.expansion);
    m.hourglass = chosen.hourglass;
    some_expand = some_expand || m.expansion != 0.0;
  }
}

/* ----------------------------------------------------------------------
   density times volume is the mass; a mass that was given must agree, at the
   start of each run: 'set' and pair_coeff may have changed them. A temperature
   that was not given is the reference temperature. Before the fixes are
   initialized: some of LAMMPS's take the masses there.
------------------------------------------------------------------------- */

void TMSPHMaterials::complete_particles(bool formed) const
{
  const Atom *const atom = lammps->atom;
  Error *const error = lammps->error;
  constexpr double AGREE = 1.0e-6;    // data files have 8 digits or more, mistakes are larger
  for (int i = 0; i < atom->nlocal; i++) {
    const Material &m = materials[atom->type[i]];
    const double volume = atom->vfrac[i];
    if (!(volume > 0.0))
      error->one(FLERR,
                 "Particle {} has volume {}: give reference volumes with 'set group all volume V'",
                 atom->tag[i], volume);
    if (std::isnan(atom->temperature[i]) && !formed) atom->temperature[i] = m.reference_temperature;
    const double mass = m.density * volume;
    if (atom->rmass[i] == 0.0)
      atom->rmass[i] = mass;
    else if (!(std::fabs(atom->rmass[i] - mass) <= AGREE * mass))
      error->one(FLERR,
                 "Particle {} of type {} has mass {:.8g}, but density {:.8g} times volume {:.8g} "
                 "is {:.8g}: {}",
                 atom->tag[i], atom->type[i], atom->rmass[i], m.density, volume, mass,
                 formed ? "with 'set type', 'set mass' or another density in pair_coeff after the "
                          "first run change the others too; volumes stay"
                        : "correct one of them, or leave the mass out");
    const double *v = atom->v[i];
    if (!formed && !std::isfinite(v[0] + v[1] + v[2]))
      error->one(FLERR,
                 "Particle {} has a velocity that is not a number: before the first run it has no "
                 "mass yet, so give 'run 0' before 'velocity ... create'",
                 atom->tag[i]);
  }
}

/* ---------------------------------------------------------------------- */

bool TMSPHMaterials::plausible(int type) const
{
  const UnitNames unit(lammps->update->unit_style);
  const double speed = unit.meters_per_second * wave_speed(materials[type]);
  return unit.meters_per_second == 0.0 || (speed > SLOWEST && speed < FASTEST);
}

/* ---------------------------------------------------------------------- */

bool TMSPHMaterials::same_material(int itype, int jtype) const
{
  const Material &one = materials[itype], &other = materials[jtype];
  return one.young == other.young && one.poisson == other.poisson &&
      one.expansion == other.expansion && one.reference_temperature == other.reference_temperature;
}

/* ----------------------------------------------------------------------
   plane strain: nu (sxx + syy) - E alpha dT
------------------------------------------------------------------------- */

double TMSPHMaterials::stress_zz(int i, double sxx, double syy) const
{
  if (chosen.plane == Plane::STRESS) return 0.0;
  const Material &m = materials[lammps->atom->type[i]];
  return m.poisson * (sxx + syy) - m.young * m.expansion * heating(i);
}

/* ---------------------------------------------------------------------- */

void TMSPHMaterials::write_materials(FILE *fp, int **given) const
{
  for (int i = 1; i < (int) materials.size(); i++) {
    const Material &m = materials[i];
    const double list[7] = {(double) given[i][i],    m.young,  m.poisson, m.density, m.expansion,
                            m.reference_temperature, m.horizon};
    fwrite(list, sizeof(double), 7, fp);
    fwrite(are_bonded[i].data(), 1, materials.size(), fp);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHMaterials::read_materials(FILE *fp, int **given)
{
  Error *const error = lammps->error;
  const int n = materials.size();
  for (int i = 1; i < n; i++) {
    double list[7];
    if (lammps->comm->me == 0) {
      utils::sfread(FLERR, list, sizeof(double), 7, fp, nullptr, error);
      utils::sfread(FLERR, are_bonded[i].data(), 1, n, fp, nullptr, error);
    }
    MPI_Bcast(list, 7, MPI_DOUBLE, 0, lammps->world);
    MPI_Bcast(are_bonded[i].data(), n, MPI_CHAR, 0, lammps->world);
    given[i][i] = list[0] != 0.0;
    Material &m = materials[i];
    m.young = list[1];
    m.poisson = list[2];
    m.density = list[3];
    m.expansion = list[4];
    m.reference_temperature = list[5];
    m.horizon = list[6];
  }
}
