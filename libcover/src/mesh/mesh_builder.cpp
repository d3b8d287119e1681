// The mesh is built straight into OpenMesh's arrays. Its add_face() looks for the edges around both
// ends of each new edge and relinks the boundary after each face; here all faces are known at once,
// so edges are paired by a sort, and the links along the boundary are set once, at the end:
//
//   1. an edge is made when its first half-edge comes by, in the order of the faces;
//   2. around a boundary vertex lie one or more fans of triangles with void between. The boundary
//      half-edge that arrives at the first edge of a fan goes on along the last edge of the fan
//      before it. Several fans (regions that meet only in this point) are put in the order of
//      their directions, so that the boundary loops are those of the void.
//
// Tested by tests/unit/mesh/stitch_test.cpp.
#include "mesh/mesh_builder.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include <cover/mesh.hpp>

#include "base/sort_by_team.hpp"
#include "geom/predicates.hpp"
#include "geom/topology/corner.hpp"

namespace cover {

using Halfedge = TriMesh::HalfedgeHandle;
using Vertex = TriMesh::VertexHandle;

namespace {

constexpr std::size_t kWord = 64;

Vertex vertex(std::uint32_t v) { return Vertex(static_cast<int>(v)); }

/// Of numbers that several threads have.
void keep_larger(std::uint32_t number, std::uint32_t& kept) {
  const std::atomic_ref shared(kept);
  std::uint32_t other = shared.load(std::memory_order_relaxed);
  while (other < number &&
         !shared.compare_exchange_weak(other, number, std::memory_order_relaxed)) {
  }
}

/// Where ranges of fans begin of which none has a vertex of another, and the end. To be asked
/// before any of them is sorted: both sides of each place are looked at.
template <class Fan>
std::vector<std::size_t> begin_of_ranges(const std::vector<Fan>& fans) {
  std::vector<std::size_t> begin;
  for (std::size_t at = 0; at < fans.size(); at += kItemsAtATime) {
    begin.push_back(at);
    std::size_t& k = begin.back();
    while (k > 0 && k < fans.size() && fans[k].vertex == fans[k - 1].vertex) ++k;
  }
  begin.push_back(fans.size());
  return begin;
}

}  // namespace

/// A fan of triangles around a boundary vertex, from its first edge counter-clockwise to its last.
struct MeshBuilder::Fan {
  std::uint32_t vertex = 0;
  std::uint32_t towards = 0;  ///< the other end of the first edge
  Halfedge arriving;          ///< boundary half-edge along the first edge, towards `vertex`
  Halfedge leaving;           ///< boundary half-edge along the last edge
};

MeshBuilder::MeshBuilder(std::span<const Point> points, std::span<const IndexTriple> triangles,
                         const Team& team)
    : points_(points),
      triangles_(triangles),
      half_edge_(opposite_half_edges(points.size(), triangles, team)) {
  count_edges(team);
}

Mesh MeshBuilder::build(const Team& team) {
  Mesh mesh;
  TriMesh& tri = mesh.tri();
  std::vector<std::uint32_t> last_of;
  team.each(2, [&](std::size_t k) {
    if (k == 0) {
      // OpenMesh does it in one thread.
      tri.resize(points_.size(), edges_before_.back(), triangles_.size());
    } else {
      number_half_edges(team);
      last_of = last_half_edges(team);
    }
  });
  team.each_range(triangles_.size(), kItemsAtATime,
                  [&](std::size_t first, std::size_t last) { set_faces(first, last, tri); });
  team.each_range(points_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (auto v = static_cast<std::uint32_t>(first); v < last; ++v) {
      tri.set_point(vertex(v), TriMesh::Point(points_[v].x, points_[v].y, 0));
      if (last_of[v] != 0) tri.set_halfedge_handle(vertex(v), halfedge(last_of[v] - 1));
    }
  });
  set_boundary(team, tri);
  return mesh;
}

/// The first half-edge of an edge, in the order of the faces, counts; the other one is marked.
void MeshBuilder::count_edges(const Team& team) {
  static_assert(kItemsAtATime % kWord == 0);  // so that threads share no word
  is_second_.assign(Team::ranges(half_edge_.size(), kWord), 0);
  edges_before_.assign(Team::ranges(half_edge_.size(), kItemsAtATime) + 1, 0);
  team.each_range(half_edge_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    std::uint32_t own = 0;
    for (std::size_t h = first; h < last; ++h) {
      if (half_edge_[h] < h) {
        is_second_[h / kWord] |= std::uint64_t{1} << (h % kWord);
      } else {
        ++own;
      }
    }
    edges_before_[first / kItemsAtATime + 1] = own;
  });
  for (std::size_t k = 1; k < edges_before_.size(); ++k) edges_before_[k] += edges_before_[k - 1];
}

