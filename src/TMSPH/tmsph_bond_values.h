/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Numbers that particles or single bonds carry for whoever asked the owner of
   the bonds for them, see TMSPHFamilies: they stay with their particles and
   partners in sorting, exchanges and restarts, when ids change and when
   partners are deleted. What nobody has begun to carry costs nothing.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BOND_VALUES_H
#define LMP_TMSPH_BOND_VALUES_H

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

/** width numbers of each local particle; NaN until somebody sets them. */
class TMSPHParticleValues {
 public:
  TMSPHParticleValues(std::string name, int width) : name(std::move(name)), width(width) {}
  const std::string name;
  const int width;

  bool carried() const { return on; }
  /// from here on; to be called on all processors
  void start(int nmax)
  {
    on = true;
    grow(nmax);
  }
  /// forgets all and gives the memory back; to be called on all processors
  void stop()
  {
    on = false;
    std::vector<double>().swap(numbers);
  }
  double *operator[](int i) { return numbers.data() + (size_t) width * i; }
  const double *operator[](int i) const { return numbers.data() + (size_t) width * i; }

  // for the owner

  void grow(int nmax)
  {
    if (on) numbers.resize((size_t) width * nmax, NAN);
  }
  void copy(int i, int j)
  {
    if (on) std::copy_n((*this)[i], width, (*this)[j]);
  }
  void clear(int i)
  {
    if (on) std::fill_n((*this)[i], width, NAN);
  }
  int size() const { return on ? width : 0; }    ///< doubles that pack() writes
  int pack(int i, double *buf) const
  {
    if (on) std::copy_n((*this)[i], width, buf);
    return size();
  }
  int unpack(int i, const double *buf)
  {
    if (on) std::copy_n(buf, width, (*this)[i]);
    return size();
  }
  double bytes() const { return numbers.capacity() * sizeof(double); }

 private:
  bool on = false;
  std::vector<double> numbers;    // [nmax][width]
};

/** width numbers of some of the bonds of each local particle. Each end of a bond has its own. */
class TMSPHBondValues {
 public:
  TMSPHBondValues(std::string name, int width) : name(std::move(name)), width(width) {}
  const std::string name;
  const int width;

  /// of how many bonds local particle i carries some
  int count(int i) const { return rows.empty() ? 0 : rows[i].size() / (width + 1); }
  /// place in the family of number n of these, ascending
  int place(int i, int n) const { return (int) rows[i][(size_t) n * (width + 1)]; }
  double *values(int i, int n) { return rows[i].data() + (size_t) n * (width + 1) + 1; }
  const double *values(int i, int n) const
  {
    return const_cast<TMSPHBondValues *>(this)->values(i, n);
  }
  /// number of the bond at place k in the family of i; -1 if it carries none
  int number(int i, int k) const
  {
    const int n = at(i, k);
    return n < count(i) && place(i, n) == k ? n : -1;
  }
  double *find(int i, int k)
  {
    const int n = number(i, k);
    return n < 0 ? nullptr : values(i, n);
  }
  /// begins to carry numbers for the bond at place k in the family of i, zeros first
  double *insert(int i, int k, int nmax)
  {
    if (rows.empty()) rows.resize(nmax);
    const int n = at(i, k);
    std::vector<double> fresh(width + 1, 0.0);
    fresh[0] = k;
    rows[i].insert(rows[i].begin() + (size_t) n * (width + 1), fresh.begin(), fresh.end());
    return values(i, n);
  }
  void erase(int i, int k)
  {
    if (!find(i, k)) return;
    const auto first = rows[i].begin() + (size_t) at(i, k) * (width + 1);
    rows[i].erase(first, first + width + 1);
  }

  // for the owner

  void grow(int nmax)
  {
    if (!rows.empty()) rows.resize(nmax);
  }
  void copy(int i, int j)
  {
    if (!rows.empty()) rows[j] = rows[i];
  }
  void clear(int i)
  {
    if (!rows.empty()) rows[i].clear();
  }
  /// the family of i has changed: what stood at place k stands at places[k] now, or nowhere: -1
  void move(int i, const std::vector<int> &places)
  {
    const int n = count(i);
    std::vector<std::pair<int, int>> order;
    for (int m = 0; m < n; m++)
      if (places[place(i, m)] >= 0) order.emplace_back(places[place(i, m)], m);
    std::sort(order.begin(), order.end());
    std::vector<double> moved;
    for (const auto &[k, m] : order) {
      moved.push_back(k);
      moved.insert(moved.end(), values(i, m), values(i, m) + width);
    }
    if (n) rows[i].swap(moved);
  }
  /// doubles that pack() writes, of local particle i and at most if all of its bonds carry some
  int size(int i) const { return 1 + count(i) * (width + 1); }
  int most(int bonds) const { return 1 + bonds * (width + 1); }
  int pack(int i, double *buf) const
  {
    buf[0] = count(i);
    if (!rows.empty()) std::copy(rows[i].begin(), rows[i].end(), buf + 1);
    return size(i);
  }
  int unpack(int i, const double *buf, int nmax)
  {
    const int n = (int) buf[0] * (width + 1);
    if (n && rows.empty()) rows.resize(nmax);
    if (!rows.empty()) rows[i].assign(buf + 1, buf + 1 + n);
    return 1 + n;
  }
  double bytes() const
  {
    double sum = rows.capacity() * sizeof(std::vector<double>);
    for (const auto &row : rows) sum += row.capacity() * sizeof(double);
    return sum;
  }

 private:
  // [nmax] place and numbers of each; empty: nobody has any
  std::vector<std::vector<double>> rows;

  int at(int i, int k) const    // the first that does not stand before place k
  {
    int low = 0, high = count(i);
    while (low < high) {
      const int middle = (low + high) / 2;
      if (place(i, middle) < k)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }
};

}    // namespace LAMMPS_NS
#endif
