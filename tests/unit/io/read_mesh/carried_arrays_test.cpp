// Attributes of regions and values at points survive a file of their mesh, in every format that
// bears them.
#include "io/read_mesh/carried_arrays.hpp"

#include <cover/files.hpp>
#include <cover/mesh.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Equal, bit for bit, but for which NaN it is.
void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!std::isnan(a[k]) || !std::isnan(b[k])) {
      EXPECT_EQ(a[k], b[k]) << k;
    }
}

Output device_with_arrays() {
  Output output = testing::odd_device();
  std::vector<double> words, heights, values;
  for (std::size_t r = 0; r < output.table.regions.size(); ++r) {
    words.push_back(static_cast<double>(r % 3));
    heights.push_back(r == 1 ? kNan : 0.1 + static_cast<double>(r) / 3);
  }
  for (std::size_t v = 0; v < output.mesh.vertices(); ++v)
    values.push_back(v == 0 ? kNan : -1e15 / (1 + static_cast<double>(v)));
  output.table.attributes = {{"N\xc3\xa4he: x & use", true, {"W\xc3\xa4lder", "b <c>"}, words},
                             {"RegionId", false, {}, heights}};  // a name that is taken
  output.fields = {{"Net/1e17", values}, {"Boron", values}};
  return output;
}

struct Case {
  std::string file;
  bool manifest = false;  ///< beside it
  bool words = true;      ///< bears words, and names as they were given
  WriteOptions options{};
};

TEST(CarriedArrays, ComeBackFromEveryFormatThatBearsThem) {
  const Output output = device_with_arrays();
  for (const int order : {1, 2}) {
    for (const Case& c :
         {Case{"x.vtu", true}, Case{"x.vtu", false, false}, Case{"x.vtm"}, Case{"x.vtm", true},
          Case{"x.vtkhdf"}, Case{"x.msh", true}, Case{"x.msh", false, false},
          Case{"x.msh", true, true, {.msh = "4.1"}}, Case{"x.xdmf", true},
          Case{"x.xdmf", false, false}, Case{"x.xdmf", true, true, {.xdmf = "hdf5"}},
          Case{"x.xdmf", false, false, {.xdmf = "hdf5"}}}) {
      SCOPED_TRACE(c.file + (c.manifest ? " with a manifest " : " alone ") + std::to_string(order));
      const testing::TemporaryFolder folder;
      const std::string path = folder.path() / c.file;
      WriteOptions options = c.options;
      options.order = order;
      ASSERT_TRUE(write_mesh(output, path, options));
      if (c.manifest) {
        ASSERT_TRUE(write_mesh(output, folder.path() / "x.json", options));
      }
      const Result<Output> back = read_output(path);
      ASSERT_TRUE(back) << back.error().message;
      ASSERT_EQ(back->table.attributes.size(), 2U);
      ASSERT_EQ(back->fields.size(), 2U);
      for (const Attribute& before : output.table.attributes) {
        const bool is_plain = !c.manifest;
        const auto called = [&](const Attribute& attribute) {
          return attribute.name == before.name ||
                 (is_plain && before.name == "RegionId" && attribute.name == "RegionId_2");
        };
        const auto after =
            std::find_if(back->table.attributes.begin(), back->table.attributes.end(), called);
        ASSERT_NE(after, back->table.attributes.end()) << before.name;
        EXPECT_EQ(after->is_text, before.is_text && c.words);
        if (c.words) {
          EXPECT_EQ(after->words, before.words);
        }
        expect_same(after->values, before.values);
      }
      for (const PlaneField::Array& before : output.fields) {
        const auto after =
            std::find_if(back->fields.begin(), back->fields.end(), [&](const auto& field) {
              return field.name == before.name || (field.name == "Net_1e17" && !c.manifest);
            });
        ASSERT_NE(after, back->fields.end()) << before.name;
        expect_same(after->values, before.values);
      }
    }
  }
}

TEST(CarriedArrays, ValuesAtPointsComeBackFromVtk) {
  Output output = device_with_arrays();
  output.fields.push_back({"a b %41 \xc3\xa4", output.fields.front().values});
  for (const bool lines : {false, true}) {
    const testing::TemporaryFolder folder;
    ASSERT_TRUE(write_mesh(output, folder.path() / "x.vtk", {.lines = lines}));
    const Result<Output> back = read_output(folder.path() / "x.vtk");
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_EQ(back->fields.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(back->fields[k].name, k == 0 ? "Net_1e17" : output.fields[k].name);
      expect_same(back->fields[k].values, output.fields[k].values);
    }
  }
}

