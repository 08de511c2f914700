/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words, report and restart of fix tmsph/heat.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "math_const.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "text_file_reader.h"
#include "tmsph_restart.h"
#include "tmsph_types.h"
#include "tokenizer.h"
#include "update.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using TMSPH::PropertyTable;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 4.0;

// scaled time must leave mechanical waves this many passages while heat crosses the body

static constexpr double WAVE_PASSAGES = 50.0;

// shorter steps, as parts of the stable one, show that time was not scaled

static constexpr double LEAST_STEP = 1.0e-3;

// diffusivities of solids in m2/s: silver has 1.7e-4, plastics have 1e-7; only diamond and graphite
// are above (CRC Handbook of Chemistry and Physics)

static constexpr double LEAST_DIFFUSIVITY = 1.0e-8, MOST_DIFFUSIVITY = 4.0e-4;

/* ---------------------------------------------------------------------- */

FixTMSPHHeat::FixTMSPHHeat(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr), bonds(nullptr), norms(nullptr),
    substances(atom->ntypes + 1), rkl2(true), tables(false), every(1), time_scale(1.0),
    gap(atom->ntypes + 1, std::vector<double>(atom->ntypes + 1, 0.0)), crosses(false),
    friction(false), viscous(false), told(false), version(-1), removals(0), evened(false),
    faced(false), ghosts(lmp, this), face_sent(NONE), heats(false), cools(false), stable(0.0),
    covered(0.0), fastest(0.0), comfortable(MAXSMALLINT / 2), applications(0), former_energy(0.0)
{
  if (!atom->temperature_flag || !atom->vfrac_flag || !atom->rmass_flag)
    error->all(FLERR, "Fix tmsph/heat needs an atom style with temperature, volume and mass: "
                      "atom_style tmsph");
  if (igroup != 0)
    error->all(FLERR, "Fix tmsph/heat works on all particles: use group all and give each type its "
                      "conductivity");
  parse(narg, arg);
  scalar_flag = vector_flag = 1;
  size_vector = 8;
  global_freq = 1;
  extscalar = 1;
  extvector = 0;
  restart_global = restart_peratom = 1;
  comm_forward = layer_size();    // at most
  maxexchange = 1 + faces_size();
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  grow_arrays(atom->nmax);
}

/* ----------------------------------------------------------------------
   lines 'temperature value' after the name of the section, up to a line of one word
   @return what is wrong, or nothing
------------------------------------------------------------------------- */

static std::string read_table(const char *file, const std::string &section, std::vector<double> &T,
                              std::vector<double> &values)
{
  try {
    const std::string path = utils::get_potential_file_path(file);
    TextFileReader reader(path.empty() ? file : path, "table");
    char *line;
    while ((line = reader.next_line()) && ValueTokenizer(line).next_string() != section) {}
    if (!line) return fmt::format("it has no section {}", section);
    while ((line = reader.next_line())) {
      ValueTokenizer words(line);
      if (words.count() == 1) break;
      if (words.count() != 2)
        return fmt::format("lines must be 'temperature value', not '{}'", utils::trim(line));
      T.push_back(words.next_double());
      values.push_back(words.next_double());
    }
  } catch (std::exception &e) {
    return e.what();
  }
  return T.empty() ? "its section has no lines 'temperature value'" : "";
}

/* ----------------------------------------------------------------------
   a positive number, or a table of positive numbers over temperature
   @return index of the word after it
------------------------------------------------------------------------- */

static int parse_property(LAMMPS *lmp, const std::string &word, int iarg, int narg, char **arg,
                          PropertyTable &property)
{
  Error *error = lmp->error;
  if (strcmp(arg[iarg], "table") == 0) {
    if (iarg + 2 >= narg)
      utils::missing_cmd_args(FLERR, "fix tmsph/heat " + word + " table", error);
    std::vector<double> T, values;
    std::string trouble;
    if (lmp->comm->me == 0) {
      trouble = read_table(arg[iarg + 1], arg[iarg + 2], T, values);
      for (size_t n = 0; n < T.size() && trouble.empty(); n++) {
        if (n && !(T[n] > T[n - 1]))
          trouble = fmt::format("temperatures must ascend, but {} comes after {}", T[n], T[n - 1]);
        if (!(values[n] > 0.0))
          trouble = fmt::format("value {} at temperature {} must be positive", values[n], T[n]);
      }
    }
    int size[2] = {(int) T.size(), (int) trouble.size()};
    MPI_Bcast(size, 2, MPI_INT, 0, lmp->world);
    trouble.resize(size[1]);
    MPI_Bcast(&trouble[0], size[1], MPI_CHAR, 0, lmp->world);
    if (size[1])
      error->all(FLERR, "Table {} of fix tmsph/heat {}: {}", arg[iarg + 1], word, trouble);
    T.resize(size[0]);
    values.resize(size[0]);
    MPI_Bcast(T.data(), size[0], MPI_DOUBLE, 0, lmp->world);
    MPI_Bcast(values.data(), size[0], MPI_DOUBLE, 0, lmp->world);
    property = PropertyTable(T, values);
    return iarg + 3;
  }
  const double value = utils::numeric(FLERR, arg[iarg], false, lmp);
  if (!(value > 0.0 && std::isfinite(value)))
    error->all(FLERR, "Fix tmsph/heat {} {} must be positive", word, arg[iarg]);
  property = PropertyTable(value);
  return iarg + 1;
}

