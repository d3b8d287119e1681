#include "cuts/before_meshing/onto_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <cover/adopt_cuts.hpp>
#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"
#include "support/inputs/periodic_cells.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

using testing::must_mesh;

Options sized(double size) {
  Options options;
  options.split_interfaces = Angle::degrees(120);
  options.sizes = {{"", size, false}};
  options.effort = Effort::fast;
  return options;
}

Input disc(int chords) {
  Input input;
  testing::add_circle(input, {1, 2}, 3, chords, "rim");
  return input;
}

TEST(OntoArcs, SizesPutPointsOnTheCircle) {
  for (const bool box_method : {false, true}) {
    Options options = sized(0.5);
    options.box_method = box_method;
    const Output output = must_mesh(disc(5), options);
    EXPECT_GT(output.pslg.points.size(), 30U);
    for (const Point& p : output.pslg.points) EXPECT_NEAR(length(p - Point{1, 2}), 3, 1e-14);
    for (const BoxCut& cut : output.report.box_cuts)
      EXPECT_NEAR(length(cut.at - Point{1, 2}), 3, 1e-14);
    EXPECT_EQ(testing::violations(output), "");
    // Areas and lengths follow.
    EXPECT_NEAR(output.table.regions[0].area, output.report.quality.area, 1e-12);
    double around = 0;
    for (const Segment& s : output.pslg.segments)
      around += length(output.pslg.points[s.b.index()] - output.pslg.points[s.a.index()]);
    EXPECT_NEAR(output.table.interfaces[0].length, around, 1e-12);
  }
}

TEST(OntoArcs, TheBoxMethodCutsOnTheCircleToo) {
  // A line close to a chord encroaches it.
  Input input = disc(6);
  input.points.push_back({0.5, 4.2});
  input.points.push_back({1.5, 4.2});
  InputSegment line;
  line.a = 6, line.b = 7, line.id = 6;
  input.segments.push_back(line);
  Options options;
  options.box_method = true;
  const Output output = must_mesh(input, options);
  ASSERT_FALSE(output.report.box_cuts.empty());
  std::size_t on_circle = 0;
  for (std::size_t v = 8; v < output.pslg.points.size(); ++v) {
    on_circle += std::abs(length(output.pslg.points[v] - Point{1, 2}) - 3) < 1e-13 ? 1 : 0;
  }
  EXPECT_GT(on_circle, 0U);
  VerifyOptions verify;
  verify.box_method = true;
  EXPECT_TRUE(verify_cover(output.pslg, output.table, triangle_soup(output.mesh), verify)
                  .violations.empty());
}

TEST(OntoArcs, WhereAnotherLineIsBetweenTheChordIsCut) {
  // A square around the disc that the chords do not meet, but their arcs do.
  Input input;
  testing::add_circle(input, {0, 0}, 1, 4, "", 0.7853981633974483);
  for (const Point p : {Point{-0.8, -0.8}, Point{0.8, -0.8}, Point{0.8, 0.8}, Point{-0.8, 0.8}})
    input.points.push_back(p);
  for (std::uint32_t k = 0; k < 4; ++k) {
    InputSegment side;
    side.a = 4 + k, side.b = 4 + (k + 1) % 4, side.id = 4 + k;
    input.segments.push_back(side);
  }
  const Output output = must_mesh(input, sized(0.3));
  EXPECT_EQ(testing::violations(output), "");
  EXPECT_TRUE(
      std::any_of(output.report.notes.begin(), output.report.notes.end(), [](const Note& note) {
        return note.message.find("pieces of arcs are straight") != std::string::npos;
      }));
  for (const Segment& s : output.pslg.segments) EXPECT_EQ(circle_of(output.pslg, s), nullptr);
  EXPECT_EQ(output.table.regions.size(), 2U);
}

TEST(OntoArcs, NoPointChangesSides) {
  // An isolated point, and a small triangle, between a chord and its arc: nothing is crossed, but
  // both would come to lie inside.
  for (const bool triangle : {false, true}) {
    Input input;
    testing::add_circle(input, {0, 0}, 1, 4, "", 0.7853981633974483);
    testing::add_circle(input, {0, 0}, 2, 40);
    const auto first = static_cast<std::uint32_t>(input.points.size());
    input.points.push_back({0.8, 0});
    if (triangle) {
      input.points.push_back({0.81, 0});
      input.points.push_back({0.81, 0.01});
      for (std::uint32_t k = 0; k < 3; ++k) {
        InputSegment side;
        side.a = first + k, side.b = first + (k + 1) % 3;
        side.id = static_cast<long>(input.segments.size());
        input.segments.push_back(side);
      }
    }
    const Output output = must_mesh(input, sized(0.3));
    EXPECT_EQ(testing::violations(output), "");
    std::size_t straight = 0;
    for (const Segment& s : output.pslg.segments) {
      if ((s.circle & kStraightened) == 0) continue;
      ++straight;  // of the chord beside the point, and of no other
      EXPECT_NEAR(output.pslg.points[s.a.index()].x, std::sqrt(0.5), 1e-15);
      EXPECT_NEAR(output.pslg.points[s.b.index()].x, std::sqrt(0.5), 1e-15);
    }
    EXPECT_GT(straight, 1U);
    if (!triangle) {
      ASSERT_EQ(output.table.isolated_points.size(), 1U);
      // Between the circles, as at first; inside of the square there is less room.
      EXPECT_GT(output.table.region(output.table.isolated_points[0].region).area, 5);
    }
  }
}

TEST(OntoArcs, AMeshOfItIsKnownAgain) {
  const Input input = disc(6);
  const Output output = must_mesh(input, sized(0.5));
  const Result<Prepared> prepared = prepare(input);
  Pslg pslg = prepared->pslg;
  RegionTable table = prepared->table;
  const TriangleSoup soup = triangle_soup(output.mesh);
  EXPECT_GT(adopt_cuts(pslg, table, soup), 20U);
  const Verification found = verify_cover(pslg, table, soup);
  EXPECT_TRUE(found.violations.empty()) << found.violations[0].message;
  EXPECT_EQ(pslg.points, output.pslg.points);
}

TEST(OntoArcs, PeriodicArcsStayImages) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 4);
  input.segments[0].name = "a";
  input.segments[1].name = "b";
  input.periodic = {{"a", "b", PeriodicRule::Map::rotation, {0, 0}, Angle::degrees(90)}};
  const Output output = must_mesh(input, sized(0.2));
  EXPECT_EQ(testing::unpaired(output), "");
  EXPECT_GT(output.periodic[0].vertices.size(), 6U);
  for (const Point& p : output.pslg.points) EXPECT_NEAR(length(p - Point{0, 0}), 1, 1e-14);
}

}  // namespace
}  // namespace cover
