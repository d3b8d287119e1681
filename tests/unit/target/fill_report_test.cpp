// Angle statistics against angles known in closed form, box-method figures on meshes where they
// can be told by hand.
#include "target/fill_report.hpp"
#include "cdt/couplings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(MeasureAngles, EquilateralTriangleInEveryRotation) {
  const double h = std::sqrt(3.0) / 2;
  const std::vector<Point> points{{0, 0}, {1, 0}, {0.5, h}};
  for (const IndexTriple t : {IndexTriple{0, 1, 2}, IndexTriple{1, 2, 0}, IndexTriple{2, 0, 1}}) {
    const Quality q = measure_angles(points, std::vector{t});
    EXPECT_NEAR(q.largest_nu.in_degrees(), 120, 1e-12);
    EXPECT_NEAR(q.smallest.in_degrees(), 60, 1e-12);
    EXPECT_EQ(q.obtuse, 0U);
    EXPECT_NEAR(q.area, h / 2, 1e-15);
    EXPECT_EQ(std::accumulate(q.histogram.begin(), q.histogram.end(), 0U), 3U);
  }
}

TEST(MeasureAngles, FlatTriangleKeepsItsDigits) {
  const double height = 0x1p-40;
  const std::vector<Point> points{{-1, 0}, {1, 0}, {0, height}};
  const Quality q = measure_angles(points, std::vector{IndexTriple{0, 1, 2}});
  EXPECT_NEAR(q.largest_nu.in_radians() / (2 * height), 1, 1e-15);
  EXPECT_NEAR(q.smallest.in_radians() / height, 1, 1e-15);
  EXPECT_EQ(q.obtuse, 1U);
  EXPECT_EQ(q.above_120, 1U);
  EXPECT_EQ(q.above_150, 1U);
}

TEST(MeasureAngles, EveryAngleHasItsBin) {
  for (int degrees = 15; degrees < 80; degrees += 10) {  // and what is left, at a right angle
    const double slope = std::tan(Angle::degrees(degrees).in_radians());
    const std::vector<Point> points{{0, 0}, {1, 0}, {1, slope}};
    const Quality q = measure_angles(points, std::vector<IndexTriple>{{0, 1, 2}});
    const auto bin = static_cast<std::size_t>(degrees / 10);
    EXPECT_EQ(q.histogram[bin], bin == 4 ? 2U : 1U);
    EXPECT_EQ(q.histogram[8 - bin], bin == 4 ? 2U : 1U);
  }
  const std::vector<Point> line{{0, 0}, {1, 0}, {2, 0}};
  const Quality flat = measure_angles(line, std::vector<IndexTriple>{{0, 1, 2}});
  EXPECT_EQ(flat.histogram[17], 1U);
  EXPECT_EQ(flat.histogram[0], 2U);
}

TEST(MeasureAngles, RightAngleIsNotObtuse) {
  const std::vector<Point> points{{0.1, 0.1}, {0.3, 0.1}, {0.1, 0.7}};
  const Quality q = measure_angles(points, std::vector{IndexTriple{0, 1, 2}});
  EXPECT_EQ(q.obtuse, 0U);
  EXPECT_EQ(q.histogram[8] + q.histogram[9], 1U);
}

TEST(MeasureAngles, RightAnglesThatRoundingMissesAreNotObtuse) {
  std::vector<Point> points{{0, 0}, {0, 0}, {0, 0}};
  for (int k = 1; k < 200; ++k) {
    const double c = std::cos(0.031 * k), s = std::sin(0.031 * k);
    points[1] = {3 * c, 3 * s};
    points[2] = {-s, c};
    EXPECT_EQ(measure_angles(points, std::vector{IndexTriple{0, 1, 2}}).obtuse, 0U) << k;
    points[2] = {-s - 1e-8 * c, c - 1e-8 * s};
    EXPECT_EQ(measure_angles(points, std::vector{IndexTriple{0, 1, 2}}).obtuse, 1U) << k;
    const std::vector<IndexPair> sides{{0, 1}, {1, 2}, {2, 0}};
    EXPECT_EQ(measure_boxes(points, std::vector{IndexTriple{0, 1, 2}}, sides).obtuse_sides, 1U);
  }
}