/* ----------------------------------------------------------------------
   keywords: conductivity and specific/heat TYPES value, source TYPES value,
   contact TYPES TYPES h, friction yes|no, viscous yes|no, subcycle explicit|rkl2,
   time/scale S, every N
------------------------------------------------------------------------- */

void FixTMSPHHeat::parse(int narg, char **arg)
{
  int iarg = 3;
  while (iarg < narg) {
    const std::string word = arg[iarg];
    const bool by_type = word == "conductivity" || word == "specific/heat" || word == "source";
    const auto others = {"contact", "friction", "viscous", "subcycle", "time/scale", "every"};
    if (!by_type && std::find(others.begin(), others.end(), word) == others.end())
      error->all(FLERR, "Unknown keyword '{}' of fix tmsph/heat: use conductivity, specific/heat, "
                        "source, contact, friction, viscous, subcycle, time/scale or every", word);
    if (iarg + (word == "contact" ? 3 : by_type ? 2 : 1) >= narg)
      utils::missing_cmd_args(FLERR, "fix tmsph/heat " + word + (word == "contact" ? " I J h" : ""),
                              error);
    if (by_type)
      iarg = parse_by_type(word, iarg + 1, narg, arg);
    else if (word == "contact") {
      parse_contact(arg + iarg + 1);
      iarg += 4;
    } else {
      parse_setting(word, arg[iarg + 1]);
      iarg += 2;
    }
  }
  check_words();
}

/* ----------------------------------------------------------------------
   @return index of the word after types and value
------------------------------------------------------------------------- */

