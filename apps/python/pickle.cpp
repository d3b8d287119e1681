#include "pickle.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cover/curved_mesh.hpp>
#include <cover/mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/pslg.hpp>
#include <cover/stored_mesh.hpp>

#include "arrays.hpp"
#include "raise.hpp"

namespace py = pybind11;

namespace cover::python {
namespace {

py::list pickled_regions(const RegionTable& table) {
  py::list out;
  for (const Region& region : table.regions)
    out.append(py::make_tuple(region.material, region.name, region.material_name, region.sides,
                              region.size));
  return out;
}

py::list pickled_interfaces(const RegionTable& table) {
  py::list out;
  for (const Interface& line : table.interfaces)
    out.append(py::make_tuple(static_cast<int>(line.kind), line.name, line.left.value(),
                              line.right.value()));
  return out;
}

/// Edges on interfaces: vertices, interface, marker.
py::array_t<std::int64_t> pickled_edges(const Mesh& mesh) {
  const TriMesh& tri = mesh.tri();
  std::vector<std::int64_t> rows;
  for (const auto e : tri.edges()) {
    if (mesh.interface(e) == kNoInterface) continue;
    const auto h = tri.halfedge_handle(e, 0);
    for (const std::int64_t value :
         {std::int64_t{tri.from_vertex_handle(h).idx()},
          std::int64_t{tri.to_vertex_handle(h).idx()}, std::int64_t{mesh.interface(e).value()},
          std::int64_t{mesh.marker(e)}})
      rows.push_back(value);
  }
  return array_of(rows).reshape({-1, 4});
}

py::array_t<std::int64_t> pickled_ids(const Output& output) {
  std::vector<std::int64_t> ids;
  for (const auto v : output.mesh.tri().vertices()) {
    const long id = output.mesh.input_id(v);
    ids.push_back(id < 0 ? -1 : output.pslg.point_ids[static_cast<std::size_t>(id)]);
  }
  return array_of(ids);
}

template <class Number>
py::array_t<Number, py::array::c_style> array_in(const py::handle& value, py::ssize_t columns) {
  auto array =
      converted<py::array_t<Number, py::array::c_style>>(value, "this is no state of a cover.Mesh");
  const bool fits =
      columns == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (!fits) throw py::value_error("this is no state of a cover.Mesh");
  return array;
}

template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> rows_in(const py::handle& value) {
  const auto array = array_in<std::uint32_t>(value, N);
  const auto view = array.template unchecked<2>();
  std::vector<std::array<std::uint32_t, N>> rows(static_cast<std::size_t>(view.shape(0)));
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t j = 0; j < N; ++j)
      rows[k][j] = view(static_cast<py::ssize_t>(k), static_cast<py::ssize_t>(j));
  return rows;
}

std::vector<std::int64_t> numbers_in(const py::handle& value) {
  const auto array = array_in<std::int64_t>(value, 1);
  return {array.data(), array.data() + array.size()};
}

void take_names(const py::tuple& state, StoredMesh& stored) {
  for (const py::handle& item : state[6].cast<py::list>()) {
    const auto row = item.cast<py::tuple>();
    Region region;
    region.id = RegionId(stored.regions.size() + 1);
    region.material = row[0].cast<int>();
    region.name = row[1].cast<std::string>();
    region.material_name = row[2].cast<std::string>();
    region.sides = row[3].cast<std::size_t>();
    region.size = row[4].cast<std::optional<double>>();
    stored.regions.push_back(std::move(region));
  }
  for (const py::handle& item : state[7].cast<py::list>()) {
    const auto row = item.cast<py::tuple>();
    Interface line;
    line.id = InterfaceId(stored.interfaces.size() + 1);
    const int kind = row[0].cast<int>();
    if (kind < 0 || kind > static_cast<int>(InterfaceKind::contact))
      throw py::value_error("this is no state of a cover.Mesh");
    line.kind = static_cast<InterfaceKind>(kind);
    line.name = row[1].cast<std::string>();
    line.left = RegionId(row[2].cast<std::uint32_t>());
    line.right = RegionId(row[3].cast<std::uint32_t>());
    stored.interfaces.push_back(std::move(line));
  }
}

py::list pickled_attributes(const RegionTable& table) {
  py::list out;
  for (const Attribute& attribute : table.attributes)
    out.append(py::make_tuple(attribute.name, attribute.is_text, attribute.words,
                              array_of(attribute.values)));
  return out;
}

py::list pickled_fields(const Output& output) {
  py::list out;
  for (std::size_t k = 0; k < output.fields.size(); ++k) {
    py::list of_regions;
    if (k < output.region_values.size())
      for (const auto& [vertex, region, value] : output.region_values[k])
        of_regions.append(py::make_tuple(vertex, region.value(), value));
    out.append(
        py::make_tuple(output.fields[k].name, array_of(output.fields[k].values), of_regions));
  }
  return out;
}

/// States of old versions have none.
std::vector<RegionValue> region_values_in(const py::tuple& field, const Output& output) {
  std::vector<RegionValue> values;
  if (field.size() < 3) return values;
  for (const py::handle& item : field[2].cast<py::list>()) {
    const auto row = item.cast<py::tuple>();
    const RegionValue value{row[0].cast<std::uint32_t>(), RegionId(row[1].cast<std::uint32_t>()),
                            row[2].cast<double>()};
    if (value.vertex >= output.mesh.vertices() || value.region == kVoid ||
        value.region.index() > output.table.regions.size() ||
        (!values.empty() && !(values.back().place() < value.place())))
      throw py::value_error("this is no state of a cover.Mesh");
    values.push_back(value);
  }
  return values;
}

std::vector<double> doubles_in(const py::handle& value, std::size_t size) {
  const auto array = array_in<double>(value, 1);
  if (static_cast<std::size_t>(array.size()) != size)
    throw py::value_error("this is no state of a cover.Mesh");
  return {array.data(), array.data() + array.size()};
}

void take_values(const py::tuple& state, Output& output) {
  for (const py::handle& item : state[13].cast<py::list>()) {
    const auto row = item.cast<py::tuple>();
    Attribute attribute{row[0].cast<std::string>(), row[1].cast<bool>(),
                        row[2].cast<std::vector<std::string>>(),
                        doubles_in(row[3], output.table.regions.size())};
    for (const double value : attribute.values)
      if (attribute.is_text &&
          !(value >= 0 && value <= static_cast<double>(attribute.words.size())))
        throw py::value_error("this is no state of a cover.Mesh");
    output.table.attributes.push_back(std::move(attribute));
  }
  for (const py::handle& item : state[14].cast<py::list>()) {
    const auto row = item.cast<py::tuple>();
    output.fields.push_back(
        {row[0].cast<std::string>(), doubles_in(row[1], output.mesh.vertices())});
    output.region_values.push_back(region_values_in(row, output));
  }
}

std::vector<StoredEdge> edges_in(const py::handle& value) {
  const auto rows = array_in<std::int64_t>(value, 4);
  const auto view = rows.unchecked<2>();
  std::vector<StoredEdge> edges;
  for (py::ssize_t k = 0; k < view.shape(0); ++k) {
    StoredEdge edge;
    edge.a = static_cast<std::uint32_t>(view(k, 0));
    edge.b = static_cast<std::uint32_t>(view(k, 1));
    edge.interface = InterfaceId(static_cast<std::uint32_t>(view(k, 2)));
    edge.marker = static_cast<int>(view(k, 3));
    edges.push_back(edge);
  }
  return edges;
}

/// Chords of each circle.
py::list pickled_arcs(const Output& output) {
  const auto& circles = output.pslg.circles;
  if (circles.empty()) return py::list();
  std::vector<std::vector<std::array<std::uint32_t, 2>>> edges(circles.size());
  for (const CurvedEdge& edge : curved_mesh(output).edges)
    edges[edge.circle].push_back({edge.a, edge.b});
  py::list out;
  for (std::size_t c = 0; c < circles.size(); ++c)
    out.append(py::make_tuple(circles[c].centre.x, circles[c].centre.y, circles[c].radius,
                              array_of(edges[c])));
  return out;
}

void take_arcs(const py::list& arcs, StoredMesh& stored) {
  for (const py::handle& item : arcs) {
    const auto row = item.cast<py::tuple>();
    StoredArc arc{{{row[0].cast<double>(), row[1].cast<double>()}, row[2].cast<double>()}, {}};
    arc.edges = rows_in<2>(row[3]);
    stored.arcs.push_back(std::move(arc));
  }
}

/// Vertices of the mesh with the names that the input gives them.
py::list pickled_points(const Output& output) {
  py::list out;
  for (const NamedPoint& point : named_points_of(output))
    out.append(py::make_tuple(point.vertex.value(), name_of(point.name)));
  return out;
}

void take_points(const py::list& points, StoredMesh& stored) {
  for (const py::handle& item : points) {
    const auto row = item.cast<py::tuple>();
    stored.points.push_back({VertexId(row[0].cast<std::uint32_t>()), bytes_of(row[1])});
  }
}

/// The edges with nodes off their middles, and these; nothing as Output::nodes.
py::object pickled_nodes(const Output& output) {
  if (!output.nodes) return py::none();
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<Point> middles;
  for (const MovedNode& node : *output.nodes) {
    edges.push_back({node.a, node.b});
    middles.push_back(node.middle);
  }
  return py::make_tuple(array_of(edges), array_of(middles));
}

void take_nodes(const py::object& nodes, StoredMesh& stored) {
  stored.second_order = !nodes.is_none();
  if (!stored.second_order) return;
  const auto rows = nodes.cast<py::tuple>();
  const auto edges = rows_in<2>(rows[0]);
  const auto middles = array_in<double>(rows[1], 2);
  if (static_cast<std::size_t>(middles.shape(0)) != edges.size())
    throw py::value_error("this is no state of a cover.Mesh");
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto row = static_cast<py::ssize_t>(k);
    stored.nodes.push_back({edges[k][0], edges[k][1], {middles.at(row, 0), middles.at(row, 1)}});
  }
}

