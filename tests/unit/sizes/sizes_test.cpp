#include "sizes/sizes.hpp"
#include "sizes/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "clean/pslg.hpp"
#include "quality/quality_region.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"
#include "target/report/measure_angles.hpp"
#include "two_rectangles.hpp"
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
    const RegionMesh mesh = quality_region(boundary, {}, {}).mesh;
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
      const auto of_disc =
          static_cast<double>(quality_region(disc, options, {}).mesh.triangles.size());
      const double around_point =
          triangles_between(0, 1, [&](double r) { return std::min(0.1, fine + (growth - 1) * r); });
      EXPECT_NEAR(of_disc, around_point, 0.15 * around_point) << growth << ' ' << fine;
      // From a fine inner boundary.
      RegionBoundary ring = boundary_of({circle(1, 0.1), reversed(circle(0.2, fine))});
      ring.size = 0.1;
      const auto of_ring =
          static_cast<double>(quality_region(ring, options, {}).mesh.triangles.size());
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
    const auto triangles =
        static_cast<double>(quality_region(disc, options, {}).mesh.triangles.size());
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
  const std::size_t region = quality_region(boundary, options, {}).mesh.triangles.size();
  EXPECT_EQ(region, quality_region(boundary, {}, {}).mesh.triangles.size());
  boundary.size = 0.5;
  options.size_field = [](Point) { return 1.0 / 30; };
  EXPECT_EQ(quality_region(boundary, options, {}).mesh.triangles.size(), region);
}

TEST(Sizes, NoWishChangesNothing) {
  RegionBoundary boundary = boundary_of({regular_polygon(40)});
  const std::vector<IndexTriple> plain = quality_region(boundary, {}, {}).mesh.triangles;
  boundary.size = 3;  // longer than any edge can be
  EXPECT_EQ(quality_region(boundary, {}, {}).mesh.triangles, plain);
}

TEST(Sizes, ASizeThatNoEdgeExceedsChangesNothing) {
  Loop inner = regular_polygon(40);
  for (Point& p : inner) p = {0.8 * p.x, 0.8 * p.y};
  std::reverse(inner.begin(), inner.end());
  RegionBoundary ring = boundary_of({regular_polygon(40), inner});
  const std::vector<IndexTriple> plain = quality_region(ring, {}, {}).mesh.triangles;
  ring.size = 0.5;
  EXPECT_EQ(quality_region(ring, {}, {}).mesh.triangles, plain);
  ring.size = 0.1;
  EXPECT_GT(quality_region(ring, {}, {}).mesh.triangles.size(), plain.size());
}

TEST(Sizes, YieldToAnglesBesideLongSides) {
  // Fine triangles beside sides of 0.25 would have angles above 100 degrees.
  for (const double size : {0.1, 0.05, 0.02}) {
    RegionBoundary boundary = square(4);
    boundary.size = size;
    const RegionMesh mesh = quality_region(boundary, {}, {}).mesh;
    const Quality quality = measure_angles(all_points(boundary, mesh), mesh.triangles);
    EXPECT_LE(quality.largest_nu.supplement().in_degrees(), 100.0001) << size;
    EXPECT_GE(quality.smallest.in_degrees(), 18) << size;
    EXPECT_GT(static_cast<double>(mesh.triangles.size()), 0.1 * triangles_for(1, size)) << size;
  }
}

TEST(Sizes, GrowFromAFinePoint) {
  RegionBoundary boundary = boundary_of({regular_polygon(60)}, {{0, 0}});
  boundary.size = 0.1;
  const std::size_t none = quality_region(boundary, {}, {}).mesh.triangles.size();
  for (const Point& p : boundary.points) boundary.size_at.push_back(p == Point{0, 0} ? 0.002 : 0);
  const std::size_t gentle = quality_region(boundary, {}, {}).mesh.triangles.size();
  Options options;
  options.growth = 2;
  const std::size_t steep = quality_region(boundary, options, {}).mesh.triangles.size();
  EXPECT_GT(gentle, steep);
  EXPECT_GT(steep, none);
}

