#include "clean/arcs/touching_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>

#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"

namespace cover {
namespace {

using testing::add_circle;

constexpr double kTurn = 0.7;  ///< leads to no end of chords

Point at_turn(double radius, double turn = kTurn) {
  return {radius * std::cos(turn), radius * std::sin(turn)};
}

void add_straight(Input& input, Point a, Point b) {
  InputSegment line;
  line.a = static_cast<std::uint32_t>(input.points.size());
  line.b = line.a + 1;
  line.id = static_cast<long>(input.segments.size());
  input.points.push_back(a);
  input.points.push_back(b);
  input.segments.push_back(line);
}

/// The places at which chords of two circles end, or a chord and a straight line.
std::set<Point> common_ends(const Pslg& pslg) {
  std::map<Point, std::set<std::uint32_t>> circles;
  for (const Segment& s : pslg.segments) {
    for (const VertexId v : {s.a, s.b}) circles[pslg.points[v.index()]].insert(s.circle);
  }
  std::set<Point> out;
  for (const auto& [p, numbers] : circles) {
    if (numbers.size() > 1) out.insert(p);
  }
  return out;
}

std::size_t straight_ones(const Pslg& pslg) {
  return static_cast<std::size_t>(
      std::count_if(pslg.segments.begin(), pslg.segments.end(),
                    [&](const Segment& s) { return circle_of(pslg, s) == nullptr; }));
}

struct Joined {
  std::optional<Input> input;
  TouchingCircles circles;
  std::vector<Change> changes;
};

Joined join(const Input& input, double weld = 0) {
  Joined out;
  out.input = join_touching_arcs(input, weld, out.circles, out.changes);
  return out;
}

bool finds_nothing(const Input& input, double weld = 0) {
  const Joined found = join(input, weld);
  return !found.input && found.circles.empty() && found.changes.empty();
}

/// Two circles that touch from outside.
Input two_discs(double gap = 0) {
  Input input;
  add_circle(input, {0, 0}, 2, 31);
  add_circle(input, at_turn(5 + gap), 3, 31);
  return input;
}

TEST(TouchingArcs, CirclesThatTouchFromOutsideShareTheVertexThere) {
  const Result<Prepared> prepared = prepare(two_discs());
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->table.regions.size(), 2U);
  EXPECT_EQ(straight_ones(prepared->pslg), 0U);
  const std::set<Point> ends = common_ends(prepared->pslg);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_LT(length(*ends.begin() - at_turn(2)), 1e-14);
  ASSERT_EQ(prepared->report.changes.size(), 1U);
  const Change& change = prepared->report.changes[0];
  EXPECT_EQ(change.kind, Change::Kind::split);
  EXPECT_TRUE(change.message.starts_with("an arc of segment ")) << change.message;
  EXPECT_NE(change.message.find(" touches an arc of segment "), std::string::npos);
  EXPECT_EQ(change.where, (std::vector<Point>{*ends.begin()}));
  EXPECT_EQ(change.inputs.size(), 2U);
}

TEST(TouchingArcs, AreRefusedIfStrict) {
  Options strict;
  strict.strict = true;
  const Result<Prepared> refused = prepare(two_discs(), strict);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::changed_input);
}

/// The triangle at the tip has two sides equally long.
TEST(TouchingArcs, ChordsBesideThePlaceAreEquallyLong) {
  const Result<Prepared> prepared = prepare(two_discs());
  ASSERT_TRUE(prepared) << prepared.error().message;
  const Pslg& pslg = prepared->pslg;
  const Point place = *common_ends(pslg).begin();
  std::vector<double> lengths;
  for (const Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    if (a == place || b == place) lengths.push_back(length(b - a));
  }
  ASSERT_EQ(lengths.size(), 4U);
  std::sort(lengths.begin(), lengths.end());
  EXPECT_GT(lengths[0] / lengths[1], 7.0 / 8);
  EXPECT_GT(lengths[2] / lengths[3], 7.0 / 8);
}

