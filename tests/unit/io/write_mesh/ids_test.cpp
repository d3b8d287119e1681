// Six coils of one copper: one number or six, in every format that has numbers.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include <cover/cover_mesh.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "written_text.hpp"

namespace cover {
namespace {

using Numbers = std::set<std::int64_t>;

Output six_coils() {
  Input input;
  const auto paint = [&](double x, double side, const char* material, const std::string& name) {
    InputPolygon square;
    square.rings = {{{x, x}, {x + side, x}, {x + side, x + side}, {x, x + side}}};
    square.material = material;
    square.region = name;
    input.polygons.push_back(square);
  };
  paint(0, 13, "air", "air");
  for (int k = 0; k < 6; ++k)  // coils 5 and 6 have one name
    paint(2 * k + 1, 1, "copper", "coil " + std::to_string(std::min(k, 4)));
  Result<Output> output = cover_mesh(std::move(input));
  EXPECT_TRUE(output) << output.error().message;
  return std::move(output).value();
}

class Ids : public ::testing::Test {
 protected:
  std::string write(const std::string& name, WriteOptions options) {
    const std::string path = folder_.path() / name;
    const Status status = write_mesh(output_, path, options);
    EXPECT_TRUE(status) << status.error().message;
    return path;
  }
  MeshFile read(const std::string& name, WriteOptions options) {
    Result<MeshFile> mesh = read_mesh(write(name, std::move(options)));
    EXPECT_TRUE(mesh) << mesh.error().message;
    return std::move(mesh).value();
  }
  static Numbers set_of(const std::vector<std::int64_t>& numbers) {
    return {numbers.begin(), numbers.end()};
  }
  static Numbers array_of(const MeshFile& mesh, const std::string& name) {
    for (const CellArray& array : mesh.arrays)
      if (array.name == name) return {array.values.begin(), array.values.end()};
    return {};
  }
  /// The k-th number behind the three nodes of each triangle.
  static Numbers attribute(const std::string& ele, std::size_t k) {
    std::istringstream text(testing::content(ele));
    std::string line;
    std::getline(text, line);
    Numbers out;
    while (std::getline(text, line)) {
      std::istringstream row(line);
      long number = 0;
      for (std::size_t column = 0; column < 5 + k; ++column) row >> number;
      out.insert(number);
    }
    return out;
  }

  testing::TemporaryFolder folder_;
  Output output_ = six_coils();
  const Numbers materials_ = [this] {
    Numbers out;
    for (const Region& region : output_.table.regions) out.insert(region.material);
    return out;
  }();
};

TEST_F(Ids, CountAsTheyShould) {
  ASSERT_EQ(output_.table.regions.size(), 7U);
  ASSERT_EQ(materials_.size(), 2U);
  const Numbers regions{1, 2, 3, 4, 5, 6, 7}, names{1, 2, 3, 4, 5, 6};
  for (const auto& [ids, numbers] : {std::pair<std::string, Numbers>{"region", regions},
                                     {"material", materials_},
                                     {"name", names},
                                     {"", materials_}}) {
    SCOPED_TRACE(ids);
    for (const char* version : {"2.2", "4.1"}) {
      const MeshFile msh = read("x.msh", {.msh = version, .ids = ids});
      EXPECT_EQ(set_of(msh.group), ids.empty() ? names : numbers);
      // Lines have other numbers.
      for (const MeshLine& line : msh.lines)
        EXPECT_FALSE(set_of(msh.group).contains(line.group)) << line.group;
    }
    EXPECT_EQ(set_of(read("x.mesh", {.ids = ids}).soup.material), numbers);
    const MeshFile vtk = read("x.vtk", {.ids = ids});
    EXPECT_EQ(array_of(vtk, "MaterialID"), numbers);
    EXPECT_EQ(array_of(vtk, "mat_id"), numbers);
    EXPECT_EQ(array_of(vtk, "material"), materials_);
    EXPECT_EQ(array_of(read("x.vtk", {.lines = true, .ids = ids}), "MaterialID"), numbers);
    EXPECT_EQ(set_of(read("x.vtk", {.lines = true, .ids = ids}).soup.material), materials_);
    const std::string ele = write("x.ele", {.ids = ids});
    EXPECT_EQ(attribute(ele, 0), numbers);
    EXPECT_EQ(attribute(ele, 1), regions);
    EXPECT_EQ(set_of(read("x.ele", {.ids = ids}).soup.material), materials_);
    const MeshFile xdmf = read("x.xdmf", {.ids = ids});
    EXPECT_EQ(set_of(xdmf.soup.material), materials_);
    EXPECT_EQ(set_of(xdmf.group), ids.empty() ? names : numbers);
    const std::string text = testing::content(folder_.path() / "x.xdmf");
    EXPECT_EQ(text.find("<Attribute"), text.find(ids.empty() ? "<Attribute Name=\"MaterialID\""
                                                             : "<Attribute Name=\"GroupID\""));
  }
}

TEST_F(Ids, NamesFollow) {
  EXPECT_EQ(read("x.msh", {.ids = "region"}).region_names.at(7), "coil 4_2");
  const MeshFile by_material = read("x.msh", {.ids = "material"});
  ASSERT_EQ(by_material.region_names.size(), 2U);
  EXPECT_EQ(by_material.region_names.at(output_.table.regions[6].material), "copper");
}

TEST_F(Ids, OthersAreRefused) {
  const Status status = can_write("x.msh", {.ids = "colour"});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::bad_option);
}

/// What is the same for any ids.
TEST_F(Ids, BlocksGridsAndMaterialsStay) {
  for (const char* name : {"x.vtu", "x.vtkhdf", "x.vtm"}) {
    const std::string before = testing::content(write(name, {}));
    EXPECT_EQ(testing::content(write(name, {.ids = "region"})), before) << name;
  }
}

}  // namespace
}  // namespace cover
