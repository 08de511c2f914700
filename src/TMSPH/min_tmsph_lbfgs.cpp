/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "min_tmsph_lbfgs.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_minimize.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "pair_tmsph.h"
#include "timer.h"
#include "tmsph_fixed_point.h"
#include "tmsph_words.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using Vector = TMSPH::LBFGS::Vector;

// Force evaluations of the minima in test_quasistatic, 22 to 25 of disc, ball and stripe: 19 to 51
// with 0.001 for DMAX, 19 to 24 with 0.1; one to four fewer or more with a tenth of FIRST or
// MOST_GROWTH and ten times FIRST; with 4 TRIALS, 0.01 or 0.3 for LEAST_PART and 0.7 for MOST_PART
// the same

static constexpr double DMAX = 0.01;        // of the particle spacing
static constexpr double FIRST = 0.01;       // of the longest move: the first one, to learn
static constexpr double CURVATURE = 0.9;    // |slope| at the end/at the start: Nocedal, Wright,
                                            // Numerical Optimization, 2006, Sect. 3.1
static constexpr int TRIALS = 12;           // lengths tried on a line, each in parts of the last:
static constexpr double LEAST_PART = 0.1, MOST_PART = 0.9, MOST_GROWTH = 100.0;
static constexpr int STEPS_KEPT = 8;            // 25 gain nothing: doc/report/quasistatic.md
static constexpr double EPS_ENERGY = 1.0e-8;    // as in LAMMPS's minimizers

/* ---------------------------------------------------------------------- */

MinTMSPHLBFGS::MinTMSPHLBFGS(LAMMPS *lmp) :
    Min(lmp), lbfgs(STEPS_KEPT), preconditioner(lmp), pair(nullptr), longest(0.0),
    with_energy(true), total_evaluations(0)
{
  searchflag = 1;
  dmax = 0.0;    // not given: a fraction of the spacing
}

/* ---------------------------------------------------------------------- */

int MinTMSPHLBFGS::modify_param(int narg, char **arg)
{
  if (strcmp(arg[0], "memory") != 0) return 0;
  TMSPHValues values(lmp, "min_modify memory", "steps", arg + 1, arg + narg);
  const int memory = values.integer();
  if (memory < 1 || memory > 100)
    values.reject(arg[1], "is out of range: give 1 to 100 steps to remember");
  lbfgs = TMSPH::LBFGS(memory);
  return 2;
}

/* ---------------------------------------------------------------------- */

void MinTMSPHLBFGS::init()
{
  Min::init();
  if (dmax < 0.0) error->all(FLERR, "Min_modify dmax {} must be positive", dmax);
  longest = dmax;
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  preconditioner.init(pair);
  forget();
}

/* ----------------------------------------------------------------------
   a fraction of the smallest spacing, which is known when the bonds have formed
------------------------------------------------------------------------- */

double MinTMSPHLBFGS::usual_longest() const
{
  if (!pair) return 0.1;    // LAMMPS's own default
  double smallest = HUGE_VAL, all;
  for (int i = 0; i < atom->nlocal; i++) smallest = std::min(smallest, pair->bonds()->spacing(i));
  MPI_Allreduce(&smallest, &all, 1, MPI_DOUBLE, MPI_MIN, world);
  return DMAX * all;
}

/* ---------------------------------------------------------------------- */

void MinTMSPHLBFGS::setup_style()
{
  if (nextra_global || nextra_atom)
    error->all(FLERR,
               "Min style tmsph/lbfgs moves particles only: it cannot serve fix box/relax "
               "or other degrees of freedom: use 'min_style cg' with 'min_modify line "
               "forcezero' and a dmax of 0.01 spacings");
  for (int n = 0; n < HISTORY + 2 * lbfgs.memory(); n++) fix_minimize->add_vector(3);
}

/* ---------------------------------------------------------------------- */

void MinTMSPHLBFGS::reset_vectors()
{
  nvec = 3 * atom->nlocal;
  if (nvec) xvec = atom->x[0];
  if (nvec) fvec = atom->f[0];
}

/* ---------------------------------------------------------------------- */

double *MinTMSPHLBFGS::fix_vector(int n)
{
  return fix_minimize->request_vector(n);
}

/* ---------------------------------------------------------------------- */

double MinTMSPHLBFGS::dot(const Vector &a, const Vector &b)
{
  const double terms = 3.0 * std::max<bigint>(atom->natoms, 1);
  const double scale = TMSPH::fixed_point_scale(terms * a.bound * b.bound);
  if (scale == 0.0) return 0.0;
  int64_t mine = TMSPH::fixed_point_dot(nvec, a.at, b.at, scale), all;
  MPI_Allreduce(&mine, &all, 1, MPI_LL, MPI_SUM, world);
  return all / scale;
}

/* ---------------------------------------------------------------------- */

double MinTMSPHLBFGS::largest(const double *a)
{
  double mine = TMSPH::largest_magnitude(nvec, a);
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}

/* ---------------------------------------------------------------------- */

double MinTMSPHLBFGS::force_norm()
{
  const Vector f = {fvec, largest(fvec)};
  return std::sqrt(dot(f, f));
}

/* ---------------------------------------------------------------------- */

void MinTMSPHLBFGS::evaluate()
{
  neval++;
  if (with_energy)
    update_all();
  else
    update_forces();
}

/* ---------------------------------------------------------------------- */

void MinTMSPHLBFGS::update_all()
{
  total_evaluations++;
  ecurrent = energy_force(1);
}

/* ----------------------------------------------------------------------
   forces of pair style and fixes; particles change hands as in Min
------------------------------------------------------------------------- */

