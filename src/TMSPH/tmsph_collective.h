/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Figures of numbers that are spread over processors: the same however they are
   spread.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_COLLECTIVE_H
#define LMP_TMSPH_COLLECTIVE_H

#include <array>
#include <mpi.h>
#include <vector>

namespace TMSPH {

/// The sum of the terms of all processors.
double fixed_point_sum(const std::vector<double> &terms, MPI_Comm world);
/// the same of vectors
std::array<double, 3> fixed_point_sum(const std::vector<std::array<double, 3>> &terms,
                                      MPI_Comm world);

/// Median of positive numbers of all processors; 0 if there are none.
double median(const std::vector<double> &values, MPI_Comm world);

}    // namespace TMSPH
#endif
