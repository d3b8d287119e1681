// The joined mesh: who is beyond a segment, what is left above the goal, the way back.
#include "cuts/after_meshing/mutable_joined_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geom/vector.hpp"
#include "prepared_work.hpp"
#include "quality/fault/merit.hpp"
#include "region/whole_mesh.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

const Goal kRightAngles = Goal::of(Angle::degrees(90), Angle::degrees(20));

Options plain() {
  Options options;
  options.threads = 1;
  return options;
}

MutableJoinedMesh joined(const Work& work, const Goal& goal = kRightAngles) {
  return {work.pslg, work.boundaries, work.meshes, goal};
}

/// Two squares beside each other.
Input two_squares() {
  Input input = testing::segments_between(
      {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}},
      {{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 4}}, {{4, 5}}, {{5, 0}}, {{1, 4}}});
  input.seeds.push_back({{0.5, 0.5}, "1", "", {}, 0, 0});
  input.seeds.push_back({{1.5, 0.5}, "2", "", {}, 1, 0});
  return input;
}

TEST(MutableJoinedMesh, HaveTheTrianglesOfAllAndASideForEachOfTheirs) {
  const Work work = meshed(testing::checker(3, 4, 7), plain());
  const MutableJoinedMesh all = joined(work);
  std::size_t triangles = 0, sides = 0;
  for (const RegionMesh& mesh : work.meshes) triangles += mesh.triangles.size();
  for (const RegionBoundary& boundary : work.boundaries) sides += boundary.sides.size();
  EXPECT_EQ(all.mesh().triangle_count(), triangles);
  EXPECT_EQ(all.mesh().sides.size(), sides);
  EXPECT_TRUE(all.may_cut());
  EXPECT_FALSE(all.has_changed());
  EXPECT_TRUE(all.is_valid());
}

TEST(MutableJoinedMesh, TwoSidesOfOneSegmentArePartnersAndTheVoidIsNone) {
  const MutableJoinedMesh all = joined(meshed(two_squares(), plain()));
  std::size_t alone = 0, paired = 0;
  for (std::uint32_t s = 0; s < all.mesh().sides.size(); ++s) {
    const std::uint32_t other = all.partner(s);
    if (other == kNone) {
      ++alone;
      continue;
    }
    ++paired;
    EXPECT_EQ(all.partner(other), s);
    EXPECT_NE(other, s);
    EXPECT_TRUE(all.is_free(s));
  }
  EXPECT_EQ(alone, 6U);
  EXPECT_EQ(paired, 2U);
}

TEST(MutableJoinedMesh, TrianglesAboveComeInTheOrderOfTheirPlacesWhateverThatOfTheInput) {
  const Input input = testing::random_cells(8, 3);
  const Work work = meshed(input, plain()), other = meshed(testing::shuffled(input, 5), plain());
  const MutableJoinedMesh all = joined(work), again = joined(other);
  const std::vector<std::uint32_t> above = all.triangles_above();
  ASSERT_GT(above.size(), 2U);
  for (const std::uint32_t t : above) EXPECT_TRUE(is_above(all.mesh(), t, kRightAngles));
  EXPECT_EQ(again.triangles_above(), above);
  const auto lowest = [&](std::uint32_t t) {
    return std::min({all.mesh().corner(t, 0), all.mesh().corner(t, 1), all.mesh().corner(t, 2)});
  };
  EXPECT_TRUE(std::is_sorted(above.begin(), above.end(), [&](std::uint32_t a, std::uint32_t b) {
    return lowest(a) < lowest(b);
  }));
  EXPECT_TRUE(joined(work, Goal::of(Angle::degrees(179.9), Angle::degrees(0.001)))
                  .triangles_above()
                  .empty());
}

TEST(MutableJoinedMesh, HalvesTheLongestSegmentsNearWhatIsLeft) {
  const Input input = testing::segments_between({{0, 0}, {4, 0}, {4, 1}, {0, 1}},
                                                {{{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}});
  const Work work = meshed(input, plain());
  const MutableJoinedMesh all = joined(work, Goal::of(Angle::degrees(61), Angle::degrees(20)));
  ASSERT_FALSE(all.triangles_above().empty());
  const std::vector<SegmentId> halved = all.segments_to_halve();
  ASSERT_EQ(halved.size(), 2U) << "each once, however many triangles are near";
  EXPECT_LT(halved[0], halved[1]);
  for (const SegmentId s : halved) {
    const Segment& segment = work.pslg.segments[s.index()];
    const Point a = work.pslg.points[segment.a.index()], b = work.pslg.points[segment.b.index()];
    EXPECT_DOUBLE_EQ(length(b - a), 4);
  }
}

TEST(MutableJoinedMesh, SeparatedAgainTheyAreTheMeshesThatTheyWere) {
  const Work work = meshed(testing::checker(3, 4, 7), plain());
  std::vector<RegionMesh> meshes = work.meshes;
  joined(work).separate(work.pslg, work.boundaries, meshes);
  ASSERT_EQ(meshes.size(), work.meshes.size());
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    EXPECT_EQ(meshes[r].triangles.size(), work.meshes[r].triangles.size());
    std::vector<Point> now = meshes[r].steiner, then = work.meshes[r].steiner;
    std::sort(now.begin(), now.end());
    std::sort(then.begin(), then.end());
    EXPECT_EQ(now, then);
    EXPECT_FALSE(find_flaw(work.boundaries[r], meshes[r]));
  }
}

TEST(MutableJoinedMesh, AnExcerptReachesOverSegments) {
  const Work work = meshed(two_squares(), plain());
  const MutableJoinedMesh all = joined(work);
  const Excerpt excerpt = all.excerpt_around(0, 1000);
  EXPECT_EQ(excerpt.mesh.triangles.size(), all.mesh().triangle_count());
}

}  // namespace
}  // namespace cover
