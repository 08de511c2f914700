/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_network.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_collective.h"
#include "tmsph_conduction.h"
#include "tmsph_heat_materials.h"
#include "tmsph_heat_sweep.h"
#include "tmsph_openings.h"
#include "tmsph_participants.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

TMSPHHeatNetwork::TMSPHHeatNetwork(LAMMPS *lmp, const TMSPHHeatMaterials &given,
                                   TMSPHGhostSender &sender) :
    Pointers(lmp),
    materials(given), ghosts(sender), norms_of_bonds(lmp), flat_faces(lmp, sender),
    balance(lmp, norms_of_bonds, sender),
    body_surface(lmp, norms_of_bonds, flat_faces, balance, sender), calibrated(atom->ntypes + 1)
{
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatNetwork::init(const FixTMSPHBond *owner, const TMSPHBondUser *user,
                            const TMSPHParticipants *participants)
{
  bonds = owner;
  others = participants;
  watch.forget();
  norms_of_bonds.init(owner, user);
  flat_faces.init(owner, user);
  balance.init(owner);
  body_surface.init(owner);
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatNetwork::form()
{
  if (!norms_of_bonds.lacking()) return;
  balance.drop();
  flat_faces.drop_all();
  std::vector<double> second = norms_of_bonds.second_moments();
  const auto pulls = body_surface.pulls(false);
  const std::vector<char> near = body_surface.near(pulls);
  const bool irregular = body_surface.irregular_inside(pulls, near);
  if (!irregular) flat_faces.find(near, second);
  norms_of_bonds.set(second, near);
  norms_of_bonds.find_depths();
  if (irregular) {
    const auto normed = body_surface.pulls(false);
    balance.solve(normed, body_surface.near(normed));
  }
  for (int type = 1; type <= atom->ntypes; type++)
    if (materials.orthotropic(type))
      domain->dimension == 2 ? calibrate<2>(type, near) : calibrate<3>(type, near);
}

/* ----------------------------------------------------------------------
   A lattice has few directions: its mean of k(e) e e^T is not quite K. The
   tensor in k(e) is adjusted until it is but for round-off, on the mean of the
   interior: in 26 to 41 ITERATIONS for the lattices of test_heat_modes.
------------------------------------------------------------------------- */

template <int D> void TMSPHHeatNetwork::calibrate(int type, const std::vector<char> &near)
{
  static constexpr int ITERATIONS = 100;
  using Conductivity = DirectionalConductivity<D>;
  const double *given = materials.tensor(type);
  typename Conductivity::Tensor K, used;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) K(a, b) = given[3 * a + b];
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
        if (!pure) continue;
        const double weight = bonds->weight(i, j) * correction(i, j, X);
        sum += weight * k(R.normalized()) * R * R.transpose();
      }
      if (!pure) continue;
      sum *= norms_of_bonds.frozen_norm(i) / atom->vfrac[i];
      ones.push_back(1.0);
      for (int a = 0, n = 0; a < D; a++)
        for (int b = a; b < D; b++) terms[n++].push_back(sum(a, b));
    }
    const double count = fixed_point_sum(ones, world);
    if (count == 0.0) break;
    typename Conductivity::Tensor mean;
    for (int a = 0, n = 0; a < D; a++)
      for (int b = a; b < D; b++)
        mean(a, b) = mean(b, a) = fixed_point_sum(terms[n++], world) / count;
    const double error = (K - mean).norm() / K.norm();
    used += K - mean;
    if (error < 1.0e-13) break;
  }
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) calibrated[type][3 * a + b] = used(a, b);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHHeatNetwork::find_conductances(const std::vector<int> &particles)
{
  const Slices &slices = bonds->layout();
  const int ntypes = atom->ntypes;
  const bool tables = materials.has_tables();
  const TMSPHOpenings *const openings = others->openings();
  std::vector<double> k(ntypes + 1), most(ntypes + 1);
  std::vector<DirectionalConductivity<D>> directional(ntypes + 1);
  for (int type = 1; type <= ntypes; type++) {
    k[type] = tables ? 1.0 : materials.conductivity(type)(0.0);
    most[type] = materials.conductivity(type).largest();
    if (!materials.orthotropic(type)) continue;
    typename DirectionalConductivity<D>::Tensor K;
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) K(a, b) = calibrated[type][3 * a + b];
    directional[type] = DirectionalConductivity<D>(K);
  }
  for (const int i : particles) {
    const int itype = atom->type[i];
    sum_of[i] = 0.0;
    for (int n = 0; n < bonds->count(i); n++) {
      const size_t at = slices.at(i, n);
      conductances[at] = 0.0f;
      if (bonds->bond_state(i, n) != FixTMSPHBond::INTACT) continue;
      const int j = slices.partner[at], jtype = atom->type[j];
      double ki = k[itype], kj = k[jtype];
      if (materials.orthotropic(itype) || materials.orthotropic(jtype)) {
        double X[3];
        bonds->reference_vector(i, j, X);
        const auto e = typename DirectionalConductivity<D>::Vector(X).normalized();
        if (materials.orthotropic(itype)) ki = directional[itype](e);
        if (materials.orthotropic(jtype)) kj = directional[jtype](e);
      }
      double base = (norms_of_bonds.norm(i) + norms_of_bonds.norm(j)) * bonds->weight(i, j);
      if (corrected(i, j)) {
        double X[3];
        bonds->reference_vector(i, j, X);
        base *= correction(i, j, X);
      }
      if (openings) base *= std::max(0.0, 1.0 - openings->part_open(i, n));
      const bool across = itype != jtype && !tables;
      const double both = across
          ? in_series(ki, norms_of_bonds.depth(i), kj, norms_of_bonds.depth(j))
          : harmonic_mean(ki, kj);
      conductances[at] = (float) (base * both);
      sum_of[i] += tables ? base * harmonic_mean(most[itype], most[jtype]) : conductances[at];
    }
  }
}

