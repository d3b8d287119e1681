#include <cover/curved_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <cover/mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"
#include "support/mesh_shape.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

using testing::must_mesh;

Output disc(int chords, double size) {
  Input input;
  testing::add_circle(input, {1, 2}, 3, chords);
  Options options;
  options.split_interfaces = Angle::degrees(120);
  options.sizes = {{"", size, false}};
  return must_mesh(input, options);
}

TEST(CurvedMesh, MiddleNodesLieOnTheCircle) {
  const Output output = disc(8, 1);
  const CurvedMesh curved = curved_mesh(output);
  EXPECT_EQ(curved.edges.size(), output.pslg.segments.size());
  for (const CurvedEdge& edge : curved.edges) {
    EXPECT_FALSE(edge.is_straight);
    EXPECT_NEAR(length(edge.middle - Point{1, 2}), 3, 1e-14);
  }
  WriteOptions order_2;
  order_2.order = 2;
  const MeshView view = view_of(output, order_2);
  std::size_t on_circle = 0;
  for (std::size_t p = view.corners; p < view.points.size(); ++p)
    on_circle += std::abs(length(view.points[p] - Point{1, 2}) - 3) < 1e-14 ? 1 : 0;
  EXPECT_EQ(on_circle, curved.edges.size());
}

TEST(CurvedMesh, AreasComeToThatOfTheDisc) {
  const double exact = std::numbers::pi * 9;
  double before = 0;
  for (const int chords : {8, 16, 32}) {
    const CurvedMesh curved = curved_mesh(disc(chords, 100));
    ASSERT_EQ(curved.areas.size(), 1U);
    const double error = std::abs(curved.areas[0] / exact - 1);
    EXPECT_LT(error, 1e-3);
    EXPECT_TRUE(before == 0 || error < before / 12) << error;  // fourth order
    before = error;
  }
}

/// Two circles, and a point at this share of the arc's height above the middle of a chord of the
/// inner one.
Input ring_with_point(double share) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 12);
  testing::add_circle(input, {0, 0}, 2, 24);
  const Point m = midpoint(input.points[0], input.points[1]);
  const double height = 1 - length(m - Point{0, 0});
  input.points.push_back(m + (share * height / length(m - Point{0, 0})) * (m - Point{0, 0}));
  return input;
}

std::size_t straight_edges(const Input& input) {
  const CurvedMesh curved = curved_mesh(must_mesh(input));
  EXPECT_EQ(curved.edges.size(), 36U);
  std::size_t straight = 0;
  for (const CurvedEdge& edge : curved.edges) straight += edge.is_straight ? 1 : 0;
  return straight;
}

TEST(CurvedMesh, WhatCannotBeCurvedIsStraightAndOnlyThat) {
  EXPECT_EQ(straight_edges(ring_with_point(-0.5)), 0U);  // the arc leads away from it
  EXPECT_EQ(straight_edges(ring_with_point(0.5)), 1U);   // it is below the arc
  EXPECT_EQ(straight_edges(ring_with_point(6)), 0U);
}

TEST(CurvedMesh, NodesOfNeighboursGiveWayToAnArc) {
  const Output output = must_mesh(ring_with_point(1.5));  // above it, but not by enough
  const CurvedMesh curved = curved_mesh(output);
  for (const CurvedEdge& edge : curved.edges) EXPECT_FALSE(edge.is_straight);
  ASSERT_FALSE(curved.moved.empty());
  EXPECT_LE(curved.moved.size(), 12U);
  // The nodes of a file are these, and all areas stay what arcs make them.
  WriteOptions order_2;
  order_2.order = 2;
  const MeshView view = view_of(output, order_2);
  for (const MovedNode& node : curved.moved) {
    EXPECT_EQ(std::count(view.points.begin(), view.points.end(), node.middle), 1);
    EXPECT_NE(node.middle, midpoint(view.points[node.a], view.points[node.b]));
  }
  const CurvedMesh smooth = curved_mesh(must_mesh(ring_with_point(6)));
  EXPECT_TRUE(smooth.moved.empty());
  EXPECT_NEAR(curved.areas[0], smooth.areas[0], 1e-12);
  EXPECT_NEAR(curved.areas[1], smooth.areas[1], 1e-12);
}

TEST(CurvedMesh, FilesKeepArcs) {
  const testing::TemporaryFolder folder;
  const Output output = disc(8, 1);
  const std::string path = folder.path() / "a.vtk";
  ASSERT_TRUE(write_vtk(output, path));
  ASSERT_TRUE(write_manifest(output, folder.path() / "a.json"));
  const Result<Output> again = read_output(path);
  ASSERT_TRUE(again) << again.error().message;
  const CurvedMesh a = curved_mesh(output), b = curved_mesh(*again);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  EXPECT_EQ(a.areas.size(), b.areas.size());
  EXPECT_NEAR(a.areas[0], b.areas[0], 1e-12);
}

}  // namespace
}  // namespace cover
