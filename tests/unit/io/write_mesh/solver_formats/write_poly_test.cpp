#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <cover/read_input.hpp>
#include <cover/write_mesh.hpp>

#include "clean/pslg.hpp"

#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/soups.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

struct Clean {
  Pslg pslg;
  RegionTable table;
};

Clean prepare_clean(const Input& input) {
  Report report;
  auto pslg = make_pslg(input, {}, report);
  if (!pslg) throw std::runtime_error(pslg.error().message);
  auto table = build_region_table(*pslg, {}, report.notes);
  if (!table) throw std::runtime_error(table.error().message);
  return {std::move(*pslg), std::move(*table)};
}

/// What is written and read back has the same regions.
void expect_round_trip(const Input& input) {
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / "clean.poly").string();
  const Clean before = prepare_clean(input);
  ASSERT_TRUE(write_poly(before.pslg, before.table, path));
  const auto again = read_input(path);
  ASSERT_TRUE(again) << again.error().message;
  const Clean after = prepare_clean(*again);
  EXPECT_EQ(after.pslg.points, before.pslg.points);
  EXPECT_EQ(after.pslg.point_markers, before.pslg.point_markers);
  ASSERT_EQ(after.pslg.segments.size(), before.pslg.segments.size());
  for (std::size_t s = 0; s < after.pslg.segments.size(); ++s) {
    EXPECT_EQ(after.pslg.segments[s].marker, before.pslg.segments[s].marker);
    EXPECT_EQ(after.table.sides[s].left, before.table.sides[s].left);
    EXPECT_EQ(after.table.sides[s].right, before.table.sides[s].right);
  }
  ASSERT_EQ(after.table.regions.size(), before.table.regions.size());
  for (std::size_t k = 0; k < after.table.regions.size(); ++k) {
    EXPECT_EQ(after.table.regions[k].material, before.table.regions[k].material);
    EXPECT_EQ(after.table.regions[k].area, before.table.regions[k].area);
  }
}

TEST(WritePoly, KeepsEveryBitAndRegion) {
  Input input = testing::transformed(testing::checker(6, 3, 11), 1e-7, {1e-3, 1 / 3.0});
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    input.segments[s].marker = static_cast<int>(s % 5);
  }
  input.point_markers.assign(input.points.size(), -3);
  expect_round_trip(input);
}

TEST(WritePoly, NumbersNamedLines) {
  Input input = testing::input_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (InputSegment& segment : input.segments) segment.name = "gate";
  input.segments[1].name = "dra\nin";
  input.segments[2].marker = 1;  // a number of the input stays, with the name that it has
  input.segments[3].name = "";
  const Clean clean = prepare_clean(input);
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / "named.poly").string();
  ASSERT_TRUE(write_poly(clean.pslg, clean.table, path));
  const std::string text = testing::content(path);
  EXPECT_NE(text.find("# segments\n# marker 1: gate\n# marker 2: gate\n# marker 3: dra in\n4 1\n"),
            std::string::npos)
      << text;
  const auto again = read_input(path);
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_EQ(again->segments.size(), 4U);
  EXPECT_EQ(again->segments[0].marker, 2);
  EXPECT_EQ(again->segments[1].marker, 3);
  EXPECT_EQ(again->segments[2].marker, 1);
  EXPECT_EQ(again->segments[3].marker, 0);
}

TEST(WritePoly, WritesHolesForUnseededFaces) {
  Input input = testing::checker(4, 2, 1);
  input.seeds.resize(9);
  input.seeds[3].material = "Si, \"n\"\ntype";
  input.seeds[4].size = 0.25;
  input.void_rule = VoidRule::unseeded_faces;
  EXPECT_EQ(prepare_clean(input).table.void_seeds.size(), 7U);
  expect_round_trip(input);
}

/// A square with a triangle between neighbouring doubles in it.
Input square_with_speck() {
  const double next = std::nextafter(1.0, 2.0);
  Input input = testing::input_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  for (const Point p : {Point{1, 1}, {next, 1}, {1, next}}) input.points.push_back(p);
  for (std::uint32_t k = 0; k < 3; ++k) {
    input.segments.emplace_back();
    input.segments.back().a = 4 + k;
    input.segments.back().b = 4 + (k + 1) % 3;
  }
  return input;
}

TEST(WritePoly, NeedsNoSeedInAnUnnamedRegionThatHoldsNoDouble) {
  Input input = square_with_speck();
  const Clean clean = prepare_clean(input);
  ASSERT_EQ(clean.table.regions.size(), 2U);
  EXPECT_EQ(std::count_if(clean.table.regions.begin(), clean.table.regions.end(),
                          [](const Region& r) { return r.inside.has_value(); }),
            1);
  expect_round_trip(input);
  input.seeds.resize(1);
  input.seeds[0].at = {0.5, 0.25};
  input.seeds[0].material = "7";
  expect_round_trip(input);
}

TEST(WritePoly, PutsNoSeedBesideARegionThatHoldsNoDouble) {
  Input input = square_with_speck();
  input.segments.pop_back();  // the triangle is open: a void of the same shape takes its place
  input.segments.pop_back();
  input.segments.pop_back();
  testing::add_polygon(input, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, "a");
  testing::add_polygon(input, {input.points[4], input.points[5], input.points[6]}, "b");
  Options off;
  off.weld = 0;
  Report report;
  const auto pslg = make_pslg(input, off, report);
  ASSERT_TRUE(pslg) << pslg.error().message;
  const auto table = build_region_table(*pslg, {}, report.notes);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_EQ(table->regions.size(), 2U);
  EXPECT_FALSE(table->regions[1].inside);
  EXPECT_TRUE(std::any_of(report.notes.begin(), report.notes.end(), [](const Note& n) {
    return n.message.find("region 'b' at (1, 1) is so thin that no double lies inside") == 0;
  }));
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / "x.poly").string();
  ASSERT_TRUE(write_poly(*pslg, *table, path));
  EXPECT_EQ(read_input(path)->seeds.size(), 1U);
}

TEST(WritePoly, LeavesNothingWhereItCannotWrite) {
  const Clean clean = prepare_clean(testing::checker(2, 1, 1));
  const Status status = write_poly(clean.pslg, clean.table, "/no/such/folder/x.poly");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
}

}  // namespace
}  // namespace cover
