#include "cuts/boxes/cut_for_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

/// A triangle above a long side, whose apex sees that at an obtuse angle.
Input flat_triangle() { return testing::input_of({{0, 0}, {8, 0}, {4, 1}}); }

Options with_boxes() {
  Options options;
  options.box_method = true;
  return options;
}

std::vector<Note> notes_on_cuts(const Report& report) {
  std::vector<Note> notes;
  std::copy_if(report.notes.begin(), report.notes.end(), std::back_inserter(notes),
               [](const Note& note) { return note.kind == Note::Kind::box_cut; });
  return notes;
}

TEST(CutForBoxes, AnEncroachedSideIsCutBeforeThereIsAMesh) {
  const Result<Prepared> prepared = prepare(flat_triangle(), with_boxes());
  ASSERT_TRUE(prepared) << prepared.error().message;
  ASSERT_EQ(prepared->report.box_cuts.size(), 1U);
  EXPECT_EQ(prepared->report.box_cuts[0].at, (Point{4, 0}));
  EXPECT_EQ(prepared->report.box_cuts[0].reason, BoxCut::Reason::encroached);
  EXPECT_EQ(prepared->pslg.points.size(), 4U);
}

TEST(CutForBoxes, WithoutTheOptionNothingIsCut) {
  const Result<Prepared> prepared = prepare(flat_triangle());
  ASSERT_TRUE(prepared) << prepared.error().message;
  EXPECT_TRUE(prepared->report.box_cuts.empty());
  EXPECT_EQ(prepared->pslg.points.size(), 3U);
}

TEST(TellBoxCuts, OneNoteTellsThemAllHoweverOftenItIsTold) {
  Report report;
  tell_box_cuts(report);
  EXPECT_TRUE(report.notes.empty()) << "there is nothing to tell";
  report.box_cuts = {{{1, 0}, BoxCut::Reason::encroached, {1, 1}}};
  tell_box_cuts(report);
  report.box_cuts.push_back({{2, 0}, BoxCut::Reason::given_up, {2, 1}});
  tell_box_cuts(report);
  const std::vector<Note> notes = notes_on_cuts(report);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].where, (std::vector<Point>{{1, 0}, {2, 0}}));
  EXPECT_NE(notes[0].message.find("2 points added on segments"), std::string::npos);
}

TEST(CutForBoxes, IsRefusedByNameWhereItCannotBe) {
  for (const auto& change :
       {+[](Options& o) { o.method = Method::almond; },
        +[](Options& o) { o.method = Method::nonobtuse; }, +[](Options& o) { o.hull = true; }}) {
    Options options = with_boxes();
    change(options);
    const auto output = cover_mesh(flat_triangle(), options);
    ASSERT_FALSE(output.has_value());
    EXPECT_EQ(output.error().code, ErrorCode::bad_option);
    EXPECT_NE(output.error().message.find("the box method"), std::string::npos);
  }
}

}  // namespace
}  // namespace cover
