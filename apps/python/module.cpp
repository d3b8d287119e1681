// The Python module: numpy arrays in, numpy arrays out. No geometry here.
//
// A run works on a thread of its own, see run.hpp. The progress callback takes the GIL for its call
// only; what it raises stops the run and comes out of the call.
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cover/cover_mesh.hpp>
#include <cover/join_inputs.hpp>
#include <cover/option_table.hpp>
#include <cover/read_input.hpp>
#include <cover/read_mesh.hpp>
#include <cover/read_option_table.hpp>
#include <cover/read_size_field.hpp>
#include <cover/remesh.hpp>
#include <cover/requirements.hpp>
#include <cover/stored_mesh.hpp>
#include <cover/verify.hpp>
#include <cover/version.hpp>
#include <cover/write_mesh.hpp>
#include <cover/write_option_table.hpp>

#include "arrays.hpp"
#include "mesh_class.hpp"
#include "options.hpp"
#include "pickle.hpp"
#include "py_mesh.hpp"
#include "raise.hpp"
#include "read_geometry.hpp"
#include "run.hpp"

namespace py = pybind11;

namespace cover::python {
namespace {

/// False, also numpy's; None is not.
bool is_false(const py::object& answer) {
  if (answer.ptr() == Py_False) return true;
  if (!py::hasattr(answer, "dtype")) return false;
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth < 0) throw py::error_already_set();  // an array of several values has none
  return truth == 0;
}

/// Where `progress` goes.
Callbacks callbacks_of(const py::object& progress, Callables& callables) {
  Callbacks callbacks;
  callbacks.stop = callables.token();
  if (progress.is_none()) return callbacks;
  if (PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress: " + shown(progress) +
                         " is no function of a stage, what is done and what there is in all");
  callbacks.progress = [&](const Progress& p) {
    const bool goes_on = callables.call(
        [&] { return !is_false(progress(std::string(p.stage), p.done, p.total)); }, true);
    if (!goes_on) callables.request_stop();
  };
  return callbacks;
}

/// `report` and `remarks`: of a mesh that was pickled.
PyMesh py_mesh_of(Output output, std::string report = {}, std::vector<std::string> remarks = {}) {
  TriangleSoup soup = triangle_soup(output.mesh);
  return {std::move(output), std::move(soup), std::move(report), {}, std::move(remarks)};
}

/// What a mesh made with `options` promises, against the PSLG of its run: segments that the run cut
/// are cut there, too. The publication as printed promises no bound.
VerifyOptions promises_of(const Options& options) {
  VerifyOptions verify;
  verify.bound = !options.paper;
  verify.hull = options.hull;
  verify.max_angle = options.max_angle;
  verify.min_angle = options.min_angle;
  verify.threads = options.threads;
  return verify;
}

/// Background sizes that are a function: f(x, y), a length.
SizeFunction sizes_of(const py::object& function, Callables& callables) {
  return [&function, &callables](Point at) {
    return callables.call([&] { return py::float_(function(at.x, at.y)).cast<double>(); }, NAN);
  };
}

[[noreturn]] void refuse(std::string message) {
  raise({ErrorCode::bad_option, std::move(message), {}, {}});
}

/// Raises OptionError for what is neither a function nor a path.
void check_size_field(const py::dict& keywords) {
  if (!keywords.contains("size_field")) return;
  const py::object field = keywords["size_field"];
  if (!field.is_none() && PyCallable_Check(field.ptr()) == 0 && !py::isinstance<py::str>(field) &&
      !py::hasattr(field, "__fspath__"))
    refuse("size_field: " + shown(field) +
           " is neither a function of x and y nor the path of a file; a length is given as size");
}

/// Regions that are meshed again, and the mesh in which they are replaced.
struct Again {
  std::vector<std::string> only;
  TriangleSoup onto;
  std::string name;              ///< of that mesh
  std::optional<Output> before;  ///< that mesh with what belongs to it, where that can be read
};

/// The triangles of a file. Where it has groups instead of materials, the manifest tells them.
Result<TriangleSoup> triangles_in(const std::string& path) {
  Result<MeshFile> mesh = read_mesh(path);
  if (!mesh) return std::move(mesh).error();
  if (!mesh->soup.material.empty() || mesh->group.empty()) return std::move(mesh->soup);
  StoredMesh stored;
  stored.soup = std::move(mesh->soup);
  const Result<bool> named =
      read_manifest(std::filesystem::path(path).replace_extension(".json"), mesh->group, stored);
  if (!named || !*named) stored.soup.region.clear(), stored.soup.material.clear();
  return std::move(stored.soup);
}

/// Takes only and onto out of `keywords`, a copy of them.
std::optional<Again> take_again(py::dict& keywords) {
  if (!keywords.contains("onto")) return std::nullopt;
  keywords = keywords.attr("copy")();
  const py::object onto = keywords.attr("pop")("onto"), only = keywords.attr("pop")("only");
  if (only.is_none() || onto.is_none())
    refuse("only names the regions that are meshed again in the mesh onto: both are needed");
  Again again;
  const bool is_one = py::isinstance<py::str>(only) || !py::isinstance<py::iterable>(only);
  for (const py::handle& name : is_one ? py::list(py::make_tuple(only)) : py::list(only)) {
    if (!py::isinstance<py::str>(name) && PyIndex_Check(name.ptr()) == 0)
      refuse("only: " + shown(name) + " is no name of a region or a material");
    again.only.push_back(bytes_of(py::str(name)));
  }
  if (py::isinstance<PyMesh>(onto)) {
    const auto& mesh = onto.cast<const PyMesh&>();
    again.onto = mesh.soup;
    again.name = "the mesh";
    again.before = mesh.output;
    return again;
  }
  again.name = py::module_::import("os").attr("fsencode")(onto).cast<std::string>();
  check_path(again.name);
  Callables nothing;
  again.onto = run(nothing, [&] { return triangles_in(again.name); });
  // Nothing was lost that cannot be read.
  if (Result<Output> before = read_output(again.name)) again.before = *std::move(before);
  return again;
}

PyMesh mesh_input(Input input, py::dict keywords, const py::object& progress,
                  const std::vector<Provenance::Setting>& read_with = {}) {
  Callables callables;
  py::object sizes;
  check_size_field(keywords);
  if (keywords.contains("size_field") && PyCallable_Check(keywords["size_field"].ptr()) != 0) {
    sizes = keywords["size_field"];
    if (keywords.contains("size_of") && !keywords["size_of"].is_none())
      refuse("size_of is of the values of a file, and size_field is a function");
    keywords = keywords.attr("copy")();
    keywords.attr("pop")("size_field");
  }
  const std::optional<Again> again = take_again(keywords);
  Options before;
  if (sizes) {
    before.size_field = sizes_of(sizes, callables);
    before.size_field_name = "a function";
  }
  auto [options, idle] = options_from(keywords, std::move(before));
  input.warnings.insert(input.warnings.end(), idle.begin(), idle.end());
  const Callbacks callbacks = callbacks_of(progress, callables);
  Output output = run(callables, [&, &chosen = options]() -> Result<Output> {
    if (Status status = load_size_field(chosen, input); !status) return std::move(status).error();
    if (!again) return cover_mesh(input, chosen, callbacks);
    Result<Output> made = remesh(input, again->onto, again->only, chosen, callbacks);
    if (!made && made.error().code == ErrorCode::other_mesh) {
      Error error = std::move(made).error();
      error.message = again->name + ": " + error.message;
      return error;
    }
    return made;
  });
  if (again) {
    output.report.provenance.settings.push_back({"onto", again->name});
    if (again->before) keep_attributes(*again->before, again->name, output);
  }
  std::vector<Provenance::Setting>& settings = output.report.provenance.settings;
  settings.insert(settings.end(), read_with.begin(), read_with.end());
  const std::vector<std::string> unmet = unmet_requirements(output, options);
  PyMesh mesh = py_mesh_of(std::move(output));
  mesh.promises = promises_of(options);
  if (unmet.empty()) return mesh;
  std::string words = "the mesh does not meet";
  for (const std::string& requirement : unmet)
    words += (&requirement == &unmet.front() ? " " : "; ") + requirement;
  raise({ErrorCode::requirement_not_met, words, {}, {}}, py::cast(std::move(mesh)));
}

/// A mesh that cover wrote.
PyMesh read_saved(const std::string& path) {
  check_path(path);
  Callables nothing;
  return py_mesh_of(run(nothing, [&] { return read_output(path); }));
}

/// Meshes files as one geometry; options are those of reading and of meshing.
PyMesh mesh_files(const std::vector<std::string>& paths, py::dict keywords,
                  const py::object& progress) {
  for (const std::string& path : paths) check_path(path);
  auto [options, given] = take_read_options(keywords);
  options.is_one_of_several = paths.size() > 1;
  if (keywords.contains("threads"))
    options.threads =
        options_from(py::dict(py::arg("threads") = keywords["threads"])).options.threads;
  Callables nothing;  // Ctrl-C ends a program that reads the file; else it counts once that is read
  Input input = run(nothing, [&, &chosen = options]() -> Result<Input> {
    std::vector<Input> inputs;
    for (const std::string& path : paths) {
      Result<Input> read = reading::read_geometry(path, chosen, nothing.token());
      if (!read || paths.size() == 1) return read;
      inputs.push_back(*std::move(read));
    }
    return join_inputs(std::move(inputs));
  });
  const std::vector<std::string> idle = idle_read_options(given, options, paths);
  input.warnings.insert(input.warnings.end(), idle.begin(), idle.end());
  return mesh_input(std::move(input), keywords, progress, describe_read_options(options));
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

/// Geometry in one of the formats of text.
Input read_text(const std::string& text, const std::string& extension, const std::string& source) {
  Result<Input> input = parse_input(text, extension, source);
  if (!input) raise(input.error());
  return std::move(input).value();
}

}  // namespace
}  // namespace cover::python

PYBIND11_MODULE(_cover, module) {
  using namespace cover::python;  // NOLINT: a module is nothing but names
  module.doc() = "Multi-region triangle meshes with a proven bound on the largest angle";

  module.attr("__version__") = COVER_VERSION;

  stop_runs_at_exit();
  define_mesh(module);
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
  module.def("mesh_files", &mesh_files);
  module.def("read", &read_saved);
  module.def("mesh_of_state", [](const py::tuple& state) {
    auto [output, report, remarks] = unpickled(state);
    return py_mesh_of(std::move(output), std::move(report), std::move(remarks));
  });
}