constexpr std::array kCoefficients{&Isometry::xx, &Isometry::xy, &Isometry::yx,
                                   &Isometry::yy, &Isometry::x0, &Isometry::y0};

py::list pickled_periodic(const Output& output) {
  py::list out;
  for (const PeriodicNodes& nodes : output.periodic) {
    py::list map;
    for (const auto coefficient : kCoefficients) map.append(nodes.map.*coefficient);
    const PeriodicRule& rule = nodes.rule;
    out.append(py::make_tuple(rule.from, rule.to, static_cast<int>(rule.map), rule.centre.x,
                              rule.centre.y, rule.angle.in_radians(), map, array_of(nodes.vertices),
                              array_of(nodes.edges)));
  }
  return out;
}

void take_periodic(const py::list& periodic, StoredMesh& stored) {
  for (const py::handle& item : periodic) {
    const auto row = item.cast<py::tuple>();
    PeriodicNodes nodes;
    const int map = row[2].cast<int>();
    if (map < 0 || map > static_cast<int>(PeriodicRule::Map::glide))
      throw py::value_error("this is no state of a cover.Mesh");
    nodes.rule = {row[0].cast<std::string>(),
                  row[1].cast<std::string>(),
                  static_cast<PeriodicRule::Map>(map),
                  {row[3].cast<double>(), row[4].cast<double>()},
                  Angle::radians(row[5].cast<double>())};
    const auto coefficients = row[6].cast<std::vector<Isometry::Coefficient>>();
    if (coefficients.size() != kCoefficients.size())
      throw py::value_error("this is no state of a cover.Mesh");
    for (std::size_t k = 0; k < kCoefficients.size(); ++k)
      nodes.map.*kCoefficients[k] = coefficients[k];
    nodes.vertices = rows_in<2>(row[7]);
    nodes.edges = rows_in<4>(row[8]);
    stored.periodic.push_back(std::move(nodes));
  }
}

