/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What LAMMPS and outputs ask of pair style tmsph besides forces, and what it
   tells at the start of a run.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "domain.h"
#include "error.h"
#include "force.h"
#include "tmsph_openings.h"

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

void PairTMSPH::run_begins()
{
  int left = !openings() && bond_fix->bonds_carry(TMSPHOpenings::NAME, atom->nlocal), any;
  MPI_Allreduce(&left, &any, 1, MPI_INT, MPI_MAX, world);
  if (any)
    error->all(FLERR,
               "Bonds have begun to open, and no fix has the word energy or toughness: keep "
               "the fix that breaks bonds as it was, after read_restart too");
  const bool two = domain->dimension == 2;
  const int columns = two ? Rows<2>::communicated(on) : Rows<3>::communicated(on);
  const int others = averaging.doubles_per_ghost() + coupling.doubles_per_ghost();
  const double bytes = memory_usage() + bond_fix->memory_usage();
  run_report.begin(*bond_fix, {features(), bytes, columns + others, expands()},
                   [this]() { return stable_timestep(); });
}

/* ---------------------------------------------------------------------- */

std::string PairTMSPH::features() const
{
  std::string text = domain->dimension == 3 ? "3-D"
      : chosen.plane == Plane::STRAIN       ? "plane strain"
                                            : "plane stress";
  text += std::visit([](auto law) { return fmt::format(", {}", law.TITLE); }, on.law);
  if (on.thermal == ThermalStrain::BOND) text += ", thermal bonds";
  if (on.thermal == ThermalStrain::CONSTITUTIVE) text += ", thermal strain";
  if (averaging.on()) text += ", averaged dilatation";
  if (coupling.on()) text += ", coupled interfaces";
  if (on.hourglass) text += fmt::format(", hourglass {}", chosen.hourglass);
  if (openings()) text += ", more of it where bonds open";
  if (on.viscosity) text += fmt::format(", viscosity {} {}", chosen.alpha1, chosen.alpha2);
  if (break_test)
    text += fmt::format(", breaking with {} doubles more per ghost", stress_row(domain->dimension));
  if (contact)
    text += fmt::format(", contact with {} doubles more per ghost", contact->doubles_per_ghost());
  const int more = break_test ? pressed.doubles_per_ghost() : 0;
  if (more) text += fmt::format(", pressed surfaces with {} doubles more per ghost", more);
  return text;
}

/* ---------------------------------------------------------------------- */

int PairTMSPH::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  const int size = ghosts.pack(n, list, buf);
  if (pbc_flag) rows.add_rate(n, list, buf, pbc);
  return size;
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::unpack_forward_comm(int n, int first, double *buf)
{
  ghosts.unpack(n, first, buf);
}

/* ---------------------------------------------------------------------- */

double PairTMSPH::memory_usage()
{
  return Pair::memory_usage() + rows.bytes() + averaging.bytes() + coupling.bytes() +
      own_side.bytes() + pressed.bytes() +
      (stress.capacity() + gradient.capacity()) * sizeof(double);
}

/* ---------------------------------------------------------------------- */

PairTMSPH *PairTMSPH::laid_out(LAMMPS *lmp, const std::string &who)
{
  auto pair = dynamic_cast<PairTMSPH *>(lmp->force->pair_match("^tmsph", 0));
  if (!pair) lmp->error->all(FLERR, "{} needs pair style tmsph", who);
  if (!pair->bond_fix || !pair->bond_fix->formed())
    lmp->error->all(FLERR, "{} before the bonds formed: do a run first", who);
  pair->bond_fix->need_layout(who);
  pair->the_box.meet_output();
  return pair;
}
