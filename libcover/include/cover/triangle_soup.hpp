// A mesh as plain arrays, of which nothing is promised.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/mesh_class.hpp>
#include <cover/point.hpp>

namespace cover {

/// A triangle mesh as a file gives it.
struct TriangleSoup {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int64_t> region;    ///< per triangle; empty: the file has none
  std::vector<std::int64_t> material;  ///< per triangle; empty: the file has none
};

/// The mesh of a run as plain arrays.
TriangleSoup triangle_soup(const Mesh& mesh);

}  // namespace cover
