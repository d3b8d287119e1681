#include "clean/arcs/meet_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>

#include <cover/cover_mesh.hpp>

#include "clean/remember_arcs.hpp"
#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"

namespace cover {
namespace {

Point at_angle(double radius, double degrees) {
  const double angle = Angle::degrees(degrees).in_radians();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

void add_line(Input& input, Point a, Point b) {
  InputSegment line;
  line.a = static_cast<std::uint32_t>(input.points.size());
  line.b = line.a + 1;
  line.id = static_cast<long>(input.segments.size());
  line.name = "wall";
  input.points.push_back(a);
  input.points.push_back(b);
  input.segments.push_back(line);
}

/// A ring of eight chords to a circle, and two walls across it, which end on the circles between
/// ends of chords.
Input ring_with_walls(double out = 0) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 8);
  testing::add_circle(input, {0, 0}, 2, 8);
  input.holes.push_back({{0, 0}, 0, 0});
  for (const double degrees : {30.0, 200.0})
    add_line(input, at_angle(1 + out, degrees), at_angle(2 + out, degrees));
  return input;
}

std::size_t regions_of(const Prepared& prepared) { return prepared.table.regions.size(); }

bool has_note(const Report& report, const std::string& part) {
  return std::any_of(report.notes.begin(), report.notes.end(), [&](const Note& note) {
    return note.message.find(part) != std::string::npos;
  });
}

TEST(MeetArcs, WallsThatEndOnArcsPartARing) {
  const Input input = ring_with_walls();
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(regions_of(*prepared), 2U);
  const Pslg& pslg = prepared->pslg;
  EXPECT_EQ(pslg.points, input.points);  // bit for bit, and no others
  EXPECT_EQ(pslg.segments.size(), 8U + 8 + 2 + 4);
  for (const Segment& s : pslg.segments)
    EXPECT_EQ(circle_of(pslg, s) == nullptr, pslg.names[s.name] == "wall");
}

/// As where they end on straight lines.
TEST(MeetArcs, ArcsThatAreSplitAreToldAndRefusedIfStrict) {
  const Input input = ring_with_walls();
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  const std::vector<Change>& changes = prepared->report.changes;
  ASSERT_EQ(changes.size(), 4U);
  for (const Change& change : changes) {
    EXPECT_EQ(change.kind, Change::Kind::split);
    ASSERT_EQ(change.where.size(), 1U);
    EXPECT_EQ(std::count(input.points.end() - 4, input.points.end(), change.where[0]), 1);
    ASSERT_EQ(change.inputs.size(), 1U);
    EXPECT_EQ(change.inputs[0].kind, InputKind::segment);
    const auto id = static_cast<std::size_t>(change.inputs[0].id);
    ASSERT_LT(id, input.segments.size());
    EXPECT_NE(change.message.find(fmt::format("the arc of segment {} from", id)),
              std::string::npos);
    const ArcCircle& circle = input.circles[input.segments[id].circle - 1];
    EXPECT_LT(distance_to_circle(circle, change.where[0]), 1e-15);
  }
  Options strict;
  strict.strict = true;
  const Result<Prepared> refused = prepare(input, strict);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::changed_input);
  EXPECT_EQ(refused.error().inputs.size(), 4U);
}

TEST(MeetArcs, EndsOffByMoreThanRoundingAreTakenByWeldingAlone) {
  const Input input = ring_with_walls(3e-8);
  const Result<Prepared> as_drawn = prepare(input);
  ASSERT_TRUE(as_drawn) << as_drawn.error().message;
  EXPECT_EQ(regions_of(*as_drawn), 1U);
  EXPECT_TRUE(has_note(as_drawn->report, "4 ends of lines are close to an arc and not on it"));
  EXPECT_TRUE(has_note(as_drawn->report, "misses it by 3e-08: --weld 8e-09 closes such gaps"));
  Options options;
  options.weld = 8e-9;
  const Result<Prepared> welded = prepare(input, options);
  ASSERT_TRUE(welded) << welded.error().message;
  EXPECT_EQ(regions_of(*welded), 2U);
  EXPECT_EQ(welded->pslg.points, input.points);
  EXPECT_EQ(welded->report.changes.size(), 4U);
  for (const Change& change : welded->report.changes) {
    EXPECT_EQ(change.kind, Change::Kind::welded);
    EXPECT_EQ(change.inputs.size(), 1U);
  }
  EXPECT_FALSE(has_note(welded->report, "close to an arc"));
}

