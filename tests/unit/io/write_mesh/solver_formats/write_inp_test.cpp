// Names are upper case in this format and coordinates have at most 20 characters.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <cover/mesh_view.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using testing::WrittenCell;
using testing::WrittenMesh;

struct Deck {
  WrittenMesh mesh;  ///< triangles numbered by their set, from 1
  std::vector<std::string> element_types;
  std::map<std::string, std::set<std::uint32_t>> node_sets;
  std::map<std::string, std::set<std::uint32_t>> element_sets;
  std::map<std::string, std::vector<std::pair<std::string, int>>> surfaces;  ///< sets and edges
  std::size_t longest_number = 0;
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream text(line);
  for (std::string field; std::getline(text >> std::ws, field, ',');) fields.push_back(field);
  return fields;
}

Deck parse_inp_text(const std::string& path) {
  Deck deck;
  std::istringstream text(testing::content(path));
  std::map<long, WrittenCell> elements;
  std::string card, set;
  for (std::string line; std::getline(text, line);) {
    const std::vector<std::string> fields = split(line);
    if (line[0] == '*') {
      card = fields[0];
      set = fields.back().substr(fields.back().find('=') + 1);
      if (card == "*ELEMENT") {
        deck.element_types.push_back(fields[1]);
        deck.mesh.region_names[static_cast<long>(deck.element_types.size())] = set;
      }
    } else if (card == "*NODE") {
      EXPECT_EQ(std::stoul(fields[0]), deck.mesh.points.size() + 1);
      for (const auto& field : fields)
        deck.longest_number = std::max(deck.longest_number, field.size());
      deck.mesh.points.push_back(
          {std::strtod(fields[1].c_str(), nullptr), std::strtod(fields[2].c_str(), nullptr)});
    } else if (card == "*ELEMENT") {
      WrittenCell& cell = elements[std::stol(fields[0])];
      cell.number = static_cast<long>(deck.element_types.size());
      for (std::size_t k = 1; k < fields.size(); ++k)
        cell.nodes.push_back(static_cast<std::uint32_t>(std::stol(fields[k]) - 1));
    } else if (card == "*ELSET") {
      deck.element_sets[set].insert(static_cast<std::uint32_t>(std::stol(fields[0]) - 1));
    } else if (card == "*SURFACE") {
      deck.surfaces[set].emplace_back(fields[0], fields[1][1] - '1');
    } else {
      EXPECT_EQ(card, "*NSET");
      deck.node_sets[set].insert(static_cast<std::uint32_t>(std::stol(fields[0]) - 1));
    }
  }
  for (const auto& [number, cell] : elements) deck.mesh.triangles.push_back(cell);
  return deck;
}

class WriteInp : public ::testing::Test {
 protected:
  Deck written(const WriteOptions& options) {
    const Status status = write_inp(output_, path_, options);
    EXPECT_TRUE(status) << status.error().message;
    return parse_inp_text(path_);
  }

  testing::TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "x.inp").string();
  Output output_ = testing::odd_device();
};

TEST_F(WriteInp, ElementSetsByRegion) {
  Deck deck = written({});
  EXPECT_EQ(deck.element_types, std::vector<std::string>(3, "TYPE=S3"));
  EXPECT_EQ(deck.mesh.region_names,
            (std::map<long, std::string>{{1, "SI__N_"}, {2, "SIO____OXIDE"}, {3, "SI__N__2"}}));
  testing::expect_same_triangles(output_, deck.mesh);
  deck.mesh.region_names = {{1, "Si__n_"}, {2, "SiO____oxide"}, {3, "Si__n__2"}};
  testing::expect_region_groups(output_, deck.mesh);
}

TEST_F(WriteInp, NodeSetsByLine) {
  const Deck deck = written({});
  std::map<std::string, std::set<std::uint32_t>> expected;
  const TriMesh& tri = output_.mesh.tri();
  for (const auto e : tri.edges()) {
    const InterfaceId id = output_.mesh.interface(e);
    if (id == kNoInterface) continue;
    const std::string& name = output_.table.interface(id).name;
    for (const auto v : {tri.to_vertex_handle(tri.s_halfedge_handle(e, 0)),
                         tri.to_vertex_handle(tri.s_halfedge_handle(e, 1))})
      expected[name].insert(static_cast<std::uint32_t>(v.idx()));
  }
  EXPECT_EQ(deck.node_sets.at("GATE"), expected.at("gate"));
  EXPECT_EQ(deck.node_sets.at("DRAIN_CONTACT"), expected.at("drain contact"));
  EXPECT_EQ(deck.node_sets.at("SI_SIO____TRAP"), expected.at("Si/SiO\xe2\x82\x82 trap"));
}