/// A foot on a slanted segment is rounded: angles there are right up to that only.
TEST(MeasureAngles, WhatRoundingMakesIsNotObtuse) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> share(0.3, 0.7);
  const Point a{1234.1, 871.3}, b{1235.7, 872.9};
  const Vector along = b - a;
  std::size_t exactly = 0, by_more_than_before = 0, by_rounding = 0;
  for (int k = 0; k < 200; ++k) {
    const Point foot = a + share(random) * along;
    const Point p = foot + 1e-6 * left_normal(along);
    const std::vector<Point> points{a, foot, p, b};
    const std::vector<IndexTriple> triangles{{0, 1, 2}, {1, 3, 2}};
    for (const Point end : {a, b}) {
      exactly += compare_with_90_degrees(end, foot, p) == Sign::positive ? 1 : 0;
      by_more_than_before += angle_at(end, foot, p) > std::numbers::pi / 2 + 1e-9 ? 1 : 0;
    }
    EXPECT_EQ(measure_angles(points, triangles).obtuse, 0u);
    by_rounding += measure_angles(points, triangles).obtuse_by_rounding;
    const std::vector<Point> moved{a, foot + -1e-8 * along, p, b};
    EXPECT_EQ(measure_angles(moved, triangles).obtuse, 2u);  // at the foot, and opposite
  }
  EXPECT_GT(exactly, 50u);
  EXPECT_EQ(by_rounding, exactly);
  EXPECT_GT(by_more_than_before, 50u);
}

TEST(MeasureAngles, MergeAddsUp) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {3, -0.5}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {0, 3, 1}};
  Quality sum = measure_angles(points, std::span(triangles).first(1));
  merge(sum, measure_angles(points, std::span(triangles).last(1)));
  const Quality whole = measure_angles(points, triangles);
  EXPECT_EQ(sum.triangles, whole.triangles);
  EXPECT_EQ(sum.largest_nu, whole.largest_nu);
  EXPECT_EQ(sum.smallest, whole.smallest);
  EXPECT_EQ(sum.histogram, whole.histogram);
  EXPECT_EQ(sum.area, whole.area);
}

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

TEST(Measure, FillsTheReportAndNamesTheWorstTriangle) {
  const RegionBoundary boundary = testing::boundary_of({{{0, 0}, {4, 0}, {2, 0.5}}});
  RegionMesh mesh;
  mesh.triangles = {{0, 2, 1}};
  mesh.report.id = boundary.id;
  mesh.report.nu_bound = Angle::degrees(20);
  fill_report(boundary, mesh);
  EXPECT_TRUE(mesh.report.bound_held);
  EXPECT_TRUE(mesh.report.notes.empty());
  EXPECT_EQ(mesh.report.quality.triangles, 1U);
  EXPECT_EQ(mesh.report.input_vertices, 3U);
  EXPECT_NEAR(mesh.report.quality.largest_nu.in_radians(), 2 * std::atan(0.25), 1e-15);

  mesh.report.nu_bound = Angle::degrees(30);
  fill_report(boundary, mesh);
  EXPECT_FALSE(mesh.report.bound_held);
  ASSERT_EQ(mesh.report.notes.size(), 1U);
  EXPECT_EQ(mesh.report.notes[0].kind, Note::Kind::bound_missed);
  EXPECT_NE(mesh.report.notes[0].message.find("(2, 0.5)"), std::string::npos);
  EXPECT_EQ(mesh.report.notes[0].where.size(), 3U);
}

TEST(Measure, BoundHoldsUpToTheRoundingOfTheCoordinates) {
  // nu = 2 * 2^-30 with coordinates near 2^20: a unit in the last place is 2^-32.
  const double x = 0x1p20, height = 0x1p-30;
  const std::vector<Point> points{{x, x}, {x + 2, x}, {x + 1, x + height}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}};
  EXPECT_TRUE(holds_bound(points, triangles, Angle::radians(2.4 * height)));
  EXPECT_FALSE(holds_bound(points, triangles, Angle::radians(6 * height)));
  const std::vector<Point> at_origin{{0, 0}, {2, 0}, {1, height}};
  EXPECT_FALSE(holds_bound(at_origin, triangles, Angle::radians(2.4 * height)));
}

TEST(Measure, NoTriangleHoldsNoBound) {
  const RegionBoundary boundary = testing::boundary_of({testing::regular_polygon(5)});
  RegionMesh mesh;
  fill_report(boundary, mesh);
  EXPECT_FALSE(mesh.report.bound_held);
  EXPECT_NEAR(mesh.report.quality.largest_nu.in_radians(), std::numbers::pi, 0);
}

}  // namespace
}  // namespace cover