/// Between circles that are nearer than the tolerance of welding, with a line across.
TEST(MeetArcs, WeldingTakesNoEndForAnotherArcsThanItsOwn) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 8);
  testing::add_circle(input, {0, 0}, 1 + 1e-5, 8);
  add_line(input, at_angle(1, 30), at_angle(1 + 1e-5, 30));
  std::vector<Change> changes;
  std::vector<Note> notes;
  const auto met = meet_arcs(input, 1e-4, changes, notes);
  ASSERT_TRUE(met);
  EXPECT_EQ(met->segments.size(), 19U);  // one end for each circle
  ASSERT_EQ(changes.size(), 2U);
  for (const Change& change : changes) EXPECT_EQ(change.kind, Change::Kind::split);
}

/// Two regions, with a nearly flat arc between them, the upper one a thin layer of many lines. What
/// may be rounding does not grow with the radius.
TEST(MeetArcs, AThinLayerOnAFlatArcKeepsItsPlace) {
  for (const double radius : {1e6, 1e8, 1e9, 1e12}) {
    constexpr double kHeight = 1e-6;
    Input input;
    input.circles = {{{0.5, -radius}, radius}};
    input.points = {{0, -1}, {1, -1}, {1, 0}, {0, 0}};
    for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0}) input.points.push_back({x, kHeight});
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t circle) {
      InputSegment segment;
      segment.a = a;
      segment.b = b;
      segment.id = static_cast<long>(input.segments.size());
      segment.circle = circle;
      input.segments.push_back(segment);
    };
    for (const std::uint32_t k : {0U, 1U, 2U, 3U}) add(k, (k + 1) % 4, k == 2 ? 1 : 0);
    for (const std::uint32_t k : {4U, 5U, 6U, 7U}) add(k, k + 1, 0);
    add(3, 4, 0);
    add(2, 8, 0);
    std::vector<Change> changes;
    std::vector<Note> notes;
    EXPECT_FALSE(meet_arcs(input, 0, changes, notes)) << radius;
    EXPECT_FALSE(meet_arcs(input, 1e-9, changes, notes)) << radius;
    const Result<Prepared> prepared = prepare(input);
    ASSERT_TRUE(prepared) << prepared.error().message;
    EXPECT_EQ(regions_of(*prepared), 2U) << radius;
    EXPECT_TRUE(prepared->report.changes.empty());
  }
}

/// Coordinates that are multiples of 2^-30, so that a shift by 2^20 loses nothing.
TEST(MeetArcs, AnExactShiftChangesNothing) {
  const auto coarse = [](Point p) {
    return Point{std::round(p.x * 0x1p30) / 0x1p30, std::round(p.y * 0x1p30) / 0x1p30};
  };
  Input input;
  testing::add_circle(input, {0, 0}, 1, 8);
  testing::add_circle(input, {0, 0}, 2, 8);
  add_line(input, at_angle(1 + 5e-7, 75), at_angle(1.5, 75));
  for (Point& p : input.points) p = coarse(p);
  Input shifted = input;
  constexpr Vector kShift{0x1p20, 0x1p20};
  for (Point& p : shifted.points) p = p + kShift;
  for (ArcCircle& circle : shifted.circles) circle.centre = circle.centre + kShift;
  for (const double weld : {0.0, 1e-6}) {
    std::vector<Change> changes, changes_shifted;
    std::vector<Note> notes, notes_shifted;
    const auto met = meet_arcs(input, weld, changes, notes);
    const auto met_shifted = meet_arcs(shifted, weld, changes_shifted, notes_shifted);
    ASSERT_EQ(met.has_value(), met_shifted.has_value());
    if (met) {
      EXPECT_EQ(met->segments.size(), met_shifted->segments.size());
    }
    EXPECT_EQ(changes.size(), changes_shifted.size());
    ASSERT_EQ(notes.size(), notes_shifted.size());
    for (std::size_t k = 0; k < notes.size(); ++k)
      EXPECT_EQ(notes[k].where.size(), notes_shifted[k].where.size());
  }
}

/// An end of the ring's second wall lies on the outer circle, next to an end of chords. What is not
/// joined to that is an end of chords of its own, however near.
TEST(MeetArcs, EndsBesideEndsOfChordsMeetTheArc) {
  for (const double degrees : {1e-8, 3e-11, 3e-13}) {
    Input input = ring_with_walls();
    input.points.back() = at_angle(2, 225 - degrees);
    const Result<Prepared> prepared = prepare(input);
    ASSERT_TRUE(prepared) << prepared.error().message;
    EXPECT_EQ(regions_of(*prepared), 2U) << degrees;
    EXPECT_EQ(prepared->pslg.points, input.points);
    EXPECT_FALSE(has_note(prepared->report, "nearly meets"));
  }
}

