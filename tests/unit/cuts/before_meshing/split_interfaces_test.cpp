#include "cuts/before_meshing/split_interfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/arc_devices.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "target/side_limit.hpp"
#include "unit/sizes/two_rectangles.hpp"

namespace cover {
namespace {

using namespace testing;

double worst_gamma(const Regions& regions) {
  double nu = std::numbers::pi;
  for (const RegionBoundary& b : split_regions(regions.pslg, regions.table)) {
    const Triangulation cdt = triangulate_domain(b.points, b.sides).triangulation;
    for (const SideLimit& side : side_limits(cdt, locate_sides(cdt, b.sides))) {
      nu = std::min(nu, std::atan2(1.0, -side.apex_cot));
    }
  }
  return 180 - nu * 180 / std::numbers::pi;
}

TEST(SplitInterfaces, CutsUntilNothingForcesALargerAngle) {
  Input input = two_rectangles();
  input.points[4] = {1.1, 0.3};  // a notch close to the lower sides
  Regions regions = regions_of(input);
  EXPECT_GT(worst_gamma(regions), 95);
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  const std::size_t before = regions.pslg.points.size();
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  EXPECT_LE(worst_gamma(regions), 90 + 1e-6);
  EXPECT_GT(regions.pslg.points.size(), before);
  EXPECT_LT(regions.pslg.points.size(), 20 * before);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].kind, Note::Kind::cut);
  EXPECT_EQ(notes[0].where.size(), regions.pslg.points.size() - before);
}

TEST(SplitInterfaces, AFootBesideACornerIsMovedAwayFromIt) {
  Regions regions = regions_of(pinch_out());
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  const std::vector<Point> given = regions.pslg.points;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  EXPECT_LE(worst_gamma(regions), 90 + 1e-6);
  EXPECT_GT(regions.pslg.points.size(), given.size());
  // The walls are 0.4 apart there; at the foot it was 0.0028.
  double least = 1;
  for (std::size_t v = given.size(); v < regions.pslg.points.size(); ++v) {
    for (std::size_t u = 0; u < v; ++u)
      least = std::min(least, length(regions.pslg.points[v] - regions.pslg.points[u]));
  }
  EXPECT_GT(least, 0.3);
}

TEST(SplitInterfaces, HalvesTheSegmentsGivenAndThenForcesNothing) {
  Regions regions = regions_of(two_rectangles());
  const std::size_t uncut = regions.pslg.points.size();
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  const std::size_t before = regions.pslg.points.size();
  const std::vector<SegmentId> right{SegmentId{2}};
  const Segment cut = regions.pslg.segments[2];
  const Point middle =
      midpoint(regions.pslg.points[cut.a.index()], regions.pslg.points[cut.b.index()]);
  const Result<bool> given_up =
      halve_segments(regions.pslg, regions.table, options, uncut, right, before);
  ASSERT_TRUE(given_up);
  EXPECT_FALSE(*given_up);
  EXPECT_EQ(regions.pslg.points.size(), before);
  const Result<bool> halved =
      halve_segments(regions.pslg, regions.table, options, uncut, right, 1000);
  ASSERT_TRUE(halved);
  EXPECT_TRUE(*halved);
  EXPECT_GT(regions.pslg.points.size(), before);
  EXPECT_EQ(regions.pslg.points[before], middle);
  EXPECT_LE(worst_gamma(regions), 90 + 1e-6);
}

/// Segments after cutting for sizes alone.
Regions cut_for(const Input& input, std::vector<SizeRule> sizes) {
  Regions regions = regions_of(input);
  Options options;
  options.split_interfaces = Angle::degrees(170);
  options.sizes = std::move(sizes);
  std::vector<Note> notes;
  EXPECT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  return regions;
}

TEST(SplitInterfaces, CutsToTheSizesOfLinesPointsAndRegions) {
  Input input = two_rectangles();
  input.segments[2].name = "anode";  // from (3, 0) to (3, 1)
  input.point_ids = {10, 11, 12, 13, 14, 15};
  const auto added = [&](std::vector<SizeRule> sizes) {
    return cut_for(input, std::move(sizes)).pslg.points.size() - 6;
  };
  // 8 pieces, and from their ends growing ones: ln(3.4) / 0.3 or, to 2, ln(5.8) / 0.3. The side on
  // the left, 1 from there, has 0.425 at its ends and two pieces.
  EXPECT_EQ(added({{"left_right", 0.125, true}}), 7U + 2U * (4U - 1U) + 2U * (6U - 1U) + 1U);
  // Two sides of the right one begin at the fine left one: ln(3.4) / 0.3 pieces.
  EXPECT_EQ(added({{"left", 0.25, false}}), 4U * 3U + 2U * (4U - 1U));
  EXPECT_EQ(added({{"", 0.5, false}}), 5U * 1U + 2U * 3U);
  const Regions fine = cut_for(input, {{"anode", 0.125, true}});
  std::size_t on_anode = 0;
  for (const Point& p : fine.pslg.points) on_anode += p.x == 3 ? 1 : 0;
  EXPECT_EQ(on_anode, 9U);
}

