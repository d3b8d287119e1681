// What stands in a file, and in which order, follows from what its readers take: triangles only,
// the material first and as active scalars, no field data but where segments were cut.
// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtu_test.cpp.
#include "io/write_mesh/vtk_formats/vtu_parts.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <numeric>

#include "base/containers/order.hpp"
#include "base/containers/unset_vector.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// VTK's numbers of the types of cells.
enum class CellType : std::uint8_t {
  line = 3,
  triangle = 5,
  quadratic_edge = 21,
  quadratic_triangle = 22
};

/// A point as VTK has it.
using Place3 = std::array<double, 3>;

CellType type_of_triangles(const MeshView& view) {
  return view.second_order() ? CellType::quadratic_triangle : CellType::triangle;
}

struct PointBlock {
  std::size_t count;
  ArrayWriter coordinates;  ///< writes those of all
};

/// Cells of one type.
struct CellBlock {
  std::size_t count;
  CellType type;
  std::size_t nodes_each;
  ArrayWriter nodes;  ///< writes those of all
};

void add_cells(PointBlock points, CellBlock cells, VtuGrid& grid) {
  grid.points = points.count;
  grid.cells = cells.count;
  constexpr std::size_t kDimensions = 3;
  grid.coordinates = {NumberType::float64,
                      "Points",
                      kDimensions,
                      {},
                      points.count * kDimensions * sizeof(double),
                      std::move(points.coordinates)};
  grid.connectivity.push_back({NumberType::int64,
                               "connectivity",
                               1,
                               {},
                               cells.count * cells.nodes_each * sizeof(std::int64_t),
                               std::move(cells.nodes)});
  grid.connectivity.push_back(vtu_array<std::int64_t>(
      "offsets", cells.count, [each = cells.nodes_each](std::size_t k) { return (k + 1) * each; }));
  grid.connectivity.push_back(vtu_array<std::uint8_t>(
      "types", cells.count, [type = cells.type](std::size_t) { return type; }));
}

/// The same of `cells`; `point(p)` is a place.
template <class Place>
void add_cells(const Cells& cells, CellType type, std::size_t points, Place place, VtuGrid& grid) {
  ArrayWriter coordinates(points, sizeof(Place3),
                          [place](std::size_t first, std::size_t last, char* to) {
                            for (std::size_t p = first; p < last; ++p, to += sizeof(Place3)) {
                              const Point at = place(p);
                              const Place3 numbers{at.x, at.y, 0};
                              std::memcpy(to, numbers.data(), sizeof numbers);
                            }
                          });
  ArrayWriter nodes = array_of_values<std::int64_t>(
      cells.nodes.size(), [&cells](std::size_t k) { return cells.nodes[k]; });
  add_cells({points, std::move(coordinates)},
            {cells.size(), type, cells.nodes_each, std::move(nodes)}, grid);
}

/// The class of each point, where there are periodic sides; `number(p)` is its number in the whole
/// mesh.
template <class Number>
void add_periodic_nodes(const MeshView& view, std::size_t points, Number number, VtuGrid& grid) {
  if (view.periodic_node.empty()) return;
  grid.point_data.push_back(vtu_array<std::int64_t>(
      "PeriodicNode", points,
      [&view, number](std::size_t p) { return view.periodic_node[number(p)]; }));
}

/// Values that came with the input; `number(p)` is the number of a point in the whole mesh.
template <class Number>
void add_fields(const MeshView& view, std::size_t points, Number number, VtuGrid& grid) {
  for (const PlaneField::Array& field : view.fields)
    grid.point_data.push_back(vtu_array<double>(
        field.name, points, [&field, number](std::size_t p) { return field.values[number(p)]; }));
}

