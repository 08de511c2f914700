/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_families.h"

#include "lammps.h"
#include "pointers.h"    // ubuf

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

int TMSPHFamilies::count_in(int i, unsigned states) const
{
  const unsigned char *const first = state.data() + at(i, 0);
  return std::count_if(first, first + npartner[i],
                       [states](unsigned char one) { return states >> one & 1u; });
}

/* ---------------------------------------------------------------------- */

int TMSPHFamilies::state_with(int i, tagint id) const
{
  const tagint *const first = partner.data() + at(i, 0), *const last = first + npartner[i];
  const tagint *const found = std::lower_bound(first, last, id);
  return found != last && *found == id ? state[at(i, found - first)] : -1;
}

/* ---------------------------------------------------------------------- */

namespace {
template <class Values>
Values &found_or_new(std::vector<std::unique_ptr<Values>> &all, const std::string &name, int width)
{
  for (const auto &one : all)
    if (one->name == name) return *one;
  all.push_back(std::make_unique<Values>(name, width));
  return *all.back();
}
}    // namespace

TMSPHParticleValues &TMSPHFamilies::particle_values(const std::string &name, int width)
{
  return found_or_new(of_particles, name, width);
}

TMSPHBondValues &TMSPHFamilies::bond_values(const std::string &name, int width)
{
  return found_or_new(of_bonds, name, width);
}

/* ---------------------------------------------------------------------- */

bool TMSPHFamilies::bonds_carry(const std::string &name, int n) const
{
  for (const auto &values : of_bonds)
    for (int i = 0; values->name == name && i < n; i++)
      if (values->count(i)) return true;
  return false;
}

/* ---------------------------------------------------------------------- */

void TMSPHFamilies::resize_rows(int length, int nmax)
{
  maxpartner = length;
  std::vector<tagint>().swap(partner);
  std::vector<unsigned char>().swap(state);
  grow_rows(nmax);
}

/* ---------------------------------------------------------------------- */

void TMSPHFamilies::set_family(int i, tagint id,
                               const std::vector<std::pair<tagint, State>> &members)
{
  npartner[i] = members.size();
  for (int k = 0; k < npartner[i]; k++) {
    partner[at(i, k)] = members[k].first;
    state[at(i, k)] = members[k].second;
  }
  own_tag[i] = first_tag[i] = id;
}

/* ----------------------------------------------------------------------
   no more memory than that: a vector that grows by itself takes twice as much
------------------------------------------------------------------------- */

void TMSPHFamilies::grow_rows(int nmax)
{
  const auto grow = [](auto &numbers, size_t size) {
    numbers.reserve(size);
    numbers.resize(size);
  };
  grow(npartner, nmax);
  grow(own_tag, nmax);
  grow(first_tag, nmax);
  grow(partner, (size_t) nmax * maxpartner);
  grow(state, (size_t) nmax * maxpartner);
  for (auto &values : of_particles) values->grow(nmax);
  for (auto &values : of_bonds) values->grow(nmax);
}

/* ---------------------------------------------------------------------- */

void TMSPHFamilies::copy_row(int i, int j)
{
  npartner[j] = npartner[i];
  own_tag[j] = own_tag[i];
  first_tag[j] = first_tag[i];
  std::copy_n(&partner[at(i, 0)], npartner[i], &partner[at(j, 0)]);
  std::copy_n(&state[at(i, 0)], npartner[i], &state[at(j, 0)]);
  for (auto &values : of_particles) values->copy(i, j);
  for (auto &values : of_bonds) values->copy(i, j);
}

/* ---------------------------------------------------------------------- */

void TMSPHFamilies::clear_row(int i)
{
  npartner[i] = 0;
  own_tag[i] = first_tag[i] = NOBODY;
  for (auto &values : of_particles) values->clear(i);
  for (auto &values : of_bonds) values->clear(i);
}

/* ----------------------------------------------------------------------
   own ids, number of bonds, then id and state of each, then what is carried
------------------------------------------------------------------------- */

