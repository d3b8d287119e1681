#include <gtest/gtest.h>

#include <cover/read_input.hpp>
#include <cover/write_mesh.hpp>

#include "region/pslg.hpp"
#include "region/region_graph.hpp"
#include "support/inputs.hpp"
#include "support/temporary_folder.hpp"

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
  const auto again = read_poly(path);
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

TEST(WritePoly, WritesHolesForUnseededFaces) {
  Input input = testing::checker(4, 2, 1);
  input.seeds.resize(9);
  input.seeds[3].material = "Si, \"n\"\ntype";
  input.seeds[4].size = 0.25;
  input.void_rule = VoidRule::unseeded_faces;
  EXPECT_EQ(prepare_clean(input).table.void_seeds.size(), 7U);
  expect_round_trip(input);
}

TEST(WritePoly, LeavesNothingWhereItCannotWrite) {
  const Clean clean = prepare_clean(testing::checker(2, 1, 1));
  const Status status = write_poly(clean.pslg, clean.table, "/no/such/folder/x.poly");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
}

}  // namespace
}  // namespace cover
