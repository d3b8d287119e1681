// Box-method figures on meshes where they can be told by hand.
#include "target/report/measure_boxes.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "cdt/couplings.hpp"
#include "target/report/measure_angles.hpp"

namespace cover {
namespace {

/// A square cut into the fan around its middle, with the sides of the square.
struct Star {
  std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  std::vector<IndexTriple> triangles{{4, 0, 1}, {4, 1, 2}, {4, 2, 3}, {4, 3, 0}};
  std::vector<IndexPair> sides{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
};

TEST(MeasureBoxes, NonobtuseMeshHasTheRightArea) {
  const Star star;
  const BoxMethod box = measure_boxes(star.points, star.triangles, star.sides);
  EXPECT_EQ(box.obtuse_sides, 0U);
  EXPECT_EQ(box.non_delaunay_edges, 0U);
  EXPECT_TRUE(negative_edges(star.points, star.triangles, star.sides).empty());
  EXPECT_NEAR(box.box_area, 1, 1e-15);
}

TEST(MeasureBoxes, ObtuseSideAndWrongArea) {
  Star star;
  star.points[4] = {0.5, 0.25};
  const BoxMethod box = measure_boxes(star.points, star.triangles, star.sides);
  EXPECT_EQ(box.obtuse_sides, 1U) << "the bottom side sees an angle of 126.9 degrees";
  EXPECT_EQ(box.non_delaunay_edges, 0U);
  EXPECT_EQ(negative_edges(star.points, star.triangles, star.sides).size(), 1U);
  // Every triangle's signed areas add up to its own; the bottom side's is -3/16 here.
  EXPECT_NEAR(box.box_area, 1 + 2 * 3.0 / 16, 1e-15);
}

TEST(MeasureBoxes, EdgeThatIsNotDelaunay) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {2, 1}, {2, -1}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {1, 0, 3}};
  const std::vector<IndexPair> outline{{1, 2}, {2, 0}, {0, 3}, {3, 1}};
  EXPECT_EQ(measure_boxes(points, triangles, outline).non_delaunay_edges, 1U);
  // As a slit the same edge counts on both its sides.
  std::vector<IndexPair> with_slit = outline;
  with_slit.push_back({0, 1});
  with_slit.push_back({1, 0});
  EXPECT_EQ(measure_boxes(points, triangles, with_slit).non_delaunay_edges, 0U);
  EXPECT_EQ(measure_boxes(points, triangles, with_slit).obtuse_sides, 2U);
}

/// A square of four triangles around C and a right one below it, worked out by hand: |e| d_e / 2
/// with d_e the distance from the middle of an edge to the circumcentre, the cotangents of the
/// angles.
///
///   triangle   circumcentre   |e| d_e / 2              sum   area   cotangents
///   A B C      (2, -1)        AB 2, BC 5/2, CA 3/2       6      2   A 1, B 3, C -1/2
///   B A D      (2, 0)         BA 0, AD 2, DB 2           4      4   B 1, A 1, D 0
///   B E C      (3, 2)         BE 2, EC 3/2, CB 5/2       6      6   B 1/3, E 1, C 1/2
///   C E F      (2, 3)         CE 3/2, EF 2, FC 5/2       6      6   C 1/2, E 1, F 1/3
///   C F A      (-1, 2)        CF 5/2, FA 2, AC 3/2       6      2   C -1/2, F 3, A 1
struct ByHand {
  // A, B, C, D, E, F
  std::vector<Point> points{{0, 0}, {4, 0}, {1, 1}, {2, -2}, {4, 4}, {0, 4}};
  std::vector<IndexTriple> triangles{{0, 1, 2}, {1, 0, 3}, {1, 4, 2}, {2, 4, 5}, {2, 5, 0}};
};

TEST(MeasureBoxes, AMeshWorkedOutByHand) {
  const ByHand mesh;
  const std::vector<IndexPair> sides{{0, 3}, {3, 1}, {1, 4}, {4, 5}, {5, 0}};
  const BoxMethod box = measure_boxes(mesh.points, mesh.triangles, sides);
  EXPECT_NEAR(box.box_area, 28, 1e-14);
  EXPECT_EQ(box.non_delaunay_edges, 1U);  // AB: -1/2 + 0
  EXPECT_EQ(box.obtuse_sides, 1U);        // FA, seen from C
  EXPECT_EQ(negative_edges(mesh.points, mesh.triangles, sides).size(), 2U);
  const Quality quality = measure_angles(mesh.points, mesh.triangles);
  EXPECT_EQ(quality.obtuse, 2U);
  EXPECT_NEAR(quality.area, 20, 1e-14);
}

TEST(MeasureBoxes, AnInterfaceIsASideOfBothRegions) {
  const ByHand mesh;
  const std::vector<IndexTriple> below{mesh.triangles[1]};
  const std::vector<IndexPair> sides_below{{0, 3}, {3, 1}, {1, 0}};
  const BoxMethod lower = measure_boxes(mesh.points, below, sides_below);
  EXPECT_NEAR(lower.box_area, 4, 1e-15);
  EXPECT_TRUE(negative_edges(mesh.points, below, sides_below).empty());
  std::vector<IndexTriple> above = mesh.triangles;
  above.erase(above.begin() + 1);
  const std::vector<IndexPair> sides_above{{0, 1}, {1, 4}, {4, 5}, {5, 0}};
  const BoxMethod upper = measure_boxes(mesh.points, above, sides_above);
  EXPECT_NEAR(upper.box_area, 24, 1e-14);
  EXPECT_EQ(upper.non_delaunay_edges, 0U);
  EXPECT_EQ(upper.obtuse_sides, 2U);  // AB and FA
  EXPECT_EQ(negative_edges(mesh.points, above, sides_above).size(), 2U);
}

}  // namespace
}  // namespace cover
