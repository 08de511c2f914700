/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "fix_tmsph_bond.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "my_page.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace LAMMPS_NS;
using namespace FixConst;
using TMSPH::LANES;

// a particle at the horizon but for round-off, as it may be in a lattice, is no partner: its weight
// would be 0

static constexpr double AT_HORIZON = 1.0 - 2.0e-9;    // of the square

/* ---------------------------------------------------------------------- */

FixTMSPHBond::FixTMSPHBond(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), TMSPHReferenceGeometry(lmp), census(lmp, *this, this),
    lag(particle_values("velocity lag", 6)), list(nullptr), bonds_formed(false), faced(false)
{
  if (narg != 3 || strcmp(id, ID) != 0)
    error->all(FLERR,
               "Fix tmsph/bond is internal to pair style tmsph, which makes its own: remove "
               "this one");
  restart_global = 1;
  restart_peratom = 1;
  create_attribute = 1;
  maxexchange_dynamic = 1;
  comm_forward = 3;

  FixTMSPHBond::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  for (int i = 0; i < atom->nlocal; i++) FixTMSPHBond::set_arrays(i);
}

/* ---------------------------------------------------------------------- */

FixTMSPHBond::~FixTMSPHBond()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::setmask()
{
  return PRE_EXCHANGE | POST_NEIGHBOR | MIN_POST_NEIGHBOR;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::init()
{
  user = dynamic_cast<TMSPHBondUser *>(force->pair_match("^tmsph", 0));
  if (!user) error->all(FLERR, "The bonds of pair style tmsph are left without their pair style");

  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "Pair style tmsph cannot run with run_style {}: use run_style verlet",
               update->integrate_style);
  if (bonds_formed && horizon != user->horizon())
    error->all(FLERR,
               "Horizon {} of pair_style tmsph differs from {}, with which the bonds have formed: "
               "keep it, or 'clear' and start anew",
               user->horizon(), horizon);
  for (int t = 1; bonds_formed && t <= atom->ntypes; t++)
    if (type_horizons[t] != user->horizon(t, t))
      error->all(FLERR,
                 "Horizon {} of type {} in pair_coeff differs from {}, with which the bonds have "
                 "formed: keep it, or 'clear' and start anew",
                 user->horizon(t, t), t, type_horizons[t]);

  // a neighbor list serves once, to form the families

  if (!bonds_formed) neighbor->add_request(this, NeighConst::REQ_FULL | NeighConst::REQ_OCCASIONAL);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::init_list(int /*id*/, NeighList *ptr)
{
  list = ptr;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::setup_post_neighbor()
{
  const bool fresh = !bonds_formed;
  if (fresh)
    form();
  else {
    if (!census.follow_ids()) census.follow_losses();
    census.refuse_other_volumes();
    refuse_bonds_without();
  }
  census.take();
  send_references();
  lay_out();
  if (fresh) {
    kappa = largest_kappa();
    thickness = find_thickness();
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::setup(int /*vflag*/)
{
  user->run_begins();
  lag.stop();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::pre_exchange()
{
  maxexchange = most_of_row();
  user->exchange_comes();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::post_neighbor()
{
  census.follow_losses();
  send_references();
  lay_out();
}

/* ----------------------------------------------------------------------
   what the bonds are about to form with
------------------------------------------------------------------------- */

void FixTMSPHBond::check_formation() const
{
  census.refuse_equal_ids();
  if (comm->get_comm_cutoff() < horizon)
    error->all(FLERR,
               "The ghost cutoff {} is shorter than the horizon {} of pair style tmsph: raise it "
               "with comm_modify cutoff",
               comm->get_comm_cutoff(), horizon);
  if (neighbor->exclude)
    error->all(FLERR,
               "Neigh_modify exclude would leave out bonds of pair style tmsph: remove it before "
               "the first run; types without bonds between them have 'pair_coeff I J none'");
  for (int k = 0; k < 3; k++)
    if (period[k] > 0.0 && period[k] < 2.0 * horizon)
      error->all(FLERR,
                 "Periodic box length {} in {} is shorter than two horizons of {}: enlarge the box "
                 "or make this boundary non-periodic",
                 period[k], "xyz"[k], horizon);
}

/* ----------------------------------------------------------------------
   the list is not used again: its pages go back, before more is allocated
------------------------------------------------------------------------- */

static void release_pages(NeighList *list, int nthreads, const Neighbor &neighbor)
{
  if (!list->copy && list->ipage) {
    list->inum = list->gnum = 0;
    for (int t = 0; t < nthreads; t++) list->ipage[t].init(neighbor.oneatom, neighbor.pgsize);
  }
#if defined(__GLIBC__)
  malloc_trim(0);    // glibc would keep the pages for itself, in pieces that nothing fits into
#endif
}

/* ----------------------------------------------------------------------
   the present positions become the reference; all pairs of bonded types
   within the horizon become bonds, sorted by the partner's id
------------------------------------------------------------------------- */

void FixTMSPHBond::form()
{
  horizon = user->horizon();
  type_horizons.assign(atom->ntypes + 1, 0.0);
  for (int t = 1; t <= atom->ntypes; t++) {
    type_horizons[t] = user->horizon(t, t);
    for (int u = 1; u < t; u++) faced = faced || user->touching(t, u);
  }
  take_box();
  check_formation();
  for (int i = 0; i < atom->nlocal; i++) domain->unmap(atom->x[i], atom->image[i], atom->x0[i]);
  comm->forward_comm_array(3, atom->x0);    // ghosts came with those of before
  send_references();

  // counted first and then stored: no more memory than the bonds take in the end

  neighbor->build_one(list);
  int longest = 1, longest_of_all;
  for (int ii = 0; ii < list->inum; ii++)
    longest = std::max<int>(longest, find_members(list->ilist[ii]).size());
  MPI_Allreduce(&longest, &longest_of_all, 1, MPI_INT, MPI_MAX, world);
  resize_rows(longest_of_all, atom->nmax);
  maxexchange = most_of_row();
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    set_family(i, atom->tag[i], find_members(i));
    atom->damage[i] = 0.0;
  }
  release_pages(list, comm->nthreads, *neighbor);
  list = nullptr;
  bonds_formed = true;
  check_families();
}

/* ----------------------------------------------------------------------
   ids and states of those within the horizon of a local particle, ascending
------------------------------------------------------------------------- */

std::vector<std::pair<tagint, TMSPHFamilies::State>> FixTMSPHBond::find_members(int i) const
{
  std::vector<std::pair<tagint, State>> members;
  for (int jj = 0; jj < list->numneigh[i]; jj++) {
    const int j = list->firstneigh[i][jj] & NEIGHMASK;
    const bool bond = user->bonded(atom->type[i], atom->type[j]);
    if (!bond && !user->touching(atom->type[i], atom->type[j])) continue;
    if (atom->tag[j] == atom->tag[i]) continue;    // its own image
    double X[3];
    reference_vector(i, j, X);
    const double R2 = X[0] * X[0] + X[1] * X[1] + X[2] * X[2];
    const double reach = user->horizon(atom->type[i], atom->type[j]);
    if (R2 >= AT_HORIZON * reach * reach) continue;
    if (R2 == 0.0)
      error->one(FLERR,
                 "Particles {} and {} stand on the same place: remove one, for instance with "
                 "delete_atoms overlap",
                 atom->tag[i], atom->tag[j]);
    members.emplace_back(atom->tag[j], bond ? INTACT : UNBONDED);
  }
  // in a short periodic box the list also has images beyond the nearest
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  return members;
}

/* ----------------------------------------------------------------------
   a strain needs d+1 particles: dust is allowed, a horizon too short is not
------------------------------------------------------------------------- */

void FixTMSPHBond::check_families() const
{
  bigint few = 0, all;
  for (int i = 0; i < atom->nlocal; i++) few += count_in(i, FORMED) < domain->dimension;
  MPI_Allreduce(&few, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all > atom->natoms / 2)
    error->all(FLERR,
               "{} of {} particles have fewer than {} neighbors within the horizon {}: it should "
               "be about 3 particle spacings",
               all, atom->natoms, domain->dimension, user->horizon());
  if (all && comm->me == 0)
    error->warning(FLERR, "{} particles have fewer than {} neighbors and carry no stress", all,
                   domain->dimension);
}

/* ----------------------------------------------------------------------
   reference positions in the frame of the present images, ghosts too
------------------------------------------------------------------------- */

void FixTMSPHBond::send_references()
{
  place_local();
  comm->forward_comm(this);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  return census.sending() ? census.pack(n, list, buf)
                          : pack_references(n, list, buf, pbc_flag, pbc);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::unpack_forward_comm(int n, int first, double *buf)
{
  if (census.sending())
    census.unpack(n, first, buf);
  else
    unpack_references(n, first, buf);
}

/* ----------------------------------------------------------------------
   slices of eight consecutive local particles, bonds in the order of ids;
   a bond that is gone keeps its place with weight 0
------------------------------------------------------------------------- */

void FixTMSPHBond::lay_out()
{
  const int nlocal = atom->nlocal;
  const int nslice = (nlocal + LANES - 1) / LANES;

  slices.particle.resize((size_t) nslice * LANES);
  slices.valid.resize(nslice);
  slices.offset.resize(nslice + 1);
  slices.offset[0] = 0;
  for (int q = 0; q < nslice; q++) {
    const int first = q * LANES, n = std::min(LANES, nlocal - first);
    int rows = 0;
    for (int l = 0; l < LANES; l++) {
      slices.particle[first + l] = l < n ? first + l : first;
      if (l < n) rows = std::max(rows, count(first + l));
    }
    slices.valid[q] = n;
    slices.offset[q + 1] = slices.offset[q] + rows;
  }
  const size_t size = (size_t) slices.offset[nslice] * LANES;
  slices.partner.resize(size);
  slices.weight.resize(size);
  slices.averaging.clear();

  for (int q = 0; q < nslice; q++) {
    const int rows = slices.offset[q + 1] - slices.offset[q];
    for (int l = 0; l < LANES; l++) {
      const int i = slices.particle[q * LANES + l];
      const bool pad = l >= slices.valid[q];
      for (int k = 0; k < rows; k++) {
        int j = -1;
        const size_t at = slices.at(q, l, k);
        slices.weight[at] = 0.0f;
        if (!pad && k < count(i)) {
          j = find_image(i, partner_tag(i, k));
          const bool holds = bond_state(i, k) == INTACT;
          if (j < 0 && holds) stop_lost(i, partner_tag(i, k));
          if (j >= 0 && holds) slices.weight[at] = weight(i, j);
        }
        slices.partner[at] = j < 0 ? i : j;
      }
    }
  }
  lays_out();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::stop_lost(int i, tagint partner) const
{
  refuse_changed_images(i, partner);
  const bool careless =
      update->whichflag == 2 && strcmp(update->minimize_style, "tmsph/lbfgs") != 0;
  if (careless)
    error->one(FLERR,
               "Particle {} lost its bonded partner {} in iteration {} of min_style {}, which "
               "moves particles too far: use 'min_style tmsph/lbfgs'",
               atom->tag[i], partner, update->ntimestep, update->minimize_style);
  error->one(FLERR,
             "Particle {} lost its bonded partner {} on step {}: it moved farther than the ghost "
             "cutoff {}; raise it with comm_modify cutoff or let the bond break",
             atom->tag[i], partner, update->ntimestep, comm->get_comm_cutoff());
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::remove_bond(int i, int k, State why)
{
  set_state(i, k, why);
  drop_carried(i, k);
  loses(i);
  const size_t at = slices.at(i, k);
  slices.weight[at] = 0.0f;
  if (!slices.averaging.empty()) slices.averaging[at] = 0.0f;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::update_damage(int i, double opened)
{
  const int broken = count_in(i, 1u << BROKEN), formed = count_in(i, FORMED);
  atom->damage[i] = formed ? (broken + opened) / formed : 0.0;
}

/* ---------------------------------------------------------------------- */

bigint FixTMSPHBond::count_bonds(State which) const
{
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) mine += count_in(i, 1u << which);
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all / 2;
}

/* ---------------------------------------------------------------------- */

std::pair<int, int> FixTMSPHBond::family_sizes() const
{
  int mine[2] = {-MAXSMALLINT, 0}, all[2];    // minus the smallest, the largest
  for (int i = 0; i < atom->nlocal; i++) {
    const int formed = count_in(i, FORMED);
    mine[0] = std::max(mine[0], -formed);
    mine[1] = std::max(mine[1], formed);
  }
  MPI_Allreduce(mine, all, 2, MPI_INT, MPI_MAX, world);
  return {-all[0], all[1]};
}

/* ----------------------------------------------------------------------
   which types are bonded is asked only when the bonds form
------------------------------------------------------------------------- */

void FixTMSPHBond::refuse_bonds_without() const
{
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < count(i); k++) {
      const int j = atom->map(partner_tag(i, k));
      if (bond_state(i, k) == INTACT && j >= 0 && !user->bonded(atom->type[i], atom->type[j]))
        error->one(FLERR,
                   "Particles {} and {} are bonded, and 'pair_coeff {} {} none' came later, or "
                   "'set type': bonds form at the first run; later tmsph/cut removes them",
                   atom->tag[i], partner_tag(i, k), atom->type[i], atom->type[j]);
    }
}

/* ----------------------------------------------------------------------
   A partner that is near, but not in the reference frame, has another image flag than when the
   bonds formed, and did not move by a period.
------------------------------------------------------------------------- */

void FixTMSPHBond::refuse_changed_images(int i, tagint partner) const
{
  for (int j = atom->map(partner); j >= 0; j = atom->sametag[j]) {
    double r2 = 0.0;
    for (int k = 0; k < 3; k++) r2 += std::pow(atom->x[j][k] - atom->x[i][k], 2);
    if (r2 < horizon * horizon)
      error->one(FLERR,
                 "Particles {} and {}, which are bonded, have image flags that were changed since "
                 "the bonds formed: do without 'set image' and 'reset_atoms image', or use them "
                 "before the first run",
                 atom->tag[i], partner);
  }
}

/* ----------------------------------------------------------------------
   what outputs find by local and ghost indices was laid out when ghosts came last;
   between runs particles may have gone to other places since (collective)
------------------------------------------------------------------------- */

void FixTMSPHBond::need_layout(const std::string &who) const
{
  int mine = !all_in_place() || !all_placed();
  int any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (any)
    error->all(FLERR, "{} after particles were created, deleted or displaced: do a 'run 0' first",
               who);
}
