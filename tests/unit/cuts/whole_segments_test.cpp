#include "cuts/whole_segments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>

#include "cuts/cut_segments.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

TEST(WholeSegments, PiecesOfPiecesHaveTheEndsOfTheWhole) {
  const Result<Prepared> prepared = prepare(testing::checker(3, 2, 7));
  ASSERT_TRUE(prepared.has_value());
  Pslg pslg = prepared->pslg;
  RegionTable table = prepared->table;
  const std::size_t uncut = pslg.points.size();
  const auto at = [&](VertexId v) { return pslg.points[v.index()]; };
  std::vector<std::array<Point, 2>> ends;
  for (const Segment& s : pslg.segments) ends.push_back({at(s.a), at(s.b)});
  for (int round = 0; round < 3; ++round) {
    std::vector<SegmentCut> cuts;
    std::vector<std::array<Point, 2>> next;
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      next.push_back(ends[s]);
      if ((s + static_cast<std::size_t>(round)) % 3 == 0) continue;
      cuts.push_back({SegmentId{s}, {midpoint(at(pslg.segments[s].a), at(pslg.segments[s].b))}});
      next.push_back(ends[s]);
    }
    cut_segments(pslg, table, cuts);
    ends = next;
  }
  const WholeSegments whole(pslg, uncut);
  for (std::size_t s = 0; s < pslg.segments.size(); ++s)
    EXPECT_EQ(whole.ends(SegmentId{s}), ends[s]) << s;
}

TEST(WholeSegments, OnlyWhatRoundingTookOffALineIsPutBack) {
  const Point a{1e12, 1e12}, b{1e12 + 3, 1e12 + 1};
  Pslg pslg;
  pslg.points = {a, b};
  pslg.segments = {{VertexId{0}, VertexId{1}}};
  const WholeSegments whole(pslg, 2);
  const auto put = [&](Point p) { return whole.on_whole(SegmentId{0}, p); };
  const double spacing = spacing_of(std::array{a, b});
  const Vector across = (spacing / length(b - a)) * Vector{-(b - a).y, (b - a).x};
  const auto off = [&](Point p) { return std::abs(cross(b - a, p - a)) / length(b - a); };
  const Point middle = midpoint(a, b);
  EXPECT_EQ(put(middle), middle);
  for (const double units : {-15.0, -4.0, 4.0, 15.0}) {
    const Point p = middle + units * across;
    ASSERT_GT(off(p), 3 * spacing);
    EXPECT_LE(off(put(p)), spacing) << units;
  }
  const Point on_arc = middle + 40 * across;
  EXPECT_EQ(put(on_arc), on_arc);
}

}  // namespace
}  // namespace cover
