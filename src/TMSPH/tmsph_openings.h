/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Openings of bonds that a cohesive law holds: what they change in a force
   evaluation, how they grow, when a bond leaves the fit. The equations are in
   tmsph_open_bond.h and tmsph_cohesion.h.

   In a step, at the new positions, the openings follow the tractions until
   these are on their law again; both halves of the kick have the forces of then.
   So positions feel the potential that is left when the openings are in
   equilibrium: nothing is lost to how fast a crack opens. (One update a step
   lags behind, and acts like viscosity between the faces.) Searches for
   equilibrium have that potential too: until one ends, openings may go back to
   where it began.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OPENINGS_H
#define LMP_TMSPH_OPENINGS_H

#include "fix_tmsph_bond.h"
#include "pointers.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_opening_balance.h"
#include "tmsph_opening_update.h"
#include "tmsph_own_side.h"

#include <tuple>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

/** What a force evaluation works on; see tmsph_sweep.h. */
struct TMSPHBondState {
  const TMSPH::Features &on;
  const TMSPH::Slices &slices;
  const double *kinematic;
  double *force_row;
  double *gradient, *stress;           ///< or nullptr
  TMSPHOwnSide *own_side = nullptr;    ///< where stresses are tested
};

class TMSPHOpenings : protected Pointers {
 public:
  /// of what bonds carry
  static constexpr const char *NAME = "opening";
  TMSPHOpenings(class LAMMPS *, FixTMSPHBond &, TMSPHGhostSender &);
  void set_law(const TMSPH::CohesiveLaw &softening) { law = softening; }

  /// true if a bond of this processor's particles opens; of any processor's, as of the last look()
  bool here() const { return !open.empty(); }
  bool anywhere() const { return any; }
  bool opens_at(int i) const { return values.count(i); }
  bool opens_bond(int i, int k) const { return values.find(i, k); }
  /// how far it is open, of full opening: 0 closed, 1 or more without traction
  double part_open(int i, int k) const
  {
    const int m = values.count(i) ? values.number(i, k) : -1;
    return m < 0 ? 0.0 : bond(i, m).opening.now / bond(i, m).opening.end;
  }
  void look(bool anywhere) { any = anywhere; }
  /// particles may have changed places (collective)
  void follow();
  /// bonds were removed here
  void list_open();

  /// gradients, stresses and the first part of the force rows of particles with openings
  template <int D> void correct(const TMSPHBondState &);
  /// of those at interfaces of materials the stress of their own side, and its gradient
  template <int D> void correct_own_side(const TMSPHBondState &);
  /// the force rows; ghosts get rotations (collective)
  template <int D> void finish(const TMSPHBondState &);
  /// what the rows do not hold: added to forces of local particles and to virials, where these are
  /// not nullptr
  template <int D>
  void add_forces(const TMSPHBondState &, double *f, int stride, double *total, double *each) const;
  /// what finish() found instead of the energy of local particle i, with half of what its openings
  /// hold
  struct Energy {
    int i;
    double energy;
  };
  const std::vector<Energy> &energies() const { return energy; }

  /// rows of all local particles are filled and sent (collective). near: bonds at them are tested;
  /// or nullptr, if none are
  template <int D> void exchange(const TMSPHBondState &, const char *near);
  bool near(int i) const { return rows[i][near_column] != 0.0; }
  /// adds what the fits of both ends leave over of bond (i, j) to its mean stress
  template <int D> void add_residual(int i, int j, double *stress) const;
  /// bond (i, j) lies across the crack that a stress opens, not along its faces
  bool crosses(int i, int j, const double *stress) const;
  /** Bond k of local particle i begins to open across a stress; it crosses that crack.
      @param strength t0
      @param energy   of the crack per area, G_f, with the calibration of the method in it */
  template <int D>
  void begin(int i, int k, int j, const double *stress, double strength, double energy);
  /// areas of those that just began, on some processor (collective)
  template <int D> void complete(const TMSPHBondState &);
  /// openings follow the tractions, again and again (collective); after exchange()
  template <int D> void update(TMSPHBondState);
  /// the same in a search for equilibrium, from what the openings were before it (collective)
  template <int D> void relax(TMSPHBondState);
  /// no search goes back beyond the openings of now
  void settle();
  /** A bond that leaves the fit, seen from one of its ends: particle and place; energy of its part
      of the crack. */
  struct Leaving {
    int i, k;
    double energy;
  };
  /// those of now, booked as finished
  std::vector<Leaving> leaving();

  /// doubles per particle that it sends at most
  int most_sent() const;
  double bytes() const;

  /// of this processor, with the bonds that are opening
  TMSPHOpeningBalance::Figures figures() const;
  TMSPHOpeningBalance &balance() { return account; }

 private:
  FixTMSPHBond &bonds;
  TMSPHGhostSender &ghosts;
  TMSPHBondValues &values;
  TMSPHParticleValues &shapes;    // Kbar^-1 when the first bond began to open
  TMSPHBondWatch watch;
  std::vector<int> open;    // local particles with openings, ascending
  bool any = false;
  std::tuple<std::vector<TMSPH::OpenFit<2>>, std::vector<TMSPH::OpenFit<3>>> fits_of;
  bool gathered = false;    // they are those of the open bonds of now
  std::vector<Energy> energy;
  TMSPHGhostRows rows;
  int near_column = 0;
  const double *kinematic = nullptr;    // of the last exchange(),
  bool heated = false;                  // where it has thermal bonds
  TMSPHOpeningBalance account;
  TMSPH::CohesiveLaw law;

  TMSPH::OpenBond &bond(int i, int n)
  {
    return *reinterpret_cast<TMSPH::OpenBond *>(values.values(i, n));
  }
  const TMSPH::OpenBond &bond(int i, int n) const
  {
    return *reinterpret_cast<const TMSPH::OpenBond *>(values.values(i, n));
  }
  void make_rows(int width);
  /// X and u' of bond (i, j), with the displacements of the rows: the same bits from both ends
  template <int D> double relative(int i, int j, double *X, double *u) const;
  template <int D> void gather(const TMSPHBondState &);
  /// what the ends see of openings in the bonds of their fits
  template <int D> void take_jumps();
  template <int D> void evaluate(const TMSPHBondState &);
  /// rows of particles with openings after their fits
  template <int D> void fill_open_rows(const TMSPHBondState &);
  template <int D> void follow_laws(const TMSPHBondState &, bool search);
  template <int D> void sum_normals(int i, double *sum) const;
  template <int D> std::vector<TMSPH::FollowedBond<D>> followed_bonds();
  template <int D> void decide_leaving(int i, int j, TMSPH::OpenBond &);
  template <int D> void find_candidate(int i, const TMSPH::OpenFit<D> &, const TMSPH::ElasticLaw &);
};

}    // namespace LAMMPS_NS
#endif
