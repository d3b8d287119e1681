// Tested by tests/unit/picture/picture_test.cpp.
#include <cover/curved_mesh.hpp>
#include <cover/mesh.hpp>
#include <cover/picture.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include "base/numbers.hpp"
#include "geom/vector.hpp"
#include "picture/parts/triangle_angles.hpp"

namespace cover {
namespace {

/// By triangle: the nodes of its edges, from the first on.
std::vector<std::array<Point, 3>> middles_of(const Output& output, const TriangleSoup& soup) {
  const CurvedMesh curved = curved_mesh(output);
  std::map<std::pair<std::uint32_t, std::uint32_t>, Point> node;
  for (const CurvedEdge& edge : curved.edges) node[std::minmax(edge.a, edge.b)] = edge.middle;
  for (const auto* nodes : {&curved.moved, &curved.rounded}) {
    for (const MovedNode& edge : *nodes) node[std::minmax(edge.a, edge.b)] = edge.middle;
  }
  std::vector<std::array<Point, 3>> middles;
  for (const auto& t : soup.triangles) {
    auto& of_triangle = middles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      const auto at = node.find(std::minmax(a, b));
      of_triangle[i] = at != node.end() ? at->second : midpoint(soup.points[a], soup.points[b]);
    }
  }
  return middles;
}

/// What each triangle has of an attribute of its region; of words, their numbers. None: NaN.
CellArray by_triangle(const Attribute& attribute, const TriangleSoup& soup) {
  CellArray array{attribute.name, {}};
  array.values.reserve(soup.triangles.size());
  for (const std::int64_t region : soup.region) {
    const double value = attribute.values[static_cast<std::size_t>(region) - 1];
    array.values.push_back(attribute.is_text && value == 0 ? kNoNumber : value);
  }
  return array;
}

}  // namespace

PictureMesh picture_of(const Output& output, int order) {
  PictureMesh picture;
  picture.mesh.soup = triangle_soup(output.mesh);
  if (order == 2) picture.mesh.middles = middles_of(output, picture.mesh.soup);
  picture.unit = output.report.unit;
  picture.mesh.arrays = {{"max_angle", largest_angles(picture.mesh.soup)},
                         {"min_angle", smallest_angles(picture.mesh.soup)}};
  for (const Attribute& attribute : output.table.attributes)
    picture.mesh.arrays.push_back(by_triangle(attribute, picture.mesh.soup));
  picture.mesh.point_arrays = output.fields;
  picture.region_values = output.region_values;
  for (const Region& region : output.table.regions) {
    picture.region_names[region.id.value()] = region.name;
    picture.material_names[region.material] = region.material_name;
  }
  for (const Interface& line : output.table.interfaces) {
    picture.lines.push_back({line.name, line.kind == InterfaceKind::contact, {}});
  }
  std::map<int, PictureLine> marked;  // a .poly names its contacts by number
  for (const auto edge : output.mesh.tri().edges()) {
    const InterfaceId line = output.mesh.interface(edge);
    if (line == kNoInterface) continue;
    const std::array<std::uint32_t, 2> ends{static_cast<std::uint32_t>(edge.v0().idx()),
                                            static_cast<std::uint32_t>(edge.v1().idx())};
    picture.lines[place_of(line)].edges.push_back(ends);
    const int marker = output.mesh.marker(edge);
    if (marker == 0 || picture.lines[place_of(line)].contact) continue;
    PictureLine& contact = marked[marker];
    contact.name = "marker " + std::to_string(marker);
    contact.contact = true;
    contact.edges.push_back(ends);
  }
  for (const PeriodicNodes& nodes : output.periodic) {
    std::vector<std::uint32_t>& vertices = picture.periodic.emplace_back();
    for (const auto& pair : nodes.vertices)
      vertices.insert(vertices.end(), pair.begin(), pair.end());
  }
  for (auto& entry : marked) picture.lines.push_back(std::move(entry.second));
  return picture;
}

}  // namespace cover
