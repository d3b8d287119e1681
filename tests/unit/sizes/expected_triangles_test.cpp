// Estimates against meshes, and sizes that no mesh can have.
#include "sizes/expected_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>

#include "clean/pslg.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

using testing::Loop;

Options with_size(double size) {
  Options options;
  options.sizes.push_back({"", size, false});
  return options;
}

/// A disk whose sides are about as long as `size`.
Input disk(double size) {
  return testing::input_of(testing::regular_polygon(static_cast<int>(6.3 / size)));
}

double expected_in(const Input& input, const Options& options) {
  Report report;
  const auto pslg = make_pslg(input, options, report);
  const auto table = build_region_table(*pslg, options, report.notes);
  auto boundaries = split_regions(*pslg, *table);
  boundaries.front().size = options.sizes.front().size;
  return expected_triangles(boundaries.front(), options);
}

TEST(ExpectedTriangles, AreAboutThoseOfTheMesh) {
  const Options options = with_size(0.04);
  const Output output = testing::must_mesh(disk(0.04), options);
  const auto triangles = static_cast<double>(output.report.quality.triangles);
  EXPECT_NEAR(expected_in(disk(0.04), options), triangles, 0.5 * triangles);
}

TEST(ExpectedTriangles, SizesGrowFromLongSides) {
  const Input square = testing::input_of(testing::regular_polygon(4));
  EXPECT_LT(expected_in(square, with_size(1e-9)), 1e6);
  EXPECT_GT(expected_in(disk(0.01), with_size(1e-9)), 7e8);
}

TEST(ExpectedTriangles, LongSidesThatWillBeCutDoNotCount) {
  const Input square = testing::input_of(testing::regular_polygon(4));
  Options options = with_size(1e-7);
  options.split_interfaces = Angle::degrees(90);
  EXPECT_GT(expected_in(square, options), 1e8);
  EXPECT_FALSE(cover_mesh(square, options));
}

TEST(ExpectedTriangles, FollowABackgroundThatIsFineInOnePlace) {
  Options options = with_size(1);
  // A cone of sizes around the middle of a triangle.
  const double tip = 1e-5;
  const Loop triangle{{0, 0}, {1, 0}, {0.5, 0.75}};
  options.size_field = [&](Point p) { return tip + 0.3 * std::hypot(p.x - 0.5, p.y - 0.25); };
  options.split_interfaces = Angle::degrees(90);
  const double annulus = 2 * 3.14159265 * 4 / std::sqrt(3.0) / 0.09;  // per factor e of the radius
  const double known = annulus * (std::log(0.25 * 0.3 / tip) - 0.7);
  const double expected = expected_in(testing::input_of(triangle), options);
  EXPECT_GT(expected, 0.7 * known);
  EXPECT_LT(expected, 3 * known) << "a sample at the tip alone says 5e8";
}

TEST(ExpectedTriangles, MoreThanAMeshHoldsAreRefusedBeforeTheWork) {
  const Result<Output> output = cover_mesh(disk(0.01), with_size(1e-9));
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::bad_option);
  EXPECT_NE(output.error().message.find(
                "more triangles than a mesh can hold, 7.2e+08; most of "
                "them in region 1 'unnamed', where edges of 1e-09 are asked for at ("),
            std::string::npos)
      << output.error().message;
}

TEST(ExpectedTriangles, ARegionMustFitIntoMemoryWhereTheMeshNeedNot) {
  const Options options = with_size(1e-3);  // 7e6 triangles: 1.2 GB, and 0.6 while it is meshed
  Report report;
  const auto pslg = make_pslg(disk(1e-3), options, report);
  const auto table = build_region_table(*pslg, options, report.notes);
  auto boundaries = split_regions(*pslg, *table);
  boundaries.front().size = options.sizes.front().size;
  const auto check = [&](Held held, double memory) {
    return check_expected_triangles(*table, boundaries, options, held, memory);
  };
  EXPECT_TRUE(check(Held::all, 1e9));
  EXPECT_FALSE(check(Held::all, 6e8));
  EXPECT_TRUE(check(Held::one_region, 6e8));
  const Status refused = check(Held::one_region, 2e8);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::out_of_memory);
  EXPECT_NE(refused.error().message.find("GB of memory in their largest region alone, and there "
                                         "are 0.2; most of them in region 1"),
            std::string::npos)
      << refused.error().message;
}

}  // namespace
}  // namespace cover
