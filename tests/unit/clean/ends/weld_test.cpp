#include "clean/ends/weld.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <cover/option_ranges.hpp>

#include "base/random.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/soups.hpp"

namespace cover {
namespace {

using testing::add_polygon;
using testing::clean;
using testing::rectangle;

/// Two rectangles side by side; the shared border misses by `gap` and is cut differently.
Input neighbours(double gap) {
  Input input;
  add_polygon(input, rectangle(0, 0, 1, 1), "left");
  add_polygon(input, {{1 + gap, 0}, {2, 0}, {2, 1}, {1 + gap, 1 - gap}, {1 - gap, 0.3}}, "right");
  return input;
}

TEST(Weld, ClosesGapsAndSlivers) {
  for (const double gap : {1e-16, 1e-13, 1e-10, -1e-10}) {
    const auto out = clean(neighbours(gap));
    ASSERT_TRUE(out) << out.error().message;
    EXPECT_EQ(out->table.regions.size(), 2U) << gap;
    EXPECT_EQ(out->table.interfaces.size(), 3U) << gap;
    EXPECT_EQ(out->pslg.points.size(), 7U) << gap;
    EXPECT_NEAR(out->area("left"), 1, 1e-9);
  }
  const auto out = clean(neighbours(1e-10));
  EXPECT_TRUE(out->tells("was moved by 1e-10 onto"));
  EXPECT_TRUE(out->tells("the edge of polygon 1 'left' from (1, 0) to (1, 1) was bent by"));
}

/// Four parcels meet at a cross, each with a corner of its own. Where each of them reaches over the
/// others, their sides hide all corners from each other.
TEST(Weld, UnitesCornersThatAreHiddenBehindTheirLines) {
  constexpr std::array<Point, 4> kSigns{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  const auto parcels = [&](const std::array<Point, 4>& corners) {
    Input input;
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = kSigns[k].x / 2, y = kSigns[k].y / 2;
      add_polygon(input, {corners[k], {x, 0}, {x, y}, {0, y}}, "parcel " + std::to_string(k));
    }
    return input;
  };
  Options options;
  options.weld = 2e-3;
  const auto expect_one_vertex = [&](const std::array<Point, 4>& corners) {
    const auto out = clean(parcels(corners), options);
    ASSERT_TRUE(out) << out.error().message;
    EXPECT_EQ(out->pslg.points.size(), 9U);
    EXPECT_EQ(out->table.regions.size(), 4U);
  };
  expect_one_vertex({{{-0.0006755758050932619, -0.0002663623911815181},
                      {0.00021739534124545773, -0.0007854098840860749},
                      {0.0009668977346732828, -0.0002176728279968925},
                      {3.011341070423875e-05, 0.0005943417448773677}}});
  Random random(7);
  for (int n = 0; n < 200; ++n) {
    std::array<Point, 4> corners;
    for (Point& p : corners) {
      const double far = 0.0005 + 0.0005 * random.unit(), way = 6.28 * random.unit();
      p = {far * std::cos(way), far * std::sin(way)};
    }
    SCOPED_TRACE(n);
    expect_one_vertex(corners);
  }
}

/// A square whose ring comes back to where it began, but for rounding.
Input nearly_closed(double x) {
  Input input;
  add_polygon(input, {{x, 0.1}, {1, 0.1}, {1, 1}, {x, 1}, {x, std::nextafter(0.1, 1)}}, "square");
  return input;
}

TEST(Weld, AnEdgeOfRoundingIsOnePoint) {
  for (const double x : {0.1, -7.0}) {
    const auto out = clean(nearly_closed(x));
    ASSERT_TRUE(out) << out.error().message;
    EXPECT_EQ(out->pslg.points.size(), 4U) << x;
    EXPECT_TRUE(out->tells("was moved by 1.39e-17 onto"));
    Options off;
    off.weld = 0;
    const auto as_drawn = clean(nearly_closed(x), off);
    ASSERT_TRUE(as_drawn) << as_drawn.error().message;
    EXPECT_EQ(as_drawn->pslg.points.size(), 5U) << x;
  }
}

/// A chain of edges that are all of rounding does not shrink to one point, and an edge that is
/// longer than that stays, whatever the tolerance.
TEST(Weld, OnlyEdgesOfRoundingAreShrunk) {
  Input input;
  std::vector<Point> ring{{1, 2}, {0, 2}, {0, 0}};
  for (int k = 0; k < 100; ++k) ring.push_back({1 + k * 0x1p-51, 0});
  add_polygon(input, ring, "chain");
  const auto chain = clean(input);
  ASSERT_TRUE(chain) << chain.error().message;
  EXPECT_GT(chain->pslg.points.size(), 15U);
  EXPECT_LT(chain->pslg.points.size(), 60U);

  Input longer;
  add_polygon(longer, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1e-14}}, "longer");
  Options options;
  options.weld = 1e-3;
  const auto out = clean(longer, options);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->pslg.points.size(), 5U);
}

