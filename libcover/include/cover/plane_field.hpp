// Values at the corners of triangles: what simulators store beside a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// Named numbers at points, linear in the triangles between them. The same place may be several
/// points: a value may jump there.
struct PlaneField {
  struct Array {
    std::string name;
    std::vector<double> values;  ///< by point; NaN: none there
  };
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into `points`, either way round
  std::vector<std::string> material;                    ///< by triangle; empty: unknown
  std::vector<Array> arrays;
};

}  // namespace cover