py::tuple pickled_provenance(const Provenance& from) {
  py::list settings;
  for (const Provenance::Setting& setting : from.settings)
    settings.append(py::make_tuple(setting.name, name_of(setting.value)));
  return py::make_tuple(name_of(from.source), from.version, settings);
}

Provenance provenance_in(const py::tuple& from) {
  Provenance out{bytes_of(from[0]), from[1].cast<std::string>(), {}};
  for (const py::handle& item : from[2].cast<py::list>()) {
    const auto row = item.cast<py::tuple>();
    out.settings.push_back({row[0].cast<std::string>(), bytes_of(row[1])});
  }
  return out;
}

constexpr std::array kCounts{&Quality::triangles, &Quality::obtuse, &Quality::obtuse_by_rounding,
                             &Quality::above_120, &Quality::above_150};

py::tuple pickled_quality(const Quality& quality) {
  py::list counts;
  for (const auto count : kCounts) counts.append(quality.*count);
  return py::make_tuple(counts, quality.largest_nu.in_radians(), quality.smallest.in_radians(),
                        quality.histogram, quality.area);
}

Quality quality_in(const py::tuple& from) {
  Quality quality;
  const auto counts = from[0].cast<std::array<std::size_t, kCounts.size()>>();
  for (std::size_t k = 0; k < kCounts.size(); ++k) quality.*kCounts[k] = counts[k];
  quality.largest_nu = Angle::radians(from[1].cast<double>());
  quality.smallest = Angle::radians(from[2].cast<double>());
  quality.histogram = from[3].cast<decltype(quality.histogram)>();
  quality.area = from[4].cast<double>();
  return quality;
}