TEST(CarriedArrays, NumbersOfAnotherRunAreRefused) {
  const testing::TemporaryFolder folder;
  Output output = device_with_arrays();
  const std::string path = folder.path() / "x.xdmf";
  ASSERT_TRUE(write_mesh(output, path, {.xdmf = "hdf5"}));
  const Result<std::string> before = read_file(path);
  ASSERT_TRUE(before);
  output.fields.front().values.back() *= 2;
  ASSERT_TRUE(write_mesh(output, path, {.xdmf = "hdf5"}));
  EXPECT_TRUE(read_mesh(path));
  ASSERT_TRUE(replace_file(path, *before));
  const Result<MeshFile> mixed = read_mesh(path);
  ASSERT_FALSE(mixed);
  EXPECT_NE(mixed.error().message.find("holds the numbers of another mesh"), std::string::npos)
      << mixed.error().message;
}

TEST(CarriedArrays, WhatIsLeftOutIsTold) {
  const testing::TemporaryFolder folder;
  const Output output = device_with_arrays();
  // Medit's format bears no arrays: attributes come from the manifest, values at points do not.
  ASSERT_TRUE(write_mesh(output, folder.path() / "x.mesh"));
  ASSERT_TRUE(write_mesh(output, folder.path() / "x.json"));
  const Result<Output> back = read_output(folder.path() / "x.mesh");
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->table.attributes.size(), 2U);
  EXPECT_EQ(back->table.attributes[0].words, output.table.attributes[0].words);
  EXPECT_TRUE(back->fields.empty());
  const auto& notes = back->report.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const Note& note) {
    return note.message.find("values at points that the manifest names: Net/1e17, Boron") !=
           std::string::npos;
  }));

  StoredMesh stored;
  stored.soup.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  stored.soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  stored.soup.region = {1, 1};
  const std::vector<std::string> told = take_arrays(
      {{"RegionId", {1, 1}}, {"error", {0.5, 0.25}}, {"same", {7, 7}}, {"none", {kNan, kNan}}}, {},
      {{"same", {"a", "b"}}}, stored);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0], "arrays of triangles that differ within a region are left out: error");
  ASSERT_EQ(stored.attributes.size(), 2U);
  EXPECT_FALSE(stored.attributes[0].is_text) << "there is no seventh word";
}

TEST(CarriedArrays, BrokenOnesOfXdmfAreRefused) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "x.xdmf";
  const auto said_of = [&](const std::string& xdmf, std::string from, const std::string& to) {
    EXPECT_TRUE(write_mesh(device_with_arrays(), path, {.xdmf = xdmf}));
    std::string text = testing::content(path);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    (void)folder.write("x.xdmf", text.replace(at, from.size(), to));
    const Result<Output> back = read_output(path);
    return back ? std::string() : back.error().message;
  };
  EXPECT_EQ(said_of("hdf5", "mesh/attribute_1<", "mesh/attribute_1<"), "");
  EXPECT_NE(said_of("hdf5", "mesh/attribute_2<", "mesh/attribute_1<").find("two arrays"),
            std::string::npos);
  EXPECT_NE(said_of("hdf5", "mesh/attribute_1<", "mesh/field_1<").find("wrong size"),
            std::string::npos);
  EXPECT_NE(said_of("hdf5", "mesh/attribute_1<", "mesh/none<").find("no numbers"),
            std::string::npos);
  EXPECT_NE(said_of("text", "Center=\"Node\"", "Center=\"Cell\"").find("wrong size"),
            std::string::npos);
  EXPECT_EQ(said_of("text", "Scalar\" Center=\"Node\"", "Vector\" Center=\"Node\""), "")
      << "passed over";
}

TEST(CarriedArrays, AreCheckedBeforeTheyAreTaken) {
  StoredMesh stored;
  stored.soup.points = {{0, 0}, {1, 0}, {0, 1}};
  stored.soup.triangles = {{0, 1, 2}};
  stored.soup.region = {1};
  stored.soup.material = {1};
  EXPECT_TRUE(rebuild(stored));
  stored.attributes = {{"use", true, {"a"}, {2}}};
  EXPECT_FALSE(rebuild(stored));
  stored.attributes = {{"use", false, {}, {2, 3}}};
  EXPECT_FALSE(rebuild(stored));
  stored.attributes.clear();
  stored.fields = {{"Net", {1, 2}}};
  EXPECT_FALSE(rebuild(stored));
  stored.fields = {{"Net", {1, 2, 3}}};
  const Result<Output> output = rebuild(stored);
  ASSERT_TRUE(output);
  EXPECT_EQ(output->fields[0].values, (std::vector<double>{1, 2, 3}));
}

}  // namespace
}  // namespace cover
