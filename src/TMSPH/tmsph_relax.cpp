/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Command tmsph/relax: moves the particles in regions until they are spread evenly.
------------------------------------------------------------------------- */

#include "tmsph_relax.h"

#include "atom.h"
#include "atom_vec_tmsph.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "group.h"
#include "irregular.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "region.h"
#include "tmsph_region_shapes.h"
#include "tmsph_report.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

void TMSPHRelax::command(int narg, char **arg)
{
  if (narg < 2) utils::missing_cmd_args(FLERR, "tmsph/relax", error);
  if (!domain->box_exist)
    error->all(FLERR, "Command tmsph/relax before the simulation box is defined");
  const int igroup = group->find(arg[0]);
  if (igroup < 0)
    error->all(FLERR, "Group {} of tmsph/relax does not exist: define it first", arg[0]);
  groupbit = group->bitmask[igroup];
  read_words(narg - 1, arg + 1);
  check();
  if (group->count(igroup) == 0)
    error->all(FLERR, "Group {} of tmsph/relax has no particles: create them first", arg[0]);
  gather();
  check_bodies();
  if (domain->dimension == 2)
    relax<2>();
  else
    relax<3>();
  put_back();
}

/* ---------------------------------------------------------------------- */

void TMSPHRelax::read_words(int narg, char **arg)
{
  const auto count = [](TMSPHValues &values) {
    const int n = values.integer();
    if (n < 0) values.reject(std::to_string(n), "is out of range: it must not be negative");
    return n;
  };
  TMSPHWords(lmp, "tmsph/relax",
             {{"region", "ID", [&](TMSPHValues &v) { add_region(v); }},
              {"thickness", "t",
               [&](TMSPHValues &v) {
                 thickness = v.number(TMSPHRule::positive, "is out of range: it must be positive");
               },
               2},
              {"push", "N", [&](TMSPHValues &v) { pushes = count(v); }},
              {"balance", "N", [&](TMSPHValues &v) { balances = count(v); }}})
      .read_all(arg, arg + narg);
  if (regions.empty())
    error->all(FLERR, "Command tmsph/relax needs the surface of the body: give 'region ID'");
}

/* ---------------------------------------------------------------------- */

void TMSPHRelax::add_region(TMSPHValues &values)
{
  Region *const region = domain->get_region_by_id(values.text());
  if (!region)
    values.reject(values.rest()[-1], "does not exist: define it first, by the command region");
  if (region->openflag) values.reject(region->id, "has open faces: define one without 'open'");
  if (std::count(regions.begin(), regions.end(), region))
    values.reject(region->id, "is given twice: give it once");
  region->prematch();
  regions.push_back(region);
  bodies.emplace_back();
  bodies.back().name = region->id;
}

/* ---------------------------------------------------------------------- */

void TMSPHRelax::check() const
{
  if (!dynamic_cast<AtomVecTMSPH *>(atom->avec))
    error->all(FLERR, "Command tmsph/relax needs atom_style tmsph");
  auto pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  bool complete = pair && pair->allocated;
  for (int type = 1; complete && type <= atom->ntypes; type++) complete = pair->setflag[type][type];
  if (!complete)
    error->all(FLERR, "Command tmsph/relax needs pair style tmsph and its coefficients before it");
  auto bonds = dynamic_cast<FixTMSPHBond *>(modify->get_fix_by_id(FixTMSPHBond::ID));
  if (bonds && bonds->formed())
    error->all(FLERR,
               "Command tmsph/relax after the bonds have formed would load the body: use it before "
               "the first run");
  if (domain->triclinic)
    error->all(FLERR, "Command tmsph/relax needs an orthogonal box: the box is triclinic");
}

/* ---------------------------------------------------------------------- */

int TMSPHRelax::body_of(tagint id, const double *X) const
{
  int body = -1;
  for (int b = 0; b < (int) regions.size(); b++) {
    if (!regions[b]->match(X[0], X[1], X[2])) continue;
    if (body >= 0)
      error->one(FLERR,
                 "Regions {} and {} of tmsph/relax overlap, particle {} is in both: cut one out of "
                 "the other, by 'side out' and 'intersect'",
                 regions[body]->id, regions[b]->id, id);
    body = b;
  }
  return body;
}

/* ----------------------------------------------------------------------
   all particles of the group in the regions, on all processors
------------------------------------------------------------------------- */

