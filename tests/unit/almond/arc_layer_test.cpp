#include "almond/arc_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stages.hpp"

namespace cover {
namespace {

using testing::square;
using testing::Stages;

TEST(LayArcs, NeighboursInASquareMeetOnTheDiagonals) {
  const Stages s(square());
  const ArcLayer arcs = lay_arcs(s.cdt, s.almonds, 1);
  EXPECT_EQ(arcs.points.size(), 8U);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(arcs.of(k).size(), 4U);
  for (std::size_t v = 4; v < 8; ++v) {
    EXPECT_NEAR(std::abs(arcs.points[v].x - 0.5), std::abs(arcs.points[v].y - 0.5), 1e-15);
  }
}

TEST(LayArcs, AnEquilateralTriangleHasOneMeeting) {
  // The three capped arcs pass through one point.
  const Stages s(testing::boundary_of({{{0, 0}, {1, 0}, {0.5, 0.8}}}));
  const ArcLayer arcs = lay_arcs(s.cdt, s.almonds, 1);
  std::vector<std::uint32_t> meetings;
  for (const ArcVertex& v : arcs.vertices) {
    if (v.vertex >= 3) meetings.push_back(v.vertex);
  }
  ASSERT_EQ(meetings.size(), 3U);
  EXPECT_EQ(meetings[0], meetings[1]);
  EXPECT_EQ(meetings[0], meetings[2]);
}

TEST(LayArcs, WhatASideHidesDoesNotMeet) {
  // Two facing sides with a wall between them: their arcs would cross without it.
  const auto boundary =
      testing::boundary_of({{{0, 0}, {1, 0}, {1, 0.4}, {0, 0.4}}, {{0.05, 0.2}, {0.95, 0.2}}});
  const Stages s(boundary);
  const ArcLayer arcs = lay_arcs(s.cdt, s.almonds, 1);
  for (std::size_t v = boundary.points.size(); v < arcs.points.size(); ++v) {
    const Point p = arcs.points[v];
    EXPECT_FALSE(std::abs(p.y - 0.2) < 1e-12 && p.x > 0.05 && p.x < 0.95) << p.x;
  }
}

}  // namespace
}  // namespace cover
