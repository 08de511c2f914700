/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Bonds that open instead of breaking at once: which, when they begin, when they are gone.
------------------------------------------------------------------------- */

#include "fix_tmsph_break.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// An opening bond needs so much hourglass control: with 0.1 a bond that leaves the fit gains a
// fifth of G_f, from 0.5 on nothing (strips of 2-D lattices)

static constexpr double HOURGLASS_OF_OPENINGS = 0.6;

// Bonds are given the energy of the crack over this. With it strips that are pulled apart take .953
// to .999 of the given energy (unittest/verification/test_openings.py), and centre-cracked plates
// bear 1 to 4.5 % more than by finite elements (test_cct.py), which ask for more of it. With the
// Wendland kernel and horizons of SHORTEST to LONGEST spacings, the largest on a line of particles

static constexpr double CALIBRATION = 1.14;

static constexpr double SHORTEST = 2.7, LONGEST = 3.3;

// A spacing over the characteristic length E G/tensile^2: beyond the first the longest bonds open
// at once, beyond the second cracks take much more than G_f (the same test, case spacings)

static constexpr double COARSE = 0.3, TOO_COARSE = 0.9;

// below this part of the tensile strength the largest principal stress is no tension that opens

static constexpr double NO_TENSION = 0.05;

/* ----------------------------------------------------------------------
   constants of the types whose bonds open
------------------------------------------------------------------------- */

void FixTMSPHBreak::init_openings()
{
  bool any = false;
  for (int type = 1; type <= atom->ntypes; type++) {
    Rock &rock = rocks[type];
    rock.tensile = tensile_strength(type) / rock.strength;
    if (crack_energy(type) == 0.0) continue;
    any = true;
    pair->raise_hourglass(type, HOURGLASS_OF_OPENINGS);
  }
  if (!any) opening.reset();
  else if (!opening) {
    opening = std::make_unique<TMSPHOpenings>(lmp, *bonds, ghosts);
    if (comm->me == 0) opening->resume(before);
  }
  comm_forward = std::max(1, opening ? opening->most_sent() : 0);
}

/* ---------------------------------------------------------------------- */

bool FixTMSPHBreak::softens() const
{
  for (int type = 1; type <= atom->ntypes; type++)
    if (opens_type(type)) return true;
  return false;
}

/* ----------------------------------------------------------------------
   limits of the method, when spacings are known: an error beyond them
------------------------------------------------------------------------- */

