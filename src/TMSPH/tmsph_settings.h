/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The words of pair_style tmsph, in an input and in restart files.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_SETTINGS_H
#define LMP_TMSPH_SETTINGS_H

#include "pointers.h"
#include "tmsph_dilatation.h"
#include "tmsph_kernel.h"

#include <cstdio>

namespace LAMMPS_NS {

struct TMSPHSettings {
  double horizon = 0.0;
  TMSPH::Kernel kernel = TMSPH::WendlandC2();
  TMSPH::Plane plane = TMSPH::Plane::STRAIN;
  TMSPH::ElasticLaw law;
  TMSPH::ThermalStrain thermal = TMSPH::ThermalStrain::BOND;    // where something expands
  double hourglass = 0.1;    // least errors of 0.03 to 1: doc/report/incompressible.md, accuracy.md
  double alpha1 = 0.0, alpha2 = 0.0;    // of viscosity
  TMSPH::Dilatation dilatation = TMSPH::Dilatation::AUTO;

  void read(class LAMMPS *, int narg, char **arg);
  void write_restart(FILE *) const;
  void read_restart(class LAMMPS *, FILE *);
};

}    // namespace LAMMPS_NS

#endif
