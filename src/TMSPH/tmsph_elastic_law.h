/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Laws of elasticity: from the displacement gradient H = F - I to the first
   Piola-Kirchhoff stress and to the strain energy per reference volume. One more is one more struct,
   with its place at the end of ElasticLaw.

   NAME    word of the input
   TITLE   for the log
   @param lambda, shear constants of Elastic
   @param thermal thermal strain a to be taken off the strain (0 with the thermal bond)
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_ELASTIC_LAW_H
#define LMP_TMSPH_ELASTIC_LAW_H

#include "tmsph_alternatives.h"
#include "tmsph_elastic.h"
#include "tmsph_lanes.h"

namespace TMSPH {

/** Hyperelastic: P = F (lambda tr(E) I + 2 mu E) with the Green-Lagrange strain E. */
struct StVenantKirchhoff {
  static constexpr const char *NAME = "svk", *TITLE = "St Venant-Kirchhoff";
  template <int D, class T>
  static Matrix<D, T> first_piola(const Matrix<D, T> &H, T lambda, T shear, T thermal)
  {
    return product(deformation(H), hooke(green_lagrange(H, thermal), lambda, shear));
  }
  template <int D, class T> static T energy(const Matrix<D, T> &H, T lambda, T shear, T thermal)
  {
    return hooke_energy(green_lagrange(H, thermal), lambda, shear);
  }
};

/** Hooke's law between Almansi strain and Cauchy stress (Mu et al. 2022), P = J sigma F^-T. It has no
    potential: the energy is J times Hooke's. */
struct AlmansiHooke {
  static constexpr const char *NAME = "almansi", *TITLE = "Almansi";
  template <int D, class T>
  static Matrix<D, T> first_piola(const Matrix<D, T> &H, T lambda, T shear, T thermal)
  {
    const Matrix<D, T> F = deformation(H);
    const T J = determinant(F);
    return product(hooke(almansi(F, J, thermal), lambda, shear), cofactor(F));
  }
  template <int D, class T> static T energy(const Matrix<D, T> &H, T lambda, T shear, T thermal)
  {
    const Matrix<D, T> F = deformation(H);
    const T J = determinant(F);
    return J * hooke_energy(almansi(F, J, thermal), lambda, shear);
  }
};

/** Hyperelastic, stiff against being crushed: psi = mu/2 (tr C - D) - mu ln J
    + lambda/4 (J^2 - 1 - 2 ln J), so P = mu (F - F^-T) + lambda/2 (J^2 - 1) F^-T (Simo and Hughes,
    Computational Inelasticity, Springer 1998, Eq. 9.2.3, with this volumetric part), of F/(1 + a).
    In small strain Hooke's law; in plane strain that of the body held in z. */
struct NeoHookean {
  static constexpr const char *NAME = "neohookean", *TITLE = "neo-Hookean";
  template <int D, class T>
  static Matrix<D, T> first_piola(const Matrix<D, T> &whole, T lambda, T shear, T thermal)
  {
    // F - F^-T = H + ((J - 1) I - (cof F - I))/J: no loss of digits at small strain

    const Matrix<D, T> H = elastic(whole, thermal), C = cofactor_change(H);
    const T j = volume_change(H), J = 1.0 + j, inverse = 1.0 / J, shrink = 1.0 / (1.0 + thermal);
    const T bulk = 0.5 * lambda * j * (J + 1.0);
    Matrix<D, T> P;
    for (int i = 0; i < D; i++)
      for (int k = 0; k < D; k++) {
        const T cofactor = i == k ? 1.0 + C[i][k] : C[i][k];
        const T change = i == k ? j - C[i][k] : 0.0 - C[i][k];
        P[i][k] = shrink * (shear * (H[i][k] + inverse * change) + bulk * inverse * cofactor);
      }
    return P;
  }
  template <int D, class T> static T energy(const Matrix<D, T> &whole, T lambda, T shear, T thermal)
  {
    const Matrix<D, T> H = elastic(whole, thermal);
    T square = 0.0 * thermal, trace = square;
    for (int i = 0; i < D; i++) {
      trace += H[i][i];
      for (int k = 0; k < D; k++) square += H[i][k] * H[i][k];
    }
    const T j = volume_change(H), logarithm = log_of_one_plus(j);
    return shear * (trace + 0.5 * square - logarithm) +
        0.25 * lambda * (j * (j + 2.0) - 2.0 * logarithm);
  }

 private:
  /// F/(1 + a) - I
  template <int D, class T> static Matrix<D, T> elastic(const Matrix<D, T> &H, T thermal)
  {
    const T shrink = 1.0 / (1.0 + thermal);
    Matrix<D, T> result;
    for (int i = 0; i < D; i++)
      for (int k = 0; k < D; k++) result[i][k] = shrink * (i == k ? H[i][k] - thermal : H[i][k]);
    return result;
  }
};

/// Restart files keep the place of a law in this list: new ones go to its end.
using ElasticLaw = std::variant<StVenantKirchhoff, AlmansiHooke, NeoHookean>;

}    // namespace TMSPH
#endif
