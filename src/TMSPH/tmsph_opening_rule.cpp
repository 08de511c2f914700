/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_opening_rule.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "min_tmsph_lbfgs.h"
#include "pair_tmsph.h"
#include "tmsph_arrangement.h"
#include "tmsph_rocks.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// An opening bond needs so much hourglass control: with 0.1 a beam bends at the end of the crack
// without opening more bonds, and bears twice too much behind its peak (test_bend.py)

static constexpr double HOURGLASS_OF_OPENINGS = 0.6;

// Bonds are given the energy of the crack over this: the areas of those that open sum to 1.00 to
// 1.07 of that of the crack (strips of unittest/verification/test_openings_long.py, lattices). With
// the Wendland kernel and horizons of SHORTEST to LONGEST spacings, the largest on a line of
// particles

static constexpr double CALIBRATION = 1.04;

static constexpr double SHORTEST = 2.7, LONGEST = 3.3;

// A spacing over the characteristic length E G/tensile^2: beyond the first the longest bonds open
// at once, beyond the second cracks take much more than G_f (the same test, case spacings)

static constexpr double COARSE = 0.3, TOO_COARSE = 0.9;

// Median imbalance in the interior, see tmsph_arrangement.h: less than 0.001 on square, hexagonal,
// simple and face-centred cubic lattices; of relaxed clouds of 100 to 1600 particles in 2-D 0.002 to
// 0.011, of 500 to 2000 in 3-D 0.007 to 0.022; of these lattices shaken by 5 % of the spacing 0.029 to
// 0.039, by 10 % 0.060 to 0.079, by 20 % 0.10 to 0.16 (test_openings_long.py arrangements)

static constexpr double IRREGULAR = 0.03;

// below this part of the tensile strength the largest principal stress is no tension that opens

static constexpr double NO_TENSION = 0.05;

/* ----------------------------------------------------------------------
   constants of the types whose bonds open
------------------------------------------------------------------------- */

void TMSPHOpeningRule::init(PairTMSPH &style, TMSPHGhostSender &ghosts)
{
  pair = &style;
  bonds = pair->bonds();
  bool any = false;
  for (int type = 1; type <= atom->ntypes; type++) {
    if (!rocks.opens(type)) continue;
    any = true;
    pair->raise_hourglass(type, HOURGLASS_OF_OPENINGS);
  }
  if (!any)
    opening.reset();
  else if (!opening) {
    opening = std::make_unique<TMSPHOpenings>(lmp, *bonds, ghosts);
    if (comm->me == 0) opening->balance().resume(before);
  }
  if (!opening) return;
  opening->set_law(rocks.softening());
  opening->settle();
}

/* ---------------------------------------------------------------------- */