TEST(SplitInterfaces, AWishAtALineHoldsAllAlongIt) {
  Input input = input_of({{0, 0}, {10, 0}, {10, 4}, {0, 4}});
  input.segments[0].name = "anode";
  const Regions cut = cut_for(input, {{"anode", 0.5, true}});
  std::vector<double> along;
  for (const Point& p : cut.pslg.points) {
    if (p.y == 0) along.push_back(p.x);
  }
  std::sort(along.begin(), along.end());
  ASSERT_EQ(along.size(), 21U);
  for (std::size_t k = 0; k < along.size(); ++k)
    EXPECT_NEAR(along[k], 0.5 * static_cast<double>(k), 1e-12);
}

TEST(SplitInterfaces, CutsOfAThinLayerFaceEachOther) {
  // A layer of 0.01 between two blocks, fine on one side only.
  constexpr double kTop = 1.01;
  Input input = segments_between(
      {{0, 0}, {10, 0}, {10, 1}, {0, 1}, {10, kTop}, {0, kTop}, {10, 2}, {0, 2}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}, {5, 3}, {4, 6}, {6, 7}, {7, 5}});
  input.segments[2].name = "fine";
  for (const double other : {0.0, 2.0}) {
    std::vector<SizeRule> sizes{{"fine", 0.5, true}};
    if (other > 0) sizes.push_back({"", other, false});
    const Regions cut = cut_for(input, sizes);
    std::vector<double> low, high;
    for (const Point& p : cut.pslg.points) {
      if (p.y == 1) low.push_back(p.x);
      if (p.y == kTop) high.push_back(p.x);
    }
    std::sort(low.begin(), low.end());
    std::sort(high.begin(), high.end());
    ASSERT_EQ(low.size(), high.size());
    for (std::size_t k = 0; k < low.size(); ++k) EXPECT_NEAR(low[k], high[k], 1e-12);
    // The ends of the layer, 0.01 long, want finer pieces near by. Steps of its own on each side
    // made 44 pieces, some of them 0.0005 long.
    EXPECT_GE(low.size(), 21U);
    EXPECT_LE(low.size(), 30U);
    for (std::size_t k = 1; k < low.size(); ++k) EXPECT_GT(low[k] - low[k - 1], 0.02);
  }
}

TEST(SplitInterfaces, GradesSegmentsThatArePastAFineOne) {
  Input input = two_rectangles();
  input.point_ids = {10, 11, 12, 13, 14, 15};
  const Regions corner = cut_for(input, {{"13", 0.125, true}});  // at (3, 1)
  std::size_t opposite = 0;
  for (const Segment& s : corner.pslg.segments) {
    const Point a = corner.pslg.points[s.a.index()], b = corner.pslg.points[s.b.index()];
    if (std::max(a.x, b.x) <= 1) continue;  // of the left rectangle alone
    const double nearest = std::min(length(a - Point{3, 1}), length(b - Point{3, 1}));
    EXPECT_LE(length(b - a), 1.5 * (0.125 + 0.3 * (nearest + length(b - a) / 2)));
    opposite += a.y == 0 && b.y == 0 ? 1 : 0;
  }
  EXPECT_GT(opposite, 2U);  // pieces of the lower side, which does not meet the corner
}

TEST(SplitInterfaces, ACoarseSizeCutsNoMoreThanNone) {
  const auto cut_ring = [](double size) {  // a ring between circles of 28 and 26 chords
    Input ring;
    add_circle(ring, {0, 0}, 24.75, 28);
    add_circle(ring, {0, 0}, 25.25, 26);
    ring.holes.push_back({0, 0});
    Regions regions = regions_of(ring);
    Options options;
    options.split_interfaces = Angle::degrees(100);
    if (size > 0) options.sizes = {{"", size, false}};
    std::vector<Note> notes;
    EXPECT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
    return regions.pslg.points.size();
  };
  EXPECT_GT(cut_ring(0), 54);
  EXPECT_EQ(cut_ring(50), cut_ring(0));
  EXPECT_LT(cut_ring(3), 3 * cut_ring(0));
}

