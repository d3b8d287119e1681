// The border of a mesh cuts the plane into faces, each of them wholly filled or wholly empty.
// Tested by tests/unit/mesh/rebuild_test.cpp.
#include "mesh/voids.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "base/numbers.hpp"
#include "cdt/cdt.hpp"
#include "faces/face_measures.hpp"
#include "faces/faces.hpp"
#include "geom/predicates.hpp"

namespace cover {
namespace {

Point place_of_vertex(const TriMesh& tri, TriMesh::VertexHandle v) {
  const TriMesh::Point& p = tri.point(v);
  return {p[0], p[1]};
}

/// Edges with one triangle, each with the triangle on its left, over points that are all different.
struct Border {
  std::vector<Point> points;
  std::vector<IndexPair> edges;
};

Border border_of(const TriMesh& tri) {
  std::vector<std::array<Point, 2>> sides;
  for (const auto edge : tri.edges()) {
    if (!tri.is_boundary(edge)) continue;
    auto h = tri.halfedge_handle(edge, 0);
    if (tri.is_boundary(h)) h = tri.opposite_halfedge_handle(h);
    const Point a = place_of_vertex(tri, tri.from_vertex_handle(h));
    const Point b = place_of_vertex(tri, tri.to_vertex_handle(h));
    const Point apex = place_of_vertex(tri, tri.to_vertex_handle(tri.next_halfedge_handle(h)));
    // Other tools write triangles of either turn.
    const bool turned = orientation(a, b, apex) == Sign::negative;
    sides.push_back(turned ? std::array{b, a} : std::array{a, b});
  }
  Border border;
  for (const auto& side : sides)
    border.points.insert(border.points.end(), side.begin(), side.end());
  sort_unique(border.points);
  const auto number = [&](Point p) {
    const auto found = std::lower_bound(border.points.begin(), border.points.end(), p);
    return static_cast<std::uint32_t>(found - border.points.begin());
  };
  std::vector<IndexPair> all;
  for (const auto& [a, b] : sides) all.push_back({number(a), number(b)});
  sort_unique(all);
  for (const IndexPair& edge : all) {
    if (!std::binary_search(all.begin(), all.end(), IndexPair{edge[1], edge[0]}))
      border.edges.push_back(edge);
  }
  return border;
}

}  // namespace

std::vector<Point> places_in_voids(const Mesh& mesh, std::vector<Note>& notes) {
  const Border border = border_of(mesh.tri());
  if (border.edges.empty()) return {};
  CdtResult cdt = triangulate_hull(border.points, border.edges);
  if (!cdt.conflicts.empty()) {
    // Of all conflicts `first` is a point, or a segment.
    const CdtConflict& conflict = cdt.conflicts.front();
    const bool cross = conflict.kind == CdtConflict::Kind::crossing;
    const Point at = border.points[cross ? border.edges[conflict.first][0] : conflict.first];
    notes.push_back(
        {Note::Kind::warning,
         kVoid,
         fmt::format("the border of the mesh meets itself at {}: what it encloses stays "
                     "unknown, and a .poly has no holes",
                     describe(at)),
         {at}});
    return {};
  }
  const Faces faces = faces_of(std::move(cdt.triangulation), border.edges, false);
  std::vector<bool> is_void(faces.count, true);
  is_void[kOutside] = false;
  for (const auto& [left, right] : faces.of_segment) is_void[left] = false;
  const std::vector<FaceMeasure> measures = measure_faces(faces);
  std::vector<Point> places;
  for (std::size_t f = 0; f < faces.count; ++f) {
    if (!is_void[f]) continue;
    if (measures[f].inside) {
      places.push_back(*measures[f].inside);
    } else {
      warn_of_sliver("a void", measures[f], notes);
    }
  }
  return places;
}

}  // namespace cover