/// Whatever --weld asks for: ends of chords are on their circles.
TEST(MeetArcs, NoArcIsBentTooFarOffItsCircle) {
  for (const double off : {0.9e-3, 1.1e-3}) {
    Input input;
    testing::add_circle(input, {0, 0}, 1, 8);
    add_line(input, at_angle(1 + off, 30), at_angle(2, 30));
    std::vector<Change> changes;
    std::vector<Note> notes;
    const auto met = meet_arcs(input, 1e-2, changes, notes);
    const bool is_too_far = off > 1e-3;
    ASSERT_EQ(met.has_value(), !is_too_far);
    EXPECT_EQ(changes.empty(), is_too_far);
    ASSERT_EQ(notes.size(), is_too_far ? 1U : 0U);
    if (met) {
      EXPECT_FALSE(find_bad_arcs(*met));
    } else {
      EXPECT_NE(notes[0].message.find("too far off its circle"), std::string::npos);
      EXPECT_EQ(notes[0].where, std::vector<Point>{at_angle(1 + off, 30)});
    }
  }
}

/// A disc of eight chords to its circle, and a slot beside it.
Input disc_and_slot(const std::vector<Point>& ring) {
  Input circle;
  testing::add_circle(circle, {0, 0}, 1, 8);
  Input input;
  input.circles = circle.circles;
  InputPolygon slot;
  slot.rings = {ring};
  slot.material = "copper";
  input.polygons = {testing::disc_of(circle, "iron"), slot};
  return input;
}

TEST(MeetArcs, RingsAndLinesGetEndsOfOthers) {
  Input input =
      disc_and_slot({at_angle(1, 20), at_angle(1.5, 20), at_angle(1.5, 30), at_angle(1, 30)});
  const InputPolygon disc = input.polygons[0], slot = input.polygons[1];
  InputLine contact;
  contact.name = "contact";
  contact.points = {disc.rings[0][0], disc.rings[0][1]};
  contact.circles = {1, 0};
  input.lines = {contact};
  std::vector<Change> changes;
  std::vector<Note> notes;
  const auto met = meet_arcs(input, 0, changes, notes);
  ASSERT_TRUE(met);
  const std::vector<Point> between{slot.rings[0][0], slot.rings[0][3]};
  const auto& ring = met->polygons[0].rings[0];
  ASSERT_EQ(ring.size(), 10U);
  EXPECT_EQ(std::vector<Point>(ring.begin() + 1, ring.begin() + 3), between);
  EXPECT_EQ(met->polygons[0].circles[0], std::vector<std::uint32_t>(10, 1));
  EXPECT_EQ(met->polygons[1].rings, slot.rings);
  ASSERT_EQ(changes.size(), 1U);  // of the contact; of polygons' sides alone it is no change
  EXPECT_EQ(changes[0].kind, Change::Kind::split);
  ASSERT_EQ(changes[0].inputs.size(), 1U);
  EXPECT_EQ(changes[0].inputs[0].kind, InputKind::line);
  EXPECT_EQ(changes[0].where, (std::vector<Point>{between[1], between[0]}));
  const auto& line = met->lines[0].points;
  ASSERT_EQ(line.size(), 4U);
  EXPECT_EQ(std::vector<Point>(line.begin() + 1, line.begin() + 3), between);
}

/// A corner that is named, and given again as the end of an arc, whose double is another one.
TEST(MeetArcs, CornersThatStandTwiceMeetTheCircleTheyAreOn) {
  const Point corner = at_angle(1, 20), end = at_angle(1, 30);
  const Point twin{std::nextafter(corner.x, 2), std::nextafter(corner.y, 0)};
  const Input input = disc_and_slot({corner, twin, at_angle(1.5, 20), at_angle(1.5, 30), end});
  std::vector<Change> changes;
  std::vector<Note> notes;
  const auto met = meet_arcs(input, 0, changes, notes);
  ASSERT_TRUE(met);
  const auto& ring = met->polygons[0].rings[0];
  ASSERT_EQ(ring.size(), 10U);
  EXPECT_TRUE(ring[1] == corner || ring[1] == twin);
  EXPECT_EQ(ring[2], end);
}

TEST(MeetArcs, ArcsThatNothingElseEndsOnStayAsTheyAre) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 8);
  testing::add_circle(input, {0, 0}, 2, 7);
  add_line(input, {-3, 0.3}, {3, 0.3});  // crosses both
  std::vector<Change> changes;
  std::vector<Note> notes;
  EXPECT_FALSE(meet_arcs(input, 0, changes, notes));
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace cover
