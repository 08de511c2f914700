/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress of particles that walls or contacts press, for output and for the
   breaking of bonds.

   A force on the surface reaches the outermost particles, while bonds pass it
   on over the horizon. What bonds carry of a uniform stress p near a wall
   follows from their equilibrium, row by row: 0.71, 0.81, 0.96, 1.02 p in a
   square lattice. Missing is p over half a row: the force on the surface times
   half a row. Meant is the average with the kernel of both (Hardy, J. Chem.
   Phys. 76 (1982) 622). Only bonds to the own material take part.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "comm.h"
#include "fix.h"
#include "modify.h"
#include "tmsph_presses.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace LAMMPS_NS;
using namespace TMSPH;

// particles report the average in full when their surface makes this part of their stress, or that
// of one of their family: with an eighth single ones beside a closed cut are off by 12 %, with this by
// less than 10 % (unittest/verification/test_closed_cut.py)

static constexpr double PRESSED = 0.04;

// So often: in equilibrium, with hourglass 0.1 to 0.5, the stresses of all rows of a square,
// hexagonal or simple cubic lattice along the wall are then within 1.3 % of p; with one round 6 %.
// Of rows along diagonals, whose particles stand in front of each other, 4 %.

static constexpr int ROUNDS = 3;

// of them where contacts alone press: with one single particles beside a closed cut are off by 11 %

static constexpr int CONTACT_ROUNDS = 2;

namespace {
struct Near {
  int j;
  double mass;    // V_j W_ij
};
struct Pressed {
  int i, first, last;    // itself and its bonds
  double part;           // of the average that it reports
};

/// columns of a row that is sent: how forces on the outermost particles press, how contacts do, and
/// what is to be spread over the sum of V_k W_ik
enum { BY_SURFACE, BY_CONTACT, SPREAD };
}    // namespace

/* ----------------------------------------------------------------------
   local particles that have a share or a bond to one that has
------------------------------------------------------------------------- */

std::vector<int> PairTMSPH::find_pressed(const std::vector<int> &sharing)
{
  const int nlocal = atom->nlocal, width = pressed_width();
  if (border_version != bond_fix->layout_version()) {
    border_version = bond_fix->layout_version();
    border.clear();
    for (int i = 0; i < nlocal; i++)
      for (int k = 0; k < bond_fix->count(i); k++)
        if (bond_fix->partner_index(i, k) >= nlocal) {
          border.push_back(i);
          break;
        }
  }
  std::vector<char> found(nlocal, 0);
  for (const int i : sharing) {
    found[i] = 1;
    for (int k = 0; k < bond_fix->count(i); k++)
      if (own_bond(i, k) && bond_fix->partner_index(i, k) < nlocal)
        found[bond_fix->partner_index(i, k)] = 1;
  }
  for (const int i : border)
    for (int k = 0; k < bond_fix->count(i) && !found[i]; k++)
      found[i] = own_bond(i, k) &&
          pressed[(size_t) width * bond_fix->partner_index(i, k)] > 0.0;
  std::vector<int> list;
  for (int i = 0; i < nlocal; i++)
    if (found[i]) list.push_back(i);
  return list;
}

/* ---------------------------------------------------------------------- */

bool PairTMSPH::own_bond(int i, int k) const
{
  return bond_fix->bond_state(i, k) == FixTMSPHBond::INTACT &&
      atom->type[bond_fix->partner_index(i, k)] == atom->type[i];
}

/* ----------------------------------------------------------------------
   of all fixes (collective)
   @return false without any on any processor
------------------------------------------------------------------------- */

static bool collect(Modify &modify, MPI_Comm world, std::vector<TMSPHPresses::Share> &shares)
{
  bool possible = false;
  for (const auto &fix : modify.get_fix_list())
    if (auto *one = dynamic_cast<TMSPHPresses *>(fix)) {
      one->add_shares(shares);
      possible = true;
    }
  if (!possible) return false;
  int mine = !shares.empty(), any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any;
}

/* ----------------------------------------------------------------------
   those of add_surface_stress(), once some surface is pressed; 0 without a fix that could
------------------------------------------------------------------------- */

int PairTMSPH::doubles_of_pressed() const
{
  for (Fix *fix : modify->get_fix_list())
    if (dynamic_cast<TMSPHPresses *>(fix)) return pressed_width() + ROUNDS * stress_size();
  return 0;
}

/* ----------------------------------------------------------------------
   of a stress row
------------------------------------------------------------------------- */

