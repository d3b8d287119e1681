#include "support/written_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "base/words/safe_names.hpp"
#include "geom/vector.hpp"

namespace cover::testing {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Ends = std::array<std::uint32_t, 2>;

/// Adds points once and segments between them.
class Drawing {
 public:
  Input input;

  std::uint32_t point(Point p) {
    const auto found = std::find(input.points.begin(), input.points.end(), p);
    if (found != input.points.end())
      return static_cast<std::uint32_t>(found - input.points.begin());
    input.points.push_back(p);
    return static_cast<std::uint32_t>(input.points.size() - 1);
  }
  void line(Point from, Point to, const std::string& name = "", int marker = 0) {
    InputSegment s;
    s.a = point(from);
    s.b = point(to);
    s.name = name;
    s.marker = marker;
    input.segments.push_back(s);
  }
  void seed(Point at, const std::string& region, const std::string& material) {
    RegionSeed s;
    s.at = at;
    s.region = region;
    s.material = material;
    input.seeds.push_back(s);
  }
};

Input odd_input() {
  const double a = 1.0 / 3, b = 1.1, c = b + 1e-3 / 7, top = 0.7 + 1e-10 / 3;
  const std::string odd = "Si/\"n\"", metal = "drain contact";
  Drawing d;
  // Left square with a named part of its right border, and a contact on its left.
  d.line({0, 0}, {a, 0});
  d.line({a, 0}, {a, 0.25});
  d.line({a, 0.25}, {a, 0.5}, "Si/SiO\xe2\x82\x82 trap");
  d.line({a, 0.5}, {a, top});
  d.line({a, top}, {0, top});
  d.line({0, top}, {0, 0}, "gate", 11);
  d.line({a / 4, 0.2}, {a / 2, 0.3});
  d.point({a / 3, 0.5});
  d.seed({0.01, 0.01}, odd, "silicon");
  // Middle with a void in it.
  d.line({a, 0}, {b, 0}, metal);
  d.line({b, 0}, {b, top});
  d.line({b, top}, {a, top});
  d.line({0.5, 0.2}, {0.75, 0.2});
  d.line({0.75, 0.2}, {0.75, 0.4});
  d.line({0.75, 0.4}, {0.5, 0.4});
  d.line({0.5, 0.4}, {0.5, 0.2});
  d.seed({0.9, 0.5}, "SiO\xe2\x82\x82 oxide", "oxide");
  // A thin sliver on the right: the name of the left square, another material.
  d.line({b, 0}, {c, 0}, metal);
  d.line({c, 0}, {c, top});
  d.line({c, top}, {b, top});
  d.seed({(b + c) / 2, 0.3}, odd, "metal");
  // Above the left square, touching in its corner only; same name and material as that.
  d.line({0, top}, {-1, top});
  d.line({-1, top}, {-1, 2});
  d.line({-1, 2}, {0, 2});
  d.line({0, 2}, {0, top});
  d.seed({-0.5, 1}, odd, "silicon");
  d.input.void_rule = VoidRule::unseeded_faces;
  return d.input;
}

Corners corners_of(const TriMesh& tri, TriMesh::FaceHandle face) {
  Corners corners{};
  std::size_t k = 0;
  for (const auto v : tri.fv_range(face)) corners.at(k++) = static_cast<std::uint32_t>(v.idx());
  return corners;
}

/// The same triangle from its smallest corner on.
Corners turned(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

Corners corners_of(const WrittenCell& cell) {
  return turned({cell.nodes.at(0), cell.nodes.at(1), cell.nodes.at(2)});
}

/// The face behind each cell of a file.
std::map<Corners, TriMesh::FaceHandle> faces_by_corners(const Output& output) {
  std::map<Corners, TriMesh::FaceHandle> faces;
  for (const auto f : output.mesh.tri().faces())
    faces.emplace(turned(corners_of(output.mesh.tri(), f)), f);
  return faces;
}

void expect_same_points(const Output& output, const WrittenMesh& file, int order) {
  const TriMesh& tri = output.mesh.tri();
  ASSERT_EQ(file.points.size(), tri.n_vertices() + (order == 2 ? tri.n_edges() : 0));
  for (const auto v : tri.vertices()) {
    const TriMesh::Point& p = tri.point(v);
    EXPECT_EQ(file.points[static_cast<std::size_t>(v.idx())], (Point{p[0], p[1]}));
  }
}

/// `middle` is the only node between `a` and `b`.
void expect_midpoint(const WrittenMesh& file, std::uint32_t a, std::uint32_t b,
                     std::uint32_t middle, std::map<Ends, std::uint32_t>& known) {
  const Ends ends{std::min(a, b), std::max(a, b)};
  EXPECT_EQ(known.emplace(ends, middle).first->second, middle);
  const Point p = file.points.at(a), q = file.points.at(b), m = file.points.at(middle);
  const Vector whole = q - p;
  EXPECT_LE(length((m - p) - 0.5 * whole), 1e-15 * (length(whole) + 1));
}

void expect_midpoints(const WrittenMesh& file) {
  std::map<Ends, std::uint32_t> known;
  for (const WrittenCell& t : file.triangles) {
    ASSERT_EQ(t.nodes.size(), 6U);
    for (std::size_t k = 0; k < 3; ++k)
      expect_midpoint(file, t.nodes[k], t.nodes[(k + 1) % 3], t.nodes[3 + k], known);
  }
  for (const WrittenCell& l : file.lines) {
    if (l.nodes.size() == 3) expect_midpoint(file, l.nodes[0], l.nodes[1], l.nodes[2], known);
  }
}

/// A line as it should be written.
struct ExpectedLine {
  InterfaceId interface;
  bool inner = false;
};

std::map<Ends, ExpectedLine> lines_of(const Output& output) {
  const TriMesh& tri = output.mesh.tri();
  std::map<Ends, ExpectedLine> lines;
  for (const auto e : tri.edges()) {
    const InterfaceId id = output.mesh.interface(e);
    if (id == kNoInterface) continue;
    const RegionId left = output.table.interface(id).left;
    for (const int side : {0, 1}) {
      const auto h = TriMesh::s_halfedge_handle(e, static_cast<unsigned>(side));
      if (tri.is_boundary(h) || output.mesh.region(tri.face_handle(h)) != left) continue;
      lines[{static_cast<std::uint32_t>(tri.from_vertex_handle(h).idx()),
             static_cast<std::uint32_t>(tri.to_vertex_handle(h).idx())}] = {id,
                                                                            !tri.is_boundary(e)};
    }
  }
  return lines;
}

/// Name and materials of both sides; of a contact the name alone.
using LineKey = std::tuple<std::string, int, int>;

LineKey key_of_line(const Output& output, const Interface& line) {
  const auto material = [&](RegionId region) {
    return line.kind == InterfaceKind::contact || region == kVoid
               ? 0
               : output.table.region(region).material;
  };
  return {line.name, material(line.left), material(line.right)};
}

/// `key` and `number` belong together and to nothing else.
template <class Key>
void expect_one_to_one(std::map<Key, long>& number_of, std::map<long, Key>& key_of, const Key& key,
                       long number) {
  EXPECT_EQ(number_of.emplace(key, number).first->second, number);
  EXPECT_EQ(key_of.emplace(number, key).first->second, key);
}

}  // namespace

Output odd_device() {
  Result<Output> output = cover_mesh(odd_input());
  EXPECT_TRUE(output) << output.error().message;
  return std::move(*output);
}

Output structured_mesh(int columns, int rows) {
  Output out;
  TriMesh& tri = out.mesh.tri();
  std::vector<TriMesh::VertexHandle> v;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i)
      v.push_back(tri.add_vertex({2.0 * i / columns, static_cast<double>(j) / rows / 3, 0}));
  }
  const auto at = [&](int i, int j) { return v[static_cast<std::size_t>(j * (columns + 1) + i)]; };
  for (int half = 0; half < 2; ++half) {
    for (int j = 0; j < rows; ++j) {
      for (int i = half * columns / 2; i < (half + 1) * columns / 2; ++i) {
        for (const auto f : {tri.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1)),
                             tri.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1))}) {
          out.mesh.set_region(f, RegionId(half + 1));
          out.mesh.set_material(f, half + 1);
        }
      }
    }
  }
  for (const int id : {1, 2}) {
    Region region;
    region.id = RegionId(id);
    region.material = id;
    region.name = region.material_name = id == 1 ? "Si" : "SiO2";
    out.table.regions.push_back(region);
  }
  Interface line;
  line.id = InterfaceId(1);
  line.name = "Si_SiO2";
  line.left = RegionId(1);
  line.right = RegionId(2);
  out.table.interfaces.push_back(line);
  for (int j = 0; j < rows; ++j) {
    const auto h = tri.find_halfedge(at(columns / 2, j), at(columns / 2, j + 1));
    out.mesh.set_interface(TriMesh::s_edge_handle(h), line.id);
  }
  return out;
}