TEST(SplitInterfaces, CutsStackedThinLayersOnceAndForAll) {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::uint32_t n = 0;
  for (const double y : {0.0, 0.3, 0.301, 0.30101, 0.6}) {
    points.push_back({0, y});
    points.push_back({1, y});
    segments.push_back({n, n + 1});
    if (n > 0) {
      segments.push_back({n - 2, n});
      segments.push_back({n - 1, n + 1});
    }
    n += 2;
  }
  Regions regions = regions_of(testing::segments_between(points, segments));
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.sizes = {{"", 0.05, false}};
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  EXPECT_LE(worst_gamma(regions), 90 + 1e-6);
  EXPECT_LT(regions.pslg.points.size(), 400u) << "15,000 where pieces between feet are wishes";
}

TEST(SplitInterfaces, CutsAThinLayerAcross) {
  Loop layer;  // 1 by 1e-3, its long walls with three vertices each that do not face each other
  for (const double x : {0.0, 0.21, 0.5, 0.83, 1.0}) layer.push_back({x, 0});
  for (const double x : {1.0, 0.7, 0.44, 0.1, 0.0}) layer.push_back({x, 1e-3});
  Regions regions = regions_of(testing::input_of(layer));
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  EXPECT_EQ(regions.pslg.points.size(), 16u);
  EXPECT_LE(worst_gamma(regions), 90);
}

TEST(SplitInterfaces, EndsAtSharpCorners) {
  Regions regions = regions_of(testing::segments_between(  // a third of a degree at the first
      {{0, 0}, {10, 0}, {10, 0.05}, {3, 5}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}));
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  EXPECT_LT(regions.pslg.points.size(), 20000u);
}

/// Feet go from wall to wall up to the tip, each on the piece that the last one left. Each was
/// rounded off that by half a unit in the last place, and the last of them by 15.
TEST(SplitInterfaces, ManyFeetStayOnTheirSegment) {
  const std::vector<Point> corners{{1e9, 1000000000012.7518},
                                   {999999993.4508424, 1000000000012.1918},
                                   {999999993.460519, 1000000000012.1216}};
  Regions regions = regions_of(testing::segments_between(corners, {{0, 1}, {1, 2}, {2, 0}}));
  Options options;
  // Well below 90 degrees: what only rounding makes obtuse is not cut again then.
  options.split_interfaces = Angle::degrees(88);
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  ASSERT_GT(regions.pslg.points.size(), 50U) << "no long row of feet: take another triangle";
  for (const Point& p : regions.pslg.points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector along = corners[(k + 1) % 3] - corners[k];
      nearest = std::min(nearest, std::abs(cross(along, p - corners[k])) / length(along));
    }
    EXPECT_LE(nearest, 3 * spacing_of(corners)) << p.x << ' ' << p.y;
  }
}

TEST(SplitInterfaces, LeavesWhatIsTooThinForRoundedPoints) {
  // Convex pieces between random lines; one is a few units in the last place thick.
  for (const std::uint64_t seed : {202U, 802U}) {
    Options options;
    options.split_interfaces = Angle::degrees(100);
    options.method = Method::almond;
    const Result<Output> output = cover_mesh(random_cells(24, seed), options);
    EXPECT_TRUE(output) << output.error().message;
  }
}

/// The void between two painted regions is 1e-14 wide, and doubles are 5e-7 apart: cuts beside it,
/// rounded, would cross in it, though each region is sound by itself. They are not made.
TEST(SplitInterfaces, CutsOfTwoRegionsDoNotMeetThroughAThinVoid) {
  const double y = 3e9;
  Input input;
  input.source = "thin void";
  const auto paint = [&](std::vector<Point> ring) {
    InputPolygon polygon;
    polygon.rings = {std::move(ring)};
    polygon.material = "a b";
    input.polygons.push_back(std::move(polygon));
  };
  paint({{15.000000000000007, y + 30}, {30, y + 24}, {27, y + 6}});
  paint({{4.4465908125712189e-323, y + 24},
         {17.999999999999993, y + 24},
         {17.999999999999993, y + 15},
         {4.4465908125712189e-323, y + 15}});
  paint({{9.0000000000000036, y},
         {14.999999999999993, y},
         {14.999999999999993, y + 30},
         {9.0000000000000036, y + 30}});
  Options options;
  options.weld = 0;
  options.split_interfaces = Angle::degrees(75);
  const Result<Output> output = cover_mesh(input, options);
  ASSERT_TRUE(output) << output.error().message;
  const std::vector<Note>& notes = output->report.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const Note& note) {
    return note.message.find("would have to be cut too short") != std::string::npos;
  }));
  const Verification found = verify_cover(output->pslg, output->table, triangle_soup(output->mesh));
  EXPECT_EQ(found.violation_count, 0U) << found.violations[0].message;
}

TEST(SplitInterfaces, DoesNothingUnasked) {
  Regions regions = regions_of(two_rectangles());
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, {}, notes));
  EXPECT_EQ(regions.pslg.points.size(), 6u);
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace cover
