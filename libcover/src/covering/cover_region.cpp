// The stages of one region, in order. So far: the constrained Delaunay triangulation alone.
#include "covering/cover_region.hpp"

#include "cdt/cdt.hpp"

namespace cover {

RegionMesh cover_region(const RegionBoundary& boundary, const Options& /*options*/,
                        std::stop_token /*stop*/) {
  RegionMesh mesh;
  mesh.report.id = boundary.id;
  mesh.report.method = "cdt";
  for (const Triangle& t : triangulate_domain(boundary.points, boundary.sides).triangulation.triangles) {
    mesh.triangles.push_back(t.v);
  }
  return mesh;
}

}  // namespace cover
