// Both versions of .msh are read back by a parser of our own.
#include <gtest/gtest.h>

#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using testing::WrittenCell;
using testing::WrittenMesh;

/// Nodes of the element types that may occur.
std::size_t node_count(long type) {
  return std::map<long, std::size_t>{{1, 2}, {2, 3}, {8, 3}, {9, 6}}.at(type);
}
bool is_line(long type) { return type == 1 || type == 8; }

class MshParser {
 public:
  explicit MshParser(const std::string& path) : words_(testing::content(path)) {}

  WrittenMesh parse() {
    words_.expect("$MeshFormat");
    version_ = words_.word();
    words_.expect("0");
    words_.expect("8");
    words_.expect("$EndMeshFormat");
    names();
    version_ == "2.2" ? body_2() : body_4();
    words_.expect("$EndElements");
    EXPECT_TRUE(words_.at_end());
    return mesh_;
  }

 private:
  void names() {
    mesh_.names_are_utf8 = true;
    words_.expect("$PhysicalNames");
    for (long n = words_.integer(); n > 0; --n) {
      const long dimension = words_.integer(), tag = words_.integer();
      const std::string name = words_.line();
      ASSERT_TRUE(name.size() > 2 && name.front() == '"' && name.back() == '"') << name;
      auto& names = dimension == 1 ? mesh_.line_names : mesh_.region_names;
      EXPECT_TRUE(names.emplace(tag, name.substr(1, name.size() - 2)).second);
    }
    words_.expect("$EndPhysicalNames");
  }

  void point() {
    const double x = words_.number(), y = words_.number();
    mesh_.points.push_back({x, y});
    words_.expect("0");
  }

  void element(long type, long physical, long elementary) {
    WrittenCell cell{{}, physical, elementary};
    for (std::size_t k = 0; k < node_count(type); ++k) cell.nodes.push_back(words_.index());
    (is_line(type) ? mesh_.lines : mesh_.triangles).push_back(cell);
  }

  void body_2() {
    words_.expect("$Nodes");
    const long nodes = words_.integer();
    for (long n = 1; n <= nodes; ++n) {
      EXPECT_EQ(words_.integer(), n);
      point();
    }
    words_.expect("$EndNodes");
    words_.expect("$Elements");
    const long elements = words_.integer();
    for (long e = 1; e <= elements; ++e) {
      EXPECT_EQ(words_.integer(), e);
      const long type = words_.integer();
      words_.expect("2");
      const long physical = words_.integer();
      element(type, physical, words_.integer());
    }
  }

  void body_4() {
    words_.expect("$Entities");
    words_.expect("0");
    const long curves = words_.integer(), surfaces = words_.integer();
    words_.expect("0");
    for (long k = 0; k < curves + surfaces; ++k) {
      const long tag = words_.integer();
      for (int b = 0; b < 6; ++b) words_.number();
      words_.expect("1");
      physical_[{k < curves ? 1 : 2, tag}] = words_.integer();
      words_.expect("0");
    }
    words_.expect("$EndEntities");
    words_.expect("$Nodes");
    words_.expect("1");
    const long nodes = words_.integer();
    words_.expect("1");
    EXPECT_EQ(words_.integer(), nodes);
    words_.expect("2");
    EXPECT_TRUE(physical_.contains({2, words_.integer()}));
    words_.expect("0");
    EXPECT_EQ(words_.integer(), nodes);
    for (long n = 1; n <= nodes; ++n) EXPECT_EQ(words_.integer(), n);
    for (long n = 1; n <= nodes; ++n) point();
    words_.expect("$EndNodes");
    elements_4();
  }

  void elements_4() {
    words_.expect("$Elements");
    const long blocks = words_.integer(), elements = words_.integer();
    words_.expect("1");
    EXPECT_EQ(words_.integer(), elements);
    long next = 1;
    for (long b = 0; b < blocks; ++b) {
      const long dimension = words_.integer(), tag = words_.integer(), type = words_.integer();
      for (long n = words_.integer(); n > 0; --n) {
        EXPECT_EQ(words_.integer(), next++);
        EXPECT_EQ(physical_.at({dimension, tag}), tag);
        element(type, tag, 0);
      }
    }
    EXPECT_EQ(next, elements + 1);
  }

  testing::Words words_;
  std::string version_;
  std::map<std::pair<long, long>, long> physical_;
  WrittenMesh mesh_;
};

class WriteMsh : public ::testing::TestWithParam<const char*> {
 protected:
  WrittenMesh written(WriteOptions options) {
    options.msh = GetParam();
    const Status status = write_msh(output_, path_, options);
    EXPECT_TRUE(status) << status.error().message;
    return MshParser(path_).parse();
  }

  testing::TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "x.msh").string();
  Output output_ = testing::odd_device();
};

TEST_P(WriteMsh, HoldsEverything) {
  const WrittenMesh file = written({});
  testing::expect_same_triangles_unordered(output_, file);
  testing::expect_region_groups(output_, file);
  testing::expect_same_lines(output_, file);
  EXPECT_EQ(file.region_names.begin()->first, 1);
}

TEST_P(WriteMsh, LeavesOutInnerLines) {
  WriteOptions options;
  options.inner_lines = false;
  const WrittenMesh all = written({}), outer = written(options);
  testing::expect_same_lines(output_, outer, {.inner_lines = false});
  EXPECT_LT(outer.line_names.size(), all.line_names.size());
  for (const auto& [tag, name] : outer.line_names) EXPECT_EQ(all.line_names.at(tag), name);
}

TEST_P(WriteMsh, SecondOrder) {
  WriteOptions options;
  options.order = 2;
  const WrittenMesh file = written(options);
  testing::expect_same_triangles_unordered(output_, file, 2);
  testing::expect_region_groups(output_, file);
  testing::expect_same_lines(output_, file);
}

TEST_P(WriteMsh, HullWithoutSegments) {
  output_ = testing::structured_mesh(4, 2);
  const WrittenMesh file = written({});
  EXPECT_EQ(file.lines.size(), 14U);
  EXPECT_EQ(file.line_names, (std::map<long, std::string>{{3, "Si_SiO2"}, {4, "hull"}}));
}

TEST_P(WriteMsh, NoEntityIsInTwoGroups) {
  // One interface, of which boundary markers make three groups.
  Input input = testing::checker(2, 4, 7);
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    input.segments[s].marker = static_cast<int>(s % 3);
  }
  output_ = cover_mesh(input).value();
  const WrittenMesh file = written({});
  EXPECT_GE(file.line_names.size(), 3U);
  std::map<long, long> group_of;
  for (const WrittenCell& line : file.lines) {
    if (line.entity != 0) {
      EXPECT_EQ(group_of.emplace(line.entity, line.number).first->second, line.number);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, WriteMsh, ::testing::Values("2.2", "4.1"),
                         [](const auto& tested) { return tested.param[0] == '2' ? "V2" : "V4"; });

}  // namespace
}  // namespace cover