/// What meshio would take for an array: see make_readable_by_meshio().
bool is_found_twice(const VtuGrid& grid) {
  std::vector<const VtuArray*> arrays;
  for (const auto* part : {&grid.point_data, &grid.cell_data})
    for (const VtuArray& array : *part) arrays.push_back(&array);
  arrays.push_back(&grid.coordinates);
  for (const VtuArray& array : grid.connectivity) arrays.push_back(&array);
  std::uint64_t offset = 0, in_base64 = 0;
  std::vector<std::uint64_t> replaced;
  for (const VtuArray* array : arrays) {
    if (std::find(replaced.begin(), replaced.end(), offset) != replaced.end()) return true;
    replaced.push_back(in_base64);
    const std::uint64_t size = sizeof array->bytes + array->bytes;
    offset += size;
    in_base64 += (size + 2) / 3 * 4;
  }
  return false;
}

/// Puts arrays of cells behind the first one into an order that meshio can read. It replaces the
/// offset of each appended array by a larger one, that in base64, and then takes the first array
/// that has the next offset it looks for: with four arrays of integers in front, every third mesh
/// came out wrong or not at all. Ours alone are in such an order.
void make_readable_by_meshio(VtuGrid& grid) {
  constexpr int kMostTries = 200;
  std::vector<std::size_t> order(grid.cell_data.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::vector<VtuArray> arrays = grid.cell_data;
  for (int tries = 0; tries < kMostTries && is_found_twice(grid); ++tries) {
    if (!std::next_permutation(order.begin() + 1, order.end())) return;
    for (std::size_t k = 0; k < order.size(); ++k) grid.cell_data[k] = arrays[order[k]];
  }
}

/// Some cells on points of their own: those of the cells, in the order of their numbers in the
/// whole mesh.
struct Part {
  Part(const Cells& all, std::span<const std::size_t> chosen) : cells{all.nodes_each, {}} {
    cells.nodes.reserve(cells.nodes_each * chosen.size());
    for (const std::size_t k : chosen) {
      const auto nodes = all[k];
      cells.nodes.insert(cells.nodes.end(), nodes.begin(), nodes.end());
    }
    numbers = cells.nodes;
    sort_unique(numbers);
    for (std::uint32_t& node : cells.nodes) {
      node = static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), node) -
                                        numbers.begin());
    }
  }

  /// The part as a grid that refers to it and to `view`.
  [[nodiscard]] VtuGrid grid(const MeshView& view, CellType type) const {
    VtuGrid out;
    out.point_attributes = " GlobalIds=\"GlobalNodeId\"";
    VtuArray ids = vtu_array<std::int64_t>("GlobalNodeId", numbers.size(),
                                           [this](std::size_t p) { return numbers[p]; });
    ids.more = " IdType=\"1\"";
    out.point_data.push_back(std::move(ids));
    add_periodic_nodes(
        view, numbers.size(), [this](std::size_t p) { return numbers[p]; }, out);
    add_fields(
        view, numbers.size(), [this](std::size_t p) { return numbers[p]; }, out);
    add_cells(
        cells, type, numbers.size(),
        [this, &view](std::size_t p) { return view.points[numbers[p]]; }, out);
    return out;
  }

  Cells cells;
  std::vector<std::uint32_t> numbers;  ///< by point: in the whole mesh
};

/// Has the last arrays of points, those of the fields, tell what the regions of `triangles` have
/// at the points of `part`. Of several that meet in one block the largest magnitude counts.
void set_values_of_regions(const MeshView& view, std::span<const std::size_t> triangles,
                           const Part& part, VtuGrid& grid) {
  for (std::size_t k = 0; k < view.region_values.size(); ++k) {
    const PlaneField::Array& field = view.fields[k];
    std::vector<bool> is_shared;
    for (const std::uint32_t vertex : part.numbers) {
      const auto found =
          std::lower_bound(view.region_values[k].begin(), view.region_values[k].end(), vertex,
                           [](const RegionValue& one, std::uint32_t v) { return one.vertex < v; });
      is_shared.push_back(found != view.region_values[k].end() && found->vertex == vertex);
    }
    if (std::find(is_shared.begin(), is_shared.end(), true) == is_shared.end()) continue;
    const auto values = std::make_shared<std::vector<double>>();
    for (const std::uint32_t vertex : part.numbers) values->push_back(field.values[vertex]);
    std::vector<bool> is_set(part.numbers.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (const std::uint32_t p : part.cells[t]) {
        if (!is_shared[p]) continue;
        const double value = value_in(view.fields, view.region_values, k, part.numbers[p],
                                      view.region[triangles[t]]);
        (*values)[p] = is_set[p] ? larger_value((*values)[p], value) : value;
        is_set[p] = true;
      }
    }
    grid.point_data[grid.point_data.size() - view.fields.size() + k] = vtu_array<double>(
        field.name, values->size(), [values](std::size_t p) { return (*values)[p]; });
  }
}

