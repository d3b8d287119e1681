// Periodic sides from the input to the files.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

#include <cover/mesh.hpp>
#include <cover/read_mesh.hpp>
#include <cover/remesh.hpp>
#include <cover/stored_mesh.hpp>
#include <cover/verify.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/periodic_cells.hpp"
#include "support/mesh_shape.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

using testing::must_mesh;
using testing::unpaired;

Options with_cuts() {
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.sizes = {{"", 0.3, false}};
  options.effort = Effort::fast;
  return options;
}

TEST(Periodic, EveryWayOfCuttingCutsBothSides) {
  const Input input = testing::random_cell(7, true);
  const std::size_t whole = must_mesh(input).pslg.points.size();
  for (const bool box_method : {false, true}) {
    Options options = with_cuts();
    options.box_method = box_method;
    const Output output = must_mesh(input, options);
    EXPECT_GT(output.pslg.points.size(), whole);
    EXPECT_EQ(unpaired(output), "");
    EXPECT_EQ(testing::violations(output), "");
  }
}

TEST(Periodic, TrianglesAboveTheTargetAreCutForOnBothSides) {
  Options options;
  options.split_interfaces = Angle::degrees(90);
  options.max_angle = Angle::degrees(90);
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Output output = must_mesh(testing::random_cell(seed, false), options);
    EXPECT_EQ(unpaired(output), "") << seed;
    EXPECT_EQ(testing::violations(output), "") << seed;
  }
}

TEST(Periodic, TheCentreOfASectorIsItsOwnPartner) {
  Input input;
  input.points = {{0, 0}, {2, 0}, {0, 2}};
  input.segments = {{0, 1, 0, 0, 0, "a"}, {1, 2, 0, 1, 0, ""}, {2, 0, 0, 2, 0, "b"}};
  input.periodic = {{"a", "b", PeriodicRule::Map::rotation, {0, 0}, Angle::degrees(90)}};
  const Output output = must_mesh(input);
  ASSERT_EQ(output.periodic.size(), 1U);
  EXPECT_EQ(output.periodic[0].vertices,
            (std::vector<std::array<std::uint32_t, 2>>{{0, 0}, {1, 2}}));
  EXPECT_EQ(periodic_classes(output.periodic, 3), (std::vector<std::uint32_t>{0, 1, 1}));
}

TEST(Periodic, ARuleThatIsGivenTwiceIsOne) {
  const Input input = testing::random_cell(3, true);
  ASSERT_FALSE(input.periodic.empty());
  const Output once = must_mesh(input);
  Options again;
  again.periodic = {input.periodic.front(), input.periodic.front()};
  EXPECT_EQ(must_mesh(input, again).periodic.size(), once.periodic.size());
}

TEST(Periodic, RegionsMeshedAgainStayPeriodic) {
  const Input input = testing::random_cell(11, true);
  const Output before = must_mesh(input, with_cuts());
  const std::vector<std::string> only{"region:1"};
  const Result<Output> after = remesh(input, triangle_soup(before.mesh), only);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(unpaired(*after), "");
}

TEST(Periodic, AMeshThatIsCutOnOneSideOnlyIsNotMeshedAgain) {
  Input input;
  input.points = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  input.segments = {
      {0, 1, 0, 0, 0, ""}, {1, 2, 0, 1, 0, "right"}, {2, 3, 0, 2, 0, ""}, {3, 0, 0, 3, 0, "left"}};
  Options options;
  options.split_interfaces = Angle::degrees(120);
  options.sizes = {{"left", 0.1, true}};
  const Output uneven = must_mesh(input, options);
  input.periodic = {{"left", "right", PeriodicRule::Map::translation, {}, {}}};
  const std::vector<std::string> only{"region:1"};
  const Result<Output> refused = remesh(input, triangle_soup(uneven.mesh), only);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::other_mesh);
  EXPECT_NE(refused.error().message.find("without a partner"), std::string::npos);
  EXPECT_FALSE(refused.error().where.empty());
  const Output even = must_mesh(input, options);
  EXPECT_TRUE(remesh(input, triangle_soup(even.mesh), only));
}

