#include "cuts/after_meshing/thin_cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <span>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "geom/curves/arc.hpp"
#include "support/inputs/arc_devices.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"
#include "without_obtuse.hpp"

namespace cover {
namespace {

std::size_t added(const Output& output) {
  return output.report.steiner_vertices + output.pslg.points.size() - output.report.input_points;
}

const Note* note_of(const Output& output) {
  for (const Note& note : output.report.notes) {
    if (note.message.find("that no right angle needs") != std::string::npos) return &note;
  }
  return nullptr;
}

/// A wedge of two degrees, a ten-thousandth beside a ring of 32 chords.
Input wedge_beside_a_ring() {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 2>> segments;
  const auto add = [&](const std::vector<Point>& loop) {
    const auto first = static_cast<std::uint32_t>(points.size()),
               n = static_cast<std::uint32_t>(loop.size());
    for (std::uint32_t k = 0; k < n; ++k) segments.push_back({first + k, first + (k + 1) % n});
    points.insert(points.end(), loop.begin(), loop.end());
  };
  for (const double radius : {1.05, 1.0}) {
    std::vector<Point> loop;
    for (int k = 0; k < 32; ++k)
      loop.push_back({radius * std::cos(2 * std::numbers::pi * k / 32),
                      radius * std::sin(2 * std::numbers::pi * k / 32)});
    add(loop);
  }
  const double x = 1.0501, half = 1.5 * std::tan(std::numbers::pi / 180);
  add({{x, 0}, {x + 1.5, -half}, {x + 1.5, half}});
  add({{-2, -2}, {4, -2}, {4, 2}, {-2, 2}});
  return testing::segments_between(points, segments);
}

TEST(ThinCuts, TakesVerticesAwayAndLeavesNoObtuseTriangle) {
  std::size_t told = 0;
  for (const testing::RandomInput& kind : testing::kRandomDevices) {
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
      SCOPED_TRACE(kind.name + std::to_string(seed));
      const Input input = kind.make(seed);
      Options options = no_obtuse_angle();
      options.min_angle = Angle::degrees(0);
      const Output thin = mesh_of(input, options);
      EXPECT_EQ(thin.report.quality.obtuse, 0u);
      const Note* note = note_of(thin);
      if (note == nullptr) continue;  // nothing could go
      ++told;
      EXPECT_EQ(note->kind, Note::Kind::cut);
      EXPECT_EQ(note->where.size(), thin.pslg.points.size() - thin.report.input_points);
      EXPECT_NE(note->message.find(fmt::format("became {} when", added(thin))), std::string::npos)
          << note->message << added(thin);
    }
  }
  EXPECT_GE(told, 9u);
}

/// Promise 5, too: another order of points and segments, other directions, and the same triangles.
TEST(ThinCuts, TheOrderOfTheInputDoesNotMatter) {
  std::size_t cut = 0;
  for (const bool boxes : {false, true}) {
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
      std::mt19937_64 random(seed);
      std::vector<Point> points = testing::random_star(40, 0.2, random);
      std::vector<std::array<std::uint32_t, 2>> segments;
      for (std::uint32_t k = 0; k < 40; ++k) segments.push_back({k, (k + 1) % 40});
      segments.push_back({0, 40});
      points.push_back({points[0].x / 2, points[0].y / 2});
      Options options = no_obtuse_angle();
      if (boxes) options = {};
      options.box_method = boxes;
      const auto shape = [&] {
        const Output output =
            testing::must_mesh(testing::segments_between(points, segments), options);
        cut += output.pslg.points.size() > output.report.input_points ? 1 : 0;
        return testing::shape_of(triangle_soup(output.mesh));
      };
      const testing::Shape before = shape();
      std::vector<std::uint32_t> order(points.size());
      std::iota(order.begin(), order.end(), 0U);
      std::shuffle(order.begin(), order.end(), random);
      std::vector<Point> shuffled(points.size());
      for (std::size_t k = 0; k < order.size(); ++k) shuffled[order[k]] = points[k];
      points = shuffled;
      for (auto& [a, b] : segments) {
        a = order[a], b = order[b];
        if (random() % 2 == 0) std::swap(a, b);
      }
      std::shuffle(segments.begin(), segments.end(), random);
      EXPECT_TRUE(shape() == before) << boxes << seed;
    }
  }
  EXPECT_GE(cut, 8u);
}