int TMSPHFamilies::pack_row(int i, double *buf) const
{
  int m = 0;
  buf[m++] = ubuf(own_tag[i]).d;
  buf[m++] = ubuf(first_tag[i]).d;
  buf[m++] = ubuf(npartner[i]).d;
  for (int k = 0; k < npartner[i]; k++) {
    buf[m++] = ubuf(partner[at(i, k)]).d;
    buf[m++] = ubuf((int) state[at(i, k)]).d;
  }
  for (const auto &values : of_particles) m += values->pack(i, buf + m);
  for (const auto &values : of_bonds) m += values->pack(i, buf + m);
  return m;
}

/* ---------------------------------------------------------------------- */

int TMSPHFamilies::unpack_row(int i, const double *buf, int nmax)
{
  int m = 0;
  own_tag[i] = (tagint) ubuf(buf[m++]).i;
  first_tag[i] = (tagint) ubuf(buf[m++]).i;
  npartner[i] = (int) ubuf(buf[m++]).i;
  for (int k = 0; k < npartner[i]; k++) {
    partner[at(i, k)] = (tagint) ubuf(buf[m++]).i;
    state[at(i, k)] = (unsigned char) ubuf(buf[m++]).i;
  }
  for (auto &values : of_particles) m += values->unpack(i, buf + m);
  for (auto &values : of_bonds) m += values->unpack(i, buf + m, nmax);
  return m;
}

/* ---------------------------------------------------------------------- */

int TMSPHFamilies::row_size(int i) const
{
  int size = 3 + 2 * npartner[i];
  for (const auto &values : of_particles) size += values->size();
  for (const auto &values : of_bonds) size += values->size(i);
  return size;
}

int TMSPHFamilies::most_of_row() const
{
  int size = 3 + 2 * maxpartner;
  for (const auto &values : of_particles) size += values->width;
  for (const auto &values : of_bonds) size += values->most(maxpartner);
  return size;
}

/* ---------------------------------------------------------------------- */

double TMSPHFamilies::bytes_of_rows() const
{
  double sum = npartner.capacity() * sizeof(int) + state.capacity() +
      (own_tag.capacity() + first_tag.capacity() + partner.capacity()) * sizeof(tagint);
  for (const auto &values : of_particles) sum += values->bytes();
  for (const auto &values : of_bonds) sum += values->bytes();
  return sum;
}

/* ----------------------------------------------------------------------
   In doubles: how many are of particles, how many of bonds, then of each the width, whether it is
   carried (of bonds: always) and the name.
------------------------------------------------------------------------- */

static constexpr int NAME_LENGTH = 32;    // bytes
static constexpr int ENTRY = 2 + NAME_LENGTH / sizeof(double);

std::vector<double> TMSPHFamilies::list_carried() const
{
  std::vector<double> list = {(double) of_particles.size(), (double) of_bonds.size()};
  const auto add = [&list](const std::string &name, int width, bool carried) {
    char text[NAME_LENGTH] = {};
    name.copy(text, NAME_LENGTH - 1);
    list.push_back(width);
    list.push_back(carried);
    const size_t first = list.size();
    list.resize(first + NAME_LENGTH / sizeof(double));
    memcpy(&list[first], text, NAME_LENGTH);
  };
  for (const auto &values : of_particles) add(values->name, values->width, values->carried());
  for (const auto &values : of_bonds) add(values->name, values->width, true);
  return list;
}

void TMSPHFamilies::take_carried(const char *buf, int nmax)
{
  double counts[2], entry[ENTRY];
  memcpy(counts, buf, sizeof(counts));    // buf may stand anywhere
  buf += sizeof(counts);
  const int particles = (int) counts[0], bonds = (int) counts[1];
  for (int n = 0; n < particles + bonds; n++, buf += sizeof(entry)) {
    memcpy(entry, buf, sizeof(entry));
    const int width = (int) entry[0];
    const std::string name(reinterpret_cast<const char *>(entry + 2));
    if (n >= particles)
      bond_values(name, width);
    else if (auto &values = particle_values(name, width); entry[1] != 0.0)
      values.start(nmax);
  }
}