/// Whatever the chords are, and where they begin.
TEST(TouchingArcs, CirclesThatTouchFromInsideDoNotCross) {
  for (const double inner : {0.3, 1.0, 1.9}) {
    for (const int chords : {9, 24, 60}) {
      for (const double turn : {0.0, 0.05, kTurn}) {
        Input input;
        add_circle(input, {0, 0}, 2, 24, "", turn);
        add_circle(input, at_turn(2 - inner), inner, chords, "", turn);
        const Result<Prepared> prepared = prepare(input);
        ASSERT_TRUE(prepared) << prepared.error().message;
        EXPECT_EQ(prepared->table.regions.size(), 2U) << inner << ' ' << chords << ' ' << turn;
        EXPECT_EQ(straight_ones(prepared->pslg), 0U) << inner << ' ' << chords << ' ' << turn;
        EXPECT_EQ(common_ends(prepared->pslg).size(), 1U) << inner << ' ' << chords << ' ' << turn;
      }
    }
  }
}

TEST(TouchingArcs, ALineThatTouchesIsSplit) {
  Input input;
  add_circle(input, {0, 0}, 2, 31);
  const Vector along = left_normal(at_turn(1) - Point{0, 0});
  add_straight(input, at_turn(2) + (-5) * along, at_turn(2) + 3 * along);
  const Joined found = join(input);
  ASSERT_TRUE(found.input);
  EXPECT_TRUE(found.circles.empty());
  EXPECT_EQ(found.input->segments.size(), 31U + 1 + 2);
  ASSERT_EQ(found.changes.size(), 1U);
  EXPECT_TRUE(
      found.changes[0].message.starts_with("a side of segment 31 touches an arc of segment"))
      << found.changes[0].message;
  EXPECT_LT(length(found.changes[0].where[0] - at_turn(2)), 1e-14);
}

TEST(TouchingArcs, SidesOfPolygonsAreSplitToo) {
  Input circle;
  add_circle(circle, {0.3, 0.7}, 0.7, 50);
  Input input;
  input.circles = circle.circles;
  InputPolygon floor;
  floor.rings = {{{-3, -3}, {3, -3}, {3, 0}, {-3, 0}}};
  floor.material = "floor";
  input.polygons = {floor, testing::disc_of(circle, "pipe")};
  input.polygons[1].id = 1;
  Options unwelded;
  unwelded.weld = 0;
  for (const Options& options : {Options{}, unwelded}) {
    const Result<Prepared> prepared = prepare(input, options);
    ASSERT_TRUE(prepared) << prepared.error().message;
    EXPECT_TRUE(common_ends(prepared->pslg).contains(Point{0.3, 0}));
    ASSERT_EQ(prepared->report.changes.size(), 1U);
    EXPECT_TRUE(prepared->report.changes[0].message.starts_with(
        "a side of polygon 0 touches an arc of polygon 1 at (0.3, 0)"))
        << prepared->report.changes[0].message;
  }
}

TEST(TouchingArcs, NearMissesAreJoinedByWeldingAlone) {
  for (const double gap : {1e-7, -1e-7}) {
    const Input input = two_discs(gap);
    EXPECT_TRUE(finds_nothing(input)) << gap;
    const Joined found = join(input, 2e-8);  // of 10
    ASSERT_TRUE(found.input) << gap;
    ASSERT_EQ(found.changes.size(), 1U);
    EXPECT_EQ(found.changes[0].kind, Change::Kind::welded);
    EXPECT_NE(found.changes[0].message.find(gap > 0 ? "which it misses by 1e-07"
                                                    : "overlapping it by 1e-07"),
              std::string::npos)
        << found.changes[0].message;
  }
}

/// No arc is bent farther off its circle than others.
TEST(TouchingArcs, CirclesAreNotBentFar) {
  for (const double gap : {0.001, 0.01}) {
    Input input;
    const double turn = std::acos(-1) / 8;  // below the middles of chords
    add_circle(input, {0, 0}, 2, 8);
    add_circle(input, at_turn(5 + gap, turn), 3, 8);
    EXPECT_EQ(finds_nothing(input, 2e-3), gap > 0.005) << gap;
  }
}

/// Chords have a sag of 0.01.
TEST(TouchingArcs, ArcsNearerThanTheirSagStayApart) {
  const Result<Prepared> prepared = prepare(two_discs(1e-4));
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->table.regions.size(), 2U);
  EXPECT_TRUE(common_ends(prepared->pslg).empty());
  EXPECT_TRUE(prepared->report.changes.empty());
}

