/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Is the time step stable, at the start of a run, and when is that asked anew.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_TIMESTEP_CHECK_H
#define LMP_TMSPH_TIMESTEP_CHECK_H

#include "fix_tmsph_bond.h"
#include "tmsph_materials.h"

#include <functional>
#include <string>
#include <utility>

namespace LAMMPS_NS {

class TMSPHTimestepCheck : protected Pointers {
 public:
  explicit TMSPHTimestepCheck(class LAMMPS *lmp) : Pointers(lmp) {}
  /// materials or settings are others
  void forget() { estimated = false; }
  /** An error if the time step is above the stable one, warnings if it may become so (collective).
      @param doubt    what is wrong with a material, if anything: then that is to blame
      @param estimate the stable step of the present state, which costs some tens of force
                      evaluations: asked again only when a hundredth of the bonds has gone since, or
                      materials or particles changed */
  void check(const TMSPHMaterials &, const FixTMSPHBond &, bool bonds_may_break,
             const std::string &doubt, const std::function<double()> &estimate);
  /// as estimated last
  double stable() const { return stable_dt; }

 private:
  bool estimated = false;
  bigint bonds_at_estimate = 0;
  double mass_at_estimate = 0.0, stiffness_at_estimate = 0.0;    // see matter()
  double stable_dt = 0.0, intact_dt = 0.0;                       // now, and before bonds broke

  std::pair<double, double> matter(const TMSPHMaterials &) const;
};

}    // namespace LAMMPS_NS

#endif
