// How meshes say that they were made.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include <cover/cover_mesh.hpp>
#include <cover/read_origin.hpp>
#include <cover/version.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

Output meshed() {
  Options options;
  options.max_angle = Angle::degrees(95);
  Result<Output> output = cover_mesh(testing::checker(3, 2, 2), options);
  EXPECT_TRUE(output) << output.error().message;
  output->report.provenance.source = "checker.poly";
  output->report.scale = 0.5;
  return *std::move(output);
}

void expect_origin(const std::optional<MeshOrigin>& origin, std::size_t triangles) {
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->provenance.source, "checker.poly");
  EXPECT_EQ(origin->provenance.version, COVER_VERSION);
  const Provenance::Setting largest{"max-angle", "95"};
  EXPECT_EQ(
      std::count(origin->provenance.settings.begin(), origin->provenance.settings.end(), largest),
      1);
  EXPECT_EQ(origin->scale, 0.5);
  EXPECT_EQ(origin->triangles, triangles);
}

TEST(ReadOrigin, OfAManifestAndOfFilesThatTellThemselves) {
  const testing::TemporaryFolder folder;
  const Output mesh = meshed();
  for (const char* const name : {"a.vtm", "b.vtkhdf", "c.vtu"}) {
    SCOPED_TRACE(name);
    const std::string path = folder.path() / name;
    ASSERT_TRUE(write_mesh(mesh, path));
    if (name[0] == 'c')
      EXPECT_FALSE(read_origin(path));
    else
      expect_origin(read_origin(path), 0);
    ASSERT_TRUE(write_manifest(mesh, std::filesystem::path(path).replace_extension(".json")));
    expect_origin(read_origin(path), name[0] == 'c' ? mesh.mesh.tri().n_faces() : 0);
  }
}

TEST(ReadOrigin, OfTheFileItselfBeforeThatOfAManifest) {
  const testing::TemporaryFolder folder;
  Output mesh = meshed();
  mesh.report.provenance.source = "earlier.poly";
  ASSERT_TRUE(write_manifest(mesh, folder.path() / "a.json"));
  mesh.report.provenance.source = "checker.poly";
  for (const char* const name : {"a.vtm", "a.vtkhdf"}) {
    SCOPED_TRACE(name);
    const std::string path = folder.path() / name;
    ASSERT_TRUE(write_mesh(mesh, path));
    expect_origin(read_origin(path), 0);
  }
}

TEST(ReadOrigin, AFileThatBeginsOtherwiseIsNoManifest) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "a.msh";
  const std::string format = R"("format": "cover mesh manifest"})";
  std::ofstream(folder.path() / "a.json") << "{" + format;
  EXPECT_TRUE(read_origin(path));
  std::ofstream(folder.path() / "a.json") << "{" + std::string(2000, ' ') + format;
  EXPECT_FALSE(read_origin(path));
}

TEST(ReadOrigin, BrokenFilesTellNothing) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "a.msh";
  EXPECT_FALSE(read_origin(path));
  for (const char* const text :
       {"", "{", "[]", R"({"format": "cover report"})",
        R"({"format": "cover mesh manifest", "options": {"max-angle": 3}})",
        R"({"format": "cover mesh manifest", "counts": 3})",
        R"({"format": "cover mesh manifest", "counts": {"triangles": 1e300}})",
        R"({"format": "cover mesh manifest", "counts": {"triangles": -1}})"}) {
    SCOPED_TRACE(text);
    std::ofstream(folder.path() / "a.json") << text;
    EXPECT_FALSE(read_origin(path));
  }
  EXPECT_FALSE(read_origin(folder.path() / "none.vtm"));
  EXPECT_FALSE(read_origin(folder.path() / "none.vtkhdf"));
}

}  // namespace
}  // namespace cover
