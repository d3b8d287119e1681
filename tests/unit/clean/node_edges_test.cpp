#include "clean/node_edges.hpp"

#include <gtest/gtest.h>

#include <map>

#include "clean/pslg.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using testing::segments_between;

/// The strands of every line lead from its first end to its last.
void expect_chains(const Network& network) {
  std::map<std::pair<std::uint32_t, Point>, int> ends;  // by line and place
  for (const Strand& s : network.strands) {
    --ends[{s.raw, network.points[s.a]}];
    ++ends[{s.raw, network.points[s.b]}];
  }
  for (std::uint32_t r = 0; r < network.raws.size(); ++r) {
    ++ends[{r, network.raws[r].a}];
    --ends[{r, network.raws[r].b}];
  }
  for (const auto& [end, count] : ends) ASSERT_EQ(count, 0) << "line " << end.first;
}

TEST(NodeEdges, CutsAndKeepsTrackOfLines) {
  std::vector<Change> changes;
  Network network = gather(
      segments_between({{0, 0}, {4, 4}, {0, 4}, {4, 0}, {3, 3}, {5, 5}}, {{0, 1}, {2, 3}, {4, 5}}),
      changes);
  const auto graph = node_edges(network);
  EXPECT_EQ(network.points.size(), 7U);
  EXPECT_EQ(graph.edges.size(), 6U);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    for (const Strand& s : graph.strands(network, e)) {
      const Raw& raw = network.raws[s.raw];
      EXPECT_EQ(raw.a < raw.b, network.points[s.a] < network.points[s.b]);
    }
  }
  const IndexPair shared{1, 4};  // of the two lines that overlap from (3, 3) to (4, 4)
  const auto found = std::find(graph.edges.begin(), graph.edges.end(), shared);
  ASSERT_NE(found, graph.edges.end());
  EXPECT_EQ(graph.strands(network, static_cast<std::size_t>(found - graph.edges.begin())).size(),
            2U);
}

TEST(NodeEdges, RefusesMoreCrossingsThanThereIsMemoryFor) {
  // A box, moved by less than a thousandth of its width again and again.
  Input input;
  for (int k = 0; k < 60'000; ++k) {
    const double x = 1e-3 * k, y = 1e-6 * k * k;
    input.polygons.push_back(
        {{{{x, y}, {x + 1e3, y}, {x + 1e3, y + 1e3}, {x, y + 1e3}}}, "m", "m", {}, 0, {}});
  }
  Report report;
  const auto pslg = make_pslg(input, {}, report);
  ASSERT_FALSE(pslg);
  EXPECT_EQ(pslg.error().code, ErrorCode::out_of_memory);
  EXPECT_NE(pslg.error().message.find("cross each other at more than"), std::string::npos);
}

TEST(NodeEdges, SettlesWhereRoundingMakesNewCrossings) {
  // A pencil of nearly parallel lines through a small box: intersections lie closer than doubles.
  const std::uint64_t seed = testing::test_seed(6);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1e-13);
  std::vector<Point> points;
  std::vector<IndexPair> pairs;
  for (std::uint32_t k = 0; k < 60; ++k) {
    points.push_back({uniform(random), 1 + uniform(random)});
    points.push_back({1 + uniform(random), 2 + uniform(random)});
    pairs.push_back({2 * k, 2 * k + 1});
  }
  std::vector<Change> changes;
  Network network = gather(segments_between(points, pairs), changes);
  const auto graph = node_edges(network);
  EXPECT_TRUE(triangulate_hull(network.points, graph.edges).conflicts.empty());
  ASSERT_NO_FATAL_FAILURE(expect_chains(network));
}

TEST(NodeEdges, EndsWhereANodeIsRoundedBeyondTheEndOfALine) {
  // Seven lines nearly through one point. Where one ends at another, the crossing was rounded to a
  // point on the far side of that end, and the way through it began there: a piece more each pass.
  const std::vector<Point> points{
      {-0.875, 0.22189494409000154}, {1.1326035598656257, -1.0204627865756524},
      {-0.125, -0.1629700667018784}, {-0.024127061695036534, -0.34356154576680126},
      {-0.625, 0.1677212554170422},  {0.7128726074882699, -0.897129566057814},
      {-0.625, 0.8462911009050205},  {0.2459289332937471, -0.8880076319921636},
      {0.375, -0.822268532491488},   {-0.6856531203173853, 0.4980172534682836},
      {-0.75, 0.42628434735871523},  {1.3093557588211528, -1.6857581116920919},
      {0.125, -0.4929613234892326},  {-0.21520634555198986, -0.10326710303405262}};
  std::vector<IndexPair> pairs;
  for (std::uint32_t k = 0; k < 14; k += 2) pairs.push_back({k, k + 1});
  std::vector<Change> changes;
  Network network = gather(segments_between(points, pairs), changes);
  const auto graph = node_edges(network);
  EXPECT_LT(graph.passes, 10);
  EXPECT_TRUE(triangulate_hull(network.points, graph.edges).conflicts.empty());
  ASSERT_NO_FATAL_FAILURE(expect_chains(network));
}

TEST(NodeEdges, CutsAtLonePointsAndKeepsThem) {
  std::vector<Change> changes;
  Network network = gather(
      segments_between({{0, 0}, {4, 0}, {0, 4}, {1, 0}, {3, 0}, {1, 1}, {9, 9}}, {{1, 0}, {0, 2}}),
      changes);
  EXPECT_EQ(network.lone.size(), 4U);
  const auto graph = node_edges(network);
  EXPECT_EQ(network.points.size(), 7U);
  EXPECT_EQ(graph.edges.size(), 4U);
}

TEST(NodeEdges, FindsALonePointOnALineThatRoundingBent) {
  const Point bend{1, 1.0 / 3};              // where (0, 0)-(3, 1) is cut, rounded
  const Point lone{bend.x / 2, bend.y / 2};  // exactly on what the cut leaves of it
  std::vector<Change> changes;
  Network network =
      gather(segments_between({{0, 0}, {3, 1}, {1, -1}, {1, 1}, lone}, {{0, 1}, {2, 3}}), changes);
  const auto graph = node_edges(network);
  EXPECT_EQ(network.points.size(), 6U);
  EXPECT_EQ(graph.edges.size(), 5U);
  EXPECT_TRUE(triangulate_hull(network.points, graph.edges).conflicts.empty());
}

}  // namespace
}  // namespace cover
