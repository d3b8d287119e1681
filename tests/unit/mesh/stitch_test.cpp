// Stitching: connectivity that OpenMesh would have built itself, also where regions meet only in a
// point, along slits and around holes; properties of vertices, edges and faces.
#include "mesh/stitch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include <cover/mesh.hpp>

#include "almond/almond_region.hpp"
#include "base/run_all.hpp"
#include "mesh/find_edges.hpp"
#include "mesh/mesh_builder.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using testing::Loop;

/// Regions given by loops that share points, put together by hand.
struct Patchwork {
  Pslg pslg;
  RegionTable table;
  std::vector<RegionBoundary> boundaries;
  std::vector<RegionMesh> meshes;

  explicit Patchwork(const std::vector<std::vector<Loop>>& regions) {
    for (const std::vector<Loop>& loops : regions) add_region(loops);
    for (const RegionBoundary& b : boundaries) meshes.push_back(almond_region(b, {}, {}));
  }
  [[nodiscard]] Mesh stitched() const {
    std::vector<RegionMesh> copies = meshes;
    return stitch(pslg, table, boundaries, copies);
  }

 private:
  void add_region(const std::vector<Loop>& loops) {
    RegionBoundary b = testing::boundary_of(loops);
    b.id = RegionId(boundaries.size() + 1);
    b.vertices.clear();
    for (const Point& p : b.points) {
      const auto [it, is_new] = ids_.emplace(p, pslg.points.size());
      if (is_new) pslg.points.push_back(p);
      b.vertices.emplace_back(it->second);
    }
    b.segments.clear();
    for (const auto& [i, j] : b.sides)
      b.segments.push_back(segment(b.vertices[i], b.vertices[j], b.id));
    Region region;
    region.id = b.id;
    region.material = 10 * static_cast<int>(b.id.value());
    table.regions.push_back(region);
    boundaries.push_back(std::move(b));
  }

  SegmentId segment(VertexId a, VertexId b, RegionId left) {
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      if (pslg.segments[s].a == b && pslg.segments[s].b == a) {
        table.sides[s].right = left;
        return SegmentId(s);
      }
    }
    const std::size_t s = pslg.segments.size();
    pslg.segments.push_back({a, b, 100 + static_cast<int>(s), 0});
    table.sides.push_back({left, kVoid, InterfaceId(s + 1)});
    return SegmentId(s);
  }

  std::map<Point, std::size_t> ids_;
};

/// Every invariant of the half-edge structure that OpenMesh's algorithms rely on.
void expect_sound(const Mesh& mesh) {
  const TriMesh& tri = mesh.tri();
  for (const auto h : tri.halfedges()) {
    EXPECT_EQ(tri.prev_halfedge_handle(tri.next_halfedge_handle(h)), h);
    EXPECT_EQ(tri.to_vertex_handle(h), tri.from_vertex_handle(tri.next_halfedge_handle(h)));
    EXPECT_EQ(tri.face_handle(h), tri.face_handle(tri.next_halfedge_handle(h)));
  }
  for (const auto f : tri.faces()) {
    EXPECT_EQ(tri.face_handle(tri.halfedge_handle(f)), f);
    EXPECT_EQ(tri.valence(f), 3U);
  }
  for (const auto v : tri.vertices()) {
    EXPECT_EQ(tri.from_vertex_handle(tri.halfedge_handle(v)), v);
    std::set<int> circulated, expected;
    for (const auto h : tri.voh_range(v)) circulated.insert(h.idx());
    for (const auto h : tri.halfedges()) {
      if (tri.from_vertex_handle(h) == v) expected.insert(h.idx());
    }
    EXPECT_EQ(circulated, expected) << "around vertex " << v.idx();
    const bool on_boundary = std::any_of(expected.begin(), expected.end(), [&](int h) {
      return tri.is_boundary(TriMesh::HalfedgeHandle(h));
    });
    EXPECT_EQ(tri.is_boundary(v), on_boundary);
  }
}

std::size_t boundary_loops(const TriMesh& tri) {
  std::set<int> seen;
  std::size_t loops = 0;
  for (const auto start : tri.halfedges()) {
    if (!tri.is_boundary(start) || !seen.insert(start.idx()).second) continue;
    ++loops;
    for (auto h = tri.next_halfedge_handle(start); h != start; h = tri.next_halfedge_handle(h)) {
      seen.insert(h.idx());
    }
  }
  return loops;
}

Loop square(double x, double y) { return {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}; }