/// The largest and the smallest angle of a triangle of `view`, in degrees.
std::array<double, 2> extreme_angles(const MeshView& view, std::size_t triangle) {
  const auto corners = view.triangles[triangle];
  return extreme_degrees(view.points[corners[0]], view.points[corners[1]], view.points[corners[2]]);
}

/// The arrays of triangles, in an order that meshio can read: see make_readable_by_meshio().
/// Several names for one thing: every solver looks for its own, some only for the first array.
void add_triangle_arrays(const TriangleArrays& arrays, VtuGrid& grid) {
  const auto add = [&]<class T>(T, const char* name, const ArrayWriter& write) {
    grid.cell_data.push_back({number_type<T>(), name, 1, {}, arrays.triangles * sizeof(T), write});
  };
  grid.cell_attributes = " Scalars=\"material\"";
  add(std::int32_t{}, "material", arrays.material);
  add(std::int32_t{}, "MaterialID", arrays.material);
  add(double{}, "max_angle", arrays.largest);
  add(std::int32_t{}, "mat_id", arrays.material);
  add(std::int32_t{}, "RegionId", arrays.region);
  add(double{}, "min_angle", arrays.smallest);
}

/// Those of the triangles number(0), ..., number(triangles - 1), and attributes; the grid then
/// refers to `view`.
template <class Number>
void add_triangle_arrays(const MeshView& view, std::size_t triangles, Number number, VtuGrid& grid,
                         const Team& team = {}) {
  UnsetVector<std::array<double, 2>> angles(triangles);
  team.each_range(triangles, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) angles[k] = extreme_angles(view, number(k));
  });
  const auto extremes =
      std::make_shared<const UnsetVector<std::array<double, 2>>>(std::move(angles));
  const auto material = [&view, number](std::size_t k) { return view.material[number(k)]; };
  const auto region = [&view, number](std::size_t k) { return view.region[number(k)].value(); };
  const auto largest = [extremes](std::size_t k) { return (*extremes)[k][0]; };
  const auto smallest = [extremes](std::size_t k) { return (*extremes)[k][1]; };
  add_triangle_arrays(
      {triangles, array_of_values<std::int32_t>(triangles, material),
       array_of_values<std::int32_t>(triangles, region),
       array_of_values<double>(triangles, largest), array_of_values<double>(triangles, smallest)},
      grid);
  for (const Attribute& attribute : view.attributes) {
    const auto value = [&attribute, &view, number](std::size_t k) {
      return attribute.values[place_of(view.region[number(k)])];
    };
    grid.cell_data.push_back(attribute.is_text
                                 ? vtu_array<std::int32_t>(attribute.name, triangles, value)
                                 : vtu_array<double>(attribute.name, triangles, value));
  }
  if (!view.attributes.empty() || !view.fields.empty()) make_readable_by_meshio(grid);
}

}  // namespace

std::array<double, 2> extreme_degrees(Point p, Point q, Point r) {
  const std::array angles{angle_at(q, p, r), angle_at(r, q, p), angle_at(p, r, q)};
  const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
  return {Angle::radians(*high).in_degrees(), Angle::radians(*low).in_degrees()};
}

void put_place(Point place, BinaryWriter& out) {
  out.put(place.x);
  out.put(place.y);
  out.put(0.0);
}

VtuGrid grid_of(const TriangleArrays& arrays, std::size_t points, ArrayWriter coordinates,
                ArrayWriter nodes) {
  constexpr std::size_t kNodes = 3;
  VtuGrid grid;
  add_cells({points, std::move(coordinates)},
            {arrays.triangles, CellType::triangle, kNodes, std::move(nodes)}, grid);
  add_triangle_arrays(arrays, grid);
  return grid;
}

