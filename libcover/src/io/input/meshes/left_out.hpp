// What of a mesh is left out where it is read as geometry, in the same words for every format.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/core.h>

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

}  // namespace cover
