/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Pairs whose surfaces were found anew, before they act. In a file of its own: the one
   contact_state() of tmsph_contact_forces.cpp then becomes part of the loop there.
------------------------------------------------------------------------- */

#include "tmsph_contact_forces.h"

#include "atom.h"

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ----------------------------------------------------------------------
   pasts of the refitted pairs
------------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::keep_energy()
{
  const Kernel kernel = scene.pair->kernel_of_bonds();
  const bool expands = scene.pair->expands();
  for (const TMSPHContactList::Refit &r : list.refits) {
    Pairing &p = list.pairings[r.pairing];
    const auto low = end_at<D>(p.low, expands), high = end_at<D>(p.high, expands);
    p.now = past_of_refitted(contact_state<D>(r.before, low, high, p.now, kernel, 0.0),
                             contact_state<D>(p.pair, low, high, {}, kernel, 0.0));
  }
  list.refits.clear();
}

// for tmsph_contact_forces.cpp

template void TMSPHContactForces::keep_energy<2>();
template void TMSPHContactForces::keep_energy<3>();
