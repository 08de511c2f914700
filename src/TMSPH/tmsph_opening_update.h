/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   How the openings of bonds follow the tractions of their ends while nothing
   moves. All are updated at once, with a stiffness with which no update raises
   the energy of fits and openings together (tmsph_cohesion.h), until the tractions
   are on their laws. Both ends of a bond, on whatever processors, compute the
   same: what they share rounds the same from both sides.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OPENING_UPDATE_H
#define LMP_TMSPH_OPENING_UPDATE_H

#include "tmsph_open_bond.h"

namespace TMSPH {

/// R^T u; R row-major. Compiled once: it rounds the same from both ends
template <int D> [[gnu::noinline]] Column<D> turned_back(const double *R, const Column<D> &u)
{
  Column<D> back = Column<D>::Zero();
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) back[j] += R[D * i + j] * u[i];
  return back;
}

/** R^T f of one end: its part of A t. Compiled once, see above.
    @param T       R^T B of the end, row-major
    @param X, u, s of the bond as this end sees it, u turned back
    @param W, chi  of the bond and of this end */
template <int D>
[[gnu::noinline]] Column<D> end_traction(const double *T, double chi, const Column<D> &X,
                                         const Column<D> &u, const Column<D> &s, double W)
{
  Column<D> traction;
  for (int i = 0; i < D; i++) {
    traction[i] = chi * (u[i] - s[i]);
    for (int j = 0; j < D; j++) traction[i] += T[D * i + j] * X[j];
  }
  return W * traction;
}

/** A bond whose opening follows, as one of its ends sees it. */
template <int D> struct FollowedBond {
  OpenBond *bond;
  int fit, partner;    ///< of this end; index of the other one
  Column<D> X;
  Column<D> mine, his;    ///< u' as the ends see it, turned back by their rotations
  double weight;
  double chi_mine, chi_his;
  double stiffness;    ///< half of the second derivative of the elastic energy, or more
  Column<D> c, e;      ///< where the opening is tried
  int moves = 0;       ///< updates since it turned back

  Column<D> jump() const { return c + e; }

  /** One update, from where the opening is tried.
      @param T_mine, T_his R^T B of both ends
      @return              square of the change of a traction over the strength */
  template <class Law> double update(Law law, const double *T_mine, const double *T_his)
  {
    Eigen::Map<Column<D>> at_c(bond->jump), at_e(bond->uneven);
    const Column<D> one = end_traction<D>(T_mine, chi_mine, X, mine, c + e, weight),
                    other = end_traction<D>(T_his, chi_his, -X, his, e - c, weight),
                    before_c = at_c, before_e = at_e;
    at_c = opened(law, (one - other) / bond->area);
    at_e = e + (one + other) / (bond->area * stiffness);
    const double way = std::max((at_c - c).squaredNorm(), (at_e - e).squaredNorm()),
                 change = stiffness / bond->opening.strength;
    go_on(at_c, at_e, at_c - before_c, at_e - before_e);
    return way * change * change;
  }

 private:
  /** Along the normal of the crack, as long as the faces hold each other: if each bond could slide,
      oblique ones would give way to stress along the faces, and all under pressure. Without traction
      they go wherever they want but into each other. */
  template <class Law> Column<D> opened(Law law, const Column<D> &pull)
  {
    const Eigen::Map<const Column<D>> normal(bond->normal);
    Opening &opening = bond->opening;
    opening.most = bond->settled;
    if (opening.most < opening.end) {
      const double k = stiffness_of_update(law, opening, stiffness);
      TMSPH::update(law, opening, (pull + k * c).dot(normal), k);
      return opening.now * normal;
    }
    Column<D> free = c + pull / stiffness;
    free -= std::min(0.0, free.dot(normal)) * normal;
    opening.now = free.norm();
    opening.most = std::max(opening.most, opening.now);
    return free;
  }

  /** Where the opening is tried next: further on its way, the further the longer it went on
      (Nesterov, Sov. Math. Dokl. 27, 1983, 372), and from rest where the update turned back
      (O'Donoghue and Candes, Found. Comput. Math. 15, 2015, 715). */
  void go_on(const Column<D> &at_c, const Column<D> &at_e, const Column<D> &way_c,
             const Column<D> &way_e)
  {
    if ((c - at_c).dot(way_c) + (e - at_e).dot(way_e) > 0.0) moves = 0;
    const double further = moves / (moves + 3.0);
    moves++;
    c = at_c + further * way_c;
    e = at_e + further * way_e;
  }
};

}    // namespace TMSPH
#endif
