/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Rows of doubles of particles, and how columns of them go from owners to their
   ghosts for a fix or a pair style. LAMMPS asks that one to pack and unpack; it
   hands both on:

     int FixTMSPHX::pack_forward_comm(int n, int *list, double *buf, int, int *)
     {
       return ghosts.pack(n, list, buf);
     }
     void FixTMSPHX::unpack_forward_comm(int n, int first, double *buf)
     {
       ghosts.unpack(n, first, buf);
     }
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_GHOST_ROWS_H
#define LMP_TMSPH_GHOST_ROWS_H

#include "atom.h"
#include "comm.h"
#include "pointers.h"

#include <algorithm>
#include <vector>

namespace LAMMPS_NS {

/** width doubles of each local particle, and behind them of each ghost. */
class TMSPHGhostRows {
 public:
  explicit TMSPHGhostRows(int width = 1) : width(width) {}
  int columns() const { return width; }
  /// rows of another width, which hold nothing yet
  void set_columns(int count)
  {
    width = count;
    numbers.clear();
  }
  /// keeps the first rows, fills up with zeros
  void resize(int rows) { numbers.resize((size_t) rows * width); }
  void fill(int rows, double value) { numbers.assign((size_t) rows * width, value); }
  int rows() const { return numbers.size() / width; }
  double *operator[](int i) { return numbers.data() + (size_t) width * i; }
  const double *operator[](int i) const { return numbers.data() + (size_t) width * i; }
  double bytes() const { return numbers.capacity() * sizeof(double); }

 private:
  int width;
  std::vector<double> numbers;
};

/** Sends for one fix or pair style, whose comm_forward must be the most columns at once from its
    init on: LAMMPS makes its buffers that large. */
class TMSPHGhostSender : protected Pointers {
 public:
  TMSPHGhostSender(class LAMMPS *lmp, class Fix *owner) : Pointers(lmp), fix(owner) {}
  TMSPHGhostSender(class LAMMPS *lmp, class Pair *owner) : Pointers(lmp), pair(owner) {}

  /// columns first to first+count of all rows; ghosts must have rows (collective, as all of these)
  void send(TMSPHGhostRows &rows, int first, int count)
  {
    send(rows[0] + first, rows.columns(), count);
  }
  /// all columns, after making rows for the ghosts
  void complete(TMSPHGhostRows &rows)
  {
    rows.resize(atom->nlocal + atom->nghost);
    send(rows, 0, rows.columns());
  }
  /// one number of each particle
  void complete(std::vector<double> &values)
  {
    values.resize(atom->nlocal + atom->nghost);
    send(values.data(), 1, 1);
  }
  /** @param numbers the first that is sent of the first particle
      @param stride  from there to that of the next particle
      @param count   how many side by side are sent of each */
  void send(double *numbers, int stride, int count)
  {
    sent = numbers;
    sent_stride = stride;
    sent_count = count;
    if (fix)
      comm->forward_comm(fix, count);
    else
      comm->forward_comm(pair, count);
  }

  int pack(int n, const int *list, double *buf) const
  {
    if (sent_stride == 1)    // temperatures, in each stage of a heat step
      for (int k = 0; k < n; k++) buf[k] = sent[list[k]];
    else
      for (int k = 0; k < n; k++, buf += sent_count)
        std::copy_n(sent + (size_t) sent_stride * list[k], sent_count, buf);
    return n * sent_count;
  }
  void unpack(int n, int first, const double *buf)
  {
    double *to = sent + (size_t) sent_stride * first;
    if (sent_count == sent_stride)
      std::copy_n(buf, (size_t) sent_count * n, to);
    else
      for (int k = 0; k < n; k++, buf += sent_count, to += sent_stride)
        std::copy_n(buf, sent_count, to);
  }
  /// columns under way, which are the distance of rows in the buffer
  int count() const { return sent_count; }

 private:
  class Fix *const fix = nullptr;
  class Pair *const pair = nullptr;
  double *sent = nullptr;
  int sent_stride = 0, sent_count = 0;
};

}    // namespace LAMMPS_NS

#endif