/// A triangle drawn hundreds of times, each time some units in the last place elsewhere.
Input crowd() {
  const std::array<Point, 3> corners{{{0.872, 0.848}, {0.852, 0.822}, {0.23, 0.536}}};
  Input input;
  for (const Point corner : corners) {
    for (int k = 0; k < 49; ++k)
      input.points.push_back({corner.x + (k % 7 - 3) * 0x1p-53, corner.y + (k / 7 - 3) * 0x1p-53});
  }
  Random random(5);
  for (std::uint32_t k = 0; k < 850; ++k) {
    const auto any = [&](std::uint32_t corner) {
      return 49 * corner + static_cast<std::uint32_t>(random.below(49));
    };
    InputSegment segment;
    segment.a = any(k % 3);
    segment.b = any((k + 1) % 3);
    segment.id = k;
    input.segments.push_back(segment);
  }
  return input;
}

/// Cutting them at all that they pass made 8 million pieces and tens of thousands of regions.
TEST(Weld, ACrowdOfLinesIsRefusedSoonOrBecomesOne) {
  const auto out = clean(crowd());
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().code, ErrorCode::coordinate_out_of_range) << out.error().message;
  EXPECT_NE(out.error().message.find("--weld auto unites"), std::string::npos)
      << out.error().message;

  Options options;
  options.weld = kAutoWeld;
  const auto welded = clean(crowd(), options);
  ASSERT_TRUE(welded) << welded.error().message;
  EXPECT_EQ(welded->pslg.points.size(), 3U);
  EXPECT_EQ(welded->table.regions.size(), 1U);
}

/// A flat triangle in the seam of two rectangles, and one alone: wider than rounding, thinner than
/// the default tolerance.
TEST(Weld, DefaultKeepsRealSlivers) {
  Input input;
  add_polygon(input, rectangle(0, 0, 1, 1), "below");
  add_polygon(input, {{0, 1}, {0.5, 1 + 1e-11}, {1, 1}}, "sliver");
  add_polygon(input, {{0, 1}, {0.5, 1 + 1e-11}, {1, 1}, {1, 2}, {0, 2}}, "above");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 3U);
  EXPECT_NEAR(out->area("sliver"), 0.5e-11, 1e-15);

  Input alone;
  add_polygon(alone, {{0, 0}, {1, 0}, {0.4, 1e-12}}, "sliver");
  const auto one = clean(alone);
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(one->table.regions.size(), 1U);

  // Whoever asks for a tolerance gets it, and is told what became of the polygon.
  Options options;
  options.weld = 0x1p-30;
  const auto welded = clean(alone, options);
  ASSERT_FALSE(welded);
  EXPECT_NE(welded.error().message.find("--weld off"), std::string::npos) << welded.error().message;
}

TEST(Weld, LeavesGapsAboveTheToleranceAndWarns) {
  const auto out = clean(neighbours(1e-7));
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(std::none_of(out->report.changes.begin(), out->report.changes.end(),
                           [](const Change& c) { return c.kind == Change::Kind::welded; }));
  EXPECT_TRUE(out->tells(" apart"));
  Options wide;
  wide.weld = 1e-6;
  EXPECT_EQ(clean(neighbours(1e-7), wide)->table.interfaces.size(), 3U);
}