void FixTMSPHBreak::check_openings() const
{
  if (!opening) return;
  if (!std::holds_alternative<TMSPH::WendlandC2>(pair->kernel_of_bonds()))
    error->all(FLERR, "Words energy and toughness of fix {} are calibrated for kernel wendland of "
                      "pair_style tmsph only: use that, or do without them",
               style);
  for (int type = 1; type <= atom->ntypes; type++) {
    if (!opens_type(type)) continue;
    const double spacing = pair->spacing_of(type);
    if (spacing == 0.0) continue;
    const double reach = pair->horizon(type, type) / spacing;
    if (reach < SHORTEST || reach > LONGEST)
      error->all(FLERR, "Words energy and toughness of fix {} are calibrated for horizons of {} to "
                        "{} spacings, not of {:.3g} as of type {}: use one of 3.015",
                 style, SHORTEST, LONGEST, reach, type);
    const double length = characteristic_length(type), ratio = spacing / length;
    if (ratio > TOO_COARSE)
      error->all(FLERR, "Spacing {:.4g} of type {} is {:.3g} of the characteristic length of its "
                        "cracks, {:.4g}, of which it may be {} at most: use a spacing of {:.3g} or "
                        "less, or do without energy and toughness",
                 spacing, type, ratio, length, TOO_COARSE, COARSE * length);
    if (ratio > COARSE)
      pair->warn_once(fmt::format("Spacing {:.4g} of type {} is {:.3g} of the characteristic "
                                  "length of its cracks, {:.4g}: at {} or less they take the given "
                                  "energy",
                                  spacing, type, ratio, length, COARSE));
    for (int other = 1; other <= atom->ntypes; other++)
      if (other != type && pair->spacing_of(other) > 0.0 && pair->bonded(type, other) &&
          !pair->same_material(type, other))
        error->all(FLERR, "Type {} has energy or toughness and is bonded to type {}, which differs "
                          "in pair_coeff: give both the same, or 'pair_coeff {} {} none'",
                   type, other, std::min(type, other), std::max(type, other));
    if (pair->averages(type))
      error->all(FLERR, "Nearly incompressible type {} cannot have energy or toughness in fix {}: "
                        "its dilatation is averaged",
                 type, style);
  }
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::characteristic_length(int type) const
{
  const double tensile = tensile_strength(type);
  return pair->material(type).young * crack_energy(type) / (tensile * tensile);
}

/* ----------------------------------------------------------------------
   K^2 = E G in plane stress, E/(1 - nu^2) G else
------------------------------------------------------------------------- */

double FixTMSPHBreak::crack_energy(int type) const
{
  const Rock &rock = rocks[type];
  if (rock.toughness == 0.0) return rock.energy;
  return rock.toughness * rock.toughness / crack_modulus(type);
}

double FixTMSPHBreak::crack_modulus(int type) const
{
  const auto &m = pair->material(type).elastic;
  const bool plane_stress =
      domain->dimension == 2 && pair->words().plane == TMSPH::Plane::STRESS;
  return plane_stress ? m.young : TMSPH::plane_modulus(m);
}

/* ---------------------------------------------------------------------- */

bool FixTMSPHBreak::opens(int i, int j) const
{
  return opening && opens_type(atom->type[i]) && opens_type(atom->type[j]);
}

/* ----------------------------------------------------------------------
   Openings are followed, and bonds are looked at that may open: those with an end that is beyond
   its tensile strength or has lost bonds, or some that open. Where there are none on any processor,
   ghosts get no rows.
------------------------------------------------------------------------- */

void FixTMSPHBreak::follow_openings(const double *stress)
{
  const int nlocal = atom->nlocal, size = TMSPH::stress_row(domain->dimension);
  const bool two = domain->dimension == 2;
  if (damage_watch.laid_out_anew(*bonds) || damage_watch.removed(*bonds)) {
    constexpr unsigned GONE = 1u << FixTMSPHBond::BROKEN | 1u << FixTMSPHBond::CUT;
    damaged.resize(nlocal);
    for (int i = 0; i < nlocal; i++) damaged[i] = opens(i, i) && bonds->count_in(i, GONE);
    damage_watch.see(*bonds);
  }
  watched = damaged;
  int mine[2] = {0, opening->here()}, all[2];
  for (int i = 0; i < nlocal; i++) {
    if (!watched[i] && opens(i, i))
      watched[i] = opening->opens_at(i) || may_open(i, stress + (size_t) i * size);
    mine[0] |= watched[i];
  }
  MPI_Allreduce(mine, all, 2, MPI_INT, MPI_MAX, world);
  looking = all[0] || all[1];
  opening->look(all[1]);
  if (!looking) return;
  if (two) {
    opening->exchange<2>(pair->bond_state(), watched);
    opening->update<2>(pair->bond_state());
  } else {
    opening->exchange<3>(pair->bond_state(), watched);
    opening->update<3>(pair->bond_state());
  }
}

/* ----------------------------------------------------------------------
   false only if no principal stress reaches the tensile strength
------------------------------------------------------------------------- */

bool FixTMSPHBreak::may_open(int i, const double *stress) const
{
  const bool two = domain->dimension == 2;
  const TMSPH::Invariants v = two ? TMSPH::invariants_2d(stress) : TMSPH::invariants_3d(stress);
  const double reach = two ? 1.0 : TMSPH::REACH_3D;
  return !(v.mean + reach * std::sqrt(v.deviation2) <
           tensile_strength_of(i) * TMSPH::BELOW_ROUNDING);
}

/* ----------------------------------------------------------------------
   A bond that is not looked at: what fails in it is tension, which it takes by opening when it
   comes near what opens.
------------------------------------------------------------------------- */

bool FixTMSPHBreak::pulled(const Due &bond) const
{
  return bond.principals.largest > NO_TENSION * bond_strength(bond);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::bond_strength(const Due &bond) const
{
  const int j = bonds->partner_index(bond.i, bond.k);
  return 0.5 * (tensile_strength_of(bond.i) + tensile_strength_of(j));
}

/* ----------------------------------------------------------------------
   Rankine with the residual of the fits, see tmsph_openings.h
   @return false if the bond fails without tension: it breaks at once
------------------------------------------------------------------------- */

bool FixTMSPHBreak::begin_opening(Due &bond)
{
  const int i = bond.i, j = bonds->partner_index(i, bond.k);
  const double strength = bond_strength(bond);
  if (opening->opens_bond(i, bond.k)) return true;
  const bool two = domain->dimension == 2;
  double stress[6];
  std::copy_n(bond.stress, 6, stress);
  if (two)
    opening->add_residual<2>(i, j, stress);
  else
    opening->add_residual<3>(i, j, stress);
  const double pull =
      two ? TMSPH::principals_2d(stress).largest : TMSPH::principals_3d(stress).largest;
  if (pull >= strength) {
    const double energy =
        0.5 * (crack_energy(atom->type[i]) + crack_energy(atom->type[j])) / CALIBRATION;
    if (two)
      opening->begin<2>(i, bond.k, j, stress, strength, energy);
    else
      opening->begin<3>(i, bond.k, j, stress, strength, energy);
    began = true;
    return true;
  }
  return pull > NO_TENSION * strength;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::complete_openings()
{
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

void FixTMSPHBreak::remove_opened(std::vector<int> &touched)
{
  for (const auto &[i, k] : opening->leaving()) {
    Due due = {i, k, 0.0, {}, {1.0, 0.0, 0.0}};
    if (atom->tag[i] < bonds->partner_tag(i, k)) record(due);
    pair->contact_of_surfaces()->opened(i, k);
    bonds->remove_bond(i, k, FixTMSPHBond::BROKEN);
    if (touched.empty() || touched.back() != i) touched.push_back(i);
  }
  opening->list_open();
  if (events.size() > event_rows.size()) list_events();
}

