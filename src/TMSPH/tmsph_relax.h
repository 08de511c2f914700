/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Command tmsph/relax: bodies without a lattice. Moves the particles in regions
   until they are spread evenly.
------------------------------------------------------------------------- */

#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(tmsph/relax,TMSPHRelax);
// clang-format on
#else

#ifndef LMP_TMSPH_RELAX_H
#define LMP_TMSPH_RELAX_H

#include "command.h"
#include "tmsph_relaxation.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class TMSPHRelax : public Command {
 public:
  TMSPHRelax(class LAMMPS *lmp) : Command(lmp) {}
  void command(int, char **) override;

 private:
  /// a particle of the group, in the same order on all processors
  struct Member {
    tagint id;
    int body, type;
    double place[3], volume;
  };
  struct Body {
    std::string name;
    bigint particles = 0;
    double size = 0.0, given = 0.0;    // of the region, sum of the volumes that were given
  };
  int groupbit;
  int pushes = -1, balances = 50;    // -1: as many as the size of the bodies asks for
  double thickness = 0.0;            // 0: not given
  std::vector<class Region *> regions;
  std::vector<Body> bodies;
  std::vector<Member> members;

  void read_words(int, char **);
  void check() const;
  void add_region(class TMSPHValues &);
  int body_of(tagint id, const double *X) const;
  void gather();
  void sort_by_places();
  void check_bodies() const;
  TMSPH::CloudBonds bonds() const;
  double spacing_in(const Body &) const;
  void check_horizons() const;
  template <int D> void relax();
  template <int D> std::vector<TMSPH::CloudParticle<D>> cloud();
  TMSPH::CloudShare share() const;
  void check_places(const std::vector<TMSPH::CloudFigures> &) const;
  void put_back();
  void tell(const std::vector<TMSPH::CloudFigures> &before,
            const std::vector<TMSPH::CloudFigures> &after) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
