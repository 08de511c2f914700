/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/contact: contact with friction between bodies that are not bonded
   and between the faces of cracks and cuts. It calls its parts in the order of
   a step.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/contact,FixTMSPHContact);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_CONTACT_H
#define LMP_FIX_TMSPH_CONTACT_H

#include "fix.h"
#include "tmsph_contact_couples.h"
#include "tmsph_contact_fit.h"
#include "tmsph_contact_forces.h"
#include "tmsph_contact_list.h"
#include "tmsph_contact_memory.h"
#include "tmsph_contact_outlines.h"
#include "tmsph_contact_places.h"
#include "tmsph_contact_scene.h"
#include "tmsph_contact_search.h"
#include "tmsph_contact_surfaces.h"
#include "tmsph_contact_totals.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_presses.h"
#include "tmsph_surface_contact.h"

#include <memory>

namespace LAMMPS_NS {

class FixTMSPHContact :
    public Fix,
    public TMSPHSurfaceContact,
    public TMSPHPresses,
    public TMSPHStoresIds {
 public:
  FixTMSPHContact(class LAMMPS *, int, char **);
  ~FixTMSPHContact() override;
  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  void follow_ids(const TMSPHPresentIds &) override;

  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  bool touching(int, int) const override { return true; }
  unsigned states() const override { return scene.states(); }
  void add_loads(std::vector<Load> &) override;
  bool may_press() const override { return possible(); }
  int doubles_per_ghost() const override;
  void opened(int i, int k) override { list.opened(i, k); }
  double touching_pairs() override { return compute_vector(TMSPHContactTotals::TOUCHING); }
  void touches(std::vector<Touch> &) override;
  void rubbings(std::vector<Rubbing> &) override;

 private:
  TMSPHContactScene scene;
  TMSPHGhostSender ghosts;
  TMSPHContactTotals totals;
  TMSPHContactMemories memories;    // once pairs are listed, number n is that of member n
  TMSPHContactList list;
  TMSPHContactSurfaces surfaces;
  TMSPHContactFit fits;
  TMSPHContactSearch search;
  TMSPHContactForces forces;
  TMSPHContactCouples couples;
  std::unique_ptr<TMSPHContactOutlines> outlines;    // only for method segment
  std::unique_ptr<TMSPHContactPlaces> places;
  TMSPHBondWatch watch;    // of the bonds when the pairs were listed
  bool resumed;            // the setup takes the forces of the last step again

  void parse(int, char **);
  void read_friction(class TMSPHValues &);
  void read_method(TMSPHValues &);
  void follow(bool after_breaks);
  void list_pairs(const std::vector<int> *touched);
  bool facing() const { return outlines && outlines->any; }
  bool possible() const { return list.anywhere || facing(); }
  void act(double dt);
  template <int D> void evaluate(double dt);
  void apply_again();
  void add_virial();
};

}    // namespace LAMMPS_NS

#endif
#endif
