#include <cover/verify_layers.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

/// A strip from 0 to 3, cut in three at y = 0 where it is called 'gate', and two rows on that: 0.1
/// and 0.2 thick; over the last edge there is but one.
struct Strip {
  Pslg pslg;
  RegionTable table;
  TriangleSoup mesh;

  Strip() {
    Input input = testing::segments_between(
        {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 0.1}, {3, 4}, {0, 4}, {0, 0.3}, {0, 0.1}},
        {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 0}});
    for (std::size_t s = 0; s < 3; ++s) input.segments[s].name = "gate";
    const Result<Prepared> prepared = prepare(input);
    pslg = prepared->pslg;
    table = prepared->table;
    mesh.points = input.points;
    for (const Point& p : {Point{1, 0.1}, {2, 0.1}, {1, 0.3}, {2, 0.3}}) mesh.points.push_back(p);
    mesh.triangles = {{0, 1, 9},   {0, 9, 8},  {1, 2, 10}, {1, 10, 9},  {2, 3, 4},
                      {2, 4, 10},  {8, 9, 11}, {8, 11, 7}, {9, 10, 12}, {9, 12, 11},
                      {10, 4, 12}, {12, 4, 5}, {7, 11, 6}, {11, 12, 6}, {12, 5, 6}};
  }
};

TEST(VerifyLayers, FindsRowsOverEveryEdge) {
  const Strip strip;
  const auto found = verify_layers(strip.pslg, strip.table, strip.mesh, "gate");
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->size(), 1U);
  const LayersFound& layers = found->front();
  EXPECT_EQ(layers.region, RegionId{1});
  EXPECT_EQ(layers.edges, 3U);
  EXPECT_EQ(layers.layered, 3U);
  EXPECT_EQ(layers.fewest, 1);
  EXPECT_EQ(layers.most, 2);
  EXPECT_NEAR(layers.first_least, 0.1, 1e-15);
  EXPECT_NEAR(layers.first_most, 0.1, 1e-15);
  EXPECT_NEAR(layers.thickness, 0.3, 1e-15);
  EXPECT_EQ(layers.triangles, 10U);
  EXPECT_NEAR(layers.largest.in_degrees(), 90, 1e-12);
  EXPECT_EQ(layers.above_90, 0U);
  EXPECT_EQ(layers.negative, 0U);
}

/// Over the last edge no row is as thick as asked: ordinary triangles that happen to be a cell.
TEST(VerifyLayers, WhereSomeRowsAreAsAskedOthersAreNone) {
  Strip strip;
  strip.mesh.points[4].y = strip.mesh.points[10].y = 0.25;
  const std::vector<LayerRule> rules{{"gate", "", 0.1, 2, 1}};
  const auto found = verify_layers(strip.pslg, strip.table, strip.mesh, "gate", {}, rules);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->front().edges, 3U);
  EXPECT_EQ(found->front().layered, 1U);
  EXPECT_NEAR(found->front().first_most, 0.1, 1e-15);
  // Where none is as asked, all are looked at.
  const std::vector<LayerRule> others{{"gate", "", 0.07, 2, 1}};
  const auto all = verify_layers(strip.pslg, strip.table, strip.mesh, "gate", {}, others);
  EXPECT_EQ(all->front().layered, 3U);
  EXPECT_NEAR(all->front().first_most, 0.25, 1e-15);
}

TEST(VerifyLayers, CountsLargeAnglesAndNegativeCouplings) {
  Strip strip;
  strip.mesh.points[9].x = 1.02;  // leans
  const auto found = verify_layers(strip.pslg, strip.table, strip.mesh, "gate");
  ASSERT_TRUE(found);
  EXPECT_GT(found->front().above_90, 0U);
  EXPECT_GT(found->front().largest.in_degrees(), 91);
  EXPECT_GT(found->front().negative, 0U);
}