TEST_F(WriteInp, NamesThatDifferInCaseOnly) {
  output_ = testing::structured_mesh(2, 1);
  output_.table.regions[0].name = "oxide";
  output_.table.regions[1].name = "Oxide";
  output_.table.interfaces[0].name = "1st";
  const Deck deck = written({});
  EXPECT_EQ(deck.mesh.region_names, (std::map<long, std::string>{{1, "OXIDE"}, {2, "OXIDE_2"}}));
  EXPECT_TRUE(deck.node_sets.contains("X1ST"));
}

TEST_F(WriteInp, NoSetIsTheSetOfAllNodes) {
  output_ = testing::structured_mesh(2, 1);
  output_.table.interfaces[0].name = "Nall";
  const Deck deck = written({});
  EXPECT_TRUE(deck.node_sets.contains("NALL_2"));
  EXPECT_FALSE(deck.node_sets.contains("NALL"));
}

TEST_F(WriteInp, NamesHaveAtMostEightyCharacters) {
  output_ = testing::structured_mesh(2, 1);
  output_.table.regions[0].name = std::string(80, 'a') + "x";
  output_.table.regions[1].name = std::string(80, 'a') + "y";
  output_.table.interfaces[0].name = std::string(80, '1');
  const Deck deck = written({});
  EXPECT_EQ(
      deck.mesh.region_names,
      (std::map<long, std::string>{{1, std::string(80, 'A')}, {2, std::string(78, 'A') + "_2"}}));
  EXPECT_TRUE(deck.node_sets.contains("X" + std::string(79, '1')));
}

/// By surface, the edges of its triangles as they run around these.
std::map<std::string, std::set<std::pair<std::uint32_t, std::uint32_t>>> edges_of_surfaces(
    const Deck& deck) {
  std::map<std::string, std::set<std::pair<std::uint32_t, std::uint32_t>>> edges;
  for (const auto& [name, sides] : deck.surfaces) {
    for (const auto& [set, edge] : sides) {
      for (const std::uint32_t t : deck.element_sets.at(set)) {
        const auto& nodes = deck.mesh.triangles[t].nodes;
        const auto k = static_cast<std::size_t>(edge);
        EXPECT_TRUE(edges[name].emplace(nodes[k], nodes[(k + 1) % 3]).second);
      }
    }
  }
  return edges;
}

TEST_F(WriteInp, LinesAreSurfacesOfPlaneElements) {
  WriteOptions options;
  options.inp_element = "CPE";
  for (const int order : {1, 2}) {
    options.order = order;
    const MeshView view = view_of(output_, options);
    std::map<std::string, std::set<std::pair<std::uint32_t, std::uint32_t>>> expected;
    const std::vector<std::string> names = abaqus_names(node_sets(view));
    for (std::size_t l = 0; l < view.lines.size(); ++l)
      expected[names[view.line_group[l]]].emplace(view.lines[l][0], view.lines[l][1]);
    ASSERT_GE(expected.size(), 3U);
    EXPECT_EQ(edges_of_surfaces(written(options)), expected);
  }
}

TEST_F(WriteInp, EdgesOfShellsAreNoSurfaces) {
  // Abaqus calls them E1, CalculiX S3.
  const Deck deck = written({});
  EXPECT_TRUE(deck.surfaces.empty());
  EXPECT_TRUE(deck.element_sets.empty());
}

TEST_F(WriteInp, ASetOfEdgesHasNoNameOfARegion) {
  output_ = testing::structured_mesh(2, 1);
  output_.table.regions[0].name = "gate_s1";
  output_.table.interfaces[0].name = "gate";
  WriteOptions options;
  options.inp_element = "CPS";
  const Deck deck = written(options);
  EXPECT_EQ(deck.mesh.region_names.at(1), "GATE_S1");
  EXPECT_FALSE(deck.element_sets.contains("GATE_S1"));
  EXPECT_TRUE(deck.surfaces.contains("GATE"));
}

