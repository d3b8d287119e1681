// Stored arrays become an Output again, or an error says what is wrong with them.
#include <cover/curved_mesh.hpp>
#include <cover/mesh.hpp>
#include <cover/stored_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "geom/topology/half_edges.hpp"

namespace cover {
namespace {

/// Two squares side by side, of material 7 and 9: the left one is region 1.
StoredMesh two_squares() {
  StoredMesh stored;
  stored.soup.points = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
  stored.soup.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  stored.soup.region = {1, 1, 2, 2};
  stored.soup.material = {7, 7, 9, 9};
  stored.input_vertices = 6;
  return stored;
}

TEST(Rebuild, MakesUpRegionsAndInterfacesWhereNoneAreStored) {
  const Result<Output> output = rebuild(two_squares());
  ASSERT_TRUE(output) << output.error().message;
  ASSERT_EQ(output->table.regions.size(), 2u);
  EXPECT_EQ(output->table.regions[0].material, 7);
  EXPECT_EQ(output->table.regions[1].name, "material_9");
  EXPECT_DOUBLE_EQ(output->table.regions[0].area, 1);
  EXPECT_EQ(output->mesh.tri().n_faces(), 4u);
  // One line between the squares, and each one's border to the void.
  ASSERT_EQ(output->table.interfaces.size(), 3u);
  double length = 0;
  for (const Interface& line : output->table.interfaces) {
    length += line.length;
    if (line.left != kVoid && line.right != kVoid) {
      EXPECT_DOUBLE_EQ(line.length, 1);
    }
  }
  EXPECT_DOUBLE_EQ(length, 7);
  EXPECT_EQ(output->pslg.segments.size(), 7u);
  EXPECT_EQ(output->report.steiner_vertices, 0u);
  EXPECT_DOUBLE_EQ(output->report.quality.largest_nu.supplement().in_degrees(), 90);
}

/// Unit squares where `rows` have '#', the lowest row last, each of two triangles; the corners of
/// letters have points of their own.
StoredMesh squares(const std::vector<std::string>& rows, bool clockwise = false) {
  StoredMesh stored;
  std::map<std::tuple<double, double, char>, std::uint32_t> numbers;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      const char kind = rows[row][column];
      if (kind == '.') continue;
      const auto corner = [&](std::size_t right, std::size_t up) {
        const auto x = static_cast<double>(column + right);
        const auto y = static_cast<double>(rows.size() - 1 - row + up);
        const auto next = static_cast<std::uint32_t>(stored.soup.points.size());
        const auto [known, is_new] = numbers.emplace(std::tuple(x, y, kind), next);
        if (is_new) stored.soup.points.push_back({x, y});
        return known->second;
      };
      const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
      for (const IndexTriple& t : {IndexTriple{a, b, c}, IndexTriple{a, c, d}})
        stored.soup.triangles.push_back(clockwise ? IndexTriple{t[0], t[2], t[1]} : t);
    }
  }
  stored.soup.region.assign(stored.soup.triangles.size(), 1);
  stored.soup.material = stored.soup.region;
  return stored;
}

/// The letter or digit that stands in `names` where each void has its place, in order.
std::string voids_of(const StoredMesh& stored, const std::vector<std::string>& names) {
  const Result<Output> output = rebuild(stored);
  if (!output) return output.error().message;
  std::string found;
  for (const Point p : output->table.void_seeds)
    found += names[names.size() - 1 - static_cast<std::size_t>(p.y)][static_cast<std::size_t>(p.x)];
  std::sort(found.begin(), found.end());
  return found;
}

/// What squares() takes, of rows in which voids have numbers.
std::vector<std::string> without_digits(std::vector<std::string> rows) {
  for (std::string& row : rows)
    for (char& c : row) c = std::isdigit(c) != 0 ? '.' : c;
  return rows;
}

TEST(Rebuild, PutsAPlaceInsideEveryVoid) {
  EXPECT_TRUE(rebuild(two_squares())->table.void_seeds.empty());
  // One with an island that has a void itself, two that meet in a point, and a bay.
  const std::vector<std::string> names{
      "##########",  //
      "#1111111##",  //
      "#1###1###.",  //
      "#1#2#1###.",  //
      "#1###1####",  //
      "#11111#3##",  //
      "#######3##",  //
      "######4###",  //
      "##########",
  };
  EXPECT_EQ(voids_of(squares(without_digits(names)), names), "1234");
  EXPECT_EQ(voids_of(squares(without_digits(names), true), names), "1234");
}

TEST(Rebuild, EdgesOnOneAnotherEncloseNoVoid) {
  // Parts with points of their own, of which A lies wholly in a void of B but for D.
  const std::vector<std::string> names{
      "BBBBBB",  //
      "BAAAAB",  //
      "BA12AB",  //
      "BAAADB",  //
      "B3BBBB",  //
      "BBBBBB",
  };
  std::string found = voids_of(squares(without_digits(names)), names);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0] == '1' || found[0] == '2');
  EXPECT_EQ(found[1], '3');
}

TEST(Rebuild, TellsOfABorderThatMeetsItself) {
  StoredMesh stored = squares({"###", "#.#", "###"});
  // A triangle of its own, of which one corner lies inside a side of the void.
  const auto n = static_cast<std::uint32_t>(stored.soup.points.size());
  for (const Point p : {Point{1, 1.5}, {1.5, 1.25}, {1.5, 1.75}}) stored.soup.points.push_back(p);
  stored.soup.triangles.push_back({n, n + 1, n + 2});
  stored.soup.region.push_back(1);
  stored.soup.material.push_back(1);
  const Result<Output> output = rebuild(stored);
  ASSERT_TRUE(output) << output.error().message;
  EXPECT_TRUE(output->table.void_seeds.empty());
  ASSERT_EQ(output->report.notes.size(), 1U);
  EXPECT_EQ(output->report.notes[0].message,
            "the border of the mesh meets itself at (1, 1.5): what it encloses stays unknown, and "
            "a .poly has no holes");
}