static double norm(const double *s, int size)
{
  const int dimension = size == 3 ? 2 : 3;
  double square = 0.0;
  for (int k = 0; k < size; k++) square += (k < dimension ? 1.0 : 2.0) * s[k] * s[k];
  return std::sqrt(square);
}

/* ----------------------------------------------------------------------
   Forces on the outermost particles are spread with the kernel, which keeps the sum of their stress
   over volumes. All who get some, or have a partner who has, report
     S_i + p_i sum_j V_j W_ij (S_j - S_i), round after round.
   Pairs of contact are over the horizon as they are: with the smaller of p_i and p_j for p_i, so
   that particles which nothing presses, as those at the tip of a crack whose faces touch, keep
   their own.
------------------------------------------------------------------------- */

void PairTMSPH::add_surface_stress()
{
  std::vector<TMSPHPresses::Share> shares;
  if (!collect(*modify, world, shares)) return;
  const int size = stress_size(), width = pressed_width();
  pressed.assign((size_t) width * (atom->nlocal + atom->nghost), 0.0);
  const auto row = [&](int i) { return pressed.data() + (size_t) width * i; };
  const auto stress_of = [&](int i) { return stress.data() + (size_t) size * i; };
  const auto bearable = [&](int i) { return stress_of(i)[0] < UNBEARABLE; };
  std::vector<Near> near;
  const auto add_near = [&](int i) {    // itself first, then by ascending ids
    const auto mass = [this, i](int j) {
      return bond_fix->kernel_mass(i, j, horizon(atom->type[i], atom->type[i])) /
          bond_fix->body_thickness();
    };
    near.push_back({i, mass(i)});
    for (int k = 0; k < bond_fix->count(i); k++)
      if (own_bond(i, k)) {
        const int j = bond_fix->partner_index(i, k);
        near.push_back({j, mass(j)});
      }
  };

  std::vector<int> sharing, touching;
  for (const auto &share : shares) {
    const int i = share.i;
    const double flat[3] = {share.stress[0], share.stress[1], share.stress[3]};
    const double *s = size == 3 ? flat : share.stress;
    const double surface = norm(s, size), bonded = norm(stress_of(i), size);
    if (surface == 0.0) continue;
    double &pressed_by = row(i)[share.outermost ? BY_SURFACE : BY_CONTACT];
    if (pressed_by == 0.0) (share.outermost ? sharing : touching).push_back(i);
    pressed_by = std::max(pressed_by, std::min(1.0, surface / (PRESSED * (surface + bonded))));
    double sum = 1.0;
    if (share.outermost) {
      near.clear();
      add_near(i);
      sum = std::accumulate(near.begin(), near.end(), 0.0,
                            [](double all, const Near &n) { return all + n.mass; });
    }
    for (int k = 0; k < size; k++)
      (share.outermost ? row(i)[SPREAD + k] : stress_of(i)[k]) += s[k] / sum;
  }
  send(PRESSES);

  near.clear();
  std::vector<Pressed> members;
  std::vector<double> spread;
  std::vector<int> list = find_pressed(sharing);
  list.insert(list.end(), touching.begin(), touching.end());
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  for (const int i : list) {
    const int first = near.size();
    add_near(i);
    double most = 0.0, sum[6] = {};
    for (size_t n = first; n < near.size(); n++) {
      const double *his = row(near[n].j);
      most = std::max(most, his[BY_SURFACE]);
      for (int k = 0; k < size; k++) sum[k] += near[n].mass * his[SPREAD + k];
    }
    members.push_back({i, first, (int) near.size(), most});
    spread.insert(spread.end(), sum, sum + size);
  }
  const auto add = [&](const std::vector<double> &change) {
    for (size_t m = 0; m < members.size(); m++)
      for (int k = 0; k < size; k++) stress_of(members[m].i)[k] += change[m * size + k];
  };
  add(spread);

  for (int round = 0; round < ROUNDS; round++) {
    send(STRESS);
    std::vector<double> change(members.size() * size, 0.0);
    for (size_t m = 0; m < members.size(); m++) {
      const double *mine = stress_of(members[m].i);
      const double touched = round < CONTACT_ROUNDS ? row(members[m].i)[BY_CONTACT] : 0.0;
      if (!bearable(members[m].i)) continue;
      for (int n = members[m].first; n < members[m].last; n++) {
        const int j = near[n].j;
        const double average = std::max(members[m].part, std::min(touched, row(j)[BY_CONTACT]));
        if (average == 0.0 || !bearable(j)) continue;
        const double *his = stress_of(j), part = average * near[n].mass;
        for (int k = 0; k < size; k++) change[m * size + k] += part * (his[k] - mine[k]);
      }
    }
    add(change);
  }
}
