// Tested by tests/unit/cdt/region_cdt_test.cpp.
#include "region/triangulation_of.hpp"

#include "cdt/region_cdt.hpp"

namespace cover {

Triangulation triangulation_of(const RegionBoundary& boundary, const Team& team) {
  return triangulate_region(boundary.points, boundary.sides, boundary.known_triangles(), team);
}

}  // namespace cover