/// In place of their opposites. A first half-edge is not looked at again where the other one takes
/// its number.
void MeshBuilder::number_half_edges(const Team& team) {
  std::vector<std::vector<std::uint32_t>> boundary(edges_before_.size() - 1);
  const auto is_first = [&](std::size_t h) {
    return (is_second_[h / kWord] >> (h % kWord) & 1) == 0;
  };
  team.each_range(half_edge_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    std::uint32_t next = 2 * edges_before_[first / kItemsAtATime];
    for (std::size_t h = first; h < last; ++h) {
      if (!is_first(h)) continue;
      if (std::exchange(half_edge_[h], next) == kNone)
        boundary[first / kItemsAtATime].push_back(next);
      next += 2;
    }
  });
  team.each_range(half_edge_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t h = first; h < last; ++h) {
      if (!is_first(h)) half_edge_[h] = half_edge_[half_edge_[h]] + 1;
    }
  });
  for (const auto& some : boundary) boundary_.insert(boundary_.end(), some.begin(), some.end());
}

/// For each vertex one more than the last half-edge that leaves it.
std::vector<std::uint32_t> MeshBuilder::last_half_edges(const Team& team) const {
  std::vector<std::uint32_t> last_of(points_.size(), 0);
  team.each_range(triangles_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (auto t = static_cast<std::uint32_t>(first); t < last; ++t)
      for (const Corner i : kCorners) keep_larger(3 * t + i + 1, last_of[triangles_[t][i]]);
  });
  return last_of;
}

/// The faces and their half-edges.
void MeshBuilder::set_faces(std::size_t first, std::size_t last, TriMesh& tri) const {
  for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
    const TriMesh::FaceHandle face(static_cast<int>(t));
    for (const Corner i : kCorners) {
      const Halfedge edge = halfedge(3 * t + i);
      tri.set_vertex_handle(edge, vertex(triangles_[t][i.next()]));
      tri.set_face_handle(edge, face);
      tri.set_next_halfedge_handle(edge, halfedge(3 * t + i.next()));
      if (i == 0) tri.set_halfedge_handle(face, edge);  // keeps the order of the corners
    }
  }
}

void MeshBuilder::set_boundary(const Team& team, TriMesh& tri) const {
  std::vector<Fan> fans(boundary_.size());
  team.each_range(boundary_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Halfedge inside(static_cast<int>(boundary_[k]));
      const Halfedge before = tri.next_halfedge_handle(tri.next_halfedge_handle(inside));
      tri.set_vertex_handle(tri.opposite_halfedge_handle(inside), tri.to_vertex_handle(before));
    }
  });
  team.each_range(boundary_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
      fans[k] = fan_from(tri, Halfedge(static_cast<int>(boundary_[k])));
  });
  sort_by_team(
      fans,
      [](const Fan& f, const Fan& g) {
        return f.vertex != g.vertex ? f.vertex < g.vertex : f.arriving < g.arriving;
      },
      team);
  const std::vector<std::size_t> begin = begin_of_ranges(fans);
  team.each(begin.size() - 1, [&](std::size_t k) {
    const auto end_of_range = fans.begin() + static_cast<std::ptrdiff_t>(begin[k + 1]);
    for (auto first = fans.begin() + static_cast<std::ptrdiff_t>(begin[k]); first < end_of_range;) {
      const auto last = std::find_if(first, end_of_range,
                                     [&](const Fan& f) { return f.vertex != first->vertex; });
      if (last - first > 1) sort_by_direction({first, last});
      for (auto fan = first; fan != last; ++fan) {
        const auto before = fan == first ? last - 1 : fan - 1;
        tri.set_next_halfedge_handle(fan->arriving, before->leaving);
      }
      // OpenMesh knows a boundary vertex by its half-edge.
      tri.set_halfedge_handle(vertex(first->vertex), first->leaving);
      first = last;
    }
  });
}

/// The fan around the source of `first`, an edge without a triangle on its right.
MeshBuilder::Fan MeshBuilder::fan_from(const TriMesh& tri, Halfedge first) {
  const auto opposite = [](Halfedge h) { return Halfedge(h.idx() ^ 1); };
  Halfedge incoming = tri.prev_halfedge_handle(first);
  for (Halfedge out = opposite(incoming); tri.face_handle(out).is_valid();
       out = opposite(incoming)) {
    incoming = tri.prev_halfedge_handle(out);
  }
  return {static_cast<std::uint32_t>(tri.from_vertex_handle(first).idx()),
          static_cast<std::uint32_t>(tri.to_vertex_handle(first).idx()), opposite(first),
          opposite(incoming)};
}

/// Counter-clockwise around their common vertex, from straight up on.
void MeshBuilder::sort_by_direction(std::span<Fan> fans) const {
  const Point centre = points_[fans.front().vertex];
  std::sort(fans.begin(), fans.end(), [&](const Fan& f, const Fan& g) {
    const Point p = points_[f.towards], q = points_[g.towards];
    if ((p < centre) != (q < centre)) return p < centre;
    return orientation(centre, p, q) == Sign::positive;
  });
}

}  // namespace cover
