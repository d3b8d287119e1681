// Groups and tags of the view; cells are compared through every written format.
#include <cover/mesh_view.hpp>

#include <gtest/gtest.h>

#include <algorithm>

#include "support/written_mesh.hpp"

namespace cover {
namespace {

std::vector<std::string> names(const std::vector<Group>& groups) {
  std::vector<std::string> out;
  for (const Group& group : groups) out.push_back(group.name);
  return out;
}

TEST(MeshView, GroupsRegionsByNameAndMaterial) {
  const Output output = testing::odd_device();
  const MeshView view = view_of(output, {});
  EXPECT_EQ(names(view.region_groups),
            (std::vector<std::string>{"Si__n_", "SiO____oxide", "Si__n__2"}));
  EXPECT_EQ(view.region_group, (std::vector<std::uint32_t>{0, 1, 2, 0}));
  EXPECT_EQ(view.region_groups[2].original, "Si/\"n\"");
  EXPECT_EQ(view.region_groups[2].material, output.table.regions[2].material);
}

TEST(MeshView, TagsAreUniqueOverRegionsAndLines) {
  const Output output = testing::odd_device();
  const MeshView view = view_of(output, {});
  int tag = 0;
  for (const Group& group : view.region_groups) EXPECT_EQ(group.tag, ++tag);
  for (const Group& group : view.line_groups) EXPECT_EQ(group.tag, ++tag);
}

TEST(MeshView, AContactOverTwoRegionsIsOneGroup) {
  const Output output = testing::odd_device();
  const auto interfaces =
      std::count_if(output.table.interfaces.begin(), output.table.interfaces.end(),
                    [](const Interface& line) { return line.name == "drain contact"; });
  EXPECT_EQ(interfaces, 2);
  const std::vector<std::string> lines = names(view_of(output, {}).line_groups);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "drain_contact"), 1);
}

TEST(MeshView, MarkersMakeGroupsOfTheirOwnAndContactsWin) {
  Input input;
  input.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    InputSegment segment;
    segment.a = k;
    segment.b = (k + 1) % 4;
    segment.marker = k < 3 ? 5 : 0;
    if (k == 0) segment.name = "gate";
    input.segments.push_back(segment);
  }
  const Output output = cover_mesh(input).value();
  const MeshView view = view_of(output, {});
  EXPECT_EQ(names(view.line_groups), (std::vector<std::string>{"unnamed_outline", "5", "gate"}));
  std::vector<int> sizes(3);
  for (const std::uint32_t group : view.line_group) ++sizes[group];
  EXPECT_EQ(sizes, (std::vector<int>{1, 2, 1}));
}

TEST(MeshView, TagsDoNotDependOnWhatIsLeftOut) {
  const Output output = testing::odd_device();
  WriteOptions outer;
  outer.inner_lines = false;
  const MeshView all = view_of(output, {}), few = view_of(output, outer);
  EXPECT_LT(few.lines.size(), all.lines.size());
  EXPECT_EQ(names(few.line_groups), names(all.line_groups));
  EXPECT_EQ(std::count(few.inner.begin(), few.inner.end(), 1), 0);
}

TEST(MeshView, EdgesOfTheHullWithoutASegmentAreALineGroup) {
  const Output output = testing::structured_mesh(2, 1);
  const MeshView view = view_of(output, {});
  EXPECT_EQ(names(view.line_groups), (std::vector<std::string>{"Si_SiO2", "hull"}));
  EXPECT_EQ(view.lines.size(), 7U);
}

}  // namespace
}  // namespace cover