TEST(Weld, NeverBridgesAThinLayer) {
  const double oxide = 1.2e-9, device = 1e-6;
  Input input;
  add_polygon(input, rectangle(0, -device, device, 0), "Si");
  add_polygon(input, rectangle(0.2e-6, 0, 0.8e-6, oxide), "SiO2");
  add_polygon(input, rectangle(0.2e-6, oxide, 0.8e-6, 0.2e-6), "poly");
  for (const double relative : {0.0, 0x1p-30, 1e-3, 1e-2, 0.5}) {
    Options options;
    options.weld = relative;
    const auto out = clean(input, options);
    ASSERT_TRUE(out) << out.error().message;
    EXPECT_EQ(out->table.regions.size(), 3U) << relative;
    EXPECT_NEAR(out->area("SiO2"), oxide * 0.6e-6, 1e-24) << relative;
  }
}

TEST(Weld, KeepsAThinLayerWhoseCornersMiss) {
  const double oxide = 1.2e-3, miss = 1e-11;
  Input input;
  add_polygon(input, rectangle(0, -1, 1, miss), "Si");
  add_polygon(input, rectangle(miss, 0, 1, oxide), "SiO2");
  add_polygon(input, rectangle(0, oxide - miss, 1 + miss, 1), "poly");
  Options options;
  options.weld = 1e-2;
  const auto out = clean(input, options);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 3U);
  EXPECT_EQ(out->pslg.points.size(), 8U);
  EXPECT_NEAR(out->area("SiO2"), oxide, 1e-9);
}

TEST(Weld, IsOffForSegmentsUnlessAskedFor) {
  const Input input = testing::segments_between({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1e-12, 0}},
                                                {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  EXPECT_EQ(clean(input)->pslg.points.size(), 6U - 1);
  Options weld;
  weld.weld = 1e-9;
  EXPECT_EQ(clean(input, weld)->pslg.points.size(), 4U);
}

TEST(Weld, UnitesCornersOnBothSidesOfALineThatMissesThem) {
  // The line y = 0 between the two corners keeps them out of each other's sight at first.
  Input input;
  add_polygon(input, rectangle(0, -2, 20, 0), "substrate");
  add_polygon(input, rectangle(10.5 - 9e-11, -1, 11, -6e-11), "well");
  add_polygon(input, {{9.5, -8e-11}, {10.4, -0.4}, {10.5, 9e-11}}, "trench");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->pslg.points.size(), 4U + 5 + 1);
  EXPECT_EQ(out->table.regions.size(), 3U);
  EXPECT_FALSE(out->tells("apart"));
}

TEST(Weld, BendsLinesToLonePointsThatMissThem) {
  Input input = testing::segments_between(
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.3, 1e-12}, {1e-12, 0}, {1e6, 1e6}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  input.point_names = {{4, "beside"}, {5, "corner"}, {6, "far"}};
  Options weld;
  weld.weld = 1e-9;  // of the drawing, whatever points there are beside it
  const auto out = clean(input, weld);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->pslg.segments.size(), 5U);
  EXPECT_EQ(out->pslg.points.size(), 6U);
  EXPECT_TRUE(out->tells("was bent by"));
  EXPECT_TRUE(out->tells("was moved by"));
  EXPECT_TRUE(out->table.isolated_points.empty());
  const auto& named = out->pslg.named_points;
  ASSERT_EQ(named.size(), 3U);
  EXPECT_EQ(out->pslg.points[named[0].vertex.index()], (Point{0.3, 1e-12}));
  EXPECT_EQ(out->pslg.points[named[1].vertex.index()], (Point{0, 0}));  // onto which it was moved
  EXPECT_EQ(out->pslg.points[named[2].vertex.index()], (Point{1e6, 1e6}));
}

TEST(Weld, DoesNotDependOnScaleOrOrder) {
  const auto base = clean(neighbours(1e-12));
  ASSERT_TRUE(base);
  for (const double factor : {0x1p30, 0x1p-30}) {
    Input scaled = neighbours(1e-12);
    for (InputPolygon& p : scaled.polygons) {
      for (Point& q : p.rings[0]) q = {q.x * factor, q.y * factor};
    }
    const auto out = clean(scaled);
    ASSERT_TRUE(out);
    ASSERT_EQ(out->pslg.points.size(), base->pslg.points.size());
    for (std::size_t k = 0; k < base->pslg.points.size(); ++k) {
      EXPECT_EQ(out->pslg.points[k].x, base->pslg.points[k].x * factor);
      EXPECT_EQ(out->pslg.points[k].y, base->pslg.points[k].y * factor);
    }
  }
}

}  // namespace
}  // namespace cover
