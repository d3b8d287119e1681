// Gaps between polygons that open to the outside.
#include "region/gaps/open_gaps.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/inputs/soups.hpp"

namespace cover {
namespace {

using testing::add_polygon;
using testing::clean;
using testing::rectangle;

/// Two municipalities at the far place of a map, with borders of their own.
Input twice_drawn(double apart, double apart_on_top) {
  const double x = 5e5, y = 5.7e6;
  Input input;
  add_polygon(input, rectangle(x, y, x + 1000, y + 800), "west");
  add_polygon(input,
              {{x + 1000 + apart, y},
               {x + 2000, y},
               {x + 2000, y + 800},
               {x + 1000 + apart_on_top, y + 800}},
              "east");
  return input;
}

TEST(OpenGaps, ABorderThatIsDrawnTwiceIsTold) {
  for (const double apart : {1e-3, 1e-2, 1.0}) {
    const Input input = twice_drawn(apart, apart);
    const auto out = clean(input);
    ASSERT_TRUE(out) << out.error().message;
    EXPECT_TRUE(out->tells("polygons leave 1 thin void between them, open at an end")) << apart;
    Options weld;  // what is advised closes it
    weld.weld = 2e-3 * apart;
    const auto closed = clean(input, weld);
    ASSERT_TRUE(closed) << closed.error().message;
    EXPECT_FALSE(closed->tells("thin void"));
    EXPECT_EQ(closed->pslg.segments.size(), 7U);
  }
  EXPECT_TRUE(clean(twice_drawn(1e-3, 1e-3))->tells("with --weld 2e-06"));
  EXPECT_TRUE(clean(twice_drawn(1, 1))->tells("with --weld 2e-03"));
  EXPECT_FALSE(clean(twice_drawn(5, 5))->tells("thin void"));  // a track
}

TEST(OpenGaps, AWedgeIsTold) {
  const auto out = clean(twice_drawn(1, -1));
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->tells("1 thin void between them, open at an end, with an area of 200"));
}

/// The same border with points of its own on both sides, many where the other has few.
TEST(OpenGaps, WallsNeedNoCornersInCommon) {
  Input input;
  const auto border = [](double x, double y) { return Point{x + 30 * std::sin(y / 30), y}; };
  std::vector<Point> west{{0, 800}, {0, 0}}, east{{2000, 0}, {2000, 800}};
  for (int k = 0; k <= 8000; ++k) west.push_back(border(1000, 0.1 * k));
  for (int k = 1000; k >= 0; --k) east.push_back(border(1000.3, 0.8 * k));
  add_polygon(input, west, "west");
  add_polygon(input, east, "east");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->tells("polygons leave 1 thin void between them, open at an end"));
  Input shifted;  // no corner of one is opposite to a corner of the other
  add_polygon(shifted, rectangle(0, 0, 800, 500), "up");
  add_polygon(shifted, rectangle(400, -500, 1200, -0.01), "low");
  EXPECT_TRUE(clean(shifted)->tells(", open at an end, with an area of 4 together"));
}

TEST(OpenGaps, EachOfARowIsTold) {
  Input row;
  for (const double x : {0.0, 20.001, 40.002, 60.003})
    add_polygon(row, rectangle(x, 0, x + 20, 30), "parcel");
  EXPECT_TRUE(clean(row)->tells("polygons leave 3 thin voids between them, open at an end"));
  Input cross;
  for (const double x : {0.0, 100.01})
    for (const double y : {0.0, 100.01})
      add_polygon(cross, rectangle(x, y, x + 100, y + 100), "quarter");
  EXPECT_TRUE(clean(cross)->tells(", open at an end, with an area of 4 together"));
}

TEST(OpenGaps, WhatIsMeantIsNotTold) {
  Input comb;  // slots of 1 : 200 in one polygon
  std::vector<Point> ring;
  for (int k = 0; k < 8; ++k) {
    const double x = 20.5 * k;
    for (const Point p : {Point{x, 0}, {x, 100}, {x + 20, 100}, {x + 20, 0}}) ring.push_back(p);
  }
  ring.insert(ring.end(), {{163.5, -50}, {0, -50}});
  add_polygon(comb, ring, "comb");
  EXPECT_FALSE(clean(comb)->tells("thin void"));

  Input lines;  // a bus, as far apart as wide
  for (int k = 0; k < 8; ++k)
    add_polygon(lines, rectangle(0, 0.4 * k, 1000, 0.4 * k + 0.2), "line");
  EXPECT_FALSE(clean(lines)->tells("thin void"));

  Input parcels;  // along streets of 1 : 50
  for (int k = 0; k < 60; ++k) {
    const double x = 20.0 * (k % 15), y = 36.0 * (k / 15);
    add_polygon(parcels, rectangle(x, y, x + 20, y + 30), "parcel");
  }
  EXPECT_FALSE(clean(parcels)->tells("thin void"));

  Input disks;  // round things that nearly touch
  for (const double at : {0.0, 2.0005, 4.001}) {
    std::vector<Point> round;
    for (int k = 0; k < 500; ++k) {
      const double angle = 2 * std::numbers::pi * k / 500;
      round.push_back({at + std::cos(angle), std::sin(angle)});
    }
    add_polygon(disks, round, "disk");
  }
  EXPECT_FALSE(clean(disks)->tells("thin void"));
}

}  // namespace
}  // namespace cover
