#include "quality/sizes.hpp"

#include <cmath>
#include <numbers>

#include "mesh_checks.hpp"
#include "quality/quality_region.hpp"
#include "quality/split_interfaces.hpp"
#include "region/pslg.hpp"
#include "region/region_graph.hpp"

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

/// Two rectangles side by side, of materials "left" and "right".
Input two_rectangles() {
  Input input;
  input.points = {{0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {0, 1}};
  const std::uint32_t ends[][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}};
  for (const auto& [a, b] : ends) {
    InputSegment s;
    s.a = a;
    s.b = b;
    input.segments.push_back(s);
  }
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
  EXPECT_EQ(notes[0].kind, Note::Kind::change);
}

TEST(SplitInterfaces, CutsAThinLayerAcross) {
  Input input;  // 1 by 1e-3, its long walls with three vertices each that do not face each other
  for (const double x : {0.0, 0.21, 0.5, 0.83, 1.0}) input.points.push_back({x, 0});
  for (const double x : {1.0, 0.7, 0.44, 0.1, 0.0}) input.points.push_back({x, 1e-3});
  for (std::uint32_t k = 0; k < 10; ++k) {
    InputSegment s;
    s.a = k;
    s.b = (k + 1) % 10;
    input.segments.push_back(s);
  }
  Regions regions = regions_of(input);
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  EXPECT_EQ(regions.pslg.points.size(), 16u);
  EXPECT_LE(worst_gamma(regions), 90);
}

TEST(SplitInterfaces, EndsAtSharpCorners) {
  Input input;
  input.points = {{0, 0}, {10, 0}, {10, 0.05}, {3, 5}};  // a third of a degree at the first
  for (const auto& [a, b] : {std::pair(0U, 1U), {1U, 2U}, {2U, 3U}, {3U, 0U}, {0U, 2U}}) {
    InputSegment s;
    s.a = a;
    s.b = b;
    input.segments.push_back(s);
  }
  Regions regions = regions_of(input);
  Options options;
  options.split_interfaces = Angle::degrees(90);
  std::vector<Note> notes;
  ASSERT_TRUE(split_interfaces(regions.pslg, regions.table, options, notes));
  EXPECT_LT(regions.pslg.points.size(), 20000u);
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
