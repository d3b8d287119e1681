// Points of the input that a mesh has with fewer digits, as its format rounds them.
#pragma once

#include <cstddef>
#include <string>

#include <cover/point.hpp>
#include <cover/pslg.hpp>
#include <cover/verify.hpp>

namespace cover::app {

/// How many points of the input lack digits, and the first of them.
struct RoundedPoints {
  std::size_t count = 0;
  Point first;     ///< in the input
  Point as_there;  ///< in the mesh
};

/// Gives vertices of an .inp the digits of the points of the input that they are rounded from, so
/// that all else can be judged. Those that two points are rounded to stay, and meshes in all other
/// formats.
RoundedPoints restore_digits(const std::string& path, const Pslg& pslg, TriangleSoup& mesh);

}  // namespace cover::app
