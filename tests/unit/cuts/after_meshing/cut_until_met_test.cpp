// The rounds of cutting by themselves: what they leave, what they keep in step, when they rest.
#include "cuts/after_meshing/cut_until_met.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "prepared_work.hpp"
#include "region/whole_mesh.hpp"
#include "support/inputs/inputs.hpp"
#include "without_obtuse.hpp"

namespace cover {
namespace {

std::size_t obtuse(const Work& work) {
  std::size_t sum = 0;
  for (const RegionMesh& mesh : work.meshes) sum += mesh.report.quality.obtuse;
  return sum;
}

Input cells() { return testing::random_cells(12, 23); }

TEST(CutUntilMet, FewerTrianglesAreLeftAndAllPartsStayInStep) {
  Work work = meshed(cells(), no_obtuse_angle());
  const std::size_t before = obtuse(work), points = work.pslg.points.size();
  ASSERT_GT(before, 0U);
  ASSERT_TRUE(cut_until_met(work, no_obtuse_angle(), {}));
  EXPECT_LT(obtuse(work), before);
  EXPECT_GT(work.pslg.points.size(), points);
  EXPECT_EQ(work.report.input_points, points) << "cuts do not count";
  EXPECT_TRUE(is_sound(work));
  ASSERT_EQ(work.meshes.size(), work.table.regions.size());
  ASSERT_EQ(work.boundaries.size(), work.table.regions.size());
}

TEST(CutUntilMet, ANoteTellsEveryPointThatWasAdded) {
  Work work = meshed(cells(), no_obtuse_angle());
  const std::size_t points = work.pslg.points.size(), notes = work.report.notes.size();
  ASSERT_TRUE(cut_until_met(work, no_obtuse_angle(), {}));
  ASSERT_EQ(work.report.notes.size(), notes + 1);
  const Note& note = work.report.notes.back();
  EXPECT_EQ(note.kind, Note::Kind::cut);
  ASSERT_EQ(note.where.size(), work.pslg.points.size() - points);
  EXPECT_TRUE(std::equal(note.where.begin(), note.where.end(),
                         work.pslg.points.begin() + static_cast<std::ptrdiff_t>(points)));
}

TEST(CutUntilMet, WhereTheTargetIsMetNothingIsCut) {
  Options easy = no_obtuse_angle();
  easy.max_angle = Angle::degrees(179);
  Work work = meshed(testing::checker(2, 4, 1), easy);
  const std::vector<Point> points = work.pslg.points;
  const std::vector<IndexTriple> triangles = work.meshes[0].triangles;
  const std::size_t notes = work.report.notes.size();
  ASSERT_TRUE(cut_until_met(work, easy, {}));
  EXPECT_EQ(work.pslg.points, points);
  EXPECT_EQ(work.meshes[0].triangles, triangles);
  EXPECT_EQ(work.report.notes.size(), notes);
}

TEST(CutUntilMet, RestsUnlessSegmentsMayBeCutByTheQualityMethodWithoutLayers) {
  Options whole = no_obtuse_angle(), almond = no_obtuse_angle(), layers = no_obtuse_angle();
  whole.split_interfaces.reset();
  almond.method = Method::almond;
  layers.layers = {{"1-2", "", 0.01, 1, 1}};
  for (const Options& options : {whole, almond, layers}) {
    Work work = meshed(cells(), no_obtuse_angle());
    const std::size_t points = work.pslg.points.size();
    ASSERT_TRUE(cut_until_met(work, options, {}));
    EXPECT_EQ(work.pslg.points.size(), points);
  }
}

TEST(CutUntilMet, StopsWhereItIsAskedTo) {
  std::stop_source source;
  source.request_stop();
  Callbacks callbacks;
  callbacks.stop = source.get_token();
  Work work = meshed(cells(), no_obtuse_angle());
  const Status status = cut_until_met(work, no_obtuse_angle(), callbacks);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace cover
