/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a fix remembers of some particles, by their ids, and how it goes with
   them into exchanges and restarts.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_MEMORIES_H
#define LMP_TMSPH_MEMORIES_H

#include "lmptype.h"

#include <unordered_map>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

/** Memory: a struct with int pack(double *) const, which writes a number of 0 or more first,
    int unpack(const double *) and int size() const, all in doubles. */
template <class Memory> class TMSPHMemories {
 public:
  int count() const { return memories.size(); }
  bool empty() const { return memories.empty(); }
  /// one after the other; the last takes the place of one that is erased
  Memory &operator[](int n) { return memories[n]; }
  const Memory &operator[](int n) const { return memories[n]; }
  tagint id(int n) const { return ids[n]; }

  /// nullptr if there is none
  Memory *find(tagint id)
  {
    const auto found = numbers.find(id);
    return found == numbers.end() ? nullptr : &memories[found->second];
  }
  const Memory *find(tagint id) const { return const_cast<TMSPHMemories *>(this)->find(id); }
  /// a new one if there is none
  Memory &of(tagint id)
  {
    const auto [found, fresh] = numbers.emplace(id, count());
    if (fresh) {
      memories.emplace_back();
      ids.push_back(id);
    }
    return memories[found->second];
  }
  void erase(tagint id)
  {
    const auto found = numbers.find(id);
    if (found == numbers.end()) return;
    const int n = found->second;
    numbers.erase(found);
    if (n < count() - 1) {
      memories[n] = std::move(memories.back());
      ids[n] = ids.back();
      numbers[ids[n]] = n;
    }
    memories.pop_back();
    ids.pop_back();
  }

  // of a particle that may have none

  int size(tagint id) const
  {
    const Memory *memory = find(id);
    return memory ? memory->size() : 1;
  }
  int pack(tagint id, double *buf) const
  {
    const Memory *memory = find(id);
    if (memory) return memory->pack(buf);
    buf[0] = ubuf(-1).d;
    return 1;
  }
  int unpack(tagint id, const double *buf) { return ubuf(buf[0]).i < 0 ? 1 : of(id).unpack(buf); }

 private:
  std::vector<Memory> memories;
  std::vector<tagint> ids;
  std::unordered_map<tagint, int> numbers;    // by id
};

}    // namespace LAMMPS_NS
#endif