TEST(FindEdges, InEitherDirectionAndOnlyThoseThatAreThere) {
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {2, 1, 3}};
  const std::vector<std::array<std::uint32_t, 2>> pairs{
      {1, 0}, {1, 2}, {2, 1}, {0, 3}, {3, 1}, {7, 0xffffffffU}, {0xffffffffU, 0xffffffffU}};
  const std::vector<std::uint32_t> found = find_edges(4, triangles, pairs);
  const HalfEdges half_edges(4, triangles);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const bool is_edge = k != 3 && k < 5;
    ASSERT_EQ(found[k] != kNone, is_edge) << k;
    if (!is_edge) continue;
    const std::array ends{half_edges.source(found[k]), half_edges.target(found[k])};
    EXPECT_TRUE(ends == pairs[k] || ends == (std::array{pairs[k][1], pairs[k][0]})) << k;
  }
  EXPECT_EQ(find_edges(1, triangles, pairs)[1], kNone) << "beyond what was asked for";
}

/// The black squares of a chessboard, each cut in two: more than one thread takes for itself. At
/// inner vertices two of them meet.
struct Chessboard {
  std::vector<Point> points;
  std::vector<IndexTriple> triangles;
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< sides of all squares, from either end

  explicit Chessboard(std::uint32_t n) : points((n + 1) * (n + 1)) {
    const auto at = [&](std::uint32_t x, std::uint32_t y) {
      const std::size_t place = std::size_t{7919} * ((n + 1) * y + x) % points.size();
      points[place] = {static_cast<double>(x), static_cast<double>(y)};
      return static_cast<std::uint32_t>(place);
    };
    for (std::uint32_t k = 0; k < n * n; ++k) {
      const std::uint32_t x = k % n, y = k / n;
      pairs.push_back({at(x, y), at(x + 1, y)});
      pairs.push_back({at(x, y + 1), at(x, y)});
      if ((x + y) % 2 != 0) continue;
      triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
      triangles.push_back({at(x, y + 1), at(x + 1, y), at(x + 1, y + 1)});
    }
  }
};

TEST(FindEdges, IsTheSameForAnyNumberOfThreads) {
  const Chessboard board(301);
  const auto alone = find_edges(board.points.size(), board.triangles, board.pairs);
  EXPECT_NE(std::count(alone.begin(), alone.end(), kNone), 0);
  for (const unsigned workers : {2U, 3U, 7U}) {
    with_team(workers, [&](const Team& team) {
      EXPECT_EQ(find_edges(board.points.size(), board.triangles, board.pairs, team), alone);
    });
  }
}

TEST(MeshBuilder, BuildsTheSameForAnyNumberOfThreads) {
  const Chessboard board(301);
  MeshBuilder builder(board.points, board.triangles);
  const Mesh alone = builder.build();
  const TriMesh& tri = alone.tri();
  for (const auto h : tri.halfedges())
    ASSERT_EQ(tri.prev_halfedge_handle(tri.next_halfedge_handle(h)), h);
  for (const unsigned workers : {2U, 3U, 7U}) {
    with_team(workers, [&](const Team& team) {
      MeshBuilder divided(board.points, board.triangles, team);
      const Mesh mesh = divided.build(team);
      ASSERT_EQ(mesh.tri().n_edges(), tri.n_edges());
      for (const auto h : tri.halfedges()) {
        ASSERT_EQ(mesh.tri().next_halfedge_handle(h), tri.next_halfedge_handle(h));
        ASSERT_EQ(mesh.tri().to_vertex_handle(h), tri.to_vertex_handle(h));
        ASSERT_EQ(mesh.tri().face_handle(h), tri.face_handle(h));
      }
      for (const auto v : tri.vertices()) {
        ASSERT_EQ(mesh.tri().halfedge_handle(v), tri.halfedge_handle(v));
        ASSERT_EQ(mesh.tri().point(v), tri.point(v));
      }
      for (const auto f : tri.faces())
        ASSERT_EQ(mesh.tri().halfedge_handle(f), tri.halfedge_handle(f));
      for (std::uint32_t h = 0; h < 3 * board.triangles.size(); ++h)
        ASSERT_EQ(divided.edge_of(h), builder.edge_of(h));
    });
  }
}

TEST(Stitch, JoinsNeighboursAlongTheirSegment) {
  const Patchwork work({{square(0, 0)}, {square(1, 0)}});
  const Mesh mesh = work.stitched();
  expect_sound(mesh);
  EXPECT_EQ(mesh.tri().n_vertices(), 6U);
  EXPECT_EQ(mesh.tri().n_faces(), 4U);
  EXPECT_EQ(mesh.tri().n_edges(), 9U);
  EXPECT_EQ(boundary_loops(mesh.tri()), 1U);
}

