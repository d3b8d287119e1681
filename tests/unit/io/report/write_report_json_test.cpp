// The report as JSON: parsed again, complete, and in agreement with the Report.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include <cover/cover_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/inputs/soups.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

nlohmann::json written(const Output& output) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "report.json";
  const Status status = write_report_json(output, path);
  EXPECT_TRUE(status);
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

TEST(WriteReportJson, HoldsWhatTheReportHolds) {
  const Output output = cover_mesh(testing::checker(3, 4, 5)).value();
  const nlohmann::json found = written(output);
  EXPECT_EQ(found["format"], "cover report");
  EXPECT_EQ(found["mesh"]["triangles"], output.mesh.tri().n_faces());
  EXPECT_EQ(found["mesh"]["vertices"], output.mesh.tri().n_vertices());
  EXPECT_EQ(found["input"]["segments"], output.pslg.segments.size());
  ASSERT_EQ(found["regions"].size(), 9U);
  std::size_t triangles = 0, angles = 0;
  for (std::size_t r = 0; r < 9; ++r) {
    const auto& region = found["regions"][r];
    const RegionReport& report = output.report.regions[r];
    EXPECT_EQ(region["id"], r + 1);
    EXPECT_EQ(region["name"], output.table.regions[r].name);
    EXPECT_EQ(region["material"], output.table.regions[r].material);
    EXPECT_EQ(region["method"], report.method);
    EXPECT_EQ(region["nu_opt_radians"], report.nu_opt.in_radians());
    EXPECT_EQ(region["largest_nu_radians"], report.quality.largest_nu.in_radians());
    EXPECT_GE(region["gamma_opt"].get<double>(), 60 - 1e-12);
    EXPECT_EQ(region["bound_held"], report.bound_held);
    triangles += region["triangles"].get<std::size_t>();
    for (const auto& bin : region["histogram"]) angles += bin.get<std::size_t>();
    EXPECT_EQ(region["box"]["obtuse_sides"], report.box.obtuse_sides);
  }
  EXPECT_EQ(found["overall"]["triangles"], triangles);
  EXPECT_EQ(angles, 3 * triangles);
  EXPECT_EQ(found["interfaces"].size(), output.table.interfaces.size());
  EXPECT_GE(found["times"].size(), 4U);
  EXPECT_FALSE(found.contains("replaced"));
}

TEST(WriteReportJson, ListsEveryChangeOfTheInput) {
  Input input;
  testing::add_polygon(input, testing::rectangle(0, 0, 2, 2), "a");
  testing::add_polygon(input, testing::rectangle(2, 0, 3, 1), "b");
  testing::add_polygon(input, testing::rectangle(2 + 1e-12, 1, 3, 2), "c");
  testing::add_polygon(input, {{5, 5}, {6, 6}}, "d");
  const Output output = cover_mesh(input).value();
  const nlohmann::json changes = written(output)["changes"];
  ASSERT_EQ(changes.size(), output.report.changes.size());
  std::set<std::string> kinds;
  for (const auto& change : changes) {
    kinds.insert(change["kind"]);
    EXPECT_FALSE(change["message"].get<std::string>().empty());
    EXPECT_TRUE(change["where"].is_array());
    EXPECT_EQ(change["inputs"].size(), change["kind"] == "welded" ? change["inputs"].size() : 1U);
  }
  // A corner of one polygon on the side of another is what painting is for, and no change.
  EXPECT_EQ(kinds, (std::set<std::string>{"dropped", "welded"}));
  const auto dropped = std::find_if(changes.begin(), changes.end(),
                                    [](const auto& c) { return c["kind"] == "dropped"; });
  EXPECT_EQ((*dropped)["inputs"], nlohmann::json::parse(R"([{"kind": "polygon", "id": 4}])"));
}

TEST(WriteReportJson, NotesAndStrangeNames) {
  Output output = cover_mesh(testing::checker(1, 2, 5)).value();
  output.table.regions[0].name = "no utf-8: \xff \"quoted\"";
  output.report.regions[0].notes.push_back(
      {Note::Kind::below_resolution, RegionId{1}, "too flat", {{1.5, -2}}});
  output.report.regions[0].bound_held = false;
  output.report.notes.push_back({Note::Kind::change, kVoid, "welded", {}});
  output.report.replaced = {{RegionId{1}, 12, 5}};
  const nlohmann::json found = written(output);
  EXPECT_EQ(found["regions"][0]["notes"][0]["kind"], "below_resolution");
  EXPECT_EQ(found["regions"][0]["notes"][0]["where"][0][1], -2);
  EXPECT_EQ(found["overall"]["bound_missed"], nlohmann::json::array({1}));
  EXPECT_EQ(found["notes"][0]["kind"], "change");
  EXPECT_EQ(found["replaced"].size(), 1U);
  EXPECT_EQ(found["replaced"][0]["triangles"], 12);
}

}  // namespace
}  // namespace cover
