// What of a mesh is left out where it is read as geometry, in the same words for every format.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "io/text/array_names.hpp"
#include "io/text/text.hpp"

namespace cover {

/// Says that curved elements are taken for straight ones.
inline std::string corners_taken(std::size_t elements) {
  return fmt::format(
      "{} elements of higher order: their corners are taken, their other nodes left "
      "out",
      elements);
}

/// Says that periodic sides are not known; `where` is what holds them in the file.
inline std::string pairs_left_out(std::string_view where) {
  return fmt::format(
      "which lines are images of each other ({}) is not taken over: --periodic A=B says it, with "
      "names of lines",
      where);
}

/// Says that a mesh of ours comes without the names that stand beside it.
inline std::string names_left_out() {
  return "regions are called by numbers, and contacts are missing: the file has no names; a .msh "
         "of the same mesh has both, as 'cover convert FILE.vtm -o FILE.msh' makes it";
}

/// Says which values at points are not taken over; nothing if all of `arrays` are our own.
template <class Arrays>
std::vector<std::string> values_left_out(const Arrays& arrays) {
  std::vector<std::string> names;
  for (const auto& array : arrays)
    if (!is_own_array(array.name)) names.push_back(fmt::format("'{}'", legible(array.name)));
  if (names.empty()) return {};
  return {fmt::format("values at points are not taken over: {}", listed(names))};
}

}  // namespace cover
