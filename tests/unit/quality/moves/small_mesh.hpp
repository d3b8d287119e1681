// Meshes of a few triangles for the tests of moves, given corner by corner.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "../mesh_checks.hpp"
#include "geom/topology/half_edges.hpp"
#include "quality/moves/workplace.hpp"

namespace cover::testing {

/// Triangles over points, the first of which are fixed. Edges with nothing on their other side are
/// sides, and so are `slits`, from both sides. Sides allow nothing beyond the goal.
struct SmallMesh {
  SmallMesh(const Goal& goal, const std::vector<Point>& fixed, const std::vector<Point>& free,
            const std::vector<IndexTriple>& corners, const std::vector<IndexPair>& slits = {}) {
    Triangulation triangulation;
    triangulation.points = fixed;
    triangulation.points.insert(triangulation.points.end(), free.begin(), free.end());
    const HalfEdges edges(triangulation.points.size(), corners);
    boundary.points = triangulation.points;
    for (std::uint32_t h = 0; h < edges.size(); ++h) {
      if (h % 3 == 0) triangulation.triangles.push_back({.v = corners[h / 3]});
      const IndexPair edge{edges.source(h), edges.target(h)}, back{edge[1], edge[0]};
      const bool is_slit = std::find(slits.begin(), slits.end(), edge) != slits.end() ||
                           std::find(slits.begin(), slits.end(), back) != slits.end();
      const std::uint32_t twin = is_slit ? kNone : edges.twin(h);
      // Edge i of a triangle is opposite to corner i; half-edge i leaves corner i.
      const std::uint32_t i = HalfEdges::previous(h) % 3;
      Triangle& triangle = triangulation.triangles[h / 3];
      if (twin != kNone) {
        triangle.n[i] = twin / 3;
        continue;
      }
      triangle.set_locked(i, true);
      boundary.sides.push_back(edge);
    }
    std::sort(boundary.sides.begin(), boundary.sides.end());
    const std::vector<SideLimit> limits(boundary.sides.size(), kNoLimit);
    mesh = MutableMesh(triangulation, static_cast<std::uint32_t>(fixed.size()),
                       locate_sides(triangulation, boundary.sides), limits);
    mesh.set_goal(goal);
  }

  RegionBoundary boundary;
  MutableMesh mesh;
};

inline Goal goal_of(double max, double min) {
  return Goal::of(Angle::degrees(max), Angle::degrees(min));
}

/// Every array of a mesh, for comparison.
struct Everything {
  explicit Everything(const MutableMesh& mesh)
      : points(mesh.points),
        excess(mesh.excess),
        home(mesh.home),
        triangle_count(mesh.triangle_count()) {
    for (const MeshTriangle& t : mesh.triangles) {
      corners.push_back(t.v);
      beyond.push_back(t.n);
    }
  }
  bool operator==(const Everything&) const = default;

  UnsetVector<Point> points;
  UnsetVector<double> excess;
  UnsetVector<std::uint32_t> home;
  std::size_t triangle_count;
  std::vector<std::array<std::uint32_t, 3>> corners, beyond;
};

/// The move changes nothing, around any triangle.
inline void expect_leaves_alone(Move move, MutableMesh& mesh) {
  const Everything before(mesh);
  Workplace work(mesh);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    EXPECT_FALSE(move(work, t)) << t;
    EXPECT_TRUE(Everything(mesh) == before) << t;
    EXPECT_TRUE(work.again.empty()) << t;
  }
}

/// The triangles to be looked at again, each once.
inline std::set<std::uint32_t> again_of(const Workplace& work) {
  return {work.again.begin(), work.again.end()};
}

/// Smallest and largest angle, in degrees.
struct AngleRange {
  double smallest = 180;
  double largest = 0;
};

inline AngleRange angles_of(const MutableMesh& mesh) {
  AngleRange range;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    for (const double dot : k.dot) {
      const double angle = std::atan2(k.cross, dot) * 180 / 3.14159265358979323846;
      range.smallest = std::min(range.smallest, angle);
      range.largest = std::max(range.largest, angle);
    }
  }
  return range;
}

/// The hexagon of radius 1 around the origin, corners from 0 to 5.
inline std::vector<Point> hexagon() { return regular_polygon(6); }

/// A free vertex 6 in a hexagon and the six triangles around it; triangle k is at corners k, k + 1.
inline SmallMesh hexagon_star(const Goal& goal, Point middle) {
  return {goal,
          hexagon(),
          {middle},
          {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 5, 6}, {5, 0, 6}}};
}

}  // namespace cover::testing
