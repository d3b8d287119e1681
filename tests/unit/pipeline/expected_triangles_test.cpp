// Estimates against meshes, and sizes that no mesh can have.
#include "pipeline/expected_triangles.hpp"

#include <gtest/gtest.h>

#include <cover/cover_mesh.hpp>

#include "region/pslg.hpp"
#include "region/region_graph.hpp"
#include "support/inputs.hpp"
#include "support/mesh_shape.hpp"
#include "support/shapes.hpp"

namespace cover {
namespace {

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
  EXPECT_GT(expected_in(disk(0.01), with_size(1e-9)), 1e12);
}

TEST(ExpectedTriangles, MoreThanAMeshHoldsAreRefusedBeforeTheWork) {
  const Result<Output> output = cover_mesh(disk(0.01), with_size(1e-9));
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::bad_option);
  EXPECT_NE(output.error().message.find("most of them in region 1 'unnamed'; a mesh holds up to"),
            std::string::npos)
      << output.error().message;
}

}  // namespace
}  // namespace cover
