// Background sizes given at points: an edge length for every place.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/options.hpp>
#include <cover/point.hpp>
#include <cover/result.hpp>

namespace cover {

/// Edge lengths at the corners of triangles, which may leave out parts of the plane.
struct SizeSamples {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into `points`, either way round
  std::vector<double> sizes;                            ///< by point, > 0
};

/// The sizes as a function for Options::size_field: linear in each triangle; outside of all, what
/// holds at the nearest place on their border (of the points, where there are no triangles).
/// Before, sizes are lowered where neighbours would differ by more than `growth` allows, as those
/// of the mesher are: else a fine spot could hide between two of its vertices.
///
/// Units:   as the mesh.
/// Errors:  bad_option unless growth > 1; non_finite_coordinate; id_out_of_range; syntax for a size
///          that is not above zero, and for no points
/// Threads: the function may be called from several at a time.
/// Cost:    O(n log n), and O(log n) for a call, unless triangles overlap much
Result<SizeFunction> size_function(const SizeSamples& samples, double growth);

}  // namespace cover
