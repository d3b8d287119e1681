// Tested by tests/unit/app/make_mesh_test.cpp, tests/cli/large_mesh_test.py.
#include "commands/mesh/make_mesh.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include <cover/cover_mesh.hpp>
#include <cover/files.hpp>
#include <cover/mesh_counts.hpp>
#include <cover/read_mesh.hpp>
#include <cover/remesh.hpp>
#include <cover/write_options.hpp>

#include "files/mesh_file.hpp"

namespace cover::app {
namespace {

/// From so many expected triangles on a mesh stays on the disk: in memory a run takes half a
/// gigabyte for them.
constexpr double kManyTriangles = 2e6;

/// Whether other processes may keep their meshes until they write them.
bool may_stay_elsewhere(const OutputFiles& files) {
  const WriteOptions format = files.write_options();
  return std::all_of(files.meshes().begin(), files.meshes().end(), [&](const std::string& path) {
    return can_write_from_elsewhere(path, format);
  });
}

/// Whether names are separated by commas, as they are elsewhere.
bool has_comma(const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [](const std::string& name) { return name.find(',') != name.npos; });
}

/// Meshes parts of a mesh again.
Result<Output> mesh_again(const MeshPlan& plan, const Input& input, const Options& options,
                          const Callbacks& callbacks, spdlog::logger& log) {
  const Result<MeshSource> source = MeshSource::open(plan.onto);
  if (!source) return source.error();
  Result<MeshTriangles> onto = read_triangles(*source, log);
  if (!onto) return std::move(onto).error();
  if (!onto->has_materials) onto->soup.material.clear();
  if (!onto->middles.empty()) warn_of_corners(*source, log);
  Result<Output> output = remesh(input, onto->soup, plan.only, options, callbacks);
  if (output) {
    output->report.provenance.settings.push_back({"onto", plan.onto});
    // Nothing was lost that cannot be read.
    if (const Result<Output> before = read_output(source->file()))
      keep_attributes(*before, source->name(), *output);
    return output;
  }
  Error error = std::move(output).error();
  if (error.code == ErrorCode::bad_option && has_comma(plan.only))
    error.message += "; blanks separate the names of --only";
  if (error.code == ErrorCode::other_mesh) error.message = source->name() + ": " + error.message;
  return error;
}

}  // namespace

std::string what_needs_all_in_memory(const MeshPlan& plan, const OutputFiles& files,
                                     const Input& input, const Options& options) {
  if (!plan.onto.empty()) return "--onto";
  if (std::string why = needs_whole_mesh(input, options); !why.empty()) return why;
  const WriteOptions format = files.write_options();
  for (const std::string& path : files.meshes()) {
    if (path == "-") return "writing to standard output";
    if (std::string why = needs_whole_mesh(path, format); !why.empty()) return why;
  }
  for (const std::string& path : files.reports())
    if (extension_of(path) == ".html") return "a report that shows the mesh";
  return {};
}

bool stays_on_disk(const MeshPlan& plan, const OutputFiles& files, const Input& input,
                   const Options& options, double triangles) {
  if (plan.stream == "off" || files.paths().empty()) return false;
  return (plan.stream == "on" || triangles > kManyTriangles) &&
         what_needs_all_in_memory(plan, files, input, options).empty();
}

Result<StreamedOutput> make_mesh(const MeshPlan& plan, const OutputFiles& files, Input input,
                                 const Options& options, const Callbacks& callbacks,
                                 spdlog::logger& log) {
  if (plan.stream != "off") {
    const std::string why = what_needs_all_in_memory(plan, files, input, options);
    if (why.empty()) {
      const StreamOptions stream{files.paths().front(), plan.stream == "on" ? 0 : kManyTriangles,
                                 may_stay_elsewhere(files)};
      return stream_mesh(std::move(input), options, stream, callbacks);
    }
    if (plan.stream == "on")
      return Error{ErrorCode::bad_option,
                   fmt::format("--stream on: the whole mesh is needed in memory for {}", why),
                   {},
                   {}};
    log.info("the mesh is held in memory: the whole of it is needed for {}", why);
  }
  Result<Output> output = plan.onto.empty() ? cover_mesh(std::move(input), options, callbacks)
                                            : mesh_again(plan, input, options, callbacks, log);
  if (!output) return std::move(output).error();
  const MeshCounts counts = count_of(output->mesh);
  return StreamedOutput{*std::move(output), counts, nullptr};
}

}  // namespace cover::app