void expect_same_triangles(const Output& output, const WrittenMesh& file, int order) {
  const TriMesh& tri = output.mesh.tri();
  expect_same_points(output, file, order);
  ASSERT_EQ(file.triangles.size(), tri.n_faces());
  for (const auto f : tri.faces()) {
    EXPECT_EQ(corners_of(file.triangles[static_cast<std::size_t>(f.idx())]),
              turned(corners_of(tri, f)));
  }
  if (order == 2) expect_midpoints(file);
}

void expect_same_triangles_unordered(const Output& output, const WrittenMesh& file, int order) {
  expect_same_points(output, file, order);
  const auto faces = faces_by_corners(output);
  std::set<Corners> seen;
  for (const WrittenCell& cell : file.triangles) {
    EXPECT_TRUE(faces.contains(corners_of(cell)));
    EXPECT_TRUE(seen.insert(corners_of(cell)).second);
  }
  EXPECT_EQ(seen.size(), faces.size());
  if (order == 2) expect_midpoints(file);
}

void expect_same_lines(const Output& output, const WrittenMesh& file, const Expected& expected) {
  auto lines = lines_of(output);
  std::map<LineKey, long> number_of;
  std::map<long, LineKey> key_of;
  std::set<long> region_numbers;
  const auto form = file.names_are_utf8 ? legible_name : safe_name;
  for (const WrittenCell& cell : file.triangles) region_numbers.insert(cell.number);
  for (const WrittenCell& cell : file.lines) {
    const Ends ends{cell.nodes.at(0), cell.nodes.at(1)};
    auto found = lines.find(ends);
    if (found == lines.end()) found = lines.find({ends[1], ends[0]});  // a slit has both sides
    ASSERT_NE(found, lines.end()) << "unexpected or reversed line " << ends[0] << ' ' << ends[1];
    const Interface& line = output.table.interface(found->second.interface);
    if (line.left != line.right) {
      EXPECT_EQ(found->first, ends) << "reversed";
    }
    EXPECT_TRUE(found->second.inner ? expected.inner_lines : expected.outer_lines);
    expect_one_to_one(number_of, key_of, key_of_line(output, line), cell.number);
    EXPECT_GT(cell.number, 0);
    if (!file.line_names.empty()) {
      EXPECT_EQ(file.line_names.at(cell.number).rfind(form(line.name), 0), 0U);
      EXPECT_FALSE(region_numbers.contains(cell.number));
    }
    if (cell.entity != 0) {
      EXPECT_EQ(cell.entity, static_cast<long>(line.id.value()));
    }
    lines.erase({ends[1], ends[0]});
    lines.erase(ends);
  }
  for (const auto& [ends, line] : lines) {
    EXPECT_FALSE(line.inner ? expected.inner_lines : expected.outer_lines)
        << "missing line " << ends[0] << ' ' << ends[1];
  }
}