TEST(Sizes, AGrowthAloneCountsFromTheEdgesOfTheBoundary) {
  const RegionBoundary boundary = boundary_of({regular_polygon(200)});
  const double side = 2 * 3.14159265 / 200;
  std::size_t last = quality_region(boundary, {}, {}).mesh.triangles.size();
  for (const double growth : {1.3, 1.1, 1.03}) {
    Options options;
    options.growth = growth;
    const RegionMesh mesh = quality_region(boundary, options, {}).mesh;
    const double wished =
        triangles_between(0, 1, [&](double r) { return side + (growth - 1) * (1 - r); });
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), wished, 0.15 * wished) << growth;
    EXPECT_GT(mesh.triangles.size(), last);
    last = mesh.triangles.size();
  }
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
  options.sizes = {{'"' + line + '"', 0.1, true}, {"\"right\"", 0.3, false}};
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[1].size, 0.3);
  options.sizes = {{"\"wrong\"", 0.1, false}};
  EXPECT_FALSE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
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
  options.sizes = {{"", 0, false, "x + 0.25"}, {"right", 0, false, "0.5"}, {"right", 0.75, false}};
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[0].size, 0);
  EXPECT_EQ(boundaries[1].size, 0.75);
  EXPECT_EQ(boundaries[0].size_function({0, 0}), 0.25);
  EXPECT_EQ(boundaries[1].size_function({0.125, 0}), 0.375);
  EXPECT_EQ(boundaries[1].size_function({2.5, 0}), 0.5);
  EXPECT_EQ(boundaries[1].size_function({-1, 0}), 0.5);  // -0.75 is no wish
  const SizeFunction all = background_of(boundaries[1], options);
  EXPECT_EQ(all({1.25, 0}), 0.5);
  options.size_field = [](Point) { return 0.125; };
  EXPECT_EQ(background_of(boundaries[1], options)({1.25, 0}), 0.125);
  options.sizes.clear();
  ASSERT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_FALSE(boundaries[0].size_function);
  options.sizes = {{"", 0, false, "x - 2"}};
  const Status zero = resolve_sizes(regions.pslg, regions.table, options, boundaries);
  ASSERT_FALSE(zero);
  EXPECT_NE(zero.error().message.find("'x - 2' falls to zero near (2"), std::string::npos);
  options.min_size = 0.01;
  EXPECT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[1].size_function({2, 0.25}), 0.01);  // zero is below the shortest
  options.sizes = {{"", 0, false, "max(0, x - 2)"}};
  EXPECT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  EXPECT_EQ(boundaries[0].size_function({0.5, 0.25}), 0.01);
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

/// The points, in order, that get the size of a rule for `name`, once for every region.
std::vector<Point> points_sized_by(const Regions& regions, const char* name) {
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
}

TEST(Sizes, AtAnInterfaceAContactAndAPoint) {
  Input input = two_rectangles();
  input.segments[2].name = "anode";  // from (3, 0) to (3, 1)
  input.point_ids = {10, 11, 12, 13, 14, 15};
  const Regions regions = regions_of(input);
  const auto at = [&](const char* name) { return points_sized_by(regions, name); };
  using Points = std::vector<Point>;
  EXPECT_EQ(at("left_right"), (Points{{1, 0}, {1, 0}, {1, 1}, {1, 1}}));
  EXPECT_EQ(at("anode"), (Points{{3, 0}, {3, 1}}));
  EXPECT_EQ(at("13"), (Points{{3, 1}}));
  EXPECT_EQ(at("11"), (Points{{1, 0}, {1, 0}}));
}