void TMSPHRelax::gather()
{
  std::vector<Member> mine;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    Member m;
    std::copy_n(atom->x[i], 3, m.place);
    imageint image = atom->image[i];
    domain->remap(m.place, image);
    m.id = atom->tag[i];
    m.type = atom->type[i];
    m.volume = atom->vfrac[i];
    m.body = body_of(m.id, m.place);
    if (m.body >= 0) mine.push_back(m);
  }
  const int bytes = mine.size() * sizeof(Member);
  std::vector<int> counts(comm->nprocs), starts(comm->nprocs);
  MPI_Allgather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  int total = 0;
  for (int p = 0; p < comm->nprocs; p++) {
    starts[p] = total;
    total += counts[p];
  }
  members.resize(total / sizeof(Member));
  MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, members.data(), counts.data(), starts.data(),
                 MPI_BYTE, world);
  sort_by_places();
  for (const Member &m : members) {
    bodies[m.body].particles++;
    bodies[m.body].given += m.volume;
  }
}

/* ----------------------------------------------------------------------
   those near each other together, in an order that knows nothing of ids: create_atoms gives others
   on other numbers of processors
------------------------------------------------------------------------- */

void TMSPHRelax::sort_by_places()
{
  constexpr int PER_CELL = 64;
  const double count = std::max(1.0, std::pow(members.size() / PER_CELL, 1.0 / domain->dimension));
  const auto cell = [&](const Member &m, int k) {
    return std::floor((m.place[k] - domain->boxlo[k]) / domain->prd[k] * count);
  };
  const auto key = [&](const Member &m) {
    return std::make_tuple(cell(m, 2), cell(m, 1), cell(m, 0), m.place[2], m.place[1], m.place[0],
                           m.id);
  };
  std::sort(members.begin(), members.end(),
            [&](const Member &a, const Member &b) { return key(a) < key(b); });
}

/* ---------------------------------------------------------------------- */

void TMSPHRelax::check_bodies() const
{
  for (const Body &body : bodies)
    if (body.particles == 0)
      error->all(FLERR, "Region {} of tmsph/relax has no particles of the group: create some there",
                 body.name);
  const auto missing =
      std::find_if(members.begin(), members.end(), [](const Member &m) { return m.volume == 0.0; });
  const auto given =
      std::find_if(members.begin(), members.end(), [](const Member &m) { return m.volume > 0.0; });
  if (missing != members.end() && given != members.end())
    error->all(FLERR,
               "Tmsph/relax: particle {} has a volume and {} has none: set all of them or none",
               given->id, missing->id);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHRelax::relax()
{
  const TMSPHRegionShapes<D> shapes(lmp, regions);
  constexpr double FINE = 0.125;    // a ball of 5 spacings is then measured to 2e-4
  const double dense = std::pow(
      domain->prd[0] * domain->prd[1] * (D == 3 ? domain->prd[2] : 1.0) / members.size(), 1.0 / D);
  for (int b = 0; b < (int) bodies.size(); b++) bodies[b].size = shapes.size(b, FINE * dense);
  CloudBox<D> box;
  for (int k = 0; k < D; k++) {
    box.low[k] = domain->boxlo[k];
    box.period[k] = domain->periodicity[k] ? domain->prd[k] : 0.0;
  }
  const auto particles = cloud<D>();
  check_horizons();
  Relaxation<D> relaxation(particles, box, shapes, bonds(), share());
  const auto before = relaxation.figures();
  check_places(before);
  if (pushes < 0) pushes = relaxation.pushes();
  relaxation.push(pushes);
  relaxation.balance(balances);
  for (size_t n = 0; n < members.size(); n++)
    std::copy_n(relaxation.particles()[n].place.data(), D, members[n].place);
  tell(before, relaxation.figures());
}

/* ----------------------------------------------------------------------
   sizes of the particles, and their volumes
------------------------------------------------------------------------- */

template <int D> std::vector<CloudParticle<D>> TMSPHRelax::cloud()
{
  std::vector<CloudParticle<D>> all;
  for (Member &m : members) {
    const Body &body = bodies[m.body];
    CloudParticle<D> p;
    std::copy_n(m.place, D, p.place.data());
    p.body = m.body;
    p.type = m.type;
    p.size = body.given > 0.0 ? m.volume / body.given * body.size : body.size / body.particles;
    all.push_back(p);
    if (D == 3)
      m.volume = p.size;
    else if (thickness > 0.0 || m.volume == 0.0)
      m.volume = p.size * (thickness > 0.0 ? thickness : 1.0);
  }
  return all;
}

/* ---------------------------------------------------------------------- */

CloudBonds TMSPHRelax::bonds() const
{
  const auto &pair = dynamic_cast<PairTMSPH &>(*force->pair);
  const int types = atom->ntypes + 1;
  CloudBonds bonds{pair.kernel_of_bonds(), {}};
  bonds.horizon.assign(types, std::vector<double>(types));
  for (int i = 1; i < types; i++)
    for (int j = 1; j < types; j++)
      if (i == j || pair.bonded(i, j)) bonds.horizon[i][j] = pair.horizon(i, j);
  return bonds;
}

double TMSPHRelax::spacing_in(const Body &body) const
{
  return std::pow(body.size / body.particles, 1.0 / domain->dimension);
}

/* ----------------------------------------------------------------------
   a length in wrong units, for instance, leaves no bonds or far too many
------------------------------------------------------------------------- */

void TMSPHRelax::check_horizons() const
{
  constexpr double LEAST = 1.5, MOST = 10.0;    // 3 is usual
  const auto horizons = bonds().horizon;
  for (const Member &m : members) {
    const Body &body = bodies[m.body];
    const double spacing = spacing_in(body), horizon = horizons[m.type][m.type];
    if (horizon < LEAST * spacing || horizon > MOST * spacing)
      error->all(
          FLERR,
          "Horizon {:.4g} of the pair style is {:.3g} spacings of the particles in region {} "
          "of tmsph/relax: give about 3 spacings, {:.3g}",
          horizon, horizon / spacing, body.name, 3.0 * spacing);
  }
}

/* ----------------------------------------------------------------------
   equal parts of the particles for each processor
------------------------------------------------------------------------- */

CloudShare TMSPHRelax::share() const
{
  const bigint n = members.size(), nprocs = comm->nprocs;
  std::vector<int> first;
  for (bigint p = 0; p <= nprocs; p++) first.push_back(p * n / nprocs);
  const auto complete = [=](double *rows, int width) {
    std::vector<int> counts, starts;
    for (int p = 0; p < nprocs; p++) {
      starts.push_back(width * first[p]);
      counts.push_back(width * (first[p + 1] - first[p]));
    }
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, rows, counts.data(), starts.data(),
                   MPI_DOUBLE, world);
  };
  return {first[comm->me], first[comm->me + 1], complete};
}

