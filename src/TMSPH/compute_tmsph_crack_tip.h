/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   compute tmsph/crack/tip: the farthest broken bond along a direction, and how
   fast it advances.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(tmsph/crack/tip,ComputeTMSPHCrackTip);
// clang-format on
#else

#ifndef LMP_COMPUTE_TMSPH_CRACK_TIP_H
#define LMP_COMPUTE_TMSPH_CRACK_TIP_H

#include "compute.h"

#include <array>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class ComputeTMSPHCrackTip : public Compute {
 public:
  ComputeTMSPHCrackTip(class LAMMPS *, int, char **);
  ~ComputeTMSPHCrackTip() override;
  void init() override;
  void compute_vector() override;

 private:
  /** A bond seen from one of its ends; doubles, as processors send them to each other. */
  struct Tip {
    double distance = 0.0, own_id = 0.0, partner_id = 0.0;
    double X[3] = {0.0, 0.0, 0.0};    // its middle, in the reference state
    double part = 0.0;                // how far it is open; 0: there is none
    bool farther_than(const Tip &) const;
  };
  /** A broken bond, but nobody here knows where its other end is. */
  struct OutOfReach {
    int i;
    tagint partner;
  };

  double direction[3];
  double least_part = 1.0;    // that a bond is open to count
  bool with_cuts = false;
  int window = 10;    // evaluations that the speed is fitted to
  const class FixTMSPHBond *bonds = nullptr;
  std::string store_id;
  class FixStoreGlobal *store;    // distances of before; they go into restart files

  void read_direction(class TMSPHValues &);
  void keep_history();
  double part_of(class TMSPHOpenings *, int i, int k) const;
  void take(Tip &, int i, tagint partner, const double *partner_x0, double part) const;
  std::vector<OutOfReach> find_at_hand(Tip &) const;
  void find_out_of_reach(Tip &, const std::vector<OutOfReach> &) const;
  std::vector<std::array<double, 4>> places_of(const std::vector<tagint> &) const;
  Tip farthest_of_all(const Tip &) const;
  double find_speed(const Tip &);
};

}    // namespace LAMMPS_NS

#endif
#endif