std::vector<std::string> lines_after(const std::string& path, const std::string& start) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  bool is_on = false;
  for (std::string line; std::getline(file, line);) {
    if (is_on) lines.push_back(line);
    is_on = is_on || line == start;
  }
  return lines;
}

TEST(Periodic, MshNamesCurvesMapsAndNodes) {
  const testing::TemporaryFolder folder;
  const Output output = must_mesh(testing::random_cell(7, true), with_cuts());
  for (const char* version : {"2.2", "4.1"}) {
    for (const int order : {1, 2}) {
      WriteOptions options;
      options.msh = version;
      options.order = order;
      const std::string path = folder.path() / "a.msh";
      ASSERT_TRUE(write_msh(output, path, options));
      const auto lines = lines_after(path, "$Periodic");
      ASSERT_FALSE(lines.empty());
      EXPECT_EQ(lines[0], "2");
      EXPECT_EQ(lines.back(), "$EndPeriodic");
      std::map<std::size_t, Point> node;
      const auto all = lines_after(path, "$Nodes");
      const std::size_t count = order == 1 ? output.mesh.vertices()
                                           : output.mesh.vertices() + output.mesh.tri().n_edges();
      for (std::size_t k = 0; k < count; ++k) {
        if (std::string(version) == "2.2") {
          std::istringstream in(all[1 + k]);
          std::size_t number = 0;
          in >> number;
          in >> node[number].x >> node[number].y;
        } else {
          std::istringstream in(all[2 + count + k]);
          in >> node[k + 1].x >> node[k + 1].y;
        }
      }
      std::size_t at = 1, pairs = 0;
      for (int link = 0; link < 2; ++link) {
        std::istringstream affine(lines[at + 1]);
        std::string word;
        affine >> word;
        EXPECT_EQ(word, std::string(version) == "2.2" ? "Affine" : "16");
        double m[16] = {};
        for (double& c : m) affine >> c;
        const std::size_t n = std::stoul(lines[at + 2]);
        for (std::size_t k = 0; k < n; ++k) {
          std::istringstream in(lines[at + 3 + k]);
          std::size_t image = 0, original = 0;
          in >> image >> original;
          const Point p = node.at(original), q = node.at(image);
          EXPECT_NEAR(m[0] * p.x + m[1] * p.y + m[3], q.x, 1e-14 * 4);
          EXPECT_NEAR(m[4] * p.x + m[5] * p.y + m[7], q.y, 1e-14 * 4);
        }
        at += 3 + n;
        pairs += n;
      }
      EXPECT_EQ(lines[at], "$EndPeriodic");
      std::size_t expected = 0;
      for (const PeriodicNodes& nodes : output.periodic)
        expected += nodes.vertices.size() + (order == 2 ? nodes.edges.size() : 0);
      EXPECT_EQ(pairs, expected);
    }
  }
}

TEST(Periodic, FilesAreReadBackWithTheirPairs) {
  const testing::TemporaryFolder folder;
  const Output output = must_mesh(testing::random_sector(4, true, false), with_cuts());
  const std::string path = folder.path() / "a.vtk";
  ASSERT_TRUE(write_vtk(output, path));
  ASSERT_TRUE(write_manifest(output, folder.path() / "a.json"));
  const auto nodes = lines_after(path, "SCALARS PeriodicNode int 1");
  const auto classes = periodic_classes(output.periodic, output.mesh.vertices());
  ASSERT_EQ(nodes.size(), classes.size() + 1);
  for (std::size_t v = 0; v < classes.size(); ++v)
    EXPECT_EQ(nodes[v + 1], std::to_string(classes[v]));
  const Result<Output> again = read_output(path);
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_EQ(again->periodic.size(), 1U);
  EXPECT_EQ(again->periodic[0].vertices, output.periodic[0].vertices);
  EXPECT_EQ(again->periodic[0].edges, output.periodic[0].edges);
  EXPECT_EQ(again->periodic[0].rule.from, "start");
  EXPECT_EQ(unpaired(*again), "");
  const auto report = nlohmann::json::parse(report_json(output));
  EXPECT_EQ(report.at("periodic").at(0).at("vertices"), output.periodic[0].vertices.size());
}

}  // namespace
}  // namespace cover
