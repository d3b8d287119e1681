#include "clean/arcs/crossing_chords.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <cover/cover_mesh.hpp>

#include "geom/curves/arc.hpp"
#include "support/inputs/arc_devices.hpp"

namespace cover {
namespace {

constexpr double kHalfAChord = 3.14159265358979 / 72;

/// Two circles about one centre, of 72 chords, those of the inner one turned.
Input two_circles(double inner, double turn = kHalfAChord) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 72, "outer");
  testing::add_circle(input, {0, 0}, inner, 72, "inner", turn);
  return input;
}

TEST(CrossingChords, CirclesSideBySideHaveOneRegionBetweenThem) {
  const Input input = two_circles(0.9995);  // a chord is 0.00095 off its arc
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->table.regions.size(), 2U);
  // The outer ones are halved once, the inner ones not at all.
  EXPECT_EQ(prepared->pslg.segments.size(), 72U * 3);
  for (const Segment& s : prepared->pslg.segments) EXPECT_NE(circle_of(prepared->pslg, s), nullptr);
  EXPECT_TRUE(prepared->report.changes.empty());
  ASSERT_FALSE(prepared->report.notes.empty());
  const Note& note = prepared->report.notes[0];
  EXPECT_EQ(note.kind, Note::Kind::warning);
  EXPECT_TRUE(note.message.starts_with("72 chords crossed chords of other arcs, though"))
      << note.message;
  EXPECT_NE(note.message.find("72 were cut on their arcs, and no longer cross"), std::string::npos)
      << note.message;
  EXPECT_NE(note.message.find("a smaller --chord-angle"), std::string::npos) << note.message;
  EXPECT_EQ(note.where.size(), 72U);
}

TEST(CrossingChords, AThinCoatIsOneRegion) {
  for (const double thickness : {3e-5, 1e-5, 1e-6}) {
    SCOPED_TRACE(thickness);
    Input input;
    testing::add_circle(input, {0, 0}, 1, 24, "outer");
    testing::add_circle(input, {0, 0}, 1 - thickness, 23, "inner");
    const Result<Prepared> prepared = prepare(input);
    ASSERT_TRUE(prepared) << prepared.error().message;
    EXPECT_EQ(prepared->table.regions.size(), 2U);
    EXPECT_LT(prepared->pslg.segments.size(), 2000U);
    ASSERT_FALSE(prepared->report.notes.empty());
    EXPECT_NE(prepared->report.notes[0].message.find(", and no longer cross"), std::string::npos)
        << prepared->report.notes[0].message;
  }
}

// A chord that is halved crosses that of the next circle.
TEST(CrossingChords, ManyThinRingsAreARegionEach) {
  Input input;
  for (int k = 0; k < 20; ++k) testing::add_circle(input, {0, 0}, 1 + 1e-3 * k, 32 + k);
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_EQ(prepared->table.regions.size(), 20U);
}

// None meets the outer one, but the chords of the outer one are looked up for each.
TEST(CrossingChords, ManySmallCirclesThatTouchOneAreLeftAlone) {
  Input input;
  testing::add_circle(input, {0, 0}, 1, 720);
  for (int k = 0; k < 24; ++k) {
    const double turn = k * 3.14159265358979 / 12;
    testing::add_circle(input, {1.02 * std::cos(turn), 1.02 * std::sin(turn)}, 0.02, 16);
  }
  std::vector<Note> notes;
  EXPECT_FALSE(part_crossing_chords(input, {}, notes));
  EXPECT_TRUE(notes.empty());
}

TEST(CrossingChords, CirclesThatAreNearlyOneAreToldAsCrossing) {
  const Input input = two_circles(1 - 1e-10, kHalfAChord / 3);
  std::vector<Note> notes;
  ASSERT_TRUE(part_crossing_chords(input, {}, notes));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].message.find(", of whose pieces "), std::string::npos) << notes[0].message;
  EXPECT_NE(notes[0].message.find(" still cross (arcs are 1e-10 apart)"), std::string::npos)
      << notes[0].message;
}

TEST(CrossingChords, ArcsThatMeetOrLieApartAreLeftAlone) {
  std::vector<Note> notes;
  EXPECT_FALSE(part_crossing_chords(two_circles(0.99), {}, notes));
  Input across;  // circles that cross, and two that touch
  testing::add_circle(across, {0, 0}, 1, 12);
  testing::add_circle(across, {1.2, 0.1}, 1, 17);
  testing::add_circle(across, {-0.5, 0}, 0.5, 6);
  EXPECT_FALSE(part_crossing_chords(across, {}, notes));
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace cover