int FixTMSPHHeat::parse_by_type(const std::string &word, int iarg, int narg, char **arg)
{
  int lo, hi, next = iarg + 2;
  TMSPH::read_types(lmp, "Fix tmsph/heat " + word, word + " * value", arg[iarg], lo, hi);
  const char *value = arg[iarg + 1];
  Substance given;
  if (word == "conductivity")
    next = parse_conductivity(iarg + 1, narg, arg, given);
  else if (word == "specific/heat")
    next = parse_property(lmp, word, iarg + 1, narg, arg, given.specific_heat);
  else if (utils::strmatch(value, "^v_"))
    given.source_variable = value + 2;
  else
    given.source = utils::numeric(FLERR, value, false, lmp);
  for (int type = lo; type <= hi; type++) {
    Substance &s = substances[type];
    if (word == "conductivity") {
      s.conductivity = given.conductivity;
      s.orthotropic = given.orthotropic;
      std::copy_n(given.principal, 9, s.principal);
    } else if (word == "specific/heat")
      s.specific_heat = given.specific_heat;
    else {
      s.source = given.source;
      s.source_variable = given.source_variable;
    }
  }
  return next;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::parse_contact(char **given)
{
  int ilo, ihi, jlo, jhi;
  const std::string what = "Fix tmsph/heat contact", usage = "contact * * h";
  TMSPH::read_types(lmp, what, usage, given[0], ilo, ihi);
  TMSPH::read_types(lmp, what, usage, given[1], jlo, jhi);
  const double h = utils::numeric(FLERR, given[2], false, lmp);
  if (!(h >= 0.0 && std::isfinite(h)))
    error->all(FLERR,
               "Fix tmsph/heat contact {} must not be negative: it is the conductance of a "
               "closed crack per area",
               given[2]);
  for (int i = ilo; i <= ihi; i++)
    for (int j = jlo; j <= jhi; j++) gap[i][j] = gap[j][i] = h;
  crosses = crosses || h > 0.0;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::parse_setting(const std::string &word, const char *value)
{
  if (word == "friction")
    friction = utils::logical(FLERR, value, false, lmp);
  else if (word == "viscous")
    viscous = utils::logical(FLERR, value, false, lmp);
  else if (word == "subcycle") {
    if (strcmp(value, "rkl2") != 0 && strcmp(value, "explicit") != 0)
      error->all(FLERR, "Unknown value '{}' of fix tmsph/heat subcycle: use explicit or rkl2",
                 value);
    rkl2 = strcmp(value, "rkl2") == 0;
  } else if (word == "time/scale") {
    time_scale = utils::numeric(FLERR, value, false, lmp);
    if (!(time_scale > 0.0 && std::isfinite(time_scale)))
      error->all(FLERR, "Fix tmsph/heat time/scale {} must be positive", value);
  } else {
    every = utils::inumeric(FLERR, value, false, lmp);
    if (every < 1) error->all(FLERR, "Fix tmsph/heat every {} must be at least 1 step", value);
  }
}

/* ----------------------------------------------------------------------
   what they lack and what does not go together
------------------------------------------------------------------------- */

void FixTMSPHHeat::check_words()
{
  if (viscous && every > 1)
    error->all(FLERR, "Fix tmsph/heat viscous takes the work of each step: remove 'every {}'",
               every);
  bool any_orthotropic = false;
  for (int type = 1; type <= atom->ntypes; type++) {
    const Substance &s = substances[type];
    if (!(s.conductivity.smallest() > 0.0))
      error->all(FLERR, "Fix tmsph/heat lacks the conductivity of type {}: add 'conductivity {} k'",
                 type, type);
    if (!(s.specific_heat.smallest() > 0.0))
      error->all(FLERR,
                 "Fix tmsph/heat lacks the specific heat of type {}: add 'specific/heat {} c'",
                 type, type);
    tables = tables || !s.conductivity.constant();
    any_orthotropic = any_orthotropic || s.orthotropic;
  }
  if (tables && any_orthotropic)
    error->all(FLERR,
               "Fix tmsph/heat cannot have both orthotropic conductivities and conductivities "
               "from tables: give numbers instead of tables");
}

/* ----------------------------------------------------------------------
   a number, a table, or the principal values and the turn of their axes: in 2-D
   orthotropic k1 k2 angle, in 3-D orthotropic k1 k2 k3 axis-x axis-y axis-z angle
------------------------------------------------------------------------- */

int FixTMSPHHeat::parse_conductivity(int iarg, int narg, char **arg, Substance &s)
{
  if (strcmp(arg[iarg], "orthotropic") != 0)
    return parse_property(lmp, "conductivity", iarg, narg, arg, s.conductivity);
  const int dimension = domain->dimension, words = dimension == 2 ? 3 : 7;
  if (iarg + words >= narg)
    utils::missing_cmd_args(FLERR, "fix tmsph/heat conductivity orthotropic", error);
  double n[7];
  for (int k = 0; k < words; k++) n[k] = utils::numeric(FLERR, arg[iarg + 1 + k], false, lmp);
  Eigen::Vector3d values(n[0], n[1], dimension == 2 ? n[0] : n[2]), axis(0.0, 0.0, 1.0);
  for (int k = 0; k < dimension; k++)
    if (!(values[k] > 0.0 && std::isfinite(values[k])))
      error->all(FLERR, "Fix tmsph/heat conductivity {} must be positive", arg[iarg + 1 + k]);
  if (dimension == 3) axis = Eigen::Vector3d(n[3], n[4], n[5]);
  if (!(axis.norm() > 0.0))
    error->all(FLERR, "The axis by which the principal directions of fix tmsph/heat conductivity "
                      "orthotropic turn has no length: for no turn use 0 0 1 0");
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(n[words - 1] * MathConst::DEG2RAD, axis.normalized()).toRotationMatrix();
  const Eigen::Matrix3d K = turn * values.asDiagonal() * turn.transpose();
  Eigen::Map<Eigen::Matrix3d>(s.principal) = 0.5 * (K + K.transpose());
  s.orthotropic = true;
  s.conductivity = PropertyTable(values.maxCoeff());
  return iarg + 1 + words;
}

/* ----------------------------------------------------------------------
   once, at the first run
------------------------------------------------------------------------- */

void FixTMSPHHeat::tell()
{
  using namespace TMSPH;
  const UnitNames unit(update->unit_style);
  TextTable table({"type", heading("diffusivity", unit.diffusivity)});
  double diffusivity = 0.0, slowest = HUGE_VAL, size = 0.0;
  bool strange = false;
  for (int type = 1; type <= atom->ntypes; type++) {
    const Substance &s = substances[type];
    const PairTMSPH::Material &m = pair->material(type);
    const double largest = s.conductivity.largest() / (m.density * s.specific_heat.smallest());
    table.add({std::to_string(type), digits(largest)});
    diffusivity = std::max(diffusivity, largest);
    slowest = std::min(slowest, PairTMSPH::wave_speed(m));
    const double metric = unit.square_meters_per_second * largest;
    if (metric == 0.0 || (metric > LEAST_DIFFUSIVITY && metric < MOST_DIFFUSIVITY)) continue;
    if (!strange && pair->plausible(type))
      pair->warn_once(fmt::format(
          "Hardly a solid has a thermal diffusivity of {:.3g} {} as type {}: give fix tmsph/heat "
          "conductivity and specific/heat in the units of the input, in units si W/m/K and J/kg/K",
          largest, unit.diffusivity, type));
    strange = true;
  }
  for (int k = 0; k < domain->dimension; k++) size = std::max(size, domain->prd[k]);
  const double step = every * time_scale * update->dt;
  if (!told) {
    double bytes = memory_usage(), all_bytes;
    MPI_Allreduce(&bytes, &all_bytes, 1, MPI_DOUBLE, MPI_SUM, world);
    if (comm->me == 0)
      utils::logmesg(lmp,
                     "TMSPH heat: {}, {:.0f} bytes per particle, 1 double sent per ghost and "
                     "stage\n  stable explicit step {:.4g}, heat step {:.4g} every {} steps, "
                     "{:.3g} of it\n{}",
                     rkl2 ? "RKL2" : "explicit", all_bytes / std::max<bigint>(atom->natoms, 1),
                     stable, step, every, step / stable, table.text());
  }
  told = true;
  if (update->whichflag != 1 || update->nsteps == 0 || strange || !std::isfinite(stable)) return;

  const double by_the_end = covered + update->nsteps * time_scale * update->dt;
  if (step < LEAST_STEP * stable && by_the_end < stable)
    pair->warn_once(fmt::format(
        "Heat is hardly conducted in this run, which covers {:.2g} of the {:.2g} in which it "
        "crosses a spacing: give fix tmsph/heat a 'time/scale' of {:.1g} or more",
        by_the_end, stable, 10.0 * LEAST_STEP * stable / (every * update->dt)));
  bool integrates = false;
  for (const auto &fix : modify->get_fix_list()) integrates = integrates || fix->time_integrate;
  const double conduction = size * size / (time_scale * diffusivity), wave = size / slowest;
  if (integrates && conduction < WAVE_PASSAGES * wave)
    pair->warn_once(fmt::format(
        "Heat crosses the body in {:.3g}, waves in {:.3g}: with this time/scale of fix tmsph/heat "
        "inertia matters; keep it below {:.2g}",
        conduction, wave, time_scale * conduction / (WAVE_PASSAGES * wave)));
}

/* ----------------------------------------------------------------------
   The sums are then with process 0, as in a run that goes on from the file: the same round-off.
------------------------------------------------------------------------- */

void FixTMSPHHeat::write_restart(FILE *fp)
{
  double former;
  MPI_Allreduce(&former_energy, &former, 1, MPI_DOUBLE, MPI_SUM, world);
  std::vector<double> list = {RESTART_FORMAT, covered, (double) applications, fastest,
                              (double) comfortable, stable, former, (double) accounts.size()};
  former_energy = comm->me == 0 ? former : 0.0;
  for (Account &a : accounts) {
    double mine[2] = {a.power, a.energy}, all[2];
    MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
    list.insert(list.end(), all, all + 2);
    a = comm->me == 0 ? Account{all[0], all[1]} : Account();
  }
  for (const Substance &s : substances)
    list.insert(list.end(), s.calibrated, s.calibrated + 9);
  if (comm->me) return;
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::restart(char *buf)
{
  double list[8];
  memcpy(list, buf, sizeof(double));
  check_restart_format(error, "fix tmsph/heat", list[0], RESTART_FORMAT);
  memcpy(list, buf, sizeof(list));
  covered = list[1];
  applications = (bigint) list[2];
  fastest = list[3];
  comfortable = (int) list[4];
  stable = list[5];
  former_energy = comm->me == 0 ? list[6] : 0.0;
  accounts.assign((size_t) list[7], Account());
  buf += sizeof(list);
  for (Account &account : accounts) {
    double both[2];
    memcpy(both, buf, sizeof(both));
    if (comm->me == 0) account = {both[0], both[1]};
    buf += sizeof(both);
  }
  for (Substance &s : substances) {
    memcpy(s.calibrated, buf, sizeof(s.calibrated));
    buf += sizeof(s.calibrated);
  }
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHeat::memory_usage()
{
  const size_t doubles = conductivities.capacity() + sums.capacity() + all_norms.capacity() +
      all_depths.capacity() + multipliers[0].capacity() * 3 +
      faces.capacity() + source_of.capacity() + power.capacity();
  return doubles * sizeof(double) + conductances.capacity() * sizeof(float) +
      (held.capacity() + face_row.capacity()) * sizeof(int) +
      exchanges.capacity() * sizeof(Exchange);
}
