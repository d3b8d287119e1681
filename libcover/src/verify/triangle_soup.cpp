// The way from our own mesh to arrays that verify_cover() trusts with nothing.
// Tested by tests/unit/verify/verify_test.cpp.
#include <cover/mesh.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

TriangleSoup triangle_soup(const Mesh& mesh) {
  const TriMesh& tri = mesh.tri();
  TriangleSoup soup;
  soup.points.reserve(tri.n_vertices());
  for (const auto v : tri.vertices()) soup.points.push_back({tri.point(v)[0], tri.point(v)[1]});
  soup.triangles.reserve(tri.n_faces());
  for (const auto f : tri.faces()) {
    const auto h = tri.halfedge_handle(f);
    soup.triangles.push_back(
        {static_cast<std::uint32_t>(tri.from_vertex_handle(h).idx()),
         static_cast<std::uint32_t>(tri.to_vertex_handle(h).idx()),
         static_cast<std::uint32_t>(tri.to_vertex_handle(tri.next_halfedge_handle(h)).idx())});
    soup.region.push_back(mesh.region(f).value());
    soup.material.push_back(mesh.material(f));
  }
  return soup;
}

}  // namespace cover