TEST_F(WriteInp, SurfacesAreReadAsLines) {
  WriteOptions options;
  options.inp_element = "CAX";
  for (const int order : {1, 2}) {
    options.order = order;
    ASSERT_TRUE(write_inp(output_, path_, options));
    const Result<Output> read = read_output(path_);
    ASSERT_TRUE(read) << read.error().message;
    std::map<std::string, std::size_t> edges, expected;
    const auto count = [](const Output& output, auto& by_name) {
      for (const auto e : output.mesh.tri().edges()) {
        const InterfaceId id = output.mesh.interface(e);
        if (id != kNoInterface) ++by_name[output.table.interface(id).name];
      }
    };
    count(*read, edges);
    count(output_, expected);
    EXPECT_EQ(edges.at("GATE"), expected.at("gate"));
    EXPECT_EQ(edges.at("DRAIN_CONTACT"), expected.at("drain contact"));
  }
}

TEST_F(WriteInp, PlaneElementsOfSecondOrder) {
  WriteOptions options;
  options.order = 2;
  options.inp_element = "CPS";
  const Deck deck = written(options);
  EXPECT_EQ(deck.element_types.front(), "TYPE=CPS6");
  testing::expect_same_triangles(output_, deck.mesh, 2);
}

TEST_F(WriteInp, NoNumberIsLongerThanItsReadersTake) {
  // Twenty-two and more characters in the shortest form that is exact.
  output_ = testing::structured_mesh(2, 1);
  TriMesh& tri = output_.mesh.tri();
  for (const auto v : tri.vertices()) {
    TriMesh::Point& p = tri.point(v);
    p = {-p[0] * 1e-7 / 7 - 1e-123 / 9, p[1] * 1e-4 / 11 - 1e-9 / 13, 0};
  }
  const Deck deck = written({});
  EXPECT_EQ(deck.longest_number, 20U);
  for (const auto v : tri.vertices()) {
    const Point p = deck.mesh.points[static_cast<std::size_t>(v.idx())];
    EXPECT_LE(std::abs(p.x - tri.point(v)[0]), 1e-12 * std::abs(p.x));
    EXPECT_LE(std::abs(p.y - tri.point(v)[1]), 1e-12 * std::abs(p.y));
  }
  std::size_t moved = 0;
  for (const auto v : tri.vertices()) {
    const Point p = deck.mesh.points[static_cast<std::size_t>(v.idx())];
    if (p.x != tri.point(v)[0] || p.y != tri.point(v)[1]) ++moved;
  }
  EXPECT_GT(moved, 0U);
  EXPECT_EQ(points_rounded_by_inp(output_), moved);
}

TEST_F(WriteInp, CoordinatesThatFitAreNotRounded) {
  EXPECT_EQ(points_rounded_by_inp(output_), 0U);
  TriMesh& tri = output_.mesh.tri();
  for (const auto v : tri.vertices()) tri.point(v)[0] += 0.12345678901234567;
  EXPECT_EQ(points_rounded_by_inp(output_), 0U);
  WriteOptions curved;
  curved.order = 2;
  tri.point(tri.vertex_handle(0))[1] = 1.2345678901234567e-9;
  const std::size_t corners = points_rounded_by_inp(output_);
  EXPECT_EQ(corners, 1U);
  EXPECT_GT(points_rounded_by_inp(output_, curved), corners);  // midpoints beside it
}

TEST_F(WriteInp, TrianglesThatRoundingWouldFlattenAreRefused) {
  // Abscissas differ in digits that twenty characters do not hold.
  output_ = testing::structured_mesh(2, 1);
  TriMesh& tri = output_.mesh.tri();
  for (const auto v : tri.vertices()) {
    TriMesh::Point& p = tri.point(v);
    p[0] = 1.2345678901234567e-5 + 1e-20 * p[0];
    p[0] = -p[0];
  }
  const std::string path = (folder_.path() / "flat.inp").string();
  const Status status = write_inp(output_, path);
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
  EXPECT_EQ(status.error().where.size(), tri.n_faces());
  EXPECT_NE(status.error().message.find("4 triangles are flat or turned over"), std::string::npos)
      << status.error().message;
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace cover
