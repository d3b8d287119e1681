// The class Mesh of Python: what is known of a mesh, as arrays, lists and dictionaries.
#include "mesh_class.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cover/curved_mesh.hpp>
#include <cover/files.hpp>
#include <cover/mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/picture.hpp>
#include <cover/text.hpp>
#include <cover/verify.hpp>
#include <cover/write_mesh.hpp>

#include "arrays.hpp"
#include "options.hpp"
#include "pickle.hpp"
#include "py_mesh.hpp"
#include "raise.hpp"
#include "run.hpp"

namespace py = pybind11;

namespace cover::python {
namespace {

/// Names and materials of regions, in the order of their numbers.
py::list regions_of(const PyMesh& mesh) {
  py::list regions;
  for (const Region& region : mesh.output.table.regions) {
    py::dict row;
    row["id"] = region.id.value();
    row["name"] = region.name;
    row["material"] = region.material;
    row["material_name"] = region.material_name;
    regions.append(row);
  }
  return regions;
}

/// The names of materials by their numbers.
py::dict materials_of(const PyMesh& mesh) {
  py::dict materials;
  for (const Region& region : mesh.output.table.regions)
    materials[py::int_(region.material)] = region.material_name;
  return materials;
}

py::array_t<std::int64_t> input_ids(const PyMesh& mesh) {
  const TriMesh& tri = mesh.output.mesh.tri();
  std::vector<std::int64_t> ids;
  ids.reserve(tri.n_vertices());
  for (const auto v : tri.vertices()) {
    const long id = mesh.output.mesh.input_id(v);
    ids.push_back(id < 0 ? -1 : mesh.output.pslg.point_ids[static_cast<std::size_t>(id)]);
  }
  return array_of(ids);
}

/// The edges of each named line, by its name.
py::dict lines_of(const PyMesh& mesh) {
  const TriMesh& tri = mesh.output.mesh.tri();
  std::vector<std::vector<std::array<std::uint32_t, 2>>> edges(mesh.output.table.interfaces.size());
  for (const auto e : tri.edges()) {
    const InterfaceId id = mesh.output.mesh.interface(e);
    if (id == kNoInterface) continue;
    const auto h = tri.halfedge_handle(e, 0);
    edges[place_of(id)].push_back({static_cast<std::uint32_t>(tri.from_vertex_handle(h).idx()),
                                   static_cast<std::uint32_t>(tri.to_vertex_handle(h).idx())});
  }
  py::dict lines;
  for (const Interface& line : mesh.output.table.interfaces) {
    const py::str name(line.name);
    if (!lines.contains(name)) lines[name] = py::list();
    py::dict piece;
    piece["left"] = line.left.value();
    piece["right"] = line.right.value();
    piece["edges"] = array_of(edges[place_of(line.id)]);
    lines[name].cast<py::list>().append(piece);
  }
  return lines;
}

/// The vertices that the input calls by a name, by that.
py::dict named_points(const PyMesh& mesh) {
  std::map<std::string, std::vector<std::int64_t>> vertices;
  std::vector<std::string> names;  // in the order of the input
  for (const NamedPoint& point : named_points_of(mesh.output)) {
    std::vector<std::int64_t>& of_name = vertices[point.name];
    if (of_name.empty()) names.push_back(point.name);
    of_name.push_back(point.vertex.value());
  }
  py::dict points;
  for (const std::string& name : names) points[name_of(name)] = array_of(vertices[name]);
  return points;
}

/// Pairs of vertices and edges on periodic sides, by rule.
py::list periodic_of(const PyMesh& mesh) {
  py::list rules;
  for (const PeriodicNodes& nodes : mesh.output.periodic) {
    py::dict rule;
    rule["from"] = nodes.rule.from;
    rule["to"] = nodes.rule.to;
    rule["vertices"] = array_of(nodes.vertices);
    rule["edges"] = array_of(nodes.edges);
    rules.append(rule);
  }
  return rules;
}

/// Attributes of a map that were kept, by name: numbers as an array, texts as a list, by region.
py::dict attributes_of(const PyMesh& mesh) {
  py::dict attributes;
  for (const Attribute& attribute : mesh.output.table.attributes) {
    if (!attribute.is_text) {
      attributes[py::str(attribute.name)] = array_of(attribute.values);
      continue;
    }
    py::list words;
    for (const double value : attribute.values)
      words.append(value == 0 ? py::object(py::none())
                              : py::str(attribute.words[static_cast<std::size_t>(value) - 1]));
    attributes[py::str(attribute.name)] = words;
  }
  return attributes;
}

/// What the input has beside its geometry, at the points, by name.
py::dict fields_of(const PyMesh& mesh) {
  py::dict fields;
  for (const PlaneField::Array& field : mesh.output.fields)
    fields[py::str(field.name)] = array_of(field.values);
  return fields;
}

/// Edges on arcs with the middle nodes that order=2 gives them, and areas of regions with them.
py::dict arcs_of(const PyMesh& mesh) {
  const CurvedMesh curved = curved_mesh(mesh.output);
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<Point> middles;
  py::list straight;
  for (const CurvedEdge& edge : curved.edges) {
    edges.push_back({edge.a, edge.b});
    middles.push_back(edge.middle);
    straight.append(edge.is_straight);
  }
  py::dict arcs;
  arcs["edges"] = array_of(edges);
  arcs["middles"] = array_of(middles);
  arcs["straight"] = straight;
  arcs["areas"] = py::cast(curved.areas);
  return arcs;
}

std::string report_text(const PyMesh& mesh) {
  return mesh.report.empty() ? report_json(mesh.output) : mesh.report;
}

/// The JSON report as a dictionary.
py::object report_of(const PyMesh& mesh) {
  return py::module_::import("json").attr("loads")(report_text(mesh));
}

/// What a file lacks of what the mesh has, a sentence each, as `cover convert` tells it where no
/// manifest is written.
std::vector<std::string> losses_of(const Output& output, const std::string& path,
                                   const std::string& extension, const WriteOptions& options) {
  if (extension == ".svg" || extension == ".png" || extension == ".json") return {};
  const std::string file = path.substr(path.rfind('/') + 1);
  std::vector<std::string> sentences;
  const auto tell = [&](const char* what, const std::vector<std::string>& names,
                        const std::vector<std::string>& holding) {
    if (!names.empty() && std::find(holding.begin(), holding.end(), extension) == holding.end())
      sentences.push_back(not_held(what, first_of_all(names), {file}, holding));
  };
  std::vector<std::string> attributes, sides, points, values;
  for (const Attribute& attribute : output.table.attributes) attributes.push_back(attribute.name);
  for (const PeriodicNodes& nodes : output.periodic) sides.push_back(describe(nodes.rule));
  for (const NamedPoint& point : output.pslg.named_points) points.push_back(point.name);
  for (const PlaneField::Array& field : output.fields) values.push_back(field.name);
  const bool is_geometry = extension == ".poly";
  if (!is_geometry) tell("attributes", attributes, attribute_formats());
  tell("pairs on periodic sides", sides, periodic_formats());
  if (!is_geometry) tell("names of points", points, point_formats(options));
  if (!is_geometry) tell("values at points", values, value_formats());
  const std::size_t rounded = extension == ".inp" ? points_rounded_by_inp(output, options) : 0;
  if (rounded > 0)
    sentences.push_back(counted(rounded, "point") + " in " + file +
                        (rounded == 1 ? " is" : " are") +
                        " rounded: readers of .inp take 20 characters of a coordinate; other "
                        "formats keep all digits");
  const std::size_t beyond = extension == ".inp" ? points_beyond_axis(output, options) : 0;
  if (beyond > 0)
    sentences.push_back(counted(beyond, "point") + " in " + file +
                        (beyond == 1 ? " has" : " have") +
                        " x < 0: solvers refuse axisymmetric elements (CAX) there, the axis is x = "
                        "0");
  return sentences;
}

/// A mesh file or a picture, as the extension says.
void save(const py::object& self, const py::object& path, const py::kwargs& keywords) {
  auto& mesh = self.cast<PyMesh&>();
  const std::string name = py::module_::import("os").attr("fsencode")(path).cast<std::string>();
  check_path(name);
  const std::string extension = extension_of(name);
  py::dict rest(keywords);
  PictureKeywords picture = take_picture_options(rest);
  auto [options, given] = write_options_from(rest);
  std::vector<std::string> known = write_formats();
  known.insert(known.end(), {".svg", ".png"});
  if (std::find(known.begin(), known.end(), extension) == known.end())
    raise(unknown_output_format(name, known));
  const auto remark = [&](std::vector<std::string> sentences) {
    for (std::string& sentence : sentences)
      if (std::find(mesh.remarks.begin(), mesh.remarks.end(), sentence) == mesh.remarks.end())
        mesh.remarks.push_back(std::move(sentence));
  };
  remark(idle_write_options(given, extension));
  remark(idle_picture_options(picture, extension));
  if (extension == ".png") {
    py::module_::import("cover._png")
        .attr("write_png")(self, py::bytes(name), options.order, py::bytes(picture.options.title),
                           picture.options.width, py::bytes(picture.options.color));
    return;
  }
  Callables callables;
  options.stop = callables.token();
  run(callables, [&, &chosen = options]() -> Status {
    if (extension != ".svg") return write_mesh(mesh.output, name, chosen);
    picture.options.stop = chosen.stop;
    return write_svg(picture_of(mesh.output, chosen.order), picture.options, name);
  });
  remark(losses_of(mesh.output, name, extension, options));
}

/// What verify_cover() finds; see the words for Python below.
std::vector<std::string> violations(const PyMesh& mesh) {
  if (!mesh.promises)
    throw py::value_error(
        "this mesh was read, copied or pickled: the input with which it would be compared is not "
        "there; 'cover check INPUT MESH' compares a file with its input");
  Callables nothing;
  const Verification found = run(nothing, [&]() -> Result<Verification> {
    return verify_cover(mesh.output.pslg, mesh.output.table, mesh.soup, *mesh.promises);
  });
  std::vector<std::string> messages;
  for (const Violation& v : found.violations) messages.push_back(v.message);
  return messages;
}

constexpr const char* kMesh =
    "A mesh with all that is known of it. Its arrays are copies, and read-only: writing to them "
    "would not change the mesh; points.copy() may be changed.\n\n"
    "A mesh that was pickled or copied is the same, with its report and its notes, but for the "
    "input of its run: violations() has nothing to compare it with, save('x.poly') writes the "
    "edges on lines as the mesh has them, and edges on lines and arcs may come in another order "
    "and direction.";

constexpr const char* kViolations =
    "Checks the mesh against the input of its run, in exact arithmetic and by code that makes no "
    "mesh: sentences on the "
    "promises that it breaks, at most ten of a kind. Empty: points, segments, orientation, "
    "conformity, materials and "
    "the bound are as promised (with the option paper the bound is not asked for). Raises "
    "ValueError for a mesh "
    "that read(), copy or pickle made, which has no input to be compared with.";

}  // namespace

void check_path(const std::string& path) {
  if (path.find('\0') != std::string::npos) throw py::value_error("a path has a zero byte in it");
}

void define_mesh(py::module_& module) {
  py::class_<PyMesh>(module, "Mesh", kMesh)
      .def_property_readonly(
          "points", [](const PyMesh& m) { return array_of(m.soup.points); },
          "(n, 2) floats: the vertices.")
      .def_property_readonly(
          "triangles", [](const PyMesh& m) { return array_of(m.soup.triangles); },
          "(m, 3) indices into points, counter-clockwise.")
      .def_property_readonly(
          "region", [](const PyMesh& m) { return array_of(m.soup.region); },
          "By triangle: the number of its region, from 1 on; see regions.")
      .def_property_readonly(
          "material", [](const PyMesh& m) { return array_of(m.soup.material); },
          "By triangle: the number of its material; see materials.")
      .def_property_readonly("input_id", &input_ids,
                             "By point: its index or number in the input; -1 for a vertex that the "
                             "run put there. Files "
                             "keep no numbers: of a mesh that was read, its index in points.")
      .def_property_readonly(
          "lines", &lines_of,
          "By name of an interface, outline, contact or inner line: its pieces, dictionaries with "
          "the regions left and right (0: the void) and edges, (k, 2) indices into points.")
      .def_property_readonly("named_points", &named_points,
                             "By name of a point, as of wells and boreholes: its indices into "
                             "points, several where several points have that name.")
      .def_property_readonly(
          "periodic", &periodic_of,
          "By pair of periodic sides: a dictionary with the lines from and to, vertices, (k, 2) "
          "indices into points, and edges, (k, 4): the ends of an edge, then their images.")
      .def_property_readonly(
          "arcs", &arcs_of,
          "A dictionary: edges on arcs, (k, 2) indices into points; their middles, the nodes that "
          "order=2 gives them; straight, whether such an edge keeps its own middle, by edge; areas "
          "by region with curved edges.")
      .def_property_readonly("attributes", &attributes_of,
                             "What keep_field kept of a map: arrays of numbers (NaN: none) or "
                             "lists of texts (None: none) by region, under their names.")
      .def_property_readonly("fields", &fields_of,
                             "What the input has beside its geometry, as doping: numbers by point "
                             "(NaN: none) under their names.")
      .def_property_readonly("regions", &regions_of,
                             "By region, in the order of their numbers: dictionaries with id, "
                             "name, material and material_name.")
      .def_property_readonly("materials", &materials_of, "The names of materials by their numbers.")
      .def_property_readonly("report", &report_of,
                             "The report as a dictionary, as that of `cover mesh --report`. That "
                             "of a mesh that was read has no regions.")
      .def_property_readonly(
          "_remarks", [](const PyMesh& m) { return m.remarks; },
          "Sentences on options of save() that had no effect, and on what files lack.")
      .def("save", &save, py::arg("path"),
           "Writes a mesh file, or with .svg or .png a picture, as the extension says. "
           "write_options() lists what else it takes; of pictures title, the first line, width, in "
           "pixels, and color, an array that is shown by colour, as max_angle. What a mesh has and "
           "a file lacks, as names of points, is told in notes.")
      .def("violations", &violations, kViolations)
      .def("__reduce__",
           [](const PyMesh& m) {
             return py::make_tuple(
                 py::module_::import("cover").attr("_mesh_of_state"),
                 py::make_tuple(pickled(m.output, m.soup, report_text(m), m.remarks)));
           })
      .def("__repr__", [](const PyMesh& m) {
        return "<cover.Mesh: " + std::to_string(m.soup.points.size()) + " points, " +
               std::to_string(m.soup.triangles.size()) + " triangles, " +
               std::to_string(m.output.table.regions.size()) + " regions>";
      });
}

}  // namespace cover::python
