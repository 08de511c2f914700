/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a fix remembers of some particles, by their ids, and how it goes with
   them into exchanges and restarts.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_MEMORIES_H
#define LMP_TMSPH_MEMORIES_H

#include "lmptype.h"

#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

/// the present id of the particle with a former one, 0 if it is gone
using TMSPHPresentIds = std::function<tagint(tagint)>;

/** A fix that knows particles by their ids. */
struct TMSPHStoresIds {
  /** reset_atoms id or delete_atoms gave new ones. Until this is called, in a setup after particles
      have changed places, the fix goes by the former ids, those of TMSPHFamilies::owner_tag(). */
  virtual void follow_ids(const TMSPHPresentIds &) = 0;

 protected:
  ~TMSPHStoresIds() = default;    // owned as a fix, never through this interface
};

/** Memory: a struct with int pack(double *) const, int unpack(const double *) and
    int size() const, all in doubles. What travels has the id of its particle first. */
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
    return 1 + (memory ? memory->size() : 0);
  }
  int pack(tagint id, double *buf) const
  {
    const Memory *memory = find(id);
    buf[0] = ubuf(memory ? id : 0).d;
    return 1 + (memory ? memory->pack(buf + 1) : 0);
  }
  int unpack(const double *buf)
  {
    const tagint id = (tagint) ubuf(buf[0]).i;
    return 1 + (id ? of(id).unpack(buf + 1) : 0);
  }

  /// changed(memory, former id, present id) is called for each that is kept
  template <class Changed> void follow_ids(const TMSPHPresentIds &present, Changed changed)
  {
    TMSPHMemories kept;
    for (int n = 0; n < count(); n++) {
      const tagint id = present(ids[n]);
      if (id == 0) continue;
      Memory &memory = kept.of(id);
      memory = std::move(memories[n]);
      changed(memory, ids[n], id);
    }
    std::swap(*this, kept);
  }

 private:
  std::vector<Memory> memories;
  std::vector<tagint> ids;
  std::unordered_map<tagint, int> numbers;    // by id
};

}    // namespace LAMMPS_NS
#endif