VtuGrid whole_grid(const MeshView& view, const Team& team) {
  VtuGrid grid;
  grid.cut_vertices = view.cut_vertices;
  add_cells(
      view.triangles, type_of_triangles(view), view.points.size(),
      [&view](std::size_t p) { return view.points[p]; }, grid);
  add_periodic_nodes(
      view, view.points.size(), [](std::size_t p) { return p; }, grid);
  add_fields(
      view, view.points.size(), [](std::size_t p) { return p; }, grid);
  add_triangle_arrays(
      view, view.triangles.size(), [](std::size_t k) { return k; }, grid, team);
  return grid;
}

void write_whole(const MeshView& view, const ByteSink& sink, const Team& team) {
  write_vtu_bytes(whole_grid(view, team), sink, team);
}

void write_triangles(const MeshView& view, std::span<const std::size_t> triangles,
                     const ByteSink& sink) {
  const Part part(view.triangles, triangles);
  VtuGrid grid = part.grid(view, type_of_triangles(view));
  set_values_of_regions(view, triangles, part, grid);
  add_triangle_arrays(
      view, triangles.size(), [triangles](std::size_t k) { return triangles[k]; }, grid);
  write_vtu_bytes(grid, sink);
}

void with_part_grid(const MeshView& view, const Partition& partition, std::uint32_t part,
                    const std::function<void(const VtuGrid&)>& use) {
  const MeshPart& its = partition.parts[part];
  std::vector<std::size_t> all = its.own;
  all.insert(all.end(), its.ghosts.begin(), its.ghosts.end());
  const Part cells(view.triangles, all);
  VtuGrid grid = cells.grid(view, type_of_triangles(view));
  grid.cut_vertices = view.cut_vertices;  // of the whole mesh, as in a .vtu
  add_triangle_arrays(
      view, all.size(), [&all](std::size_t k) { return all[k]; }, grid);
  const auto add = [part](std::vector<VtuArray>& arrays, std::size_t size, auto owner) {
    arrays.push_back(vtu_array<std::int32_t>("Owner", size, owner));
    arrays.push_back(vtu_array<std::uint8_t>(
        "vtkGhostType", size, [owner, part](std::size_t k) { return owner(k) == part ? 0 : 1; }));
  };
  // What VTK calls a duplicate cell or point is 1.
  add(grid.point_data, cells.numbers.size(),
      [&](std::size_t p) { return partition.vertex_owner[cells.numbers[p]]; });
  VtuArray ids =
      vtu_array<std::int64_t>("GlobalCellId", all.size(), [&all](std::size_t k) { return all[k]; });
  ids.more = " IdType=\"1\"";
  grid.cell_attributes += " GlobalIds=\"GlobalCellId\"";
  grid.cell_data.push_back(std::move(ids));
  add(grid.cell_data, all.size(), [&](std::size_t k) { return partition.owner[all[k]]; });
  use(grid);
}

void write_lines(const MeshView& view, const RegionTable& table, std::span<const std::size_t> lines,
                 const ByteSink& sink) {
  const Part part(view.lines, lines);
  VtuGrid grid = part.grid(view, view.second_order() ? CellType::quadratic_edge : CellType::line);
  const auto line = [&](std::size_t k) -> const Interface& {
    return table.interfaces[view.interface[lines[k]].index() - 1];
  };
  const auto add = [&](const char* name, auto value) {
    grid.cell_data.push_back(vtu_array<std::int32_t>(name, lines.size(), value));
  };
  add("LineID", [&](std::size_t k) { return view.interface[lines[k]].value(); });
  add("LeftRegion", [&](std::size_t k) { return line(k).left.value(); });
  add("RightRegion", [&](std::size_t k) { return line(k).right.value(); });
  add("LineKind", [&](std::size_t k) { return static_cast<int>(line(k).kind); });
  add("marker", [&](std::size_t k) { return view.marker[lines[k]]; });
  grid.cell_attributes = " Scalars=\"LineID\"";
  write_vtu_bytes(grid, sink);
}

}  // namespace cover
