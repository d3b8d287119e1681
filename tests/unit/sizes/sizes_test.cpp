#include "sizes/sizes.hpp"
#include "sizes/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "clean/pslg.hpp"
#include "cuts/before_meshing/split_interfaces.hpp"
#include "quality/quality_region.hpp"
#include "region/region_graph.hpp"
#include "support/inputs.hpp"
#include "target/measure.hpp"
#include "unit/quality/mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

/// The unit square, its sides cut into n.
RegionBoundary square(int n) {
  Loop loop;
  const Point corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  for (int c = 0; c < 4; ++c) {
    for (int k = 0; k < n; ++k) {
      loop.push_back(corners[c] + (1.0 * k / n) * (corners[c + 1] - corners[c]));
    }
  }
  return boundary_of({loop});
}

double triangles_for(double area, double size) {
  return 4 * area / (std::numbers::sqrt3 * size * size);
}

TEST(Sizes, GiveTheNumberOfTriangles) {
  for (const double part : {0.7, 1.0, 1.4}) {
    RegionBoundary boundary = square(30);
    boundary.size = part / 30;
    const RegionMesh mesh = quality_region(boundary, {}, {});
    const double expected = triangles_for(1, boundary.size);
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), expected, 0.15 * expected) << part;
  }
}

/// The integral of 4 / (sqrt 3 h^2) over the ring between two radii, for sizes that depend on the
/// radius alone.
template <class Size>
double triangles_between(double inner, double outer, Size size) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double r = inner + (outer - inner) * (k + 0.5) / kSteps;
    sum += triangles_for(2 * std::numbers::pi * r * (outer - inner) / kSteps, size(r));
  }
  return sum;
}

Loop circle(double radius, double size) {
  return regular_polygon(static_cast<int>(std::round(2 * std::numbers::pi * radius / size)),
                         radius);
}

TEST(Sizes, GiveTheNumberOfTrianglesWhereTheyGrow) {
  for (const double growth : {1.1, 1.2, 1.3, 1.5}) {
    Options options;
    options.growth = growth;
    for (const double fine : {0.01, 0.002}) {
      // From a point in the middle.
      RegionBoundary disc = boundary_of({circle(1, 0.1)}, {{0, 0}});
      disc.size = 0.1;
      for (const Point& p : disc.points) disc.size_at.push_back(p == Point{0, 0} ? fine : 0);
      const auto of_disc = static_cast<double>(quality_region(disc, options, {}).triangles.size());
      const double around_point =
          triangles_between(0, 1, [&](double r) { return std::min(0.1, fine + (growth - 1) * r); });
      EXPECT_NEAR(of_disc, around_point, 0.15 * around_point) << growth << ' ' << fine;
      // From a fine inner boundary.
      RegionBoundary ring = boundary_of({circle(1, 0.1), reversed(circle(0.2, fine))});
      ring.size = 0.1;
      const auto of_ring = static_cast<double>(quality_region(ring, options, {}).triangles.size());
      const double around_hole = triangles_between(
          0.2, 1, [&](double r) { return std::min(0.1, fine + (growth - 1) * (r - 0.2)); });
      EXPECT_NEAR(of_ring, around_hole, 0.15 * around_hole) << growth << ' ' << fine;
    }
  }
}

TEST(Sizes, GiveTheNumberOfTrianglesOfABackground) {
  const auto linear = [](double r) { return 0.02 + 0.1 * r; };
  const auto wave = [](double r) { return 0.05 + 0.02 * std::sin(6 * r); };
  const auto check = [](auto size, bool restored) {
    RegionBoundary disc = boundary_of({circle(1, size(1))});
    if (restored) {
      for (Point& p : disc.points) p = {p.x + 1024, p.y - 512};
    }
    Options options;
    options.size_field = [&](Point p) {
      return restored ? size(std::hypot(p.x - 1024, p.y + 512)) : size(std::hypot(p.x, p.y));
    };
    const auto triangles = static_cast<double>(quality_region(disc, options, {}).triangles.size());
    const double expected = triangles_between(0, 1, size);
    EXPECT_NEAR(triangles, expected, 0.15 * expected) << size(0) << restored;
  };
  for (const bool restored : {false, true}) {
    check(linear, restored);
    check(wave, restored);
  }
}

