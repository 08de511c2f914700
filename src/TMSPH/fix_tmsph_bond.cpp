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
using TMSPH::WIDTH;

// a particle at the horizon but for round-off, as it may be in a lattice, is no partner: its weight
// would be 0

static constexpr double AT_HORIZON = 1.0 - 2.0e-9;    // of the square

/* ---------------------------------------------------------------------- */

FixTMSPHBond::FixTMSPHBond(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), user(nullptr), list(nullptr), bonds_formed(false), laid_out(false),
    faced(false), maxpartner(1), npartner(nullptr), partner(nullptr), state(nullptr),
    own_tag(nullptr), first_tag(nullptr), lag(nullptr), horizon(0.0), kappa(0.0),
    thickness(1.0), period{0.0, 0.0, 0.0}, corner{0.0, 0.0, 0.0},
    particles(0), volume(NAN), version(0), nremoved(0),
    what_to_send(REFERENCE)
{
  if (narg != 3 || strcmp(id, ID) != 0)
    error->all(FLERR, "Fix tmsph/bond is internal to pair style tmsph, which makes its own: remove "
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
  memory->destroy(npartner);
  memory->destroy(partner);
  memory->destroy(state);
  memory->destroy(own_tag);
  memory->destroy(first_tag);
  memory->destroy(lag);
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

  if (!bonds_formed)
    neighbor->add_request(this, NeighConst::REQ_FULL | NeighConst::REQ_OCCASIONAL);
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
    if (!follow_ids()) follow_losses();
    refuse_other_volumes();
    refuse_bonds_without();
  }
  take_stock();
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
  memory->destroy(lag);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::min_setup(int /*vflag*/)
{
  user->run_begins();
  memory->destroy(lag);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::pre_exchange()
{
  user->exchange_comes();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::post_neighbor()
{
  follow_losses();
  send_references();
  lay_out();
}

/* ----------------------------------------------------------------------
   the present positions become the reference; all pairs of bonded types
   within the horizon become bonds, sorted by the partner's id
------------------------------------------------------------------------- */

void FixTMSPHBond::form()
{
  const int nlocal = atom->nlocal;
  const int *periodicity = domain->periodicity;
  horizon = user->horizon();
  type_horizons.assign(atom->ntypes + 1, 0.0);
  for (int t = 1; t <= atom->ntypes; t++) {
    type_horizons[t] = user->horizon(t, t);
    for (int u = 1; u < t; u++) faced = faced || user->touching(t, u);
  }
  refuse_equal_ids();
  if (comm->get_comm_cutoff() < horizon)
    error->all(FLERR,
               "The ghost cutoff {} is shorter than the horizon {} of pair style tmsph: raise it "
               "with comm_modify cutoff",
               comm->get_comm_cutoff(), horizon);
  if (neighbor->exclude)
    error->all(FLERR,
               "Neigh_modify exclude would leave out bonds of pair style tmsph: remove it before "
               "the first run; types without bonds between them have 'pair_coeff I J none'");
  for (int k = 0; k < 3; k++) {
    period[k] = periodicity[k] && k < domain->dimension ? domain->prd[k] : 0.0;
    corner[k] = domain->boxlo[k];
    if (period[k] > 0.0 && period[k] < 2.0 * horizon)
      error->all(FLERR,
                 "Periodic box length {} in {} is shorter than two horizons of {}: enlarge the box "
                 "or make this boundary non-periodic",
                 period[k], "xyz"[k], horizon);
  }
  for (int i = 0; i < nlocal; i++) domain->unmap(atom->x[i], atom->image[i], atom->x0[i]);
  comm->forward_comm_array(3, atom->x0);    // ghosts came with those of before
  send_references();

  // counted first and then stored: no more memory than the bonds take in the end

  neighbor->build_one(list);
  const auto family = [&](int i, const auto &take) {
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
      take(atom->tag[j], bond ? INTACT : UNBONDED);
    }
  };
  int longest = 1, longest_of_all;
  for (int ii = 0; ii < list->inum; ii++) {
    int count = 0;
    family(list->ilist[ii], [&](tagint, State) { count++; });
    longest = std::max(longest, count);
  }
  MPI_Allreduce(&longest, &longest_of_all, 1, MPI_INT, MPI_MAX, world);
  resize_partners(longest_of_all);
  std::vector<std::pair<tagint, State>> members;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    members.clear();
    family(i, [&](tagint id, State kind) { members.emplace_back(id, kind); });
    // in a short periodic box the list also has images beyond the nearest
    std::sort(members.begin(), members.end());
    npartner[i] = std::unique(members.begin(), members.end()) - members.begin();
    for (int k = 0; k < npartner[i]; k++) {
      partner[i][k] = members[k].first;
      state[i][k] = members[k].second;
    }
    own_tag[i] = first_tag[i] = atom->tag[i];
    atom->damage[i] = 0.0;
  }
  release_list();
  bonds_formed = true;
  check_families();
}

/* ----------------------------------------------------------------------
   the list is not used again: its pages go back, before more is allocated
------------------------------------------------------------------------- */

void FixTMSPHBond::release_list()
{
  if (!list->copy && list->ipage) {
    list->inum = list->gnum = 0;
    for (int t = 0; t < comm->nthreads; t++)
      list->ipage[t].init(neighbor->oneatom, neighbor->pgsize);
  }
#if defined(__GLIBC__)
  malloc_trim(0);    // glibc would keep the pages for itself, in pieces that nothing fits into
#endif
  list = nullptr;
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
  const int nlocal = atom->nlocal;
  xref.resize(3 * (size_t) (nlocal + atom->nghost));
  for (int i = 0; i < nlocal; i++) {
    const imageint image = atom->image[i];
    const int turn[3] = {(int) (image & IMGMASK) - IMGMAX,
                         (int) (image >> IMGBITS & IMGMASK) - IMGMAX,
                         (int) (image >> IMG2BITS) - IMGMAX};
    for (int k = 0; k < 3; k++) xref[3 * (size_t) i + k] = atom->x0[i][k] - turn[k] * period[k];
  }
  comm->forward_comm(this);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  int m = 0;
  if (what_to_send == TAG) {
    for (int ii = 0; ii < n; ii++) buf[m++] = ubuf(former_tag[list[ii]]).d;
    return m;
  }
  double shift[3] = {0.0, 0.0, 0.0};
  if (pbc_flag)
    for (int k = 0; k < 3; k++) shift[k] = pbc[k] * period[k];
  for (int ii = 0; ii < n; ii++)
    for (int k = 0; k < 3; k++) buf[m++] = xref[3 * (size_t) list[ii] + k] + shift[k];
  return m;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::unpack_forward_comm(int n, int first, double *buf)
{
  if (what_to_send == TAG)
    for (int i = 0; i < n; i++) former_tag[first + i] = (tagint) ubuf(buf[i]).i;
  else
    std::copy(buf, buf + 3 * (size_t) n, xref.begin() + 3 * (size_t) first);
}

/* ----------------------------------------------------------------------
   the image of particle "id" that is nearest to i in the reference frame
------------------------------------------------------------------------- */

int FixTMSPHBond::find_partner(int i, tagint id) const
{
  const double *mine = reference(i);
  const double reach = 1.01 * user->horizon();
  for (int j = atom->map(id); j >= 0; j = atom->sametag[j]) {
    const double *his = reference(j);
    double R2 = 0.0;
    for (int k = 0; k < 3; k++) R2 += (his[k] - mine[k]) * (his[k] - mine[k]);
    if (R2 < reach * reach) return j;
  }
  return -1;
}

/* ----------------------------------------------------------------------
   slices of eight consecutive local particles, bonds in the order of ids;
   a bond that is gone keeps its place with weight 0
------------------------------------------------------------------------- */

void FixTMSPHBond::lay_out()
{
  const int nlocal = atom->nlocal;
  const int nslice = (nlocal + WIDTH - 1) / WIDTH;

  slices.particle.resize((size_t) nslice * WIDTH);
  slices.valid.resize(nslice);
  slices.offset.resize(nslice + 1);
  slices.offset[0] = 0;
  for (int q = 0; q < nslice; q++) {
    const int first = q * WIDTH, n = std::min(WIDTH, nlocal - first);
    int rows = 0;
    for (int l = 0; l < WIDTH; l++) {
      slices.particle[first + l] = l < n ? first + l : first;
      if (l < n) rows = std::max(rows, npartner[first + l]);
    }
    slices.valid[q] = n;
    slices.offset[q + 1] = slices.offset[q] + rows;
  }
  const size_t size = (size_t) slices.offset[nslice] * WIDTH;
  slices.partner.resize(size);
  slices.weight.resize(size);
  slices.averaging.clear();

  for (int q = 0; q < nslice; q++) {
    const int rows = slices.offset[q + 1] - slices.offset[q];
    for (int l = 0; l < WIDTH; l++) {
      const int i = slices.particle[q * WIDTH + l];
      const bool pad = l >= slices.valid[q];
      for (int k = 0; k < rows; k++) {
        int j = -1;
        const size_t at = slices.at(q, l, k);
        slices.weight[at] = 0.0f;
        if (!pad && k < npartner[i]) {
          j = find_partner(i, partner[i][k]);
          if (j < 0 && state[i][k] == INTACT) stop_lost(i, partner[i][k]);
          if (j >= 0 && state[i][k] == INTACT) slices.weight[at] = weight(i, j);
        }
        slices.partner[at] = j < 0 ? i : j;
      }
    }
  }
  laid_out = true;
  version++;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::stop_lost(int i, tagint partner) const
{
  refuse_changed_images(i, partner);
  const bool careless = update->whichflag == 2 &&
      strcmp(update->minimize_style, "tmsph/lbfgs") != 0;
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

int FixTMSPHBond::state_with(int i, tagint id) const
{
  const tagint *first = partner[i], *last = first + npartner[i];
  const tagint *found = std::lower_bound(first, last, id);
  return found != last && *found == id ? state[i][found - first] : -1;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::remove_bond(int i, int k, State why)
{
  state[i][k] = why;
  nremoved++;
  const size_t at = slices.at(i / WIDTH, i % WIDTH, k);
  slices.weight[at] = 0.0f;
  if (!slices.averaging.empty()) slices.averaging[at] = 0.0f;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::update_damage(int i)
{
  const int broken = count_in(i, 1u << BROKEN), formed = count_in(i, FORMED);
  atom->damage[i] = formed ? (double) broken / formed : 0.0;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::count_in(int i, unsigned states) const
{
  return std::count_if(state[i], state[i] + npartner[i],
                       [states](unsigned char one) { return states >> one & 1u; });
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