py::list pickled_notes(const std::vector<Note>& notes) {
  py::list out;
  for (const Note& note : notes)
    out.append(py::make_tuple(static_cast<int>(note.kind), note.region.value(),
                              name_of(note.message), array_of(note.where)));
  return out;
}

std::vector<Note> notes_in(const py::list& from) {
  std::vector<Note> notes;
  for (const py::handle& item : from) {
    const auto row = item.cast<py::tuple>();
    const int kind = row[0].cast<int>();
    if (kind < 0 || kind > static_cast<int>(Note::Kind::box_cut))
      throw py::value_error("this is no state of a cover.Mesh");
    Note note{static_cast<Note::Kind>(kind),
              RegionId(row[1].cast<std::uint32_t>()),
              bytes_of(row[2]),
              {}};
    const auto where = array_in<double>(row[3], 2);
    for (py::ssize_t k = 0; k < where.shape(0); ++k)
      note.where.push_back({where.at(k, 0), where.at(k, 1)});
    notes.push_back(std::move(note));
  }
  return notes;
}

/// What a manifest tells of the run: rebuild() measures areas and lengths again, in another order.
py::tuple pickled_figures(const Output& output) {
  std::vector<double> areas, lengths;
  for (const Region& region : output.table.regions) areas.push_back(region.area);
  for (const Interface& line : output.table.interfaces) lengths.push_back(line.length);
  py::list regions;
  for (const RegionReport& region : output.report.regions)
    regions.append(py::make_tuple(region.id.value(), pickled_quality(region.quality),
                                  region.nu_opt.in_radians(), region.nu_bound.in_radians(),
                                  region.bound_held, pickled_notes(region.notes)));
  return py::make_tuple(array_of(areas), array_of(lengths), pickled_quality(output.report.quality),
                        pickled_notes(output.report.notes), regions);
}

