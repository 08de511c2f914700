/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The stable time step about a state, by power iteration on its forces.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_STABLE_STEP_H
#define LMP_TMSPH_STABLE_STEP_H

#include <functional>
#include <mpi.h>
#include <vector>

namespace TMSPH {

/** Forces on the local particles when they are displaced by push times the trial vector and have
    2/dt times that as velocities, without what is quadratic in those. */
using TrialForces = std::function<void(const std::vector<double> &trial, double push, double dt,
                                       std::vector<double> &forces)>;

/** Largest stable time step of velocity Verlet (collective).
    @param trial  to begin with, D components for each local particle
    @param D      dimension
    @param mass   of local particles
    @param length displacements to try, small against the body's
    @param dt     to begin with
    @return       HUGE_VAL if no trial displacement meets a force */
double stable_step(std::vector<double> trial, int D, const double *mass, double length, double dt,
                   MPI_Comm world, const TrialForces &forces);

}    // namespace TMSPH
#endif
