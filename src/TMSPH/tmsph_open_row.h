/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What the ends of bonds that open tell each other.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OPEN_ROW_H
#define LMP_TMSPH_OPEN_ROW_H

#include "tmsph_open_bond.h"

namespace TMSPH {

/** What a bond that opens, or may, needs from its other end. The first part is there for all
    particles, the second for those with openings. */
template <int D> struct OpenRow {
  static constexpr int U = 0, H = D, CHI = H + D * D, MODULUS = CHI + 1, NEAR = MODULUS + 1;
  static constexpr int R = NEAR + 1, T = R + D * D, LEAST = T + D * D, CANDIDATE = LEAST + 1,
                       RISE = CANDIDATE + 1, WIDTH = RISE + 1;
};

template <int D> inline SquareMatrix<D> row_major(const double *a)
{
  return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(a);
}

template <int D> inline void store(const SquareMatrix<D> &A, double *a)
{
  Eigen::Map<Eigen::Matrix<double, D, D, Eigen::RowMajor>> to(a);
  to = A;
}

}    // namespace TMSPH
#endif
