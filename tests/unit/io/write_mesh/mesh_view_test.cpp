// Groups and tags of the view; cells are compared through every written format.
#include <cover/mesh_view.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

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

/// One name of two points, one of a point that has two, and one of a point in no region.
TEST(MeshView, NamedPointsAreGroupsBehindLines) {
  Input input;
  input.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 2}, {9, 9}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    InputSegment segment;
    segment.a = k;
    segment.b = (k + 1) % 4;
    segment.name = "probe";
    input.segments.push_back(segment);
  }
  input.point_names = {{5, "probe"}, {4, "well 1"}, {5, "well 1"}, {6, "far"}};
  const Output output = cover_mesh(input).value();
  const MeshView view = view_of(output, {});
  EXPECT_EQ(names(view.point_groups), (std::vector<std::string>{"probe", "well_1"}));
  EXPECT_EQ(view.point_groups[1].original, "well 1");
  EXPECT_EQ(view.point_groups[0].tag, view.line_groups.back().tag + 1);
  EXPECT_EQ(view.named_group, (std::vector<std::uint32_t>{0, 1, 1}));
  std::vector<Point> places;
  for (const std::uint32_t v : view.named) places.push_back(view.points[v]);
  EXPECT_EQ(places, (std::vector<Point>{{3, 2}, {1, 1}, {3, 2}}));
  // The line and the point are sets of nodes.
  EXPECT_EQ(abaqus_names(node_sets(view)),
            (std::vector<std::string>{"PROBE", "PROBE_2", "WELL_1"}));
  EXPECT_TRUE(view_of_triangles(output, {}).named.empty());
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

/// Two squares, `a` and `b`, whose lines are called as cover calls others by itself.
Output named_like_made_up_ones() {
  Input input;
  input.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  const auto add = [&](std::uint32_t a, std::uint32_t b, const char* name) {
    InputSegment segment;
    segment.a = a;
    segment.b = b;
    segment.name = name;
    input.segments.push_back(segment);
  };
  add(0, 1, "");
  add(1, 2, "");
  add(2, 3, "a outline");
  add(3, 4, "A_B");
  add(4, 5, "");
  add(5, 0, "a_b");
  add(1, 4, "");
  for (const auto& [x, name] : {std::pair(0.5, "a"), std::pair(1.5, "b")}) {
    RegionSeed seed;
    seed.at = {x, 0.5};
    seed.material = name;
    input.seeds.push_back(seed);
  }
  return cover_mesh(input).value();
}

TEST(MeshView, NamesOfTheInputStayAndMadeUpOnesGiveWay) {
  const Output output = named_like_made_up_ones();
  const MeshView view = view_of(output, {});
  std::map<std::string, Group> by_label;
  for (const Group& group : view.line_groups) by_label[group.label] = group;
  ASSERT_TRUE(by_label.contains("a_b") && by_label.contains("a_b_2"));
  EXPECT_FALSE(by_label["a_b"].is_made_up);
  EXPECT_TRUE(by_label["a_b_2"].is_made_up);
  EXPECT_EQ(by_label["a_b_2"].original, "a_b_2");
  EXPECT_EQ(by_label["a outline"].name, "a_outline");
  EXPECT_EQ(by_label["a_outline"].name, "a_outline_2");
  // Only one of a_b and A_B can keep its name there, but neither that which is made up.
  const std::vector<std::string> decks = abaqus_names(view.line_groups);
  for (std::size_t g = 0; g < decks.size(); ++g) {
    if (decks[g] != "A_B" && decks[g] != "A_OUTLINE") continue;
    EXPECT_FALSE(view.line_groups[g].is_made_up) << view.line_groups[g].label;
  }
  EXPECT_EQ(std::count(decks.begin(), decks.end(), "A_B"), 1);
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
