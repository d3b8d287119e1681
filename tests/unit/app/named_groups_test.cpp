#include "commands/check/named_groups.hpp"

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

namespace cover::app {
namespace {

RegionTable two_regions() {
  RegionTable table;
  for (const auto& [material, name] : {std::pair(4, "Oxide"), std::pair(2, "Silicon")}) {
    Region region;
    region.material = material;
    region.material_name = name;
    region.name = std::string("R") + name;
    table.regions.push_back(region);
  }
  return table;
}

TEST(NamedGroups, AreTheMaterialsOfTheirNames) {
  TriangleSoup mesh;
  mesh.material = {7, 7, 9};
  EXPECT_TRUE(
      take_materials_by_name(two_regions(), {{7, "SILICON"}, {9, "ROxide"}, {1, "x"}}, mesh));
  EXPECT_EQ(mesh.material, (std::vector<std::int64_t>{2, 2, 4}));
}

TEST(NamedGroups, StayWhereANameTellsNothing) {
  TriangleSoup mesh;
  mesh.material = {7, 9};
  const auto stay = [&](const RegionTable& table,
                        const std::map<std::int64_t, std::string>& names) {
    EXPECT_FALSE(take_materials_by_name(table, names, mesh));
    EXPECT_EQ(mesh.material, (std::vector<std::int64_t>{7, 9}));
  };
  stay(two_regions(), {{7, "Silicon"}});
  stay(two_regions(), {{7, "Silicon"}, {9, "Metal"}});
  RegionTable twice = two_regions();
  twice.regions[0].name = "Silicon";
  stay(twice, {{7, "Silicon"}, {9, "Oxide"}});
}

TEST(NamedGroups, AreComparedWithRegions) {
  RegionTable table = two_regions();
  for (std::size_t r = 0; r < 2; ++r) table.regions[r].id = RegionId(r + 1);
  TriangleSoup mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 2, 1}};
  const std::vector<RegionId> regions{RegionId(1), RegionId(2), RegionId(2)};
  const std::map<std::int64_t, std::string> names{{7, "ROXIDE"}, {8, "Silicon"}, {9, "rsilicon"}};
  const auto found = [&](std::span<const std::int64_t> groups) {
    return check_named_regions(table, regions, groups, names, mesh);
  };
  EXPECT_TRUE(found(std::array<std::int64_t, 3>{7, 8, 9}).empty());
  const std::vector<WrongRegion> wrong = found(std::array<std::int64_t, 3>{9, 7, 7});
  ASSERT_EQ(wrong.size(), 2U);
  EXPECT_EQ(wrong[0].name, "ROxide");
  EXPECT_EQ(wrong[0].group, "rsilicon");
  EXPECT_EQ(wrong[0].triangles, 1U);
  EXPECT_EQ(wrong[1].triangles, 2U);
  EXPECT_EQ(wrong[1].at, (Point{1, 0}));
  EXPECT_TRUE(check_named_regions(table, {}, {}, names, mesh).empty());
}

}  // namespace
}  // namespace cover::app