TEST(Sizes, AreRefusedWhereCoordinatesCannotHoldThem) {
  // Doubles are an eighth apart there.
  const Input far = transformed(input_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), 1, {1e15, 0});
  Options options;
  options.threads = 1;
  options.sizes = {{"", 5, false}};
  EXPECT_TRUE(cover_mesh(far, options).has_value());
  options.split_interfaces = Angle::degrees(90);
  options.sizes = {{"", 0.5, false}};
  const Result<Output> refused = cover_mesh(far, options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::bad_option);
  EXPECT_NE(refused.error().message.find("0.125 apart"), std::string::npos)
      << refused.error().message;
}

TEST(Sizes, TheSmallestCounts) {
  RegionBoundary boundary = square(30);
  boundary.size = 1.0 / 30;
  Options options;
  options.size_field = [](Point) { return 0.5; };
  const std::size_t region = quality_region(boundary, options, {}).triangles.size();
  EXPECT_EQ(region, quality_region(boundary, {}, {}).triangles.size());
  boundary.size = 0.5;
  options.size_field = [](Point) { return 1.0 / 30; };
  EXPECT_EQ(quality_region(boundary, options, {}).triangles.size(), region);
}

TEST(Sizes, NoWishChangesNothing) {
  RegionBoundary boundary = boundary_of({regular_polygon(40)});
  const std::vector<IndexTriple> plain = quality_region(boundary, {}, {}).triangles;
  boundary.size = 3;  // longer than any edge can be
  EXPECT_EQ(quality_region(boundary, {}, {}).triangles, plain);
}

TEST(Sizes, YieldToAnglesBesideLongSides) {
  // Fine triangles beside sides of 0.25 would have angles above 100 degrees.
  for (const double size : {0.1, 0.05, 0.02}) {
    RegionBoundary boundary = square(4);
    boundary.size = size;
    const RegionMesh mesh = quality_region(boundary, {}, {});
    const Quality quality = measure_angles(all_points(boundary, mesh), mesh.triangles);
    EXPECT_LE(quality.largest_nu.supplement().in_degrees(), 100.0001) << size;
    EXPECT_GE(quality.smallest.in_degrees(), 18) << size;
    EXPECT_GT(static_cast<double>(mesh.triangles.size()), 0.1 * triangles_for(1, size)) << size;
  }
}

TEST(Sizes, GrowFromAFinePoint) {
  RegionBoundary boundary = boundary_of({regular_polygon(60)}, {{0, 0}});
  boundary.size = 0.1;
  const std::size_t none = quality_region(boundary, {}, {}).triangles.size();
  for (const Point& p : boundary.points) boundary.size_at.push_back(p == Point{0, 0} ? 0.002 : 0);
  const std::size_t gentle = quality_region(boundary, {}, {}).triangles.size();
  Options options;
  options.growth = 2;
  const std::size_t steep = quality_region(boundary, options, {}).triangles.size();
  EXPECT_GT(gentle, steep);
  EXPECT_GT(steep, none);
}

TEST(Sizes, AGrowthAloneCountsFromTheEdgesOfTheBoundary) {
  const RegionBoundary boundary = boundary_of({regular_polygon(200)});
  const double side = 2 * 3.14159265 / 200;
  std::size_t last = quality_region(boundary, {}, {}).triangles.size();
  for (const double growth : {1.3, 1.1, 1.03}) {
    Options options;
    options.growth = growth;
    const RegionMesh mesh = quality_region(boundary, options, {});
    const double wished =
        triangles_between(0, 1, [&](double r) { return side + (growth - 1) * (1 - r); });
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), wished, 0.15 * wished) << growth;
    EXPECT_GT(mesh.triangles.size(), last);
    last = mesh.triangles.size();
  }
}

