// Tested by tests/unit/cuts/after_meshing/one_mesh_test.cpp.
#include "cuts/after_meshing/one_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cuts/cut_segments.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

bool touches_a_region(const SegmentSides& sides) {
  return sides.left != kVoid || sides.right != kVoid;
}

/// `list` in the order that `order` tells.
template <class T>
std::vector<T> in_order(const std::vector<T>& list, const std::vector<std::uint32_t>& order) {
  std::vector<T> out;
  out.reserve(list.size());
  for (const std::uint32_t k : order) out.push_back(list[k]);
  return out;
}

template <class Less>
std::vector<std::uint32_t> sorted_order(std::size_t n, Less less) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), less);
  return order;
}

}  // namespace

void renumber(const std::vector<std::uint32_t>& number, ConformingMesh& mesh) {
  std::vector<std::uint32_t> order(number.size());
  for (std::uint32_t v = 0; v < number.size(); ++v) order[number[v]] = v;
  mesh.points = in_order(mesh.points, order);
  mesh.line = in_order(mesh.line, order);
  for (ConformingMesh::Piece& piece : mesh.pieces)
    piece = {number[piece.a], number[piece.b], piece.line};
  for (IndexTriple& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = number[v];
  }
}

std::vector<std::uint32_t> sort_by_place(ConformingMesh& mesh) {
  std::vector<std::uint32_t> order = sorted_order(
      mesh.points.size(),
      [&](std::uint32_t a, std::uint32_t b) { return mesh.points[a] < mesh.points[b]; });
  std::vector<std::uint32_t> number(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) number[order[k]] = k;
  renumber(number, mesh);
  for (StraightLine& line : mesh.lines) {
    if (line.b < line.a) std::swap(line.a, line.b);
  }
  for (IndexTriple& t : mesh.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  const std::vector<std::uint32_t> by_corners = sorted_order(
      mesh.triangles.size(),
      [&](std::uint32_t a, std::uint32_t b) { return mesh.triangles[a] < mesh.triangles[b]; });
  mesh.triangles = in_order(mesh.triangles, by_corners);
  mesh.region = in_order(mesh.region, by_corners);
  return order;
}

ConformingMesh join(const Work& work, const Pslg& uncut, const std::vector<std::uint32_t>& whole) {
  ConformingMesh mesh;
  mesh.points = work.pslg.points;
  mesh.line.assign(mesh.points.size(), ConformingMesh::kFixed);
  for (const Segment& s : uncut.segments)
    mesh.lines.push_back({uncut.points[s.a.index()], uncut.points[s.b.index()]});
  for (std::size_t s = 0; s < whole.size(); ++s) {
    if (!touches_a_region(work.table.sides[s])) continue;
    const Segment& piece = work.pslg.segments[s];
    for (const VertexId v : {piece.a, piece.b}) {
      if (v.index() >= uncut.points.size()) mesh.line[v.index()] = whole[s];
    }
    mesh.pieces.push_back({static_cast<std::uint32_t>(piece.a.index()),
                           static_cast<std::uint32_t>(piece.b.index()), whole[s]});
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
    mesh.line.resize(mesh.points.size(), ConformingMesh::kInside);
    for (const auto& [a, b, c] : work.meshes[r].triangles) {
      mesh.triangles.push_back({global(a), global(b), global(c)});
      mesh.region.push_back(static_cast<std::uint32_t>(r));
    }
  }
  return mesh;
}

void separate(const ConformingMesh& mesh, const std::vector<std::uint32_t>& old, Work& work) {
  std::vector<std::uint32_t> cuts;  // vertices, along their segments
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.line[v] < mesh.lines.size()) cuts.push_back(v);
  }
  const auto along = [&](std::uint32_t v) {
    const Segment& s = work.pslg.segments[mesh.line[v]];
    const Point a = work.pslg.points[s.a.index()], b = work.pslg.points[s.b.index()];
    return dot(mesh.points[v] - a, b - a);
  };
  std::sort(cuts.begin(), cuts.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.line[a] != mesh.line[b] ? mesh.line[a] < mesh.line[b] : along(a) < along(b);
  });
  std::vector<std::uint32_t> id(mesh.points.size(), kNone);
  std::size_t fixed = 0;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.line[v] == ConformingMesh::kFixed) id[v] = old[fixed++];
  }
  std::vector<SegmentCut> lines;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const SegmentId segment{mesh.line[cuts[k]]};
    if (lines.empty() || lines.back().segment != segment) lines.push_back({segment, {}});
    lines.back().points.push_back(mesh.points[cuts[k]]);
    id[cuts[k]] = static_cast<std::uint32_t>(work.pslg.points.size() + k);
  }
  cut_segments(work.pslg, work.table, lines);
  work.boundaries = split_regions(work.pslg, work.table);
  std::vector<std::uint32_t> local(work.pslg.points.size()), number(mesh.points.size(), kNone);
  std::vector<std::vector<std::uint32_t>> of_region(work.meshes.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) of_region[mesh.region[t]].push_back(t);
  for (std::size_t r = 0; r < work.meshes.size(); ++r) {
    const RegionBoundary& boundary = work.boundaries[r];
    RegionMesh& part = work.meshes[r];
    for (std::uint32_t v = 0; v < boundary.vertices.size(); ++v)
      local[boundary.vertices[v].index()] = v;
    part.steiner.clear();
    part.triangles.clear();
    for (const std::uint32_t t : of_region[r]) {
      IndexTriple triangle = mesh.triangles[t];
      for (std::uint32_t& v : triangle) {
        if (id[v] != kNone) {
          v = local[id[v]];
          continue;
        }
        if (number[v] == kNone) {
          number[v] = static_cast<std::uint32_t>(boundary.points.size() + part.steiner.size());
          part.steiner.push_back(mesh.points[v]);
        }
        v = number[v];
      }
      part.triangles.push_back(triangle);
    }
  }
}

}  // namespace cover