TEST(TouchingArcs, ManyCirclesInARow) {
  Input input;
  for (int k = 0; k < 200; ++k) add_circle(input, at_turn(2.0 * k), 1, 25);
  const Joined found = join(input);
  ASSERT_TRUE(found.input);
  EXPECT_EQ(found.changes.size(), 199U);
  EXPECT_EQ(found.circles.size(), 199U);
}

TEST(TouchingArcs, CirclesOfVeryDifferentRadii) {
  Input input;
  add_circle(input, {0, 0}, 1000, 72);
  add_circle(input, at_turn(1000.01), 0.01, 72);
  add_circle(input, at_turn(999.99, 2), 0.01, 72);
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->table.regions.size(), 3U);
  EXPECT_EQ(common_ends(prepared->pslg).size(), 2U);
}

/// Three pairs that touch at one place, whose points are rounded apart.
TEST(TouchingArcs, CirclesThatTouchAtOnePlaceShareOneVertex) {
  Input input;
  for (const double radius : {1.0, 0.7, 0.3}) add_circle(input, at_turn(1 - radius), radius, 23);
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(common_ends(prepared->pslg).size(), 1U);
  EXPECT_EQ(prepared->table.regions.size(), 3U);
}

/// Circles of drawings begin at angles at which others touch them.
TEST(TouchingArcs, EndsThatAreThereAreTaken) {
  Input one_end;
  add_circle(one_end, {0, 0}, 2, 31, "", kTurn);
  add_circle(one_end, at_turn(5), 3, 31);
  const Joined taken = join(one_end);
  ASSERT_TRUE(taken.input);
  ASSERT_EQ(taken.changes.size(), 1U);
  EXPECT_EQ(taken.changes[0].where[0], one_end.points[0]);
  Input both;
  add_circle(both, {0, 0}, 2, 31, "", kTurn);
  add_circle(both, at_turn(5), 3, 30, "", kTurn);  // has an end opposite to its first
  const Joined one = join(both);
  EXPECT_EQ(one.circles.size(), 1U);
  if (one.input) {  // the ends were rounded apart
    EXPECT_EQ(one.input->points.size(), both.points.size());
    ASSERT_EQ(one.changes.size(), 1U);
    EXPECT_EQ(one.changes[0].kind, Change::Kind::welded);
    Options strict;
    strict.strict = true;
    const Result<Prepared> refused = prepare(both, strict);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("are one now"), std::string::npos)
        << refused.error().message;
  }
  const Result<Prepared> prepared = prepare(both);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(common_ends(prepared->pslg).size(), 1U);
  EXPECT_EQ(straight_ones(prepared->pslg), 0U);
}

/// As a corner of a polygon that lies on a side of another one: nothing is changed by that.
TEST(TouchingArcs, EndsThatLieOnASideAreLeftToIt) {
  Input input;
  add_circle(input, {0, 0}, 2, 4);
  const Point end = input.points[3];
  add_straight(input, {-5, end.y}, {5, end.y});
  EXPECT_TRUE(finds_nothing(input));
}

TEST(TouchingArcs, ArcsThatEndBeforeThePlaceTouchNothing) {
  Input input = two_discs();
  std::erase_if(input.segments, [&](const InputSegment& s) {
    const Point middle = midpoint(input.points[s.a], input.points[s.b]);
    return s.circle == 1 && length(middle - at_turn(2)) < 0.5;
  });
  EXPECT_TRUE(finds_nothing(input));
}

TEST(TouchingArcs, ArcsOfOneCircleOrOneCentreTouchNothing) {
  Input same;
  add_circle(same, {0, 0}, 2, 31);
  add_circle(same, {0, 0}, 2, 30, "", 0.1);
  EXPECT_TRUE(finds_nothing(same));
  Input nearly_same;
  add_circle(nearly_same, {0, 0}, 2, 31);
  add_circle(nearly_same, {1e-13, 0}, 2 - 1e-13, 30, "", 0.1);
  EXPECT_TRUE(finds_nothing(nearly_same));
  Input rings;
  add_circle(rings, {0, 0}, 2, 31);
  add_circle(rings, {0, 0}, 1.999, 31);
  EXPECT_TRUE(finds_nothing(rings));
}

TEST(TouchingArcs, ArcsThatCrossTouchNothing) {
  EXPECT_TRUE(finds_nothing(two_discs(-0.1)));
  EXPECT_TRUE(finds_nothing(two_discs(-1e-9)));
}

}  // namespace
}  // namespace cover
