/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Conductances of the bonds of fix tmsph/heat, and the surface of the body.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_store_atom.h"
#include "fix_tmsph_bond.h"
#include "pair_tmsph.h"
#include "tmsph_conduction.h"
#include "tmsph_fixed_point.h"
#include "tmsph_interface.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// one-sidedness of the particles in the outermost row of a surface, at least: of a flat one it is
// about 0.45, inside an irregular cloud below 0.15

static constexpr double OUTERMOST = 0.25;

// a particle is at least this share of its spacing below an interface

static constexpr double LEAST_DEPTH = 0.1;

// less than this is round-off

static constexpr double EVEN = 1.0e-6;

// one-sidedness inside an irregular cloud, at least: with spacings that vary by a few thousandths;
// and that of surfaces in multiples of it

static constexpr double IRREGULAR = 1.0e-3, FAR_MORE = 3.0;

/* ----------------------------------------------------------------------
   a sum that does not depend on how its terms are spread over processors
------------------------------------------------------------------------- */

static double fixed_point_sum(const std::vector<double> &terms, MPI_Comm world)
{
  const int n = terms.size();
  const std::vector<double> ones(n, 1.0);
  double mine = largest_magnitude(n, terms.data()), largest;
  bigint count = n, total, all;
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  const double scale = fixed_point_scale(largest * (double) total);
  bigint sum = fixed_point_dot(n, terms.data(), ones.data(), scale);
  MPI_Allreduce(&sum, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return scale > 0.0 ? (double) all / scale : 0.0;
}

/* ----------------------------------------------------------------------
   median of positive numbers, the same however they are spread; 0 if there are none
------------------------------------------------------------------------- */

static double median(const std::vector<double> &values, MPI_Comm world)
{
  double mine[2] = {-HUGE_VAL, 0.0}, range[2];
  for (double v : values) {
    mine[0] = std::max(mine[0], -v);
    mine[1] = std::max(mine[1], v);
  }
  MPI_Allreduce(mine, range, 2, MPI_DOUBLE, MPI_MAX, world);
  bigint count = values.size(), total, below, all;
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (!total) return 0.0;
  double low = -range[0], high = range[1];
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return high;
    below = std::count_if(values.begin(), values.end(), [=](double v) { return v <= middle; });
    MPI_Allreduce(&below, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    (2 * all < total ? low : high) = middle;
  }
}

/* ----------------------------------------------------------------------
   Normal, depth and area of the surface near each local particle. With
     A_i = 2 c V_i |sum_j V_j grad W_ij|
   a field that varies linearly with the depth is steady at each particle near a
   flat surface at the right temperature: what its bonds bring, A_i k dT/dn, is
   what its share of the surface takes. Sets "shared" where a particle is
   outermost.
------------------------------------------------------------------------- */

template <int D> std::vector<FixTMSPHHeat::SurfaceShare> FixTMSPHHeat::classify(bool cracks)
{
  std::vector<SurfaceShare> shares(atom->nlocal);
  shared.assign(atom->nlocal, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    OwnSurface<D> own;
    for (int k = 0; k < bonds->count(i); k++) {
      const int j = bonds->partner_index(i, k), state = bonds->bond_state(i, k);
      if (j == i || state == FixTMSPHBond::UNBONDED) continue;
      if (cracks && state != FixTMSPHBond::INTACT) continue;
      double X[3];
      bonds->reference_vector(i, j, X);
      own.add(X, bonds->weight(i, j));
    }
    SurfaceShare &share = shares[i];
    share.surface = own.find(bonds->spacing(i), EVEN);
    const Exposure exposure = share.surface.exposure;
    if (exposure == Exposure::SURFACE) {
      share.surface.depth = own.depth_of_rows(share.surface, bonds->spacing(i));
      share.area = 2.0 * norms->astore[i][NORM] * own.length_of_sum();
    }
    share.one_sidedness = own.one_sidedness();
    if (exposure == Exposure::LOOSE || share.one_sidedness > OUTERMOST) shared[i] = 1.0;
  }
  return shares;
}

/* ----------------------------------------------------------------------
   particles that are outermost or have a partner that is
------------------------------------------------------------------------- */

std::vector<char> FixTMSPHHeat::near_surface(const std::vector<SurfaceShare> &shares)
{
  std::vector<double> outermost(shared);
  share(outermost);
  std::vector<char> near(shares.size());
  for (int i = 0; i < atom->nlocal; i++) {
    near[i] = outermost[i] != 0.0;
    for (int k = 0; k < bonds->count(i) && !near[i]; k++)
      near[i] = bonds->bond_state(i, k) != FixTMSPHBond::UNBONDED &&
          outermost[bonds->partner_index(i, k)] != 0.0;
  }
  return near;
}

/* ----------------------------------------------------------------------
   typical one-sidedness of particles away from any surface: 0 on a lattice
------------------------------------------------------------------------- */

double FixTMSPHHeat::interior_noise(const std::vector<SurfaceShare> &shares,
                                    const std::vector<char> &near) const
{
  std::vector<double> inside;
  for (size_t i = 0; i < shares.size(); i++)
    if (!near[i]) inside.push_back(shares[i].one_sidedness);
  return median(inside, world);
}

/* ----------------------------------------------------------------------
   Inside an irregular cloud bonds pull unevenly too: of its particles those make
   the surface whose bonds pull far more so. What the bonds of a neighborhood bring
   together is then shared out among those in it: inside it all pulls cancel in
   pairs, so that the sum is that of a smooth surface. All shares are scaled by the
   divergence theorem, integral of x.n over the surface = D times the volume, x
   from the middle; in periodic directions x means nothing.
------------------------------------------------------------------------- */

std::vector<FixTMSPHHeat::SurfaceShare> FixTMSPHHeat::surface(bool cracks)
{
  const int nlocal = atom->nlocal;
  std::vector<SurfaceShare> shares = domain->dimension == 2 ? classify<2>(cracks)
                                                            : classify<3>(cracks);
  const std::vector<char> near = near_surface(shares);
  for (int i = 0; i < nlocal; i++)
    if (!near[i]) shares[i].area = 0.0;
  const double noise = interior_noise(shares, near);
  if (noise < IRREGULAR) return shares;

  std::vector<double> pulls[3], areas;
  for (int k = 0; k < 3; k++) {
    for (const SurfaceShare &share : shares)
      pulls[k].push_back(share.area * share.surface.normal[k]);
    share(pulls[k]);
  }
  for (SurfaceShare &share : shares) {
    if (share.one_sidedness < FAR_MORE * noise) share.area = 0.0;
    areas.push_back(share.area);
  }
  share(areas);
  for (int i = 0; i < nlocal; i++) {
    SurfaceShare &share = shares[i];
    if (share.area == 0.0) continue;
    double sum[3], all = areas[i], square = 0.0;
    for (int k = 0; k < 3; k++) sum[k] = pulls[k][i];
    for (int n = 0; n < bonds->count(i); n++) {
      const int j = bonds->partner_index(i, n);
      if (j == i || bonds->bond_state(i, n) == FixTMSPHBond::UNBONDED) continue;
      for (int k = 0; k < 3; k++) sum[k] += pulls[k][j];
      all += areas[j];
    }
    for (int k = 0; k < 3; k++) square += sum[k] * sum[k];
    const double length = std::sqrt(square);
    share.area *= length / all;
    for (int k = 0; k < 3 && length > 0.0; k++) share.surface.normal[k] = sum[k] / length;
  }
  scale_areas(shares);
  return shares;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::scale_areas(std::vector<SurfaceShare> &shares) const
{
  const int nlocal = atom->nlocal;
  std::vector<double> volumes(atom->vfrac, atom->vfrac + nlocal), moments(nlocal);
  const double volume = fixed_point_sum(volumes, world);
  int directions = 0;
  for (int k = 0; k < domain->dimension; k++) {
    if (domain->periodicity[k]) continue;
    directions++;
    std::vector<double> places(nlocal);
    for (int i = 0; i < nlocal; i++) places[i] = atom->vfrac[i] * bonds->reference(i)[k];
    const double middle = fixed_point_sum(places, world) / volume;
    for (int i = 0; i < nlocal; i++) {
      const Surface &s = shares[i].surface;
      moments[i] += shares[i].area * s.normal[k] *
          (bonds->reference(i)[k] - middle + s.depth * s.normal[k]);
    }
  }
  const double moment = fixed_point_sum(moments, world);
  if (moment > 0.0)
    for (SurfaceShare &share : shares) share.area *= directions * volume / moment;
}

/* ----------------------------------------------------------------------
   c = D/sum_j V_j w R^2 of each particle from all bonds that it had, so that
   broken ones do not make the others conduct better. Near a surface, where the
   sum lacks terms, that of the interior.
------------------------------------------------------------------------- */

void FixTMSPHHeat::find_norms()
{
  const int nlocal = atom->nlocal, dimension = domain->dimension;
  int lacking = 0, any;
  for (int i = 0; i < nlocal; i++) lacking = lacking || norms->astore[i][NORM] == 0.0;
  MPI_Allreduce(&lacking, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any) return;

  std::vector<double> second(nlocal);    // sum_j V_j w R^2
  for (int i = 0; i < nlocal; i++) {
    for (int k = 0; k < bonds->count(i); k++) {
      const int j = bonds->partner_index(i, k);
      if (j == i || bonds->bond_state(i, k) == FixTMSPHBond::UNBONDED) continue;
      double X[3];
      bonds->reference_vector(i, j, X);
      second[i] += bonds->weight(i, j) * (X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
    }
    second[i] /= atom->vfrac[i];
  }
  const auto shares = dimension == 2 ? classify<2>(false) : classify<3>(false);
  const std::vector<char> near = near_surface(shares);
  const auto typical = [&](int type) {
    std::vector<double> inside;
    double mine = 0.0, largest;
    for (int i = 0; i < nlocal; i++) {
      if (atom->type[i] != type) continue;
      mine = std::max(mine, second[i]);
      if (!near[i]) inside.push_back(second[i]);
    }
    MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    const double middle = median(inside, world);
    return middle > 0.0 ? middle : largest;
  };
  for (int type = 1; type <= atom->ntypes; type++) {
    const double sum = typical(type);
    for (int i = 0; i < nlocal; i++)
      if (atom->type[i] == type) norms->astore[i][NORM] = dimension / (near[i] ? sum : second[i]);
  }
  find_depths();
  for (int type = 1; type <= atom->ntypes; type++)
    if (substances[type].orthotropic)
      dimension == 2 ? calibrate<2>(type, near) : calibrate<3>(type, near);
  if (interior_noise(shares, near) < IRREGULAR) return;
  for (int type = 1; type <= atom->ntypes; type++)
    dimension == 2 ? allow_for_disorder<2>(type, near) : allow_for_disorder<3>(type, near);
}

/* ----------------------------------------------------------------------
   depth below the interface to another type, of particles near one
------------------------------------------------------------------------- */

void FixTMSPHHeat::find_depths()
{
  const int dimension = domain->dimension;
  const Kernel kernel = pair->kernel_of_bonds();
  std::vector<InterfaceDepth> depth_in(atom->ntypes + 1);
  for (int type = 1; type <= atom->ntypes && atom->ntypes > 1; type++)
    depth_in[type] = InterfaceDepth(kernel, dimension, pair->horizon(type, type));
  for (int i = 0; i < atom->nlocal; i++) {
    const int type = atom->type[i];
    const double reach = pair->horizon(type, type);
    double own = atom->vfrac[i] * kernel_value(kernel, dimension, 0.0, reach), all = own;
    for (int n = 0; n < bonds->count(i); n++) {
      const int j = bonds->partner_index(i, n);
      if (j == i || bonds->bond_state(i, n) == FixTMSPHBond::UNBONDED) continue;
      double X[3];
      bonds->reference_vector(i, j, X);
      const double R = std::sqrt(X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
      const double mass = atom->vfrac[j] * kernel_value(kernel, dimension, R, reach);
      if (atom->type[j] == type) own += mass;
      all += mass;
    }
    norms->astore[i][DEPTH] = own == all
        ? 0.0
        : std::max(depth_in[type](own / all), LEAST_DEPTH * bonds->spacing(i));
  }
}

/* ----------------------------------------------------------------------
   A lattice has few directions: its mean of k(e) e e^T is not quite K. The
   tensor in k(e) is adjusted until it is, on the mean of the interior.
------------------------------------------------------------------------- */

template <int D> void FixTMSPHHeat::calibrate(int type, const std::vector<char> &near)
{
  static constexpr int ITERATIONS = 100;
  using Conductivity = DirectionalConductivity<D>;
  Substance &s = substances[type];
  typename Conductivity::Tensor K, used;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) K(a, b) = s.principal[3 * a + b];
  used = K;

  for (int iteration = 0; iteration < ITERATIONS; iteration++) {
    const Conductivity k(used);
    std::vector<double> terms[SYMMETRIC<D>], ones;
    for (int i = 0; i < atom->nlocal; i++) {
      if (atom->type[i] != type || near[i]) continue;
      bool pure = true;
      typename Conductivity::Tensor sum = Conductivity::Tensor::Zero();
      for (int n = 0; n < bonds->count(i) && pure; n++) {
        const int j = bonds->partner_index(i, n);
        pure = j != i && atom->type[j] == type;
        double X[3];
        bonds->reference_vector(i, j, X);
        const typename Conductivity::Vector R(X);
        if (pure) sum += bonds->weight(i, j) * k(R.normalized()) * R * R.transpose();
      }
      if (!pure) continue;
      sum *= norms->astore[i][NORM] / atom->vfrac[i];
      ones.push_back(1.0);
      for (int a = 0, n = 0; a < D; a++)
        for (int b = a; b < D; b++) terms[n++].push_back(sum(a, b));
    }
    const double count = fixed_point_sum(ones, world);
    if (count == 0.0) break;
    typename Conductivity::Tensor mean;
    for (int a = 0, n = 0; a < D; a++)
      for (int b = a; b < D; b++) mean(a, b) = mean(b, a) = fixed_point_sum(terms[n++], world) / count;
    const double error = (K - mean).norm() / K.norm();
    used += K - mean;
    if (error < 1.0e-13) break;
  }
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) s.calibrated[3 * a + b] = used(a, b);
}

/* ----------------------------------------------------------------------
   An irregular cloud conducts less than the mean of its bonds: in a field of
   unit slope temperatures move to where the sum over the bonds vanishes, and
   heat takes the easier ways. By how much is found in the interior, direction
   by direction, by relaxation, and made up for in c.
------------------------------------------------------------------------- */

template <int D>
void FixTMSPHHeat::allow_for_disorder(int type, const std::vector<char> &near)
{
  static constexpr int SWEEPS = 20;
  static constexpr double RELAXATION = 0.9;
  const int nlocal = atom->nlocal;
  std::vector<char> free(nlocal);
  for (int i = 0; i < nlocal; i++) {
    free[i] = atom->type[i] == type && !near[i];
    for (int n = 0; n < bonds->count(i) && free[i]; n++) {
      const int j = bonds->partner_index(i, n);
      free[i] = j != i && atom->type[j] == type;
    }
  }
  std::vector<double> c = stored(NORM), moved[D], before[D];
  share(c);
  for (auto &m : moved) m.assign(nlocal, 0.0);
  std::vector<double> rigid, relaxed;    // energies of a network of springs like this one
  for (int sweep = 0; sweep <= SWEEPS; sweep++) {
    for (int a = 0; a < D; a++) {
      before[a] = moved[a];
      share(before[a]);
    }
    for (int i = 0; i < nlocal; i++) {
      if (!free[i]) continue;
      double pull[D] = {}, all = 0.0, at_first = 0.0, now = 0.0;
      for (int n = 0; n < bonds->count(i); n++) {
        const int j = bonds->partner_index(i, n);
        const double g = (c[i] + c[j]) * bonds->weight(i, j);
        double X[3];
        bonds->reference_vector(i, j, X);
        all += g;
        for (int a = 0; a < D; a++) {
          const double stretch = X[a] + before[a][j] - before[a][i];
          pull[a] += g * stretch;
          at_first += g * X[a] * X[a];
          now += g * stretch * stretch;
        }
      }
      for (int a = 0; a < D; a++) moved[a][i] += RELAXATION * pull[a] / all;
      if (sweep < SWEEPS) continue;
      rigid.push_back(at_first);
      relaxed.push_back(now);
    }
  }
  const double rest = fixed_point_sum(relaxed, world);
  if (!(rest > 0.0)) return;
  const double gain = fixed_point_sum(rigid, world) / rest;
  for (int i = 0; i < nlocal; i++)
    if (atom->type[i] == type) norms->astore[i][NORM] *= gain;
}

/* ---------------------------------------------------------------------- */

template <int D> void FixTMSPHHeat::find_conductances()
{
  const Slices &slices = bonds->layout();
  const int ntypes = atom->ntypes;
  std::vector<double> k(ntypes + 1), most(ntypes + 1);
  std::vector<DirectionalConductivity<D>> directional(ntypes + 1);
  for (int type = 1; type <= ntypes; type++) {
    const Substance &s = substances[type];
    k[type] = tables ? 1.0 : s.conductivity(0.0);
    most[type] = s.conductivity.largest();
    if (!s.orthotropic) continue;
    typename DirectionalConductivity<D>::Tensor K;
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) K(a, b) = s.calibrated[3 * a + b];
    directional[type] = DirectionalConductivity<D>(K);
  }
  conductances.assign(slices.weight.size(), 0.0f);
  sums.assign(atom->nlocal, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    const int itype = atom->type[i];
    for (int n = 0; n < bonds->count(i); n++) {
      if (bonds->bond_state(i, n) != FixTMSPHBond::INTACT) continue;
      const size_t at = slices.at(i / WIDTH, i % WIDTH, n);
      const int j = slices.partner[at], jtype = atom->type[j];
      double ki = k[itype], kj = k[jtype];
      if (substances[itype].orthotropic || substances[jtype].orthotropic) {
        double X[3];
        bonds->reference_vector(i, j, X);
        const auto e = typename DirectionalConductivity<D>::Vector(X).normalized();
        if (substances[itype].orthotropic) ki = directional[itype](e);
        if (substances[jtype].orthotropic) kj = directional[jtype](e);
      }
      const double base = (all_norms[i] + all_norms[j]) * bonds->weight(i, j);
      const bool across = itype != jtype && !tables;
      conductances[at] = (float) (base * (across ? in_series(ki, all_depths[i], kj, all_depths[j])
                                                 : harmonic_mean(ki, kj)));
      sums[i] += tables ? base * harmonic_mean(most[itype], most[jtype]) : conductances[at];
    }
  }
}

/* ---------------------------------------------------------------------- */

std::vector<double> FixTMSPHHeat::stored(int column) const
{
  std::vector<double> values(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) values[i] = norms->astore[i][column];
  return values;
}

/* ----------------------------------------------------------------------
   after an exchange of particles all are found anew; bonds that have gone since
   no longer conduct
------------------------------------------------------------------------- */

void FixTMSPHHeat::follow()
{
  if (version != bonds->layout_version()) {
    version = bonds->layout_version();
    all_norms = stored(NORM);
    share(all_norms);
    all_depths = stored(DEPTH);
    share(all_depths);
    domain->dimension == 2 ? find_conductances<2>() : find_conductances<3>();
  } else if (removals != bonds->removals())
    drop_conductances();
  removals = bonds->removals();
}

/* ----------------------------------------------------------------------
   the sums stay as bounds: with fewer bonds the stable step is only longer
------------------------------------------------------------------------- */

void FixTMSPHHeat::drop_conductances()
{
  const Slices &slices = bonds->layout();
  for (int i = 0; i < atom->nlocal; i++)
    for (int n = 0; n < bonds->count(i); n++)
      if (bonds->bond_state(i, n) != FixTMSPHBond::INTACT)
        conductances[slices.at(i / WIDTH, i % WIDTH, n)] = 0.0f;
}

/* ----------------------------------------------------------------------
   n.K.n: the flux along n in a field that varies along n only
------------------------------------------------------------------------- */

double FixTMSPHHeat::conductivity(int i, const double *direction) const
{
  const Substance &s = substances[atom->type[i]];
  if (!s.orthotropic) return s.conductivity(atom->temperature[i]);
  double k = 0.0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) k += direction[a] * s.principal[3 * a + b] * direction[b];
  return k;
}