void TMSPHOpeningRule::check(const std::string &style)
{
  if (!opening) return;
  if (update->whichflag == 2 && !dynamic_cast<MinTMSPHLBFGS *>(update->minimize))
    error->all(FLERR,
               "Min style {} cannot follow bonds that open, as in fix {}: use 'min_style "
               "tmsph/lbfgs', which is the default",
               update->minimize_style, style);
  if (!std::holds_alternative<TMSPH::WendlandC2>(pair->kernel_of_bonds()))
    error->all(FLERR,
               "Words energy and toughness of fix {} are calibrated for kernel wendland of "
               "pair_style tmsph only: use that, or do without them",
               style);
  for (int type = imbalance.size(); type <= atom->ntypes; type++)
    imbalance.push_back(interior_imbalance(lmp, *bonds, type));
  for (int type = 1; type <= atom->ntypes; type++) {
    if (!rocks.opens(type) || pair->spacing_of(type) == 0.0) continue;
    if (imbalance[type] > IRREGULAR)    // the nearest particles do not tell the spacing then
      pair->warn_once(fmt::format(
          "Particles of type {} lie irregularly: an even stress leaves forces of {:.2g} of it "
          "between them, above {} their stresses are too inexact for cracks. Spread them by "
          "'tmsph/relax' before the first run",
          type, imbalance[type], IRREGULAR));
    else
      check_horizon(style, type);
    if (pair->averages(type))
      error->all(FLERR,
                 "Nearly incompressible type {} cannot have energy or toughness in fix {}: "
                 "its dilatation is averaged",
                 type, style);
    for (int other = type; other <= atom->ntypes; other++)
      if (rocks.opens(type, other) && (other == type || pair->bonded(type, other)))
        check_length(type, other);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHOpeningRule::check_horizon(const std::string &style, int type) const
{
  const double reach = pair->horizon(type, type) / pair->spacing_of(type);
  if (reach < SHORTEST || reach > LONGEST)
    error->all(FLERR,
               "Words energy and toughness of fix {} are calibrated for horizons of {} to "
               "{} spacings, not of {:.3g} as of type {}: use one of 3.015",
               style, SHORTEST, LONGEST, reach, type);
}

/* ---------------------------------------------------------------------- */

void TMSPHOpeningRule::check_length(int type, int other) const
{
  const double spacing = std::max(pair->spacing_of(type), pair->spacing_of(other));
  // the limits are those of the linear law: others fall more steeply in the beginning
  const double steeper = std::visit(
      [](auto law) {
        return decltype(law)::STEEPEST * decltype(law)::area(1.0) /
            (TMSPH::LinearCohesion::STEEPEST * TMSPH::LinearCohesion::area(1.0));
      },
      rocks.softening());
  const double too_coarse = TOO_COARSE / steeper, coarse = COARSE / steeper;
  const double length = rocks.characteristic_length(type, other), ratio = spacing / length;
  const std::string where = type == other ? fmt::format("type {}", type)
                                          : fmt::format("types {} and {}", type, other);
  if (ratio > too_coarse)
    error->all(FLERR,
               "Spacing {:.4g} of {} is {:.3g} of the characteristic length of cracks there, "
               "{:.4g}, of which it may be {:.2g} at most: use a spacing of {:.3g} or less, or do "
               "without energy and toughness",
               spacing, where, ratio, length, too_coarse, coarse * length);
  if (ratio > coarse)
    pair->warn_once(
        fmt::format("Spacing {:.4g} of {} is {:.3g} of the characteristic length of "
                    "cracks there, {:.4g}: at {:.2g} or less they take the given energy",
                    spacing, where, ratio, length, coarse));
}

/* ---------------------------------------------------------------------- */

bool TMSPHOpeningRule::opens(int i, int j) const
{
  return opening && rocks.opens(atom->type[i], atom->type[j]);
}

/* ----------------------------------------------------------------------
   Openings are followed, and bonds are looked at that may open: those with an end that is beyond
   its tensile strength or has lost bonds, or some that open. Where there are none on any processor,
   ghosts get no rows.
------------------------------------------------------------------------- */

void TMSPHOpeningRule::follow(const double *stress)
{
  if (!opening) return;
  const int nlocal = atom->nlocal, size = TMSPH::stress_row(domain->dimension);
  const bool two = domain->dimension == 2;
  if (damage_watch.laid_out_anew(*bonds) || damage_watch.removed(*bonds)) {
    constexpr unsigned GONE = 1u << FixTMSPHBond::BROKEN | 1u << FixTMSPHBond::CUT;
    damaged.resize(nlocal);
    for (int i = 0; i < nlocal; i++)
      damaged[i] = rocks.opens(atom->type[i]) && bonds->count_in(i, GONE);
    damage_watch.see(*bonds);
  }
  watched = damaged;
  int mine[2] = {0, opening->here()}, all[2];
  for (int i = 0; i < nlocal; i++) {
    if (!watched[i] && rocks.opens(atom->type[i]))
      watched[i] = opening->opens_at(i) || may_open(i, stress + (size_t) i * size);
    mine[0] |= watched[i];
  }
  MPI_Allreduce(mine, all, 2, MPI_INT, MPI_MAX, world);
  looking = all[0] || all[1];
  opening->look(all[1]);
  if (!looking) return;
  if (two) {
    opening->exchange<2>(pair->bond_state(), watched.data());
    opening->update<2>(pair->bond_state());
  } else {
    opening->exchange<3>(pair->bond_state(), watched.data());
    opening->update<3>(pair->bond_state());
  }
}

/* ----------------------------------------------------------------------
   false only if no principal stress reaches the tensile strength
------------------------------------------------------------------------- */

bool TMSPHOpeningRule::may_open(int i, const double *row) const
{
  const bool two = domain->dimension == 2;
  const TMSPH::Invariants v = two ? TMSPH::invariants_2d(row) : TMSPH::invariants_3d(row);
  const double reach = two ? 1.0 : TMSPH::REACH_3D;
  return !(v.mean + reach * std::sqrt(v.deviation2) <
           rocks.weakest_tensile_strength_of(i) * TMSPH::BELOW_ROUNDING);
}

/* ---------------------------------------------------------------------- */

bool TMSPHOpeningRule::is_tension(double pull, double strength)
{
  return pull > NO_TENSION * strength;
}

/* ----------------------------------------------------------------------
   Rankine with the residual of the fits, see tmsph_openings.h
------------------------------------------------------------------------- */

double TMSPHOpeningRule::pull(int i, int j, double *stress) const
{
  if (domain->dimension == 2) {
    opening->add_residual<2>(i, j, stress);
    return TMSPH::principals_2d(stress).largest;
  }
  opening->add_residual<3>(i, j, stress);
  return TMSPH::principals_3d(stress).largest;
}

/* ---------------------------------------------------------------------- */

void TMSPHOpeningRule::begin(int i, int k, const double *stress)
{
  const int j = bonds->partner_index(i, k);
  const double strength = rocks.tensile_strength_of(i, j);
  const double energy =
      rocks.energy_factor(i, j) * rocks.crack_energy(atom->type[i], atom->type[j]) / CALIBRATION;
  if (domain->dimension == 2)
    opening->begin<2>(i, k, j, stress, strength, energy);
  else
    opening->begin<3>(i, k, j, stress, strength, energy);
  began = true;
}

/* ---------------------------------------------------------------------- */

void TMSPHOpeningRule::complete()
{
  if (!opening || !looking) return;
  int mine = began, any;
  began = false;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any) return;
  opening->look(true);
  if (domain->dimension == 2)
    opening->complete<2>(pair->bond_state());
  else
    opening->complete<3>(pair->bond_state());
}

/* ---------------------------------------------------------------------- */

TMSPHOpeningBalance::Figures TMSPHOpeningRule::figures() const
{
  if (!opening) return {};
  TMSPHOpeningBalance::Figures sums = opening->figures();
  sums[TMSPHOpeningBalance::AREA] /= CALIBRATION;    // of the crack
  return sums;
}

TMSPHOpeningBalance::Figures TMSPHOpeningRule::finished() const
{
  return opening ? opening->balance().finished() : TMSPHOpeningBalance::Figures();
}

/* ---------------------------------------------------------------------- */

double TMSPHOpeningRule::bytes() const
{
  return damaged.capacity() + watched.capacity() + (opening ? opening->bytes() : 0.0);
}