/* ----------------------------------------------------------------------
   factor to the conductance of a bond with reference vector X from i to j
------------------------------------------------------------------------- */

double TMSPHHeatNetwork::correction(int i, int j, const double *X) const
{
  return balance.any() ? balance.factor(i, j, X) : flat_faces.factor(i, j, X);
}

/* ----------------------------------------------------------------------
   of all particles, or of those that lost bonds: as if they were all found now, since the stages of
   a step follow from the sums
------------------------------------------------------------------------- */

void TMSPHHeatNetwork::follow()
{
  std::vector<int> particles;
  if (watch.laid_out_anew(*bonds)) {
    norms_of_bonds.complete(ghosts);
    balance.complete();
    flat_faces.complete();
    conductances.assign(bonds->layout().weight.size(), 0.0f);
    sum_of.resize(atom->nlocal);
    particles.resize(atom->nlocal);
    std::iota(particles.begin(), particles.end(), 0);
  } else {
    watch.each_removal(*bonds, [&particles](int i) { particles.push_back(i); });
    if (const TMSPHOpenings *const openings = others->openings())
      for (int i = 0; i < atom->nlocal; i++)
        if (openings->opens_at(i)) particles.push_back(i);
    std::sort(particles.begin(), particles.end());
    particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
  }
  watch.see(*bonds);
  if (particles.empty()) return;
  if (domain->dimension == 2)
    find_conductances<2>(particles);
  else
    find_conductances<3>(particles);
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatNetwork::conduct(const double *temperature, double *power)
{
  if (materials.has_tables()) {
    const int nall = atom->nlocal + atom->nghost;
    conductivities.resize(nall);
    for (int i = 0; i < nall; i++)
      conductivities[i] = materials.conductivity(atom->type[i])(temperature[i]);
  }
  heat_sweep(bonds->layout(), conductances.data(), temperature,
             materials.has_tables() ? conductivities.data() : nullptr, power);
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatNetwork::append_to(std::vector<double> &list) const
{
  for (const auto &tensor : calibrated) list.insert(list.end(), tensor.begin(), tensor.end());
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatNetwork::take_from(const double *list)
{
  for (auto &tensor : calibrated) {
    std::copy_n(list, tensor.size(), tensor.begin());
    list += tensor.size();
  }
}

/* ---------------------------------------------------------------------- */

double TMSPHHeatNetwork::bytes() const
{
  return norms_of_bonds.bytes() + balance.bytes() + flat_faces.bytes() +
      conductances.capacity() * sizeof(float) +
      (conductivities.capacity() + sum_of.capacity()) * sizeof(double);
}
