#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cover/version.hpp>
#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using nlohmann::json;
using testing::WrittenCell;
using testing::WrittenMesh;

class WriteManifest : public ::testing::Test {
 protected:
  json written(const WriteOptions& options = {}) {
    const std::string path = (folder_.path() / "x.json").string();
    const Status status = write_manifest(output_, path, options);
    EXPECT_TRUE(status) << status.error().message;
    return json::parse(testing::content(path));
  }

  testing::TemporaryFolder folder_;
  Output output_ = testing::odd_device();
};

TEST_F(WriteManifest, OriginalAndSafeNames) {
  const json manifest = written();
  EXPECT_EQ(manifest["format_version"], 1);
  const json& groups = manifest["region_groups"];
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0]["name"], "Si__n_");
  EXPECT_EQ(groups[0]["original"], "Si/\"n\"");
  EXPECT_EQ(groups[1]["original"], "SiO\xe2\x82\x82 oxide");
  EXPECT_EQ(groups[2]["tag"], 3);
  ASSERT_EQ(manifest["regions"].size(), 4U);
  EXPECT_EQ(manifest["regions"][3]["group"], 1);
  EXPECT_EQ(manifest["regions"][3]["material_name"], "silicon");
}

TEST_F(WriteManifest, EdgesOfEveryLine) {
  const json manifest = written();
  WrittenMesh file;
  for (const json& group : manifest["line_groups"]) file.line_names[group["tag"]] = group["name"];
  for (const json& line : manifest["lines"]) {
    const Interface& expected = output_.table.interfaces.at(line["id"].get<std::size_t>() - 1);
    EXPECT_EQ(line["name"], expected.name);
    EXPECT_EQ(line["left"], expected.left.value());
    EXPECT_EQ(line["right"], expected.right.value());
    EXPECT_EQ(line.contains("markers"), expected.name == "gate");
    EXPECT_EQ(line.value("markers", json{11}), json{11});
    for (const json& edge : line["edges"])
      file.lines.push_back({{edge[0], edge[1]}, line["group"], line["id"]});
  }
  testing::expect_same_lines(output_, file);
}

TEST_F(WriteManifest, HowTheMeshCameAbout) {
  output_.report.provenance.source = "deck/device.json";
  output_.report.provenance.settings = {{"method", "quality"}, {"size", "1"}, {"size", "Si=2"}};
  output_.report.unit = "nm";
  const json manifest = written();
  EXPECT_EQ(manifest["source"], "deck/device.json");
  EXPECT_EQ(manifest["cover"], COVER_VERSION);
  EXPECT_EQ(manifest["unit"], "nm");
  EXPECT_EQ(manifest["scale"], 1.0);
  EXPECT_EQ(manifest["options"], (json{{"method", "quality"}, {"size", {"1", "Si=2"}}}));
}

TEST_F(WriteManifest, CountsAndQuality) {
  const json manifest = written();
  EXPECT_EQ(manifest["counts"]["triangles"], output_.mesh.tri().n_faces());
  EXPECT_EQ(manifest["counts"]["vertices"], output_.mesh.tri().n_vertices());
  EXPECT_EQ(manifest["counts"]["steiner_vertices"], output_.report.steiner_vertices);
  std::size_t triangles = 0;
  for (const json& region : manifest["regions"])
    triangles += region["triangles"].get<std::size_t>();
  EXPECT_EQ(triangles, output_.mesh.tri().n_faces());
  EXPECT_DOUBLE_EQ(manifest["quality"]["largest_angle"].get<double>(),
                   output_.report.quality.largest_nu.supplement().in_degrees());
  EXPECT_EQ(written({.order = 2})["counts"]["points"],
            output_.mesh.tri().n_vertices() + output_.mesh.tri().n_edges());
}

TEST_F(WriteManifest, BrokenUtf8DoesNotStopIt) {
  output_.table.regions[0].name = "Si\xff";
  EXPECT_EQ(written()["regions"][0]["name"], "Si\xef\xbf\xbd");
}

TEST_F(WriteManifest, AMeshWithoutReport) {
  output_ = testing::structured_mesh(4, 2);
  const json manifest = written();
  EXPECT_FALSE(manifest.contains("quality"));
  EXPECT_EQ(manifest["lines"].size(), 2U);
  EXPECT_EQ(manifest["lines"][0]["kind"], "hull");
  EXPECT_EQ(manifest["lines"][0]["edges"].size(), 12U);
}

}  // namespace
}  // namespace cover