TEST(Sizes, AtPointsOfAName) {
  Input input = two_rectangles();
  input.segments[2].name = "both";  // from (3, 0) to (3, 1)
  input.segments[0].marker = 7;
  input.points.push_back({0.5, 0.5});
  input.points.push_back({2, 0.5});
  input.point_names = {{6, "well"}, {7, "well"}, {0, "both"}, {7, "7"}};
  const Regions regions = regions_of(input);
  const auto at = [&](const char* name) { return points_sized_by(regions, name); };
  using Points = std::vector<Point>;
  EXPECT_EQ(at("well"), (Points{{0.5, 0.5}, {2, 0.5}}));
  EXPECT_EQ(at("both"), (Points{{0, 0}, {3, 0}, {3, 1}}));
  EXPECT_EQ(at("7"), (Points{{2, 0.5}}));  // neither the point of that number nor the marker
  auto boundaries = split_regions(regions.pslg, regions.table);
  Options options;
  options.sizes = {{"wel", 0.125, true}};
  const Status refused = resolve_sizes(regions.pslg, regions.table, options, boundaries);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("did you mean 'well'?"), std::string::npos);
  EXPECT_EQ(refused.error().message.find("--merge-materials"), std::string::npos);
  options.merge_materials = true;
  const Status merged = resolve_sizes(regions.pslg, regions.table, options, boundaries);
  ASSERT_FALSE(merged);
  EXPECT_NE(merged.error().message.find("; with --merge-materials touching regions"),
            std::string::npos);
}

TEST(Sizes, AtPointsInTheVoidAreRefused) {
  Input input = two_rectangles();
  input.points.push_back({0.5, 0.5});
  input.points.push_back({9, 0.5});
  input.point_names = {{6, "well"}, {7, "well"}, {7, "W out"}};
  const Regions regions = regions_of(input);
  EXPECT_EQ(points_sized_by(regions, "well"), (std::vector<Point>{{0.5, 0.5}}));
  auto boundaries = split_regions(regions.pslg, regions.table);
  Options options;
  options.sizes = {{"W out", 0.125, true}};
  const Status refused = resolve_sizes(regions.pslg, regions.table, options, boundaries);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "size for 'W out': the point of that name lies in the void, at (9, 0.5)");
}

TEST(Sizes, LongSegmentsAreWarnedOfOnce) {
  const Regions regions = regions_of(two_rectangles());
  auto boundaries = split_regions(regions.pslg, regions.table);
  Options options;
  options.sizes = {{"", 0.9, false}};
  const auto warned = [&] {
    EXPECT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
    std::vector<Note> notes;
    warn_of_sizes(regions.pslg, options, boundaries, true, notes);
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

TEST(Sizes, ThoseThatAreLargerThanTheDrawingAreWarnedOf) {
  const Regions regions = regions_of(two_rectangles());
  auto boundaries = split_regions(regions.pslg, regions.table);
  const auto warned = [&](std::vector<SizeRule> sizes, SizeFunction field = {}) {
    Options options;
    options.sizes = std::move(sizes);
    options.size_field = std::move(field);
    EXPECT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
    std::vector<Note> notes;
    warn_of_sizes(regions.pslg, options, boundaries, true, notes);
    return std::any_of(notes.begin(), notes.end(), [](const Note& note) {
      return note.message.starts_with(
          "every size that is asked for is larger than the whole "
          "drawing: the smallest is 4, and all points are within 3.");
    });
  };
  const SizeRule vast{"", 200, false}, left{"left", 4, false};
  EXPECT_TRUE(warned({vast, left}));
  EXPECT_FALSE(warned({vast, left, {"right", 0.5, false}}));
  EXPECT_FALSE(warned({vast, left, {"", 0, false, "1 + x"}}));
  EXPECT_FALSE(warned({vast, left}, [](Point) { return 1.0; }));
  EXPECT_FALSE(warned({}));
}

TEST(Sizes, ExpressionsThatAskForNothingAreWarnedOf) {
  const Regions regions = regions_of(two_rectangles());
  auto boundaries = split_regions(regions.pslg, regions.table);
  Options options;
  options.sizes = {SizeRule{"", 0, false, "sqrt(-1)"}, SizeRule{"", 0, false, "2 + sqrt(x - 2)"}};
  EXPECT_TRUE(resolve_sizes(regions.pslg, regions.table, options, boundaries));
  std::vector<Note> notes;
  warn_of_sizes(regions.pslg, options, boundaries, true, notes);
  // The other one is a size at some vertices, and none at others.
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].message.find("'sqrt(-1)' asks for nothing"), std::string::npos)
      << notes[0].message;
}

}  // namespace
}  // namespace cover