void MinTMSPHLBFGS::update_forces()
{
  if (neighbor->decide() || !pair_compute_flag || force->kspace ||
      atom->molecular != Atom::ATOMIC) {
    neighbor->ago--;    // asked again there
    update_all();
    return;
  }
  total_evaluations++;
  timer->stamp();
  comm->forward_comm();
  timer->stamp(Timer::COMM);
  force_clear();
  if (modify->n_min_pre_force) modify->min_pre_force(0);
  timer->stamp(Timer::MODIFY);
  force->pair->compute(0, 0);
  timer->stamp(Timer::PAIR);
  if (modify->n_min_pre_reverse) modify->min_pre_reverse(0, 0);
  if (force->newton) comm->reverse_comm();
  timer->stamp(Timer::COMM);
  if (modify->n_min_post_force) modify->min_post_force(0);
  timer->stamp(Timer::MODIFY);
}

/* ----------------------------------------------------------------------
   forces after a move by "length" along the direction
   return their component along it
------------------------------------------------------------------------- */

double MinTMSPHLBFGS::try_length(double length)
{
  const double *start = fix_vector(START), *d = fix_vector(DIRECTION);
  for (int i = 0; i < nvec; i++) xvec[i] = start[i] + length * d[i];
  evaluate();
  double *moved = fix_vector(DIRECTION);
  return dot({fvec, largest(fvec)}, {moved, largest(moved)});
}

/* ----------------------------------------------------------------------
   One iteration. A length is good if the force along the direction has not
   turned too far against it: energies, whose differences drown in round-off near
   equilibrium, are not asked.
   return 0, or why it cannot go on
------------------------------------------------------------------------- */

int MinTMSPHLBFGS::step()
{
  const auto slot_step = [&](int k) { return fix_vector(HISTORY + 2 * k); };
  const auto slot_change = [&](int k) { return fix_vector(HISTORY + 2 * k + 1); };
  const auto product = [&](const Vector &a, const Vector &b) { return dot(a, b); };

  double slope = 0.0, farthest = 0.0;
  Vector d = {fix_vector(DIRECTION), 0.0};
  const double strongest = largest(fvec);
  if (strongest == 0.0) return ZEROFORCE;
  while (true) {
    std::copy_n(fvec, nvec, d.at);
    d.bound = strongest;
    lbfgs.direction(nvec, d, slot_step, slot_change, product,
                    [this](Vector &v) { preconditioner.apply(v); });
    d.bound = farthest = largest(d.at);
    slope = dot({fvec, strongest}, d);
    if (slope > 0.0 && std::isfinite(slope)) break;
    if (lbfgs.known() == 0) return DOWNHILL;
    forget();
  }

  std::copy_n(xvec, nvec, fix_vector(START));
  std::copy_n(fvec, nvec, fix_vector(FORMER));
  fix_minimize->store_box();
  if (longest == 0.0) longest = usual_longest();
  const double most = longest / farthest;
  const bool learning = lbfgs.known() == 0;
  double length = learning ? FIRST * most : std::min(1.0, most);
  double slope_there = try_length(length);
  for (int trial = 0; trial < TRIALS; trial++) {
    const bool beyond = slope_there < -CURVATURE * slope;
    const bool before = learning && slope_there > CURVATURE * slope && length < most;
    if (!beyond && !before) break;
    length = std::min(most,
                      TMSPH::secant_length(length, slope, slope_there, LEAST_PART,
                                           before ? MOST_GROWTH : MOST_PART));
    slope_there = try_length(length);
  }
  alpha_final = length;

  // the pair of step and change; one without positive curvature teaches nothing

  const int k = lbfgs.next();
  double *s = slot_step(k), *y = slot_change(k);
  const double *direction = fix_vector(DIRECTION), *former = fix_vector(FORMER);
  for (int i = 0; i < nvec; i++) {
    s[i] = length * direction[i];
    y[i] = former[i] - fvec[i];
  }
  const double y_largest = largest(y);
  const double work = length * (slope - slope_there);
  Vector scaled = {fix_vector(SCALED), y_largest};
  std::copy_n(y, nvec, scaled.at);
  preconditioner.apply(scaled);
  const double square = dot({y, y_largest}, scaled);
  if (work > 0.0 && square > 0.0) lbfgs.take(length * farthest, y_largest, work, square);
  return 0;
}

/* ---------------------------------------------------------------------- */

int MinTMSPHLBFGS::iterate(int maxiter)
{
  with_energy = true;
  for (int iteration = 0; iteration < maxiter; iteration++) {
    if (timer->check_timeout(niter)) return TIMEOUT;
    const bigint ntimestep = ++update->ntimestep;
    niter++;
    eprevious = ecurrent;
    if (const int failure = step()) return failure;
    if (neval >= update->max_eval) return MAXEVAL;
    if (std::fabs(ecurrent - eprevious) <
        update->etol * 0.5 * (std::fabs(ecurrent) + std::fabs(eprevious) + EPS_ENERGY))
      return ETOL;
    const double norm = normstyle == MAX ? std::sqrt(fnorm_max())
        : normstyle == INF               ? std::sqrt(fnorm_inf())
                                         : force_norm();
    if (norm < update->ftol) return FTOL;
    if (output->next == ntimestep) {
      timer->stamp();
      output->write(ntimestep);
      timer->stamp(Timer::OUTPUT);
    }
  }
  return MAXITER;
}

/* ---------------------------------------------------------------------- */

bool MinTMSPHLBFGS::equilibrate(double norm, bigint most, const std::function<void()> &after)
{
  with_energy = false;
  const bigint first = total_evaluations;
  while (force_norm() > norm) {
    if (total_evaluations - first >= most) return false;
    niter++;
    if (step()) return false;
    after();
  }
  return true;
}