void take_figures(const py::tuple& from, Output& output) {
  RegionTable& table = output.table;
  const std::vector<double> areas = doubles_in(from[0], table.regions.size());
  const std::vector<double> lengths = doubles_in(from[1], table.interfaces.size());
  for (std::size_t r = 0; r < areas.size(); ++r) table.regions[r].area = areas[r];
  for (std::size_t k = 0; k < lengths.size(); ++k) table.interfaces[k].length = lengths[k];
  output.report.quality = quality_in(from[2].cast<py::tuple>());
  output.report.notes = notes_in(from[3].cast<py::list>());
  const auto regions = from[4].cast<py::list>();
  if (!regions.empty() && regions.size() != table.regions.size())
    throw py::value_error("this is no state of a cover.Mesh");
  for (const py::handle& item : regions) {
    const auto row = item.cast<py::tuple>();
    RegionReport region;
    region.id = RegionId(row[0].cast<std::uint32_t>());
    region.quality = quality_in(row[1].cast<py::tuple>());
    region.nu_opt = Angle::radians(row[2].cast<double>());
    region.nu_bound = Angle::radians(row[3].cast<double>());
    region.bound_held = row[4].cast<bool>();
    region.notes = notes_in(row[5].cast<py::list>());
    output.report.regions.push_back(std::move(region));
  }
}

/// Vertices that were points of the input, or put on its segments: the first of the mesh. The PSLG
/// has points in the void, too.
std::size_t first_vertices(const Output& output) {
  std::size_t count = 0;
  for (const auto v : output.mesh.tri().vertices()) count += output.mesh.input_id(v) >= 0 ? 1 : 0;
  return count;
}

/// Of the points that segments have, those that were not in the input, where that is known.
std::size_t cut_vertices(const Output& output) {
  const std::size_t uncut = output.report.input_points, all = output.pslg.points.size();
  return uncut > 0 && all > uncut ? all - uncut : 0;
}

}  // namespace

py::tuple pickled(const Output& output, const TriangleSoup& soup, const std::string& report,
                  const std::vector<std::string>& remarks) {
  return py::make_tuple(
      kPickleVersion, array_of(soup.points), array_of(soup.triangles), array_of(soup.region),
      array_of(soup.material), pickled_ids(output), pickled_regions(output.table),
      pickled_interfaces(output.table), pickled_edges(output.mesh), first_vertices(output),
      output.report.unit, output.report.scale, report, pickled_attributes(output.table),
      pickled_fields(output), pickled_arcs(output), pickled_periodic(output),
      pickled_provenance(output.report.provenance), cut_vertices(output), pickled_figures(output),
      remarks, pickled_nodes(output), pickled_points(output));
}

Unpickled unpickled(const py::tuple& state) {
  constexpr std::size_t kMembers = 23;
  if (state.size() != kMembers || state[0].cast<int>() != kPickleVersion)
    throw py::value_error("this is no state of a cover.Mesh, or of another version");
  StoredMesh stored;
  const auto points = array_in<double>(state[1], 2);
  for (py::ssize_t k = 0; k < points.shape(0); ++k)
    stored.soup.points.push_back({points.at(k, 0), points.at(k, 1)});
  const auto triangles = array_in<std::uint32_t>(state[2], 3);
  for (py::ssize_t k = 0; k < triangles.shape(0); ++k)
    stored.soup.triangles.push_back({triangles.at(k, 0), triangles.at(k, 1), triangles.at(k, 2)});
  stored.soup.region = numbers_in(state[3]);
  stored.soup.material = numbers_in(state[4]);
  const std::vector<std::int64_t> ids = numbers_in(state[5]);
  take_names(state, stored);
  stored.edges = edges_in(state[8]);
  stored.input_vertices = state[9].cast<std::size_t>();
  stored.unit = state[10].cast<std::string>();
  stored.scale = state[11].cast<double>();
  take_arcs(state[15].cast<py::list>(), stored);
  take_periodic(state[16].cast<py::list>(), stored);
  take_nodes(state[21], stored);
  take_points(state[22].cast<py::list>(), stored);
  stored.provenance = provenance_in(state[17].cast<py::tuple>());
  stored.cut_vertices = state[18].cast<std::size_t>();
  Result<Output> output = rebuild(stored);
  if (!output) raise(output.error());
  for (std::size_t v = 0; v < output->pslg.point_ids.size() && v < ids.size(); ++v)
    output->pslg.point_ids[v] = static_cast<long>(ids[v]);
  take_values(state, *output);
  take_figures(state[19].cast<py::tuple>(), *output);
  return {std::move(output).value(), state[12].cast<std::string>(),
          state[20].cast<std::vector<std::string>>()};
}

}  // namespace cover::python
