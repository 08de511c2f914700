/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   One evaluation of all contacts. Two passes over the pairs: which are active
   and how stiff all contacts of a particle are together, then the forces. Each
   particle sums them in the order of its partners' ids.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_FORCES_H
#define LMP_TMSPH_CONTACT_FORCES_H

#include "atom.h"
#include "pointers.h"
#include "tmsph_contact_effect.h"
#include "tmsph_contact_list.h"
#include "tmsph_contact_places.h"
#include "tmsph_contact_rows.h"
#include "tmsph_contact_totals.h"
#include "tmsph_ghost_rows.h"

#include <tuple>
#include <vector>

namespace LAMMPS_NS {

class TMSPHContactForces : protected Pointers {
 public:
  TMSPHContactForces(class LAMMPS *lmp, const TMSPHContactScene &scene, TMSPHContactList &list,
                     TMSPHGhostSender &ghosts, TMSPHContactTotals &totals) :
      Pointers(lmp),
      scene(scene), list(list), ghosts(ghosts), totals(totals)
  {
  }
  void init();
  /** The forces on local particles (collective).
      @param places of particles at segments, or nullptr where there are none
      @param dt     0: nothing is predicted */
  template <int D> void evaluate(TMSPHContactPlaces *places, double dt);
  /// of the pairs, as the last evaluation left them
  template <int D> const std::vector<TMSPH::ContactState<D>> &states()
  {
    auto &s = std::get<D - 2>(states_of);
    s.resize(list.pairings.size());
    return s;
  }
  /// the rows, which places at segments have columns of
  TMSPHGhostRows &rows() { return row; }
  /// among the columns that are being sent: where velocities begin, or -1
  int velocities_sent() const { return velocities; }
  double bytes() const { return row.bytes(); }

 private:
  /** What a pair does in a step, in the compact form that both ends take it from. */
  struct Act {
    double f[3], r[3], depth;    // of the low end, a fraction
    double borne[2];             // fractions of the couple that the low and the high end bear
  };
  using Member = TMSPHContactList::Member;
  using End = TMSPHContactList::End;
  using Pairing = TMSPHContactList::Pairing;

  const TMSPHContactScene &scene;
  TMSPHContactList &list;
  TMSPHGhostSender &ghosts;
  TMSPHContactTotals &totals;
  std::vector<class Fix *> prescribing;    // that act after it
  TMSPHGhostRows row;
  int velocities = -1;
  std::tuple<std::vector<TMSPH::ContactState<2>>, std::vector<TMSPH::ContactState<3>>> states_of;
  std::vector<double> pressing;    // stiffness of each pair that presses, else 0
  std::vector<Act> acts;           // of those
  std::vector<double> heats;       // of friction of each pair, if heat asks for them

  template <int D> void fill_rows(bool predicts);
  template <int D> TMSPH::ContactEnd<D> end_at(int p, bool expands) const;
  template <int D> void keep_energy();
  template <int D> void predict(double dt);
  void find_compliances(const TMSPHContactPlaces *);
  template <int D> void act(double dt);
  template <int D> void gather(const TMSPHContactPlaces *);
  template <int D> void add_to_totals(int i, const TMSPH::ContactEffect &);
  void take(const Member &, const TMSPH::ContactEffect &);
  template <int D> void keep_touches(const TMSPHContactPlaces *);
};

/** An end of a pair, from the rows. */
template <int D> inline TMSPH::ContactEnd<D> TMSPHContactForces::end_at(int p, bool expands) const
{
  using Row = TMSPH::ContactRow<D>;
  const double *his = row[p];
  return {atom->x[p],
          his + Row::V,
          his + Row::A,
          his + Row::H,
          expands ? scene.pair->thermal_strain(p) : 0.0,
          his[Row::BEARS] != 0.0};
}

}    // namespace LAMMPS_NS
#endif
