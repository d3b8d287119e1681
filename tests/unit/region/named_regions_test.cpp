#include <cover/regions.hpp>

#include <gtest/gtest.h>

namespace cover {
namespace {

RegionTable table() {
  RegionTable table;
  const auto add = [&](std::string name, std::string material_name, int material) {
    Region region;
    region.id = RegionId{table.regions.size() + 1};
    region.name = std::move(name);
    region.material_name = std::move(material_name);
    region.material = material;
    table.regions.push_back(region);
  };
  add("gate", "poly", 3);
  add("drain", "Si", 1);
  add("source", "Si", 1);
  add("1", "region:2", 3);
  return table;
}

using Ids = std::vector<RegionId>;

TEST(NamedRegions, NamesOfRegionsAndMaterials) {
  EXPECT_EQ(named_regions(table(), "gate"), Ids{RegionId{1}});
  EXPECT_EQ(named_regions(table(), "Si"), (Ids{RegionId{2}, RegionId{3}}));
  EXPECT_EQ(named_regions(table(), "si"), Ids{});
  EXPECT_EQ(named_regions(table(), ""), Ids{});
}

TEST(NamedRegions, NumbersOfMaterialsAndIds) {
  EXPECT_EQ(named_regions(table(), "3"), (Ids{RegionId{1}, RegionId{4}}));
  EXPECT_EQ(named_regions(table(), "region:3"), Ids{RegionId{3}});
  for (const char* none : {"2", "-1", "3x", "region:", "region:0", "region:5", "region:-1"}) {
    EXPECT_EQ(named_regions(table(), none), Ids{}) << none;
  }
}

TEST(NamedRegions, NamesComeFirst) {
  EXPECT_EQ(named_regions(table(), "1"), Ids{RegionId{4}});
  EXPECT_EQ(named_regions(table(), "region:2"), Ids{RegionId{4}});
}

TEST(NamedRegions, TheErrorNamesTheNearest) {
  const Error error = no_such_region(table(), "only", "gaet");
  EXPECT_EQ(error.code, ErrorCode::bad_option);
  EXPECT_NE(error.message.find("only 'gaet'"), std::string::npos);
  EXPECT_NE(error.message.find("'gate'?"), std::string::npos);
}

}  // namespace
}  // namespace cover
