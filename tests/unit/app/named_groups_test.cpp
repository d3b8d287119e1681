#include "commands/check/named_groups.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cover::app