TEST(VerifyLayers, SaysWhatThereIsNot) {
  const Strip strip;
  const auto line = verify_layers(strip.pslg, strip.table, strip.mesh, "gat");
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().code, ErrorCode::bad_option);
  EXPECT_NE(line.error().message.find("did you mean 'gate'?"), std::string::npos);
  const auto region = verify_layers(strip.pslg, strip.table, strip.mesh, "gate", "nowhere");
  ASSERT_FALSE(region);
  EXPECT_NE(region.error().message.find("no region 'nowhere' is beside the line 'gate'"),
            std::string::npos);
}

TEST(VerifyLayers, FindsWhatWasAskedFor) {
  Input input =
      testing::segments_between({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  input.segments[0].name = "gate";
  Options options;
  options.layers = {{"gate", "", 1e-4, 1.25, 7}};
  options.split_interfaces = Angle::degrees(120);
  options.sizes = {{"gate", 0.05, true}};
  const Output output = testing::must_mesh(input, options);
  const auto found = verify_layers(output.pslg, output.table, triangle_soup(output.mesh), "gate");
  ASSERT_TRUE(found);
  const LayersFound& layers = found->front();
  EXPECT_GE(layers.edges, 16U);
  EXPECT_EQ(layers.layered, layers.edges);
  EXPECT_EQ(layers.most, 7);  // whatever lies above them
  EXPECT_EQ(layers.fewest, 7);
  EXPECT_NEAR(layers.first_least, 1e-4, 1e-13);
  EXPECT_NEAR(layers.first_most, 1e-4, 1e-13);
  EXPECT_EQ(layers.negative, 0U);
}

/// Three rows over a line of one edge: 0.1, 0.2 and `third` thick.
LayersFound three_rows(double third, const std::vector<LayerRule>& rules) {
  Input input =
      testing::segments_between({{0, 0}, {1, 0}, {1, 3}, {0, 3}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  input.segments[0].name = "gate";
  const Result<Prepared> prepared = prepare(input);
  TriangleSoup mesh;
  double height = 0;
  for (const double thick : {0.0, 0.1, 0.2, third}) {
    height += thick;
    mesh.points.push_back({0, height});
    mesh.points.push_back({1, height});
  }
  for (std::uint32_t v = 0; v < 6; v += 2) {
    mesh.triangles.push_back({v, v + 1, v + 3});
    mesh.triangles.push_back({v, v + 3, v + 2});
  }
  const auto found = verify_layers(prepared->pslg, prepared->table, mesh, "gate", {}, rules);
  EXPECT_TRUE(found);
  return found->front();
}

TEST(VerifyLayers, CountsNoRowOfTheRest) {
  EXPECT_EQ(three_rows(0.4, {}).most, 3);
  EXPECT_EQ(three_rows(0.41, {}).most, 2);
  EXPECT_EQ(three_rows(0.4, {{"gate", "", 0.1, 2, 2}}).most, 2);
  EXPECT_EQ(three_rows(0.4, {{"gate", "", 0.1, 2, 0}}).most, 3);
  EXPECT_EQ(three_rows(0.4, {{"gate", "", 0.1, 1.5, 0}}).most, 1);
  EXPECT_EQ(three_rows(0.4, {{"gate", "", 0.3, 1.5, 0}}).most, 3);  // they are of other rules
  EXPECT_EQ(three_rows(0.4, {{"drain", "", 0.1, 1.5, 0}}).most, 3);
  EXPECT_EQ(three_rows(0.4, {{"gate", "elsewhere", 0.1, 2, 0}}).most, 0);
  EXPECT_EQ(three_rows(0.4, {{"gate", "elsewhere", 0.1, 2, 0}}).edges, 1U);
  EXPECT_NEAR(three_rows(0.41, {}).thickness, 0.3, 1e-15);
}

TEST(VerifyLayers, SurvivesAMeshOfSomethingElse) {
  Strip strip;
  strip.mesh.points = {{0, 0}, {1, 0}, {std::nan(""), 1}, {1, 1}};
  strip.mesh.triangles = {{0, 1, 2}, {0, 7, 3}, {0, 1, 3}};
  const auto found = verify_layers(strip.pslg, strip.table, strip.mesh, "gate");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->front().layered, 0U);
}

}  // namespace
}  // namespace cover