TEST(ThinCuts, KeepsSmallAnglesThatWereReached) {
  const Input input = testing::input_of(testing::smooth_star(60, 2));
  const Output output = mesh_of(input);
  EXPECT_EQ(output.report.quality.obtuse, 0u);
  EXPECT_GE(output.report.quality.smallest.in_degrees(), 20 - 1e-6);
  Options any = no_obtuse_angle();
  any.min_angle = Angle::degrees(0);
  EXPECT_LT(added(mesh_of(input, any)), added(output));
}

/// A section through the ground whose middle layer pinches out at a fifth of a degree.
Input section() {
  constexpr std::array low{-35.3, -41.4, -40.5, -38.5, -38.1, -37.5, -42.2, -40.2, -43.6};
  constexpr std::array below{-77.9, -76.0, -84.8, -75.6, -76.8, -84.4, -76.9, -77.0, -83.1};
  constexpr std::array top{-2.3, -0.1, -4.3, -1.5, 3.2, -3.2, -0.7, -4.6, 2.4};
  constexpr std::array middle{-28.3, -36.2, -37.0, -36.8};
  const auto at = [](std::size_t k, double height) {
    return Point{500.0 * static_cast<double>(k), height};
  };
  const auto eastward = [&](testing::Loop& loop, const auto& heights, std::size_t first = 0) {
    for (std::size_t k = first; k < heights.size(); ++k) loop.push_back(at(k, heights[k]));
  };
  const auto westward = [&](testing::Loop& loop, const auto& heights) {
    for (std::size_t k = heights.size(); k-- > 0;) loop.push_back(at(k, heights[k]));
  };
  Input input;
  input.polygons.resize(3);
  std::array<testing::Loop, 3> loops;
  eastward(loops[0], below), westward(loops[0], low);
  eastward(loops[1], std::span(low).first(5)), westward(loops[1], middle);
  eastward(loops[2], middle), eastward(loops[2], low, 4), westward(loops[2], top);
  for (std::size_t k = 0; k < 3; ++k) input.polygons[k].rings = {loops[k]};
  return input;
}

TEST(ThinCuts, NeedlesComeOnlyWhereNothingElseMends) {
  const Output output = mesh_of(section());
  EXPECT_EQ(output.report.quality.obtuse, 0u);
  // With a millionth of the smallest angles allowed at once it was 0.00026.
  EXPECT_GT(output.report.quality.smallest.in_degrees(), 0.05);
}

/// What stays obtuse beside narrow slits could become as flat as nobody asked.
TEST(ThinCuts, NoRegionLosesItsBound) {
  const std::vector<Point> points{{0.5, -0.2}, {0.62, -0.2}, {0.62, 1},   {0.6017, 1}, {0.6005, 0},
                                  {0.5995, 0}, {0.6006, 1},  {0.5808, 1}, {0.5805, 0}, {0.5795, 0},
                                  {0.5798, 1}, {0.5608, 1},  {0.5605, 0}, {0.5595, 0}, {0.5598, 1},
                                  {0.5413, 1}, {0.5405, 0},  {0.5395, 0}, {0.5403, 1}, {0.5192, 1},
                                  {0.5205, 0}, {0.5195, 0},  {0.5182, 1}, {0.501, 1},  {0.5005, 0},
                                  {0.4995, 0}, {0.4999, 1},  {0.5, 1},    {0.5, 1.2},  {0.62, 1.2}};
  std::vector<std::array<std::uint32_t, 2>> segments{{27, 28}, {28, 29}, {29, 2}};
  for (std::uint32_t k = 0; k < 28; ++k) segments.push_back({k, (k + 1) % 28});
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.max_angle = Angle::degrees(90);
  const Result<Output> output = cover_mesh(testing::segments_between(points, segments), options);
  ASSERT_TRUE(output.has_value()) << output.error().message;
  for (const RegionReport& region : output->report.regions) EXPECT_TRUE(region.bound_held);
}

TEST(ThinCuts, DependsOnNeitherUnitNorThreads) {
  for (const std::uint64_t seed : {1U, 2U})
    expect_same_for_threads_and_unit(testing::random_cells(12, seed));
  expect_same_for_threads_and_unit(wedge_beside_a_ring());  // by several attempts
}

TEST(ThinCuts, GoesWithBoxMethod) {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    Options options = no_obtuse_angle();
    options.box_method = true;
    options.min_angle = Angle::degrees(0);
    const Output output = mesh_of(testing::random_cells(10, seed), options);
    for (const RegionReport& region : output.report.regions)
      EXPECT_EQ(region.box.negative_couplings, 0u);
    EXPECT_EQ(output.report.quality.obtuse, 0u);
    for (const BoxCut& cut : output.report.box_cuts)
      EXPECT_EQ(std::count(output.pslg.points.begin(), output.pslg.points.end(), cut.at), 1);
  }
}

