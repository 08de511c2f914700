/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat_boundary.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_store_atom.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "tmsph_conduction.h"
#include "tmsph_region_surface.h"
#include "tmsph_words.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

// a particle is at least this fraction of its cell's edge below the surface: its conductance, and
// 1/stable step, are then at most 5 times those of a lattice, where it is half; 0.02 to 0.3 do the
// same in unittest/verification/test_heat_rings.py

static constexpr double LEAST_DEPTH = 0.1;

// cosine of the angle between the surface of a region and a flat face that it stands for, at least:
// it is about 1 to that face and 0 to the others of a corner: any number between tells

static constexpr double SAME_SIDE = 0.5;

// cosine of the angle between the direction of 'facing' and the normal, at least: a little below
// that of 45 degrees, so that faces at just this angle count in spite of round-off

static constexpr double FACING = 0.707106;

static double cosine(const double *a, const double *b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// columns of the store

enum { AREA, DEPTH, NORMAL, NCOLUMNS = NORMAL + 3 };

/* ---------------------------------------------------------------------- */

FixTMSPHHeatBoundary::FixTMSPHHeatBoundary(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), ghosts(lmp, this), kind(TEMPERATURE), place(UNDECIDED), body(false),
    value(0.0), coefficient(0.0), absolute_zero(0.0), variable_index(-1), given_area(0.0),
    one_sided(false), cracks(false), heat(nullptr), store(nullptr), found(false)
{
  if (!atom->temperature_flag)
    error->all(FLERR,
               "Fix tmsph/heat/boundary needs an atom style with temperature: atom_style "
               "tmsph");
  parse(narg, arg);
  scalar_flag = vector_flag = 1;
  size_vector = 4;
  comm_forward = 1;
  extscalar = extvector = 0;
  global_freq = 1;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::parse(int narg, char **arg)
{
  const auto target = [this](TMSPHValues &v) {
    if (!v.variable(variable)) value = v.number();
  };
  const std::string what = narg > 3 ? arg[3] : "";
  const auto film = [&](TMSPHValues &v) {
    coefficient = v.number();
    if (!TMSPHRule::not_negative(coefficient))
      error->all(FLERR, "Coefficient {} of fix tmsph/heat/boundary {} must not be negative",
                 v.rest()[-1], what);
    target(v);
  };
  const auto kind_of = [this](Kind which, std::function<void(TMSPHValues &)> read) {
    return [this, which, read](TMSPHValues &v) {
      kind = which;
      read(v);
    };
  };
  char **const next = TMSPHWords(lmp, "fix tmsph/heat/boundary",
                                 {{"temperature", "T", kind_of(TEMPERATURE, target)},
                                  {"flux", "q", kind_of(FLUX, target)},
                                  {"convection", "h T", kind_of(CONVECTION, film)},
                                  {"radiation", "B T", kind_of(RADIATION, film)}})
                          .read(arg + 3, arg + narg);

  bool surface_words = false, zero_given = false;
  const auto surface = [&surface_words](auto read) {
    return [&surface_words, read](TMSPHValues &v) {
      surface_words = true;
      read(v);
    };
  };
  TMSPHWords(lmp, "fix tmsph/heat/boundary",
             {{"place", "body/surface",
               [this](TMSPHValues &v) {
                 place = v.one_of<Place>({{"body", BODY}, {"surface", SURFACE}});
               }},
              {"region", "region-ID", surface([this](TMSPHValues &v) { region_id = v.text(); })},
              {"facing", "x y z", surface([this](TMSPHValues &v) { read_direction(v); })},
              {"area", "A", surface([this](TMSPHValues &v) {
                 given_area = v.number(TMSPHRule::positive, "must be positive");
               })},
              {"cracks", "yes/no", surface([this](TMSPHValues &v) { cracks = v.logical(); })},
              {"zero", "T",
               [&](TMSPHValues &v) {
                 absolute_zero = v.number();
                 zero_given = true;
               }}})
      .read_all(next, arg + narg);
  if (place == BODY && kind != TEMPERATURE)
    error->all(FLERR, "Fix tmsph/heat/boundary {} acts at the surface: remove 'place body'", what);
  if (place == BODY && surface_words)
    error->all(FLERR,
               "Fix tmsph/heat/boundary with 'place body' takes no region, facing, area or "
               "cracks: remove them, or use 'place surface'");
  if ((kind == RADIATION) != zero_given)
    error->all(FLERR, "Fix tmsph/heat/boundary {} 'zero T', the temperature of absolute zero",
               kind == RADIATION ? "radiation needs" : what + " does not use");
  if (surface_words) place = SURFACE;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::read_direction(TMSPHValues &values)
{
  double square = 0.0;
  for (int a = 0; a < 3; a++) {
    const double given = values.number();
    direction[a] = a < domain->dimension ? given : 0.0;
    square += direction[a] * direction[a];
  }
  char **const end = values.rest();
  if (!(square > 0.0 && std::isfinite(square)))
    values.reject(fmt::format("{} {} {}", end[-3], end[-2], end[-1]),
                  "has no length: give the direction in which the face looks");
  for (double &d : direction) d /= std::sqrt(square);
  one_sided = true;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::post_constructor()
{
  if (place == BODY) return;
  store_id = std::string(id) + "_TMSPH_SURFACE";
  store = dynamic_cast<FixStoreAtom *>(modify->add_fix(
      fmt::format("{} {} STORE/ATOM {} 0 0 1", store_id, group->names[igroup], (int) NCOLUMNS)));
}

/* ---------------------------------------------------------------------- */

FixTMSPHHeatBoundary::~FixTMSPHHeatBoundary()
{
  if (modify->nfix && !store_id.empty() && modify->get_fix_by_id(store_id))
    modify->delete_fix(store_id);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeatBoundary::setmask()
{
  return PRE_FORCE | MIN_PRE_FORCE;
}

/* ---------------------------------------------------------------------- */

FixTMSPHHeat *FixTMSPHHeatBoundary::conduction() const
{
  const auto found = modify->get_fix_by_style("^tmsph/heat$");
  return found.empty() ? nullptr : static_cast<FixTMSPHHeat *>(found[0]);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::init()
{
  heat = conduction();
  body = place == BODY || (place == UNDECIDED && kind == TEMPERATURE && !heat);
  if (!body && !heat)
    error->all(FLERR,
               "Fix tmsph/heat/boundary {} acts at the surface of a body that conducts heat: "
               "add a fix tmsph/heat",
               id);
  if (variable.empty()) return;
  variable_index = input->variable->find(variable.c_str());
  if (variable_index < 0)
    error->all(FLERR, "Variable {} of fix tmsph/heat/boundary does not exist: define it first",
               variable);
  if (!input->variable->equalstyle(variable_index) && !input->variable->atomstyle(variable_index))
    error->all(FLERR, "Variable {} of fix tmsph/heat/boundary must be of equal or atom style",
               variable);
}

/* ----------------------------------------------------------------------
   without conduction heat stays where it is put
------------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::tell()
{
  if (heat || group->count(igroup) == 0 || group->count(igroup) == atom->natoms) return;
  for (Fix *fix : modify->get_fix_by_style("^tmsph/heat/boundary$"))
    if (fix->igroup != igroup) return;    // parts of the body have temperatures of their own
  auto pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  pair->warn_once(fmt::format("Only group {} of fix tmsph/heat/boundary {} is heated: for heat to "
                              "go on from there add a fix tmsph/heat",
                              group->names[igroup], id));
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::evaluate()
{
  values.clear();
  if (!variable.empty()) {
    modify->clearstep_compute();
    if (input->variable->equalstyle(variable_index))
      value = input->variable->compute_equal(variable_index);
    else {
      values.resize(atom->nlocal);
      input->variable->compute_atom(variable_index, igroup, values.data(), 1, 0);
    }
    modify->addstep_compute(body ? update->ntimestep + 1 : heat->next_step());
  }
  double sum[2] = {0.0, 0.0}, all[2];
  for (int i = 0; i < (int) values.size(); i++)
    if (atom->mask[i] & groupbit) {
      sum[0] += values[i];
      sum[1] += 1.0;
    }
  if (!variable.empty() && input->variable->atomstyle(variable_index)) {
    MPI_Allreduce(sum, all, 2, MPI_DOUBLE, MPI_SUM, world);
    value = all[1] > 0.0 ? all[0] / all[1] : 0.0;
  }
  if (!std::isfinite(value))
    error->all(FLERR, "{} of fix tmsph/heat/boundary {} is {} on step {}: check variable {}",
               kind == FLUX ? "Flux" : "Temperature", id, value, update->ntimestep, variable);
}

/* ----------------------------------------------------------------------
   ghosts are set like their owners: only the values of an atom-style variable
   need to be sent
------------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::hold_temperature()
{
  evaluate();
  const TMSPHHeatMaterials *properties = heat ? &heat->properties() : nullptr;
  double *T = atom->temperature, brought = 0.0;
  for (int i = 0; i < atom->nlocal + (values.empty() ? atom->nghost : 0); i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double now = values.empty() ? value : values[i];
    if (heat && i < atom->nlocal && now != T[i])
      brought += atom->rmass[i] * (properties->enthalpy(i, now) - properties->enthalpy(i, T[i]));
    T[i] = now;
  }
  if (heat) heat->books().enter(this, brought);
  if (!variable.empty() && input->variable->atomstyle(variable_index))
    ghosts.send(atom->temperature, 1, 1);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeatBoundary::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  return ghosts.pack(n, list, buf);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::unpack_forward_comm(int n, int first, double *buf)
{
  ghosts.unpack(n, first, buf);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::pre_force(int /*vflag*/)
{
  if (body) hold_temperature();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::setup_pre_force(int vflag)
{
  pre_force(vflag);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::min_pre_force(int vflag)
{
  pre_force(vflag);
}

/* ----------------------------------------------------------------------
   One more piece of the surface of a particle: all together conduct like one of
   area A, depth d and conductivity n.K.n, where A/d and A/d n.K.n are sums over
   the pieces. Of faces at right angles along the axes of K this n has the part
   sqrt(A_f/d_f) of each.
------------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::add(const TMSPHSurfacePiece &piece)
{
  double *row = store->astore[piece.i], *n = row + NORMAL;
  const double before = row[AREA] > 0.0 ? row[AREA] / row[DEPTH] : 0.0;
  const double now = piece.area / piece.surface.depth;
  const double side = cosine(n, piece.surface.normal) < 0.0 ? -1.0 : 1.0;
  double square = 0.0;
  for (int a = 0; a < 3; a++) {
    n[a] = std::sqrt(before) * n[a] + side * std::sqrt(now) * piece.surface.normal[a];
    square += n[a] * n[a];
  }
  for (int a = 0; a < 3; a++) n[a] /= std::sqrt(square);
  row[AREA] += piece.area;
  row[DEPTH] = row[AREA] / (before + now);
}

/* ----------------------------------------------------------------------
   areas, depths and normals of the particles of the group at the surface
------------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::find_surface()
{
  const int nlocal = atom->nlocal;
  const FixTMSPHBond &bonds = heat->body().owner_of_bonds();
  if (!cracks && found) return;
  if (found && !watch.removed_anywhere(bonds, world)) return;
  if (!found) {    // a restart or an earlier run has it
    double mine = 0.0, all;
    for (int i = 0; i < nlocal; i++) mine += store->astore[i][AREA];
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    found = all > 0.0;
    if (found && !cracks) return;
  }
  found = true;
  watch.see(bonds);

  Region *region = nullptr;
  if (!region_id.empty()) {
    region = domain->get_region_by_id(region_id);
    if (!region)
      error->all(FLERR,
                 "Region {} of fix tmsph/heat/boundary does not exist: define it with the "
                 "command region",
                 region_id);
  }
  for (int i = 0; i < nlocal; i++) std::fill_n(store->astore[i], (int) NCOLUMNS, 0.0);
  double area = 0.0, total;
  for (TMSPHSurfacePiece piece : heat->body().surface().pieces(cracks)) {
    if (!(atom->mask[piece.i] & groupbit)) continue;
    if (one_sided && cosine(direction, piece.surface.normal) < FACING) continue;
    if (region) {
      TMSPH::Surface exact;
      exact.depth = 2.0 * bonds.reach();
      take_nearest_surface(*region, bonds, piece.i, exact);
      if (exact.exposure == TMSPH::Exposure::GIVEN &&
          (!piece.flat || cosine(exact.normal, piece.surface.normal) > SAME_SIDE))
        piece.surface = exact;
    }
    piece.surface.depth = std::max(piece.surface.depth, LEAST_DEPTH * bonds.spacing(piece.i));
    add(piece);
    area += piece.area;
  }
  MPI_Allreduce(&area, &total, 1, MPI_DOUBLE, MPI_SUM, world);
  if (!(total > 0.0) && !cracks)
    error->all(FLERR,
               "Group {} of fix tmsph/heat/boundary {} has no particle at a surface{}: choose a "
               "group that reaches it, or use 'place body'",
               group->names[igroup], id, one_sided ? " that looks as 'facing' says" : "");
  if (given_area > 0.0 && total > 0.0)
    for (int i = 0; i < nlocal; i++) store->astore[i][AREA] *= given_area / total;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::list_exchanges(std::vector<TMSPHHeatExchange> &list)
{
  find_surface();
  evaluate();
  for (int i = 0; i < atom->nlocal; i++) {
    const double *row = store->astore[i];
    if (row[AREA] == 0.0) continue;
    const double outside = values.empty() ? value : values[i], area = row[AREA];
    if (kind == FLUX) {
      list.push_back({i, 0.0, 0.0, outside * area});
      continue;
    }
    const double k = heat->properties().conductivity_of(i, row + NORMAL);
    double film = coefficient;
    if (kind == RADIATION)
      film = TMSPH::radiation_film(coefficient, atom->temperature[i], outside, absolute_zero);
    list.push_back({i,
                    kind == TEMPERATURE ? TMSPH::surface_conductance(k, area, row[DEPTH])
                                        : TMSPH::film_conductance(k, area, row[DEPTH], film),
                    outside, 0.0});
  }
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHeatBoundary::compute_scalar()
{
  return value;
}

/* ----------------------------------------------------------------------
   1 power, 2 energy so far, 3 area, 4 particles
------------------------------------------------------------------------- */

double FixTMSPHHeatBoundary::compute_vector(int n)
{
  double mine = 0.0, all;
  if (n < 2) {
    FixTMSPHHeat *present = conduction();    // it may be gone since the last run
    const TMSPHHeatAccount account = present ? present->books().account(this) : TMSPHHeatAccount();
    mine = n == 0 ? account.power : account.energy;
  } else
    for (int i = 0; i < atom->nlocal; i++) {
      const bool member = store && !body ? store->astore[i][AREA] > 0.0 : n == 3;
      if (member && (atom->mask[i] & groupbit)) mine += n == 3 ? 1.0 : store->astore[i][AREA];
    }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   the variable is asked ahead: 1, 2, 4 ... steps, then by bisection
------------------------------------------------------------------------- */

int FixTMSPHHeatBoundary::reach(int most, double largest_change)
{
  if (!body || variable.empty() || !input->variable->equalstyle(variable_index)) return most;
  const bigint now = update->ntimestep;
  const auto within = [&](int steps) {
    update->ntimestep = now + steps;
    modify->clearstep_compute();
    const double then = input->variable->compute_equal(variable_index);
    update->ntimestep = now;
    return std::fabs(then - value) <= largest_change;
  };
  int good = 1, bad = most + 1;
  while (good < most) {
    const int next = good > most / 2 ? most : 2 * good;
    if (!within(next)) {
      bad = next;
      break;
    }
    good = next;
  }
  while (bad - good > 1) {
    const int middle = good + (bad - good) / 2;
    (within(middle) ? good : bad) = middle;
  }
  return std::min(good, most);
}