TEST(Rebuild, KeepsNodesOfCurvedEdges) {
  StoredMesh stored = two_squares();
  EXPECT_FALSE(rebuild(stored)->nodes);
  stored.second_order = true;
  EXPECT_TRUE(rebuild(stored)->nodes);
  // Between the squares and on the outline, both to the right.
  stored.nodes = {{1, 4, {1.1, 0.5}}, {2, 5, {2.2, 0.5}}};
  const Result<Output> output = rebuild(stored);
  ASSERT_TRUE(output) << output.error().message;
  const CurvedMesh curved = curved_mesh(*output);
  EXPECT_TRUE(curved.not_valid.empty());
  ASSERT_EQ(curved.moved.size(), 2U);
  EXPECT_EQ(curved.moved[0].middle, (Point{1.1, 0.5}));
  ASSERT_EQ(curved.areas.size(), 2U);
  EXPECT_NEAR(curved.areas[0], 1 + 0.2 / 3, 1e-15);
  EXPECT_NEAR(curved.areas[1], 1 + 0.2 / 3, 1e-15);
  stored.nodes = {{1, 4, {0.2, 0.9}}};
  EXPECT_FALSE(curved_mesh(rebuild(stored).value()).not_valid.empty());
  stored.nodes = {{0, 5, {1, 0.5}}};
  EXPECT_EQ(rebuild(stored).error().message, "the node between vertices 0 and 5 is on no edge");
  stored.nodes = {{0, 1, {0.5, std::numeric_limits<double>::infinity()}}};
  EXPECT_EQ(rebuild(stored).error().message, "the node between vertices 0 and 1 is nowhere");
}

TEST(Rebuild, VerticesPutOnSegmentsAreNoPointsOfTheInput) {
  StoredMesh stored = two_squares();
  stored.cut_vertices = 2;
  const Result<Output> output = rebuild(stored);
  ASSERT_TRUE(output) << output.error().message;
  EXPECT_EQ(output->pslg.point_ids, (std::vector<long>{0, 1, 2, 3, -1, -1}));
  EXPECT_EQ(output->report.input_points, 4u);
}

TEST(Rebuild, KeepsNamesAndMarkersOfEdges) {
  StoredMesh stored = two_squares();
  stored.names = {"", "gate"};
  stored.edges = {{0, 1, kNoInterface, 5, 1}};
  const Result<Output> output = rebuild(stored);
  ASSERT_TRUE(output) << output.error().message;
  bool found = false;
  for (const auto e : output->mesh.tri().edges()) {
    if (output->mesh.marker(e) == 0) continue;
    EXPECT_EQ(output->mesh.marker(e), 5);
    found = output->table.interface(output->mesh.interface(e)).name == "gate";
  }
  EXPECT_TRUE(found);
}

TEST(Rebuild, SaysWhatIsWrong) {
  const struct {
    std::function<void(StoredMesh&)> damage;
    std::string message;
  } cases[] = {
      {[](StoredMesh& m) { m.soup.region.pop_back(); }, "one region and one material per triangle"},
      {[](StoredMesh& m) { m.soup.points[2].x = HUGE_VAL; }, "a coordinate is not finite"},
      {[](StoredMesh& m) { m.input_vertices = 7; }, "more input points than points"},
      {[](StoredMesh& m) { m.cut_vertices = 7; }, "more points put on segments than points"},
      {[](StoredMesh& m) { m.names.clear(); }, "do not begin with the empty one"},
      {[](StoredMesh& m) { m.names = {"gate"}; }, "do not begin with the empty one"},
      {[](StoredMesh& m) { m.regions.resize(2); }, "region 1 has the number 0"},
      {[](StoredMesh& m) { m.interfaces.resize(1); }, "interface 1 has the number 0"},
      {[](StoredMesh& m) {
         m.edges = {{0, 77, kNoInterface, 1, 0}};
       },
       "from vertex 0 to vertex 77 is no edge"},
      {[](StoredMesh& m) {
         m.edges = {{0, 1, kNoInterface, 1, 1}};
       },
       "there is no interface"},
      {[](StoredMesh& m) { m.soup.triangles[3][1] = 6; }, "triangle 3 has no vertex 6"},
      {[](StoredMesh& m) { m.soup.region[1] = 0; }, "triangle 1 has RegionId 0"},
      {[](StoredMesh& m) { m.soup.region[1] = 77; }, "triangle 1 has RegionId 77"},
      {[](StoredMesh& m) { m.soup.material[2] = std::int64_t{1} << 40; },
       "triangle 2 has the material 1099511627776"},
      {[](StoredMesh& m) {
         m.soup.triangles[1] = {0, 1, 3};
       },
       "triangles overlap"},
      {[](StoredMesh& m) {
         m.edges = {{0, 5, kNoInterface, 1, 0}};
       },
       "from vertex 0 to vertex 5 is no edge"},
      {[](StoredMesh& m) {
         m.edges = {{0, 1, InterfaceId(3), 1, 0}};
       },
       "there is no interface 3"},
  };
  for (const auto& [damage, message] : cases) {
    StoredMesh stored = two_squares();
    damage(stored);
    const Result<Output> output = rebuild(stored);
    ASSERT_FALSE(output) << message;
    EXPECT_EQ(output.error().code, ErrorCode::syntax);
    EXPECT_NE(output.error().message.find(message), std::string::npos) << output.error().message;
  }
}

}  // namespace
}  // namespace cover