/// Two rectangles side by side, of materials "left" and "right".
Input two_rectangles() {
  Input input = testing::segments_between({{0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {0, 1}},
                                          {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}});
  for (const auto& [x, name] : {std::pair(0.5, "left"), std::pair(2.0, "right")}) {
    RegionSeed seed;
    seed.at = {x, 0.5};
    seed.material = name;
    input.seeds.push_back(seed);
  }
  return input;
}

struct Regions {
  Pslg pslg;
  RegionTable table;
};

Regions regions_of(const Input& input) {
  Report report;
  Regions regions{make_pslg(input, {}, report).value(), {}};
  regions.table = build_region_table(regions.pslg, {}, report.notes).value();
  return regions;
}

TEST(Sizes, AreFoundByName) {
  const Regions regions = regions_of(two_rectangles());
  auto boundaries = split_regions(regions.pslg, regions.table);
  Options options;
  options.sizes = {{"", 0.5, false}, {"right", 0.2, false}};
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[0].size, 0.5);
  EXPECT_EQ(boundaries[1].size, 0.2);
  EXPECT_TRUE(boundaries[0].size_at.empty());
  const std::string line = regions.table.interfaces[0].name;
  options.sizes = {{line, 0.1, true}};
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  options.sizes = {{"wrong", 0.1, false}};
  const Status status = resolve_sizes(regions.pslg, regions.table, options, boundaries);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::bad_option);
}

TEST(Sizes, OfTheInputCount) {
  Input input = two_rectangles();
  input.seeds[0].size = 0.25;
  const Regions regions = regions_of(input);
  auto boundaries = split_regions(regions.pslg, regions.table);
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, {}, boundaries));
  EXPECT_EQ(boundaries[0].size, 0.25);
  EXPECT_EQ(boundaries[1].size, 0);
  Options options;
  options.sizes = {{"", 0.5, false}};
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[0].size, 0.25);
  EXPECT_EQ(boundaries[1].size, 0.5);
  options.input_sizes = false;
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[0].size, 0.5);
}

TEST(Sizes, ExpressionsHoldWhereTheyAreAsked) {
  const Regions regions = regions_of(two_rectangles());
  auto boundaries = split_regions(regions.pslg, regions.table);
  Options options;
  options.sizes = {{"", 0, false, "x - 1"}, {"right", 0, false, "0.5"}, {"right", 0.75, false}};
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[0].size, 0);
  EXPECT_EQ(boundaries[1].size, 0.75);
  EXPECT_EQ(boundaries[0].size_function({1.25, 0}), 0.25);
  EXPECT_EQ(boundaries[1].size_function({1.25, 0}), 0.25);
  EXPECT_EQ(boundaries[1].size_function({2.5, 0}), 0.5);
  EXPECT_EQ(boundaries[1].size_function({0.5, 0}), 0.5);  // -0.5 is no wish
  const SizeFunction all = background_of(boundaries[1], options);
  EXPECT_EQ(all({1.25, 0}), 0.25);
  options.size_field = [](Point) { return 0.125; };
  EXPECT_EQ(background_of(boundaries[1], options)({1.25, 0}), 0.125);
  options.sizes.clear();
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_FALSE(boundaries[0].size_function);
  options.sizes = {{"", 0, false, "x -"}};
  EXPECT_EQ(resolve_sizes(regions.pslg, regions.table, options, boundaries).error().code,
            ErrorCode::bad_option);
}

