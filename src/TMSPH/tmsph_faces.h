/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Where bonds open, faces of cracks and cuts touch whether the input asks for contact or not.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_FACES_H
#define LMP_TMSPH_FACES_H

namespace LAMMPS_NS {

class LAMMPS;

/** What a fix that breaks bonds says. */
struct TMSPHOpensBonds {
  /// true if bonds of a type open before they are gone
  virtual bool softens() const = 0;

 protected:
  ~TMSPHOpensBonds() = default;    // owned as a fix, never through this interface
};

namespace TMSPHFaces {
/// id of the fix tmsph/contact that provide() defines
constexpr const char *ID = "TMSPH_FACES";

/// true if bonds may open
bool possible(LAMMPS *);

/** In the init of the pair style: where faces are possible and the input has no fix tmsph/contact
      there is one without friction, whose energy is counted with that of the pair style. */
void provide(LAMMPS *);
}    // namespace TMSPHFaces

}    // namespace LAMMPS_NS

#endif