/// Chords stay as they were cut, and what cuts them stays on the circle; all else is thinned out.
TEST(ThinCuts, KeepsWhatIsOnArcs) {
  std::size_t told = 0, on_arcs = 0;
  for (std::uint64_t seed = 1; seed < 7; ++seed) {
    SCOPED_TRACE(seed);
    const Output output = mesh_of(testing::random_arc_device(seed));
    EXPECT_EQ(output.report.quality.obtuse, 0U);
    told += note_of(output) != nullptr ? 1 : 0;
    const bool has_straight_pieces = std::any_of(
        output.report.notes.begin(), output.report.notes.end(),
        [](const Note& note) { return note.message.find("straight") != std::string::npos; });
    if (has_straight_pieces) continue;
    for (const Segment& s : output.pslg.segments) {
      const ArcCircle* const circle = circle_of(output.pslg, s);
      if (circle == nullptr) continue;
      ++on_arcs;
      for (const VertexId v : {s.a, s.b})
        EXPECT_NEAR(length(output.pslg.points[v.index()] - circle->centre), circle->radius,
                    1e-9 * circle->radius);
    }
  }
  EXPECT_GE(told, 3U);
  EXPECT_GE(on_arcs, 100U);
}

TEST(ThinCuts, VerticesThatSizesAskedForStay) {
  Options options = no_obtuse_angle();
  options.sizes.push_back({"", 0.05});
  EXPECT_EQ(note_of(mesh_of(testing::checker(2, 2, 1), options)), nullptr);
  const std::size_t by_size = mesh_of(testing::checker(2, 2, 1), options).mesh.tri().n_faces();
  options = no_obtuse_angle();
  options.size_field = [](Point) { return 0.05; };
  const Output by_field = mesh_of(testing::checker(2, 2, 1), options);
  EXPECT_EQ(note_of(by_field), nullptr);
  EXPECT_GT(2 * by_field.mesh.tri().n_faces(), by_size);
  options = no_obtuse_angle();
  options.max_angle = Angle::degrees(85);
  EXPECT_EQ(note_of(mesh_of(testing::checker(2, 2, 1), options)), nullptr);
  options = no_obtuse_angle();
  options.split_interfaces.reset();
  EXPECT_EQ(note_of(mesh_of(testing::checker(2, 2, 1), options)), nullptr);
}

TEST(ThinCuts, MoreEffortTakesNoMoreVertices) {
  const Input input = testing::rectangles(5, 4, 3);
  std::size_t last = std::numeric_limits<std::size_t>::max();
  for (const Effort effort : {Effort::fast, Effort::normal}) {
    Options options = no_obtuse_angle();
    options.effort = effort;
    const std::size_t now = added(mesh_of(input, options));
    EXPECT_LE(now, last);
    last = now;
  }
}

// The last obtuse triangle needs angles that are smaller than any before.
TEST(ThinCuts, RightAnglesComeBeforeSmallOnes) {
  const Output output = mesh_of(wedge_beside_a_ring(), no_obtuse_angle());
  EXPECT_EQ(output.report.quality.obtuse, 0u);
}

// Where coordinates are eighths apart, cuts of facing teeth are rounded across each other.
TEST(ThinCuts, KeepsWhatThereIsWhereRoundingWouldCrossSides) {
  testing::Loop teeth{{0.8666, 0.5},     {-5.4885, 9.5},   {-7.5894, 7.125}, {-4.9895, 8.625},
                      {-11.424, 3.75},   {-5.3572, 7.25},  {-10.925, 3},     {-4.8582, 6.375},
                      {-6.0926, 4.625},  {-4.3593, 5.625}, {-8.1935, 2.25},  {-3.8603, 4.75},
                      {-8.5612, 0.875},  {-3.3614, 3.875}, {-5.4623, 1.5},   {-2.8624, 3},
                      {-7.5633, -0.875}, {-2.3635, 2.125}, {-6.1977, -1.25}, {-1.8645, 1.25},
                      {-7.432, -3.125},  {-0.499, 0.875}};
  for (Point& p : teeth) p = {1e9 + p.x, 1e15 + p.y};
  const Output output = mesh_of(testing::input_of(teeth), no_obtuse_angle());
  EXPECT_TRUE(
      std::any_of(output.report.notes.begin(), output.report.notes.end(), [](const Note& note) {
        return note.message.find("rounding would break") != std::string::npos;
      }));
}

}  // namespace
}  // namespace cover
