/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress of particles that walls or contacts press, for output and for the
   breaking of bonds.

   A force on the surface reaches the outermost particles, while bonds pass it
   on over the horizon. What bonds carry of a uniform stress p near a wall
   follows from their equilibrium, row by row: 0.71, 0.81, 0.96, 1.02 p in a
   square lattice. Missing is p over half a row: the force on the surface times
   half a row. Meant is the average with the kernel of both (Hardy, J. Chem.
   Phys. 76 (1982) 622). Only bonds to the own material take part.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PRESSED_SURFACES_H
#define LMP_TMSPH_PRESSED_SURFACES_H

#include "fix_tmsph_bond.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_materials.h"
#include "tmsph_presses.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHPressedSurfaces : protected Pointers {
 public:
  TMSPHPressedSurfaces(class LAMMPS *lmp, const TMSPHMaterials &materials,
                       TMSPHGhostSender &ghosts) :
      Pointers(lmp),
      materials(materials), ghosts(ghosts)
  {
  }
  void init();
  /** Adds to the stresses of local particles what presses on them (collective).
      @param stress rows of local particles, and room for those of ghosts */
  void add_stress(const FixTMSPHBond &, double *stress);
  /// local particles that lost a bond
  void follow(const FixTMSPHBond &, const std::vector<int> &touched);
  /// sent by add_stress(), once some surface is pressed; 0 without a fix that could
  int doubles_per_ghost() const;
  double bytes() const;

 private:
  struct Near {
    int j;
    double mass;    // V_j W_ij
  };
  struct Span {
    int first = 0, last = 0;    // of those near a particle; 0: not listed
  };
  struct Member {
    int i;
    double part;    // of the average that it reports
  };
  struct Across {
    int i, k, ghost;    // a local particle and its bond to a ghost
  };

  const TMSPHMaterials &materials;
  TMSPHGhostSender &ghosts;
  const FixTMSPHBond *bonds = nullptr;    // of the present call, as the stresses
  double *stress = nullptr;
  int size = 0;                            // of a stress row
  int trusted = 0;                         // calls until it is asked who is pressed
  TMSPHBondWatch layout;                   // that all the rest belongs to
  TMSPHGhostRows rows;                     // how it is pressed, see the columns; 0: nothing
  std::vector<int> outermost, touching;    // local particles with a row: by surfaces, by pairs
  std::vector<Member> members;
  std::vector<double> changes;    // of the stress of each
  std::vector<Near> near_ones;
  std::vector<Span> spans;    // [nlocal]
  std::vector<Across> across;
  std::vector<char> listed;    // [nlocal]

  bool pressed(bool here);
  void lay_out();
  Span near(int i);
  void take_loads(const std::vector<TMSPHPresses::Load> &);
  void find_members();
  void average_surfaces();
  void average_pairs();
  void average(const double *stresses, int stride, bool pairs);
  void add_changes();
};

}    // namespace LAMMPS_NS

#endif
