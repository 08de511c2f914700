/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Laws that a word of the input chooses: structs with a NAME in a std::variant.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_ALTERNATIVES_H
#define LMP_TMSPH_ALTERNATIVES_H

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace TMSPH {

template <class Variant, std::size_t... N>
inline std::vector<std::pair<std::string, Variant>> alternatives(std::index_sequence<N...>)
{
  return {{std::variant_alternative_t<N, Variant>::NAME, Variant(std::in_place_index<N>)}...};
}

/// All structs of a variant by their names, in its order.
template <class Variant> inline std::vector<std::pair<std::string, Variant>> alternatives()
{
  return alternatives<Variant>(std::make_index_sequence<std::variant_size_v<Variant>>());
}

}    // namespace TMSPH
#endif