/* ---------------------------------------------------------------------- */

void TMSPHRelax::check_places(const std::vector<CloudFigures> &figures) const
{
  constexpr double SAME = 1.0e-6;    // of a spacing: nothing tells which way the two should go
  for (size_t n = 0; n < members.size(); n++)
    if (figures[n].nearest < SAME)
      error->all(FLERR,
                 "Particles {} and {} of tmsph/relax are at the same place: use 'delete_atoms "
                 "overlap' before it",
                 members[n].id, members[figures[n].neighbor].id);
}

/* ----------------------------------------------------------------------
   to the particles, which go to the processors of their new places
------------------------------------------------------------------------- */

void TMSPHRelax::put_back()
{
  std::unordered_map<tagint, const Member *> of_id;
  for (const Member &m : members) of_id[m.id] = &m;
  for (int i = 0; i < atom->nlocal; i++) {
    const auto found = of_id.find(atom->tag[i]);
    if (found == of_id.end()) continue;
    std::copy_n(found->second->place, 3, atom->x[i]);
    std::copy_n(found->second->place, 3, atom->x0[i]);
    atom->vfrac[i] = found->second->volume;
  }
  for (int i = 0; i < atom->nlocal; i++) domain->remap(atom->x[i], atom->image[i]);
  domain->reset_box();
  Irregular(lmp).migrate_atoms(1);
}

/* ---------------------------------------------------------------------- */

void TMSPHRelax::tell(const std::vector<CloudFigures> &before,
                      const std::vector<CloudFigures> &after) const
{
  if (comm->me) return;
  const UnitNames unit(update->unit_style);
  const bool flat = domain->dimension == 2;
  TextTable table({"region", flat ? heading("area", unit.area) : heading("volume", unit.volume),
                   "particles", heading("spacing", unit.length), "state", "nearest/spacing",
                   "scatter", "smallest", "imbalance", "largest"});
  for (int b = 0; b < (int) bodies.size(); b++) {
    const double count = bodies[b].particles;
    const auto add = [&](const char *state, const std::vector<CloudFigures> &figures) {
      double sum = 0.0, square = 0.0, force = 0.0, smallest = HUGE_VAL, largest = 0.0;
      for (size_t n = 0; n < members.size(); n++) {
        if (members[n].body != b) continue;
        const auto &[nearest, neighbor, imbalance] = figures[n];
        sum += nearest;
        square += nearest * nearest;
        force += imbalance * imbalance;
        smallest = std::min(smallest, nearest);
        largest = std::max(largest, imbalance);
      }
      const double mean = sum / count, scatter = std::sqrt(square / count - mean * mean);
      table.add({bodies[b].name, digits(bodies[b].size), std::to_string(bodies[b].particles),
                 digits(spacing_in(bodies[b])), state, digits(mean), digits(scatter),
                 digits(smallest), digits(std::sqrt(force / count)), digits(largest)});
    };
    add("before", before);
    add("after", after);
  }
  utils::logmesg(lmp, "TMSPH relaxation: {} moves apart, {} into balance\n{}", pushes, balances,
                 table.text());
}