void expect_materials(const Output& output, const WrittenMesh& file) {
  const auto faces = faces_by_corners(output);
  for (const WrittenCell& cell : file.triangles) {
    const auto face = faces.at(corners_of(cell));
    EXPECT_EQ(cell.number, output.mesh.material(face));
    if (cell.entity != 0) {
      EXPECT_EQ(cell.entity, static_cast<long>(output.mesh.region(face).value()));
    }
  }
}

void expect_region_groups(const Output& output, const WrittenMesh& file) {
  const auto faces = faces_by_corners(output);
  std::map<std::tuple<std::string, int>, long> number_of;
  std::map<long, std::tuple<std::string, int>> key_of;
  const auto form = file.names_are_utf8 ? legible_name : safe_name;
  for (const WrittenCell& cell : file.triangles) {
    const auto face = faces.at(corners_of(cell));
    const Region& region = output.table.region(output.mesh.region(face));
    expect_one_to_one(number_of, key_of, {region.name, region.material}, cell.number);
    EXPECT_EQ(file.region_names.at(cell.number).rfind(form(region.name), 0), 0U);
    if (cell.entity != 0) {
      EXPECT_EQ(cell.entity, static_cast<long>(region.id.value()));
    }
  }
  std::set<std::string> names;
  for (const auto& [number, name] : file.region_names) EXPECT_TRUE(names.insert(name).second);
  EXPECT_EQ(names.size(), number_of.size());
}

}  // namespace cover::testing
