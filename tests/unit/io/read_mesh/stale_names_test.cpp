// Meshes beside which an earlier run left a manifest or a .vtm: what the mesh's own file holds
// counts, and the contradiction is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

/// Four regions, a contact, and attributes of a map.
Output map() {
  Input input = testing::checker(2, 2, 3);
  input.segments[0].name = "weir";
  Output output = cover_mesh(input).value();
  for (std::size_t r = 0; r < 4; ++r) {
    output.table.regions[r].name = "field " + std::to_string(r + 1);
    output.table.regions[r].material_name = r % 2 == 0 ? "meadow" : "lake";
  }
  output.table.attributes = {{"manning", false, {}, {0.035, 0.025, 0.1, 0.04}},
                             {"code", true, {"07", "12"}, {1, 2, 0, 1}}};
  return output;
}

struct Read {
  Output output;
  std::vector<std::string> notes;

  [[nodiscard]] std::string told() const {
    std::string all;
    for (const std::string& note : notes) all += note + "\n";
    return all;
  }
};

/// The mesh of `now` in `file`, beside which a file of `before` has the ending `left`.
Read read_beside(const Output& now, const Output& before, const std::string& file,
                 const std::string& left, const WriteOptions& options = {}) {
  const testing::TemporaryFolder folder;
  EXPECT_TRUE(write_mesh(before, folder.path() / ("x" + left), options));
  EXPECT_TRUE(write_mesh(now, folder.path() / file, options));
  Result<Output> read = read_output(folder.path() / file);
  EXPECT_TRUE(read) << read.error().message;
  Read all{*std::move(read), {}};
  for (const Note& note : all.output.report.notes) all.notes.push_back(note.message);
  return all;
}

struct Beside {
  std::string file;
  std::string left;
  WriteOptions options{};
};

std::vector<Beside> with_arrays() {
  return {{"x.vtu", ".json"},  {"x.msh", ".json"},  {"x.msh", ".json", {.msh = "4.1"}},
          {"x.xdmf", ".json"}, {"x.pvtu", ".json"}, {"x.vtkhdf", ".json"},
          {"x.vtm", ".json"},  {"x.vtu", ".vtm"},   {"x.msh", ".vtm"},
          {"x.xdmf", ".vtm"},  {"x.pvtu", ".vtm"}};
}

const Attribute* find(const Output& output, const std::string& name) {
  const auto& all = output.table.attributes;
  const auto at = std::find_if(all.begin(), all.end(),
                               [&](const Attribute& attribute) { return attribute.name == name; });
  return at != all.end() ? &*at : nullptr;
}

TEST(StaleNames, ValuesOfTheMeshCount) {
  const Output before = map();
  Output now = map();
  now.table.attributes[0].values[0] = 0.777;
  for (const auto& [file, left, options] : with_arrays()) {
    SCOPED_TRACE(file + " beside " + left);
    const Read same = read_beside(before, before, file, left, options);
    EXPECT_TRUE(same.notes.empty()) << same.told();
    const Read read = read_beside(now, before, file, left, options);
    const Attribute* const manning = find(read.output, "manning");
    ASSERT_NE(manning, nullptr);
    EXPECT_EQ(manning->values, now.table.attributes[0].values);
    ASSERT_EQ(read.notes.size(), 1u) << read.told();
    EXPECT_NE(read.told().find(file), std::string::npos) << read.told();
    EXPECT_NE(read.told().find("x" + left +
                               " contradicts it, and the mesh's own file counts: "
                               "'manning' of region 1 is 0.777, not 0.035"),
              std::string::npos)
        << read.told();
    const Attribute* const code = find(read.output, "code");
    ASSERT_NE(code, nullptr);
    EXPECT_EQ(code->words, now.table.attributes[1].words) << "which come from beside it";
  }
}

TEST(StaleNames, NumbersWithoutAWordStayNumbers) {
  const Output before = map();
  Output now = map();
  now.table.attributes[1] = {"code", true, {"07", "12", "31"}, {1, 2, 3, 1}};
  for (const char* left : {".json", ".vtm"}) {
    const Read read = read_beside(now, before, "x.vtu", left);
    const Attribute* const code = find(read.output, "code");
    ASSERT_NE(code, nullptr);
    EXPECT_FALSE(code->is_text);
    EXPECT_EQ(code->values, (std::vector<double>{1, 2, 3, 1}));
    EXPECT_NE(read.told().find("'code' of region 3 is 3, not none"), std::string::npos)
        << read.told();
  }
}

TEST(StaleNames, AttributesThatTheMeshDoesNotHaveAreLeftOut) {
  const Output before = map();
  Output now = map();
  now.table.attributes.erase(now.table.attributes.begin());
  for (const auto& [file, left, options] : with_arrays()) {
    SCOPED_TRACE(file + " beside " + left);
    const Read read = read_beside(now, before, file, left, options);
    EXPECT_EQ(find(read.output, "manning"), nullptr);
    ASSERT_NE(find(read.output, "code"), nullptr);
    if (file == "x.vtkhdf") continue;  // which needs no other file for attributes
    EXPECT_NE(read.told().find("the attributes that a file beside it names: manning"),
              std::string::npos)
        << read.told();
  }
}

TEST(StaleNames, NamesOfTheMeshCount) {
  const Output before = map();
  Output now = map();
  now.table.regions[1].name = "small lake";
  now.table.interface(InterfaceId(1)).name = "dam";
  for (auto& line : now.table.interfaces)
    if (line.name == "weir") line.name = "dam";
  for (const auto& [file, left, options] : std::vector<Beside>{{"x.msh", ".json"},
                                                               {"x.msh", ".json", {.msh = "4.1"}},
                                                               {"x.msh", ".vtm"},
                                                               {"x.xdmf", ".json"},
                                                               {"x.xdmf", ".vtm"},
                                                               {"x.vtm", ".json"}}) {
    SCOPED_TRACE(file + " beside " + left);
    const Read read = read_beside(now, before, file, left, options);
    EXPECT_EQ(read.output.table.regions[1].name, "small lake");
    EXPECT_EQ(read.output.table.regions[0].name, "field 1");
    EXPECT_EQ(read.output.table.regions[1].material_name, "lake");
    const auto& lines = read.output.table.interfaces;
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [](const Interface& line) { return line.name == "dam"; }));
    EXPECT_NE(read.told().find("region 2 is 'small lake', not 'field 2'"), std::string::npos)
        << read.told();
  }
}

TEST(StaleNames, MaterialsOfTheMeshCount) {
  const Output before = map();
  Output now = map();
  ASSERT_EQ(before.table.regions.size(), 4u);
  for (const int r : {0, 1, 2, 3}) {
    Region& region = now.table.regions[static_cast<std::size_t>(r)];
    region.material = r == 0 ? 2 : before.table.regions[static_cast<std::size_t>(r)].material;
  }
  for (const auto face : now.mesh.tri().faces())
    now.mesh.set_material(face, now.table.region(now.mesh.region(face)).material);
  for (const char* left : {".json", ".vtm"}) {
    for (const char* ids : {"", "region"}) {
      WriteOptions options;
      options.ids = ids;
      const Read same = read_beside(before, before, "x.vtu", left, options);
      EXPECT_TRUE(same.notes.empty()) << same.told();
    }
    const Read read = read_beside(now, before, "x.vtu", left);
    EXPECT_EQ(read.output.table.regions[0].material, 2);
    EXPECT_NE(read.told().find("the material of region 1 is 2, not 1"), std::string::npos)
        << read.told();
  }
}

}  // namespace
}  // namespace cover