TEST(Stitch, KeepsCoordinatesIdsAndProperties) {
  const Patchwork work({{square(0, 0)}, {square(1, 0)}});
  const Mesh mesh = work.stitched();
  for (const auto v : mesh.tri().vertices()) {
    const Point p = work.pslg.points[static_cast<std::size_t>(mesh.input_id(v))];
    EXPECT_EQ(mesh.tri().point(v), TriMesh::Point(p.x, p.y, 0));
  }
  for (const auto f : mesh.tri().faces()) {
    EXPECT_EQ(mesh.region(f), RegionId(f.idx() < 2 ? 1 : 2));
    EXPECT_EQ(mesh.material(f), f.idx() < 2 ? 10 : 20);
  }
  std::multiset<std::uint32_t> interfaces;
  for (const auto e : mesh.tri().edges()) {
    if (mesh.interface(e) == kNoInterface) {
      EXPECT_EQ(mesh.marker(e), 0);
    } else {
      interfaces.insert(mesh.interface(e).value());
      EXPECT_EQ(mesh.marker(e), 99 + static_cast<int>(mesh.interface(e).value()));
    }
  }
  EXPECT_EQ(interfaces, (std::multiset<std::uint32_t>{1, 2, 3, 4, 5, 6, 7}));
}

TEST(Stitch, RegionsThatMeetOnlyInAPoint) {
  const Patchwork work({{square(0, 0)}, {square(1, 1)}});
  const Mesh mesh = work.stitched();
  expect_sound(mesh);
  EXPECT_EQ(mesh.tri().n_vertices(), 7U);
  EXPECT_EQ(boundary_loops(mesh.tri()), 1U) << "the void around both is one";
}

TEST(Stitch, ManyFansAroundOnePoint) {
  std::vector<std::vector<Loop>> regions;
  const Loop rim = testing::regular_polygon(24);
  for (std::size_t k : {9U, 3U, 21U, 0U, 6U, 15U, 18U, 12U}) {
    regions.push_back({{{0, 0}, rim[k], rim[k + 1]}});
  }
  const Mesh mesh = Patchwork(regions).stitched();
  expect_sound(mesh);
  EXPECT_EQ(mesh.tri().n_faces(), 8U);
  EXPECT_EQ(boundary_loops(mesh.tri()), 1U);
}

TEST(Stitch, CheckerboardOfMaterialAndVoid) {
  std::vector<std::vector<Loop>> regions;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      if ((x + y) % 2 == 0) regions.push_back({square(x, y)});
    }
  }
  const Mesh mesh = Patchwork(regions).stitched();
  expect_sound(mesh);
  EXPECT_EQ(mesh.tri().n_faces(), 26U);
  EXPECT_EQ(boundary_loops(mesh.tri()), 5U) << "four void cells inside, and the outside";
}

TEST(Stitch, RegionWithAHoleAndASlit) {
  const Loop outer{{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  const Loop hole = testing::reversed({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  const Loop slit{{4, 3}, {4, 4}};
  const Mesh mesh = Patchwork({{outer, hole, slit}}).stitched();
  expect_sound(mesh);
  EXPECT_EQ(boundary_loops(mesh.tri()), 2U) << "a slit has a triangle on both sides";
  EXPECT_EQ(mesh.tri().n_vertices(), 10U);
}

TEST(Stitch, LeavesOutPointsOfTheVoidAndNumbersSteinerVerticesByRegion) {
  Patchwork work({{square(0, 0)}, {square(1, 0)}});
  work.pslg.points.insert(work.pslg.points.begin(), {-9, -9});
  for (RegionBoundary& b : work.boundaries) {
    for (VertexId& v : b.vertices) v = VertexId(v.value() + 1);
  }
  for (Segment& s : work.pslg.segments) {
    s.a = VertexId(s.a.value() + 1);
    s.b = VertexId(s.b.value() + 1);
  }
  // Both regions as a star around their middle.
  for (std::size_t r = 0; r < 2; ++r) {
    work.meshes[r].steiner = {{0.5 + static_cast<double>(r), 0.5}};
    work.meshes[r].triangles.clear();
    for (const auto& [i, j] : work.boundaries[r].sides)
      work.meshes[r].triangles.push_back({4, i, j});
  }
  const Mesh mesh = work.stitched();
  expect_sound(mesh);
  ASSERT_EQ(mesh.tri().n_vertices(), 8U);
  EXPECT_EQ(mesh.input_id(TriMesh::VertexHandle(0)), 1);
  for (const int v : {6, 7}) {
    EXPECT_EQ(mesh.input_id(TriMesh::VertexHandle(v)), -1);
    EXPECT_EQ(mesh.tri().point(TriMesh::VertexHandle(v))[0], v - 5.5);
  }
}

TEST(Stitch, NothingIsAnEmptyMesh) {
  const Mesh mesh = stitch({}, {}, {}, {});
  EXPECT_EQ(mesh.tri().n_vertices(), 0U);
  EXPECT_EQ(mesh.tri().n_faces(), 0U);
}

TEST(Stitch, AMeshMovesWithoutACopy) {
  Mesh mesh = Patchwork({{square(0, 0)}}).stitched();
  const TriMesh* before = &mesh.tri();
  const Mesh moved = std::move(mesh);
  EXPECT_EQ(&moved.tri(), before);
  const Mesh copy = moved;
  EXPECT_NE(&copy.tri(), before);
  EXPECT_EQ(copy.region(TriMesh::FaceHandle(0)), RegionId(1));
}

}  // namespace
}  // namespace cover
