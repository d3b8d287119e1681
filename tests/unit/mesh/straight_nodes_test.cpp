#include "mesh/straight_nodes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/curved_mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/write_mesh.hpp>

#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

/// How many triangles of second order fold over, as they are written; with nodes next to the
/// middles, too.
std::pair<std::size_t, std::size_t> folded_now_and_before(const Output& output) {
  WriteOptions options;
  options.order = 2;
  const MeshView view = view_of(output, options);
  std::pair<std::size_t, std::size_t> folded;
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    CurvedTriangle triangle, simple;
    for (std::size_t k = 0; k < 6; ++k) triangle[k] = view.points[view.triangles[t][k]];
    simple = triangle;
    for (std::size_t k = 0; k < 3; ++k)
      simple[3 + k] = midpoint(triangle[k], triangle[(k + 1) % 3]);
    folded.first += has_positive_jacobian(triangle) ? 0 : 1;
    folded.second += has_positive_jacobian(simple) ? 0 : 1;
  }
  return folded;
}

TEST(StraightNodes, SliversFarFromTheOriginAreValid) {
  const Output output = testing::must_mesh(testing::input_of(
      {{1e15, 1e15}, {1e15 + 7, 1e15}, {1e15 + 9.5, 1e15 + 1.25}, {1e15 + 1.125, 1e15 + 0.125}}));
  const auto [now, before] = folded_now_and_before(output);
  EXPECT_EQ(now, 0U);
  EXPECT_GT(before, 0U);
  const CurvedMesh curved = curved_mesh(output);
  EXPECT_FALSE(curved.rounded.empty());
  EXPECT_TRUE(curved.not_valid.empty());
}

/// A strip along a slanted line, some units in the last place wide, in triangles of which each
/// shares its long edges with others.
testing::Loop strip(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Vector along{1 + uniform(random), uniform(random)};
  const double wide = (2 + 30 * uniform(random)) * 0x1p-52;
  testing::Loop lower, upper;
  for (int k = 0; k <= 6; ++k) {
    const double at = k + 0.7 * uniform(random);
    lower.push_back(Point{1, 1} + at * along);
    upper.push_back(Point{1, 1} + (at + 0.3 * uniform(random)) * along + wide * left_normal(along));
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

TEST(StraightNodes, StripsOfSliversAreValidOrNamed) {
  const std::uint64_t seed = testing::test_seed(73);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::size_t meshed = 0, folded_before = 0, folded = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const Result<Output> output = cover_mesh(testing::input_of(strip(seed + k)));
    if (!output) continue;  // crossing, by rounding
    ++meshed;
    const auto [now, before] = folded_now_and_before(*output);
    EXPECT_EQ(now, curved_mesh(*output).not_valid.size());
    folded_before += before;
    folded += now;
  }
  EXPECT_GT(meshed, 300U);
  EXPECT_GT(folded_before, 50U);
  EXPECT_LT(folded, folded_before / 10);
}

TEST(StraightNodes, GridsOfAFewUnitsInTheLastPlaceAreNearlyAllValid) {
  constexpr std::uint32_t kCells = 12;
  std::mt19937_64 random(testing::test_seed(74));
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (std::uint32_t j = 0; j <= kCells; ++j) {
    for (std::uint32_t i = 0; i <= kCells; ++i) {
      const bool is_inside = i % kCells != 0 && j % kCells != 0;
      const auto moved = [&] { return is_inside ? static_cast<double>(random() % 2) : 0; };
      const double x = 0x1p52 + 3 * i + moved(), y = 0x1p52 + 3 * j + moved();
      const std::uint32_t v = (kCells + 1) * j + i;
      points.push_back({x, y});
      if (i > 0) ends.push_back({v - 1, v});
      if (j > 0) ends.push_back({v - kCells - 1, v});
    }
  }
  const Output output = testing::must_mesh(testing::segments_between(points, ends));
  const auto [now, before] = folded_now_and_before(output);
  EXPECT_GT(before, 20U);
  EXPECT_LT(now, before / 5);  // of the smallest triangles there may be none that is valid
  EXPECT_EQ(now, curved_mesh(output).not_valid.size());
}

TEST(StraightNodes, WhereNoDoubleServesTheFileIsRefusedAndTheTriangleNamed) {
  const Output output = testing::must_mesh(
      testing::input_of({{0x1p52, 0x1p52}, {0x1p52 + 1, 0x1p52}, {0x1p52, 0x1p52 + 1}}));
  EXPECT_EQ(curved_mesh(output).not_valid, std::vector<std::uint32_t>{0});
  const testing::TemporaryFolder folder;
  WriteOptions options;
  options.order = 2;
  const Status status = write_mesh(output, folder.path() / "x.vtu", options);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
  EXPECT_EQ(status.error().where.size(), 3U);
  EXPECT_NE(status.error().message.find("so thin that no doubles serve"), std::string::npos);
  options.order = 1;
  EXPECT_TRUE(write_mesh(output, folder.path() / "x.vtu", options));
}

}  // namespace
}  // namespace cover