/// A mesh that an expression grades has as many triangles as one that a function grades alike; only
/// the region that is named has them.
TEST(Sizes, AnExpressionGradesTheMesh) {
  Options options;
  options.sizes = {{"right", 0, false, "0.02 + 0.1*abs(x - 2)"}};
  options.split_interfaces = Angle::degrees(120);
  const Result<Output> output = cover_mesh(two_rectangles(), options);
  ASSERT_TRUE(output) << output.error().message;
  // The integral of 4 / (sqrt(3) h^2).
  const double expected = 4 / std::sqrt(3.0) * 2 * (1 / 0.02 - 1 / 0.12) / 0.1;
  const auto triangles = [&](std::size_t region) {
    return static_cast<double>(output->report.regions[region].quality.triangles);
  };
  EXPECT_GT(triangles(1), 0.7 * expected);
  EXPECT_LT(triangles(1), 1.6 * expected);
  EXPECT_LT(triangles(0), 0.2 * expected);
}

TEST(Sizes, AtAnInterfaceAContactAndAPoint) {
  Input input = two_rectangles();
  input.segments[2].name = "anode";  // from (3, 0) to (3, 1)
  input.point_ids = {10, 11, 12, 13, 14, 15};
  const Regions regions = regions_of(input);
  const auto at = [&](const char* name) {
    auto boundaries = split_regions(regions.pslg, regions.table);
    Options options;
    options.sizes = {{name, 0.125, true}};
    EXPECT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries)) << name;
    std::vector<Point> where;
    for (const RegionBoundary& boundary : boundaries) {
      for (std::size_t v = 0; v < boundary.size_at.size(); ++v) {
        if (boundary.size_at[v] == 0) continue;
        EXPECT_EQ(boundary.size_at[v], 0.125);
        where.push_back(boundary.points[v]);
      }
    }
    std::sort(where.begin(), where.end());
    return where;
  };
  using Points = std::vector<Point>;
  EXPECT_EQ(at("left_right"), (Points{{1, 0}, {1, 0}, {1, 1}, {1, 1}}));
  EXPECT_EQ(at("anode"), (Points{{3, 0}, {3, 1}}));
  EXPECT_EQ(at("13"), (Points{{3, 1}}));
  EXPECT_EQ(at("11"), (Points{{1, 0}, {1, 0}}));
}

TEST(Sizes, LongSegmentsAreWarnedOfOnce) {
  const Regions regions = regions_of(two_rectangles());
  auto boundaries = split_regions(regions.pslg, regions.table);
  Options options;
  options.sizes = {{"", 0.9, false}};
  const auto warned = [&] {
    EXPECT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
    std::vector<Note> notes;
    warn_of_sizes(regions.pslg, options, boundaries, notes);
    return notes;
  };
  const std::vector<Note> notes = warned();
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].message.find("2 segments are longer"), std::string::npos) << notes[0].message;
  EXPECT_NE(notes[0].message.find("up to 2 "), std::string::npos) << notes[0].message;
  options.sizes = {{"", 1.5, false}};
  EXPECT_TRUE(warned().empty());
  options.method = Method::almond;
  EXPECT_EQ(warned().size(), 1U);
}

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

TEST(SplitInterfaces, HalvesTheSegmentsGivenAndThenForcesNothing) {
  Regions regions = regions_of(two_rectangles());
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  const std::size_t before = regions.pslg.points.size();
  const std::vector<SegmentId> right{SegmentId{2}};
  const Segment cut = regions.pslg.segments[2];
  const Point middle =
      midpoint(regions.pslg.points[cut.a.index()], regions.pslg.points[cut.b.index()]);
  const Result<bool> given_up = halve_segments(regions.pslg, regions.table, options, right, before);
  ASSERT_TRUE(given_up);
  EXPECT_FALSE(*given_up);
  EXPECT_EQ(regions.pslg.points.size(), before);
  const Result<bool> halved = halve_segments(regions.pslg, regions.table, options, right, 1000);
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
  EXPECT_EQ(added({{"left", 0.25, false}}), 4U * 3U);
  EXPECT_EQ(added({{"", 0.5, false}}), 5U * 1U + 2U * 3U);
  const Regions fine = cut_for(input, {{"anode", 0.125, true}});
  std::size_t on_anode = 0;
  for (const Point& p : fine.pslg.points) on_anode += p.x == 3 ? 1 : 0;
  EXPECT_EQ(on_anode, 9U);
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
