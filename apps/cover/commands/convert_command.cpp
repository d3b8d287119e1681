// cover convert: a mesh that cover wrote, in another format.
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/periodic.hpp>
#include <cover/read_mesh.hpp>
#include <cover/result.hpp>
#include <cover/text.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "files/file_check.hpp"
#include "files/mesh_file.hpp"
#include "files/output_files.hpp"
#include "terminal/console.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/progress_line.hpp"
#include "words/group_text.hpp"

namespace cover::app {
namespace {

/// What the formats of `files` leave out of `mesh`.
void warn_of_losses(const OutputFiles& files, const Output& mesh, const std::string& name,
                    spdlog::logger& log) {
  std::vector<PeriodicRule> periodic;
  for (const PeriodicNodes& nodes : mesh.periodic) periodic.push_back(nodes.rule);
  std::vector<std::string> points;
  for (const NamedPoint& point : mesh.pslg.named_points) points.push_back(point.name);
  for (const std::string& warning :
       files.warnings(mesh.table.attributes, mesh.fields, periodic, points))
    log.warn("{}", warning);
  for (const std::string& warning : files.warnings_of(mesh)) log.warn("{}", warning);
  for (const std::string& left : files.left_beside()) log.warn("{}", left);
  if (mesh.nodes && files.write_options().order == 1)
    log.warn("{}: triangles have six nodes, of which the corners are written: --order 2 keeps all",
             name);
  if (const std::string joined = files.regions_joined(mesh.table); !joined.empty())
    log.warn("{}", joined);
}

}  // namespace

int run_convert(Arguments arguments) {
  CLI::App app("Write a mesh that cover wrote in another format", "cover convert");
  app.set_help_flag("-h,--help", "Show this help");
  app.footer(
      R"(Names of regions, interfaces and contacts come from the manifest (.json) or the .vtm beside
the mesh, else from the mesh's own file; what is missing then is said. Attributes of regions
(--keep-field) and values at points (doping) are kept where both formats bear them. Which sides
are periodic stands in the manifest and in .msh: else pairs are left out, which is said of files
of VTK's, which bear a trace of them. With --order 2 curved edges stay curved; the circles of arcs
stand in the manifest alone.

Examples:
  cover convert device.vtm -o device.vtu
  cover convert device.msh -o device.vtm -o clean.poly
)");
  std::string path;
  OutputFiles files;
  Verbosity verbosity;
  app.add_option(
         "mesh", path,
         fmt::format("Mesh that cover wrote: {}; {}", listed(mesh_formats()), kMeshStreamHelp))
      ->type_name("MESH")
      ->required();
  files.add_meshes(app, "stdout, in the format of --format")->required();
  files.add_formats(app, "Files");
  add_verbosity(app, verbosity);
  if (const auto code = parse(app, std::move(arguments))) return *code;

  if (const Status planned = files.plan(); !planned)
    return usage_error(app, planned.error().message);
  std::vector<NamedFile> written = files.named_files();
  written.insert(written.begin(), log_file(verbosity));
  if (const Status checked = check_files({{"", path}}, written); !checked)
    return usage_error(app, checked.error());

  const auto log = make_logger(verbosity);
  Interrupt interrupt;
  const Result<MeshSource> source = MeshSource::open(path);
  if (!source) return fail(*log, source.error());
  Result<Output> mesh = read_output(source->file());
  if (!mesh) return fail(*log, source->named(mesh.error()));
  for (Note& note : mesh->report.notes) note.message = source->named(std::move(note.message));
  log_notes(*log, mesh->report.notes);
  warn_of_losses(files, *mesh, source->name(), *log);
  const Status done = files.write(*mesh, interrupt.token(), ShowProgress::off, *log);
  if (!done) return fail(*log, done.error());
  if (verbosity.quiet) return exit_ok;
  const std::string renamed =
      renamed_text(*mesh, files.names_with_formats(), files.write_options(), verbosity.verbose > 0);
  // What is piped out of stdout must be the mesh alone.
  if (files.has_stdout())
    print_on_stderr(renamed);
  else
    fmt::print("{}", renamed);
  return exit_ok;
}

}  // namespace cover::app
