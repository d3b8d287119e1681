#include "cuts/periodic/mirror_cuts.hpp"

#include <gtest/gtest.h>

#include "geom/isometry.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Three parallel segments; the second is the first one moved by (0, 1) and turned round, the third
/// the second moved by (0, 1); then one of its own.
Pslg ladder() {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}, {0, 5}, {1, 5}};
  for (std::uint32_t s = 0; s < 4; ++s)
    pslg.segments.push_back({VertexId{2 * s}, VertexId{2 * s + 1}});
  pslg.isometries = {translation_by({0, 1}), translation_by({0, 1})};
  pslg.periodic = {{SegmentId{0U}, SegmentId{1U}, true, 0},
                   {SegmentId{1U}, SegmentId{2U}, true, 1}};
  return pslg;
}

TEST(PeriodicClasses, ACutGoesToAllImagesInTheirDirections) {
  const PeriodicClasses classes(ladder());
  EXPECT_TRUE(classes.is_periodic(SegmentId{2U}));
  EXPECT_FALSE(classes.is_periodic(SegmentId{3U}));
  const auto cuts =
      classes.with_images({{SegmentId{1U}, {{0.75, 1}, {0.25, 1}}}, {SegmentId{3U}, {{0.5, 5}}}});
  ASSERT_EQ(cuts.size(), 4U);
  EXPECT_EQ(cuts[0].points, (std::vector<Point>{{0.25, 0}, {0.75, 0}}));
  EXPECT_EQ(cuts[1].points, (std::vector<Point>{{0.75, 1}, {0.25, 1}}));
  EXPECT_EQ(cuts[2].points, (std::vector<Point>{{0.25, 2}, {0.75, 2}}));
  EXPECT_EQ(cuts[3].points, (std::vector<Point>{{0.5, 5}}));
}

TEST(PeriodicClasses, OfSeveralCutsTheOneWithMostPointsCounts) {
  const PeriodicClasses classes(ladder());
  const auto cuts = classes.with_images(
      {{SegmentId{0U}, {{0.5, 0}}}, {SegmentId{2U}, {{0.25, 2}, {0.5, 2}, {0.75, 2}}}});
  ASSERT_EQ(cuts.size(), 3U);
  for (const SegmentCut& cut : cuts) EXPECT_EQ(cut.points.size(), 3U);
}

TEST(PeriodicClasses, PiecesStayPairs) {
  Pslg pslg = ladder();
  pslg.point_ids.resize(pslg.points.size());
  pslg.point_markers.resize(pslg.points.size());
  RegionTable table;
  table.sides.resize(pslg.segments.size());
  const auto cuts = PeriodicClasses(pslg).with_images({{SegmentId{2U}, {{0.25, 2}, {0.5, 2}}}});
  cut_segments(pslg, table, cuts);
  ASSERT_EQ(pslg.periodic.size(), 6U);
  for (const SegmentPair& pair : pslg.periodic) {
    const Segment& from = pslg.segments[pair.from.index()];
    const Segment& to = pslg.segments[pair.to.index()];
    const Point a = pslg.points[from.a.index()], b = pslg.points[to.b.index()];
    EXPECT_TRUE(pair.turned);
    EXPECT_EQ(b, a + Vector({0, 1}));
  }
  // Cut on one side only: no pair any more.
  cut_segments(pslg, table, std::vector<SegmentCut>{{SegmentId{0U}, {{0.125, 0}}}});
  EXPECT_EQ(pslg.periodic.size(), 5U);
}

}  // namespace
}  // namespace cover
