// Tested by tests/unit/cuts/after_meshing/join_regions_test.cpp.
#include "cuts/after_meshing/join_regions.hpp"

#include <algorithm>
#include <utility>

#include "base/containers/order.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/hand_out_triangles.hpp"
#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

bool touches_a_region(const SegmentSides& sides) {
  return sides.left != kVoid || sides.right != kVoid;
}

/// By vertex: its point once `first` points are followed by the cuts; kNone inside a region.
std::vector<std::uint32_t> points_of(const JoinedMesh& mesh, const std::vector<std::uint32_t>& old,
                                     const std::vector<std::uint32_t>& cuts, std::size_t first) {
  std::vector<std::uint32_t> id(mesh.points.size(), kNone);
  std::size_t fixed = 0;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.line[v] == JoinedMesh::kFixed) id[v] = old[fixed++];
  }
  for (std::size_t k = 0; k < cuts.size(); ++k) id[cuts[k]] = static_cast<std::uint32_t>(first + k);
  return id;
}

}  // namespace

void renumber(const std::vector<std::uint32_t>& number, JoinedMesh& mesh) {
  const std::vector<std::uint32_t> order = places_in(number);
  mesh.points = in_order(mesh.points, order);
  mesh.line = in_order(mesh.line, order);
  for (JoinedMesh::Piece& piece : mesh.pieces)
    piece = {number[piece.a], number[piece.b], piece.line};
  for (IndexTriple& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = number[v];
  }
}

std::vector<std::uint32_t> sort_by_place(JoinedMesh& mesh) {
  std::vector<std::uint32_t> order = sorted_numbers(
      mesh.points.size(),
      [&](std::uint32_t a, std::uint32_t b) { return mesh.points[a] < mesh.points[b]; });
  renumber(places_in(order), mesh);
  for (StraightLine& line : mesh.lines) {
    if (line.b < line.a) std::swap(line.a, line.b);
  }
  for (IndexTriple& t : mesh.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  const std::vector<std::uint32_t> by_corners = sorted_numbers(
      mesh.triangles.size(),
      [&](std::uint32_t a, std::uint32_t b) { return mesh.triangles[a] < mesh.triangles[b]; });
  mesh.triangles = in_order(mesh.triangles, by_corners);
  mesh.region = in_order(mesh.region, by_corners);
  return order;
}

JoinedMesh join_regions(const Work& work, const Pslg& uncut, const United& united) {
  JoinedMesh mesh;
  mesh.points = work.pslg.points;
  mesh.line.assign(mesh.points.size(), JoinedMesh::kFixed);
  for (const Segment& s : uncut.segments)
    mesh.lines.push_back({uncut.points[s.a.index()], uncut.points[s.b.index()]});
  const auto lines = static_cast<std::uint32_t>(mesh.lines.size());
  for (std::size_t s = 0; s < united.whole.size(); ++s) {
    if (!touches_a_region(work.table.sides[s])) continue;
    const Segment& piece = work.pslg.segments[s];
    const bool is_chord = piece.circle != 0;
    for (const VertexId v : {piece.a, piece.b}) {
      if (united.number[v.index()] == kNone) mesh.line[v.index()] = united.whole[s];
    }
    mesh.pieces.push_back({static_cast<std::uint32_t>(piece.a.index()),
                           static_cast<std::uint32_t>(piece.b.index()),
                           united.whole[s] + (is_chord ? lines : 0)});
  }
  for (std::size_t r = 0; r < work.meshes.size(); ++r) {
    const RegionBoundary& boundary = work.boundaries[r];
    const std::size_t first = mesh.points.size();
    const auto global = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(v < boundary.points.size()
                                            ? boundary.vertices[v].index()
                                            : first + v - boundary.points.size());
    };
    for (const Point& p : work.meshes[r].steiner) mesh.points.push_back(p);
    mesh.line.resize(mesh.points.size(), JoinedMesh::kInside);
    for (const auto& [a, b, c] : work.meshes[r].triangles) {
      mesh.triangles.push_back({global(a), global(b), global(c)});
      mesh.region.push_back(static_cast<std::uint32_t>(r));
    }
  }
  return mesh;
}

void separate(const JoinedMesh& mesh, const std::vector<std::uint32_t>& old, Work& work) {
  std::vector<std::uint32_t> vertices;  // that cut a segment
  std::vector<PointOnSegment> points;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.line[v] >= mesh.lines.size()) continue;
    vertices.push_back(v);
    points.push_back({SegmentId{mesh.line[v]}, mesh.points[v]});
  }
  const PointsAlong along = along_segments(work.pslg, points);
  const std::vector<std::uint32_t> cuts = in_order(vertices, along.order);
  const std::vector<std::uint32_t> id = points_of(mesh, old, cuts, work.pslg.points.size());
  cut_segments(work.pslg, work.table, along.cuts);
  work.boundaries = split_regions(work.pslg, work.table);
  hand_out_triangles(mesh, id, work.boundaries, work.pslg.points.size(), work.meshes);
}

}  // namespace cover
