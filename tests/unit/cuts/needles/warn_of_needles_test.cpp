#include "cuts/needles/warn_of_needles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cuts/cut_segments.hpp"
#include "geom/vector.hpp"
#include "method/boundaries_with_wishes.hpp"
#include "support/inputs/inputs.hpp"
#include "unit/cuts/after_meshing/prepared_work.hpp"

namespace cover {
namespace {

/// What is told of a mesh of `input` whose segment `s` was cut so far from its end a.
std::vector<Note> told_of_cut(const Input& input, std::size_t s, double from_a,
                              const Options& options = {}) {
  Work work = meshed(input, options);
  const Segment segment = work.pslg.segments[s];
  const Point a = work.pslg.points[segment.a.index()], b = work.pslg.points[segment.b.index()];
  const std::vector<SegmentCut> cuts{{SegmentId{s}, {a + from_a / length(b - a) * (b - a)}}};
  cut_segments(work.pslg, work.table, cuts);
  work.boundaries = *boundaries_with_wishes(work.pslg, work.table, options);
  Result<std::vector<RegionMesh>> meshes = mesh_regions(work.boundaries, options, {});
  EXPECT_TRUE(meshes) << meshes.error().message;
  work.meshes = *std::move(meshes);
  std::vector<Note> notes;
  warn_of_needles(work, options, notes);
  return notes;
}

Input square() { return testing::input_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}}); }

TEST(WarnOfNeedles, TellsOfACutThatIsFarNearerToACornerThanAnythingWas) {
  const std::vector<Note> notes = told_of_cut(square(), 0, 1e-6);
  ASSERT_EQ(notes.size(), 2u);
  for (const Note& note : notes) {
    EXPECT_EQ(note.kind, Note::Kind::warning);
    ASSERT_EQ(note.where.size(), 1u);
  }
  EXPECT_NE(notes[0].message.find("far below what the input forces"), std::string::npos);
  EXPECT_NE(notes[0].message.find("none there or beside it was below 45"), std::string::npos);
  EXPECT_NE(notes[1].message.find("two vertices of region 1 are 1e-06 apart"), std::string::npos);
  EXPECT_LT(length(notes[1].where[0] - Point{0, 0}), 1e-5);
}

TEST(WarnOfNeedles, SaysNothingOfCutsAsFarApartAsTheRest) {
  EXPECT_TRUE(told_of_cut(square(), 0, 4).empty());
}

TEST(WarnOfNeedles, SaysNothingOfShortPiecesThatSizesAskFor) {
  Options by_size, by_field;
  by_size.sizes = {{"", 5, false}};
  by_field.size_field = [](Point) { return 5.0; };
  for (const Options& options : {by_size, by_field}) {
    const std::vector<Note> notes = told_of_cut(square(), 0, 1e-6, options);
    EXPECT_TRUE(std::none_of(notes.begin(), notes.end(), [](const Note& note) {
      return note.message.find("two vertices") != std::string::npos;
    }));
  }
}

TEST(WarnOfNeedles, SaysNothingWhereTheRegionBesideIsAsNarrow) {
  // Beyond the right side lies a layer a millionth thick.
  const Input input = testing::segments_between(
      {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {10.000001, 0}, {10.000001, 10}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 2}});
  EXPECT_TRUE(told_of_cut(input, 1, 1e-6).empty());
}

}  // namespace
}  // namespace cover
