#include "commands/check/named_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include <cover/cover_mesh.hpp>
#include <cover/mesh_view.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover::app {
namespace {

/// Two squares beside each other, with a contact on the left, one on the line between them, and a
/// marked line.
Input two_squares() {
  Input input;
  input.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  const auto add = [&](std::uint32_t a, std::uint32_t b, const char* name, int marker = 0) {
    InputSegment segment;
    segment.a = a;
    segment.b = b;
    segment.name = name;
    segment.marker = marker;
    input.segments.push_back(segment);
  };
  add(0, 1, "");
  add(1, 2, "", 7);
  add(2, 3, "7");
  add(3, 4, "");
  add(4, 5, "");
  add(5, 0, "so \"far\"");
  add(1, 4, "between");
  for (const auto& [x, name] : {std::pair(0.5, "a"), std::pair(1.5, "b")}) {
    RegionSeed seed;
    seed.at = {x, 0.5};
    seed.material = name;
    input.seeds.push_back(seed);
  }
  return input;
}

/// A mesh with its lines as a .msh has them, and its input.
struct NamedCase {
  explicit NamedCase(const Options& options = {}, const WriteOptions& write = {}) {
    const Output output = testing::must_mesh(two_squares(), options);
    mesh.soup = triangle_soup(output.mesh);
    const MeshView view = view_of(output, write);
    for (std::size_t l = 0; l < view.lines.size(); ++l)
      mesh.lines.push_back({view.lines[l][0], view.lines[l][1], view.group_of_line(l).tag});
    for (const Group& group : view.line_groups) mesh.line_names[group.tag] = group.label;
    prepared = prepare(two_squares(), {}).value();
  }

  [[nodiscard]] std::int64_t group(const std::string& name) const {
    const auto known = std::find_if(mesh.line_names.begin(), mesh.line_names.end(),
                                    [&](const auto& entry) { return entry.second == name; });
    EXPECT_NE(known, mesh.line_names.end()) << name;
    return known->first;
  }

  [[nodiscard]] NamedLines check() const {
    return check_named_lines(cut_as(prepared, mesh.soup), mesh);
  }

  MeshTriangles mesh;
  Prepared prepared;
};

TEST(NamedLines, AreThereUnderTheirNames) {
  const NamedLines lines = NamedCase().check();
  EXPECT_TRUE(lines.wrong.empty());
  EXPECT_TRUE(lines.unchecked.empty());
}

TEST(NamedLines, ThePiecesTogetherAreTheLine) {
  Options options;
  options.method = Method::nonobtuse;
  NamedCase one(options);
  const std::int64_t between = one.group("between");
  const auto is_between = [&](const MeshLine& line) { return line.group == between; };
  ASSERT_GT(std::count_if(one.mesh.lines.begin(), one.mesh.lines.end(), is_between), 1);
  EXPECT_TRUE(one.check().wrong.empty());
  one.mesh.lines.erase(std::find_if(one.mesh.lines.begin(), one.mesh.lines.end(), is_between));
  const NamedLines lines = one.check();
  ASSERT_EQ(lines.wrong.size(), 1u);
  EXPECT_EQ(lines.wrong[0].name, "between");
  EXPECT_EQ(lines.wrong[0].missing, 1u);
  EXPECT_EQ(lines.wrong[0].foreign, 0u);
}

TEST(NamedLines, SwappedNamesAreFound) {
  NamedCase one;
  std::swap(one.mesh.line_names[one.group("so _far_")], one.mesh.line_names[one.group("between")]);
  const NamedLines lines = one.check();
  ASSERT_EQ(lines.wrong.size(), 2u);
  for (const WrongLine& line : lines.wrong) {
    EXPECT_EQ(line.missing, line.edges);
    EXPECT_GT(line.foreign, 0u);
    EXPECT_EQ(line.missing_at.size(), 2u);
    EXPECT_EQ(line.foreign_at.size(), 2u);
  }
}

TEST(NamedLines, ALineWithoutEdgesIsFound) {
  NamedCase one;
  const std::int64_t gone = one.group("so _far_");
  std::erase_if(one.mesh.lines, [&](const MeshLine& line) { return line.group == gone; });
  const NamedLines lines = one.check();
  ASSERT_EQ(lines.wrong.size(), 1u);
  EXPECT_EQ(lines.wrong[0].name, "so \"far\"");
  EXPECT_EQ(lines.wrong[0].missing, lines.wrong[0].edges);
}

TEST(NamedLines, InnerOnesMayBeLeftOut) {
  WriteOptions write;
  write.inner_lines = false;
  const NamedLines lines = NamedCase({}, write).check();
  EXPECT_TRUE(lines.wrong.empty());
  EXPECT_EQ(lines.unchecked.size(), 1u);
}

TEST(NamedLines, AMeshWithoutNamesTellsNothing) {
  NamedCase one;
  one.mesh.line_names.clear();
  EXPECT_EQ(one.check().unchecked.size(), 1u);
  one.prepared = prepare(testing::checker(2, 1, 5), {}).value();
  EXPECT_TRUE(one.check().unchecked.empty());
}

}  // namespace
}  // namespace cover::app
