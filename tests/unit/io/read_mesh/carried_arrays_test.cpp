// Attributes of regions and values at points survive a file of their mesh, in every format that
// bears them.
#include "io/read_mesh/carried_arrays.hpp"

#include <cover/files.hpp>
#include <cover/mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
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

/// Where regions meet that are different blocks, the first and the last have values of their own.
void add_values_of_regions(Output& output) {
  const TriMesh& tri = output.mesh.tri();
  std::vector<std::set<RegionId>> at(output.mesh.vertices());
  for (const auto face : tri.faces())
    for (const auto v : tri.fv_range(face))
      at[static_cast<std::size_t>(v.idx())].insert(output.mesh.region(face));
  output.region_values.assign(output.fields.size(), {});
  for (std::uint32_t v = 0; v < at.size(); ++v) {
    std::set<std::string> names;
    for (const RegionId region : at[v]) names.insert(output.table.region(region).name);
    if (names.size() < 2 || names.size() < at[v].size()) continue;
    const double value = output.fields[0].values[v];
    output.region_values[0].push_back({v, *at[v].begin(), v % 2 == 0 ? kNan : value / 4});
    output.region_values[1].push_back({v, *at[v].rbegin(), 0});
  }
}

/// Equal places and values, NaN being one value.
void expect_same(const std::vector<RegionValue>& a, const std::vector<RegionValue>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].place(), b[k].place());
    expect_same(std::vector{a[k].value}, std::vector{b[k].value});
  }
}

TEST(CarriedArrays, EachBlockOfAVtmHasTheValuesOfItsRegion) {
  Output output = device_with_arrays();
  // Else no region could have a value there.
  for (PlaneField::Array& field : output.fields) field.values[0] = 1;
  add_values_of_regions(output);
  ASSERT_FALSE(output.region_values[0].empty());
  for (const int order : {1, 2}) {
    for (const bool manifest : {false, true}) {
      SCOPED_TRACE(order);
      const testing::TemporaryFolder folder;
      const std::string path = folder.path() / "x.vtm", again = folder.path() / "y.vtm";
      ASSERT_TRUE(write_mesh(output, path, {.order = order}));
      if (manifest) {
        ASSERT_TRUE(write_mesh(output, folder.path() / "x.json", {.order = order}));
      }
      const Result<Output> back = read_output(path);
      ASSERT_TRUE(back) << back.error().message;
      ASSERT_TRUE(write_mesh(*back, again, {.order = order}));
      const Result<Output> twice = read_output(again);
      ASSERT_TRUE(twice) << twice.error().message;
      const std::string whole = folder.path() / "y.vtu";
      ASSERT_TRUE(write_mesh(output, whole, {.order = order}));
      const Result<Output> beside = read_output(whole);
      ASSERT_TRUE(beside) << beside.error().message;
      for (const Output* read : {&*back, &*twice, &*beside}) {
        ASSERT_EQ(read->region_values.size(), 2U);
        for (std::size_t n = 0; n < 2; ++n) {
          const std::size_t k = read->fields[n].name == "Boron" ? 1 : 0;
          expect_same(read->fields[n].values, output.fields[k].values);
          expect_same(read->region_values[n], output.region_values[k]);
        }
      }
    }
  }
  // What has one value at a point has the largest one.
  const testing::TemporaryFolder folder;
  ASSERT_TRUE(write_mesh(output, folder.path() / "x.vtu", {}));
  const Result<Output> whole = read_output(folder.path() / "x.vtu");
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_TRUE(whole->region_values.empty());
  for (const PlaneField::Array& after : whole->fields)
    expect_same(after.values, output.fields[after.name == "Boron" ? 1 : 0].values);
}

TEST(CarriedArrays, InTheMiddleOfAnEdgeARegionHasTheMeanOfItsValues) {
  Output output = device_with_arrays();
  for (double& value : output.fields[1].values) value = 8;
  add_values_of_regions(output);
  const MeshView view = view_of(output, {.order = 2});
  std::size_t others = 0;
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const auto nodes = view.triangles[t];
    const auto seen = [&](std::size_t k) {
      return value_in(view.fields, view.region_values, 1, nodes[k], view.region[t]);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = seen(k), b = seen((k + 1) % 3);
      EXPECT_EQ(seen(k + 3), (a + b) / 2);
      others += a + b < 16 ? 1 : 0;
    }
  }
  EXPECT_GT(others, 0U);
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
  const std::string numbers = folder.path() / "x.h5";
  const Result<std::string> all = read_file(numbers);
  ASSERT_TRUE(all);
  ASSERT_TRUE(replace_file(numbers, all->substr(0, all->size() / 2)));
  const Result<MeshFile> cut = read_mesh(path);
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().message.find("another mesh"), std::string::npos) << cut.error().message;
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
    return note.message.find("values at points that a file beside it names: Net/1e17, Boron") !=
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
  for (const std::vector<RegionValue>& wrong :
       {std::vector<RegionValue>{{3, RegionId(1), 0}},
        std::vector<RegionValue>{{0, RegionId(9), 0}},
        std::vector<RegionValue>{{1, RegionId(1), 0}, {0, RegionId(1), 0}}}) {
    stored.region_values = {wrong};
    EXPECT_FALSE(rebuild(stored));
  }
}

}  // namespace
}  // namespace cover
