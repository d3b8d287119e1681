// The Python module: numpy arrays in, numpy arrays out. No geometry here.
//
// A run works on a thread of its own without the GIL, while the calling thread looks for signals,
// so that Ctrl-C stops a run and other Python threads go on. The progress callback takes the GIL
// for its call only; what it raises stops the run and comes out of the call.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <future>
#include <stop_token>
#include <thread>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cover/cover_mesh.hpp>
#include <cover/curved_mesh.hpp>
#include <cover/files.hpp>
#include <cover/option_table.hpp>
#include <cover/picture.hpp>
#include <cover/read_input.hpp>
#include <cover/read_mesh.hpp>
#include <cover/read_option_table.hpp>
#include <cover/read_size_field.hpp>
#include <cover/requirements.hpp>
#include <cover/verify.hpp>
#include <cover/version.hpp>
#include <cover/write_mesh.hpp>
#include <cover/write_option_table.hpp>

#include "arrays.hpp"
#include "options.hpp"
#include "pickle.hpp"
#include "py_mesh.hpp"
#include "raise.hpp"
#include "read_geometry.hpp"

namespace py = pybind11;

namespace cover::python {
namespace {

/// False, also numpy's; None is not.
bool is_false(const py::object& answer) {
  if (answer.ptr() == Py_False) return true;
  return py::hasattr(answer, "dtype") && PyObject_IsTrue(answer.ptr()) == 0;
}

/// The callables of a caller: whatever one of them raises stops the run. They are called from other
/// threads, with the GIL; what is here is written with it, too.
class Callables {
 public:
  /// Calls `use` with the GIL; `otherwise` where it raises, and after that.
  template <class Value, class Use>
  Value call(Use use, Value otherwise) {
    const py::gil_scoped_acquire gil;
    if (raised_) return otherwise;
    try {
      return use();
    } catch (...) {
      raised_ = std::current_exception();
      stop_.request_stop();
      return otherwise;
    }
  }
  void request_stop() { stop_.request_stop(); }
  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  void rethrow() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  std::stop_source stop_;
  std::exception_ptr raised_;
};

/// Runs `work(callbacks)` on another thread and waits for it; see the head of this file.
template <class Work>
auto run(const py::object& progress, Callables& callables, Work work) {
  Callbacks callbacks;
  callbacks.stop = callables.token();
  if (!progress.is_none()) {
    callbacks.progress = [&](const Progress& p) {
      const bool goes_on = callables.call(
          [&] { return !is_false(progress(std::string(p.stage), p.done, p.total)); }, true);
      if (!goes_on) callables.request_stop();
    };
  }
  bool interrupted = false;
  auto result = [&] {
    const py::gil_scoped_release release;
    auto future = std::async(std::launch::async, [&] { return work(callbacks); });
    while (future.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout) {
      const py::gil_scoped_acquire gil;
      if (interrupted || PyErr_CheckSignals() == 0) continue;
      interrupted = true;
      callables.request_stop();
    }
    return future.get();
  }();
  callables.rethrow();
  if (interrupted) throw py::error_already_set();  // PyErr_CheckSignals has set it
  if (!result) raise(result.error());
  return std::move(result).value();
}

/// `report`: of a mesh that was pickled.
PyMesh py_mesh_of(Output output, std::string report = {}) {
  TriangleSoup soup = triangle_soup(output.mesh);
  return {std::move(output), std::move(soup), std::move(report)};
}

/// Background sizes that are a function: f(x, y), a length.
SizeFunction sizes_of(const py::object& function, Callables& callables) {
  return [&function, &callables](Point at) {
    return callables.call([&] { return py::float_(function(at.x, at.y)).cast<double>(); }, NAN);
  };
}

PyMesh mesh_input(Input input, py::dict keywords, const py::object& progress,
                  const std::vector<Provenance::Setting>& read_with = {}) {
  Callables callables;
  py::object sizes;
  if (keywords.contains("size_field") && PyCallable_Check(keywords["size_field"].ptr()) != 0) {
    sizes = keywords["size_field"];
    keywords = keywords.attr("copy")();
    keywords.attr("pop")("size_field");
  }
  auto [options, idle] = options_from(keywords);
  if (sizes) {
    options.size_field = sizes_of(sizes, callables);
    options.size_field_name = "a function";
  }
  input.warnings.insert(input.warnings.end(), idle.begin(), idle.end());
  if (const Status status = load_size_field(options, input); !status) raise(status.error());
  Output output = run(progress, callables, [&, &chosen = options](const Callbacks& callbacks) {
    return cover_mesh(input, chosen, callbacks);
  });
  std::vector<Provenance::Setting>& settings = output.report.provenance.settings;
  settings.insert(settings.end(), read_with.begin(), read_with.end());
  const std::vector<std::string> unmet = unmet_requirements(output, options);
  PyMesh mesh = py_mesh_of(std::move(output));
  if (unmet.empty()) return mesh;
  std::string words = "the mesh does not meet";
  for (const std::string& requirement : unmet)
    words += (&requirement == &unmet.front() ? " " : "; ") + requirement;
  raise({ErrorCode::requirement_not_met, words, {}, {}}, py::cast(std::move(mesh)));
}

/// A path that the system would take as far as its first zero is another one.
void check_path(const std::string& path) {
  if (path.find('\0') != std::string::npos) throw py::value_error("a path has a zero byte in it");
}

/// A mesh that cover wrote.
PyMesh read_saved(const std::string& path) {
  check_path(path);
  Result<Output> output = [&] {
    const py::gil_scoped_release release;
    return read_output(path);
  }();
  if (!output) raise(output.error());
  return py_mesh_of(*std::move(output));
}

/// Meshes a file; its options are those of reading and of meshing.
PyMesh mesh_file(const std::string& path, py::dict keywords, const py::object& progress) {
  check_path(path);
  ReadOptions options = take_read_options(keywords);
  if (keywords.contains("threads"))
    options.threads =
        options_from(py::dict(py::arg("threads") = keywords["threads"])).options.threads;
  Result<Input> input = [&] {
    const py::gil_scoped_release release;
    return reading::read_geometry(path, options);
  }();
  if (!input) raise(input.error());
  return mesh_input(*std::move(input), keywords, progress, describe_read_options(options));
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

/// A row of a table of options, for those who make forms or documents of it.
template <class Target>
py::dict describe(const OptionOf<Target>& entry) {
  constexpr std::array kKinds{"flag", "word", "words", "whole", "number", "angle", "text"};
  py::dict row;
  row["name"] = std::string(entry.name);
  row["kind"] = kKinds.at(static_cast<std::size_t>(entry.kind));
  row["unit"] = std::string(entry.unit);
  row["low"] = entry.range.low;
  row["high"] = entry.range.high;
  row["has_low"] = entry.range.has_low;
  row["has_high"] = entry.range.has_high;
  py::list words;
  for (const std::string_view word : entry.words()) words.append(std::string(word));
  row["words"] = words;
  row["default"] = default_text(entry);
  row["repeats"] = entry.repeats;
  row["shapes_mesh"] = entry.shapes_mesh;
  row["cleaning"] = entry.group == OptionGroup::cleaning;
  row["help"] = std::string(entry.help);
  return row;
}

/// The rows of a table of options.
template <auto Table>
py::list described() {
  py::list rows;
  for (const auto& entry : Table()) rows.append(describe(entry));
  return rows;
}

std::string report_text(const PyMesh& mesh) {
  return mesh.report.empty() ? report_json(mesh.output) : mesh.report;
}

/// The JSON report as a dictionary.
py::object report_of(const PyMesh& mesh) {
  return py::module_::import("json").attr("loads")(report_text(mesh));
}

/// Geometry in one of the formats of text.
Input read_text(const std::string& text, const std::string& extension, const std::string& source) {
  Result<Input> input = parse_input(text, extension, source);
  if (!input) raise(input.error());
  return std::move(input).value();
}

/// A mesh file or a picture, as the extension says.
void save(const py::object& self, const py::object& path, const py::kwargs& keywords) {
  const auto& mesh = self.cast<const PyMesh&>();
  const std::string name = py::module_::import("os").attr("fsencode")(path).cast<std::string>();
  check_path(name);
  const std::string extension = extension_of(name);
  const WriteOptions options = write_options_from(keywords);
  if (extension == ".png") {
    py::module_::import("cover._png").attr("write_png")(self, py::bytes(name), options.order);
    return;
  }
  const Status status = [&]() -> Status {
    const py::gil_scoped_release release;
    if (extension == ".svg") return write_svg(picture_of(mesh.output, options.order), {}, name);
    return write_mesh(mesh.output, name, options);
  }();
  if (!status) raise(status.error());
}

std::vector<std::string> violations(const PyMesh& mesh) {
  std::vector<std::string> messages;
  for (const Violation& v : verify_cover(mesh.output.pslg, mesh.output.table, mesh.soup).violations)
    messages.push_back(v.message);
  return messages;
}

}  // namespace
}  // namespace cover::python

PYBIND11_MODULE(_cover, module) {
  using namespace cover::python;  // NOLINT: a module is nothing but names
  module.doc() = "Multi-region triangle meshes with a proven bound on the largest angle";

  module.attr("__version__") = COVER_VERSION;

  py::class_<PyMesh>(module, "Mesh")
      .def_property_readonly("points", [](const PyMesh& m) { return array_of(m.soup.points); })
      .def_property_readonly("triangles",
                             [](const PyMesh& m) { return array_of(m.soup.triangles); })
      .def_property_readonly("region", [](const PyMesh& m) { return array_of(m.soup.region); })
      .def_property_readonly("material", [](const PyMesh& m) { return array_of(m.soup.material); })
      .def_property_readonly("input_id", &input_ids)
      .def_property_readonly("lines", &lines_of)
      .def_property_readonly("periodic", &periodic_of)
      .def_property_readonly("arcs", &arcs_of)
      .def_property_readonly("attributes", &attributes_of)
      .def_property_readonly("fields", &fields_of)
      .def_property_readonly("report", &report_of)
      .def("save", &save, py::arg("path"))
      .def("violations", &violations)
      .def("__reduce__",
           [](const PyMesh& m) {
             return py::make_tuple(py::module_::import("cover").attr("_mesh_of_state"),
                                   py::make_tuple(pickled(m.output, m.soup, report_text(m))));
           })
      .def("__repr__", [](const PyMesh& m) {
        return "<cover.Mesh: " + std::to_string(m.soup.points.size()) + " points, " +
               std::to_string(m.soup.triangles.size()) + " triangles, " +
               std::to_string(m.output.table.regions.size()) + " regions>";
      });

  module.def("options", &described<cover::option_table>);
  module.def("read_options", &described<cover::read_option_table>);
  module.def("write_options", &described<cover::write_option_table>);
  module.def(
      "mesh_pslg", [](const py::object& points, const py::object& segments, const py::list& regions,
                      const py::object& holes, const py::dict& lines, const py::dict& options,
                      const py::object& progress) {
        return mesh_input(pslg_from(points, segments, regions, holes, lines), options, progress);
      });
  module.def("mesh_text",
             [](const std::string& text, const std::string& extension, const std::string& source,
                const py::dict& options, const py::object& progress) {
               return mesh_input(read_text(text, extension, source), options, progress);
             });
  module.def("mesh_polygons",
             [](const py::list& polygons, const py::dict& options, const py::object& progress) {
               return mesh_input(soup_from(polygons), options, progress);
             });
  module.def("mesh_file", &mesh_file);
  module.def("read", &read_saved);
  module.def("mesh_of_state", [](const py::tuple& state) {
    auto [output, report] = unpickled(state);
    return py_mesh_of(std::move(output), std::move(report));
  });
}
