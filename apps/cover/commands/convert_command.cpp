// cover convert: a mesh that cover wrote, in another format.
#include <fmt/core.h>

#include <cover/read_mesh.hpp>
#include <cover/text.hpp>

#include "commands/commands.hpp"
#include "commands/format_options.hpp"
#include "commands/options.hpp"
#include "files/output_files.hpp"
#include "terminal/console.hpp"
#include "terminal/interrupt.hpp"

namespace cover::app {

int run_convert(Arguments arguments) {
  CLI::App app("Write a mesh that cover wrote in another format", "cover convert");
  app.set_help_flag("-h,--help", "Show this help");
  app.footer(
      R"(Names of regions, interfaces and contacts come from the manifest (.json) or the .vtm beside
the mesh, else from the mesh's own file; what is missing then is said. Attributes of regions
(--keep-field) and values at points (doping) are kept where both formats bear them.

Examples:
  cover convert device.vtm -o device.vtu
  cover convert device.msh -o device.vtm -o clean.poly
)");
  std::string path, format = "vtu";
  std::vector<std::string> outputs;
  FormatOptions formats;
  Verbosity verbosity;
  app.add_option("mesh", path, fmt::format("Mesh that cover wrote: {}", listed(mesh_formats())))
      ->type_name("MESH")
      ->required();
  app.add_option(
         "-o,--output", outputs,
         fmt::format("File to write, several if repeated: {}; '-' is stdout", mesh_extensions()))
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->required();
  app.add_option("--format", format, "Format of '-o -'")->type_name("EXT")->capture_default_str();
  formats.add(app, "Files");
  add_verbosity(app, verbosity);
  if (const auto code = parse(app, std::move(arguments))) return *code;

  std::vector<Writer> writers;
  std::vector<NamedFile> written{log_file(verbosity)};
  for (const std::string& output : outputs) {
    Result<Writer> writer =
        output == "-" ? stdout_writer(format, formats.make()) : mesh_writer(output, formats.make());
    if (!writer) return usage_error(app, writer.error().message);
    writers.push_back(*std::move(writer));
    written.push_back({"-o", output, true});
  }
  if (const Status files = check_files({{"", path}}, written); !files)
    return usage_error(app, files.error());

  const auto log = make_logger(verbosity);
  Interrupt interrupt;
  const Result<Output> mesh = read_output(path);
  if (!mesh) return fail(*log, mesh.error());
  log_notes(*log, mesh->report.notes);
  for (const std::string& option : formats.ignored(outputs, format)) log->warn("{}", option);
  if (const std::string lost = files_without(mesh->table.attributes, outputs, format);
      !lost.empty())
    log->warn("{}", lost);
  if (const std::string rounded = files_that_round(*mesh, outputs, format, formats.make());
      !rounded.empty())
    log->warn("{}", rounded);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const Status done = write_to(writers[k], *mesh, outputs[k], "." + format, interrupt.token());
    if (!done) return fail(*log, done.error());
    log->info("wrote {}", outputs[k] == "-" ? "to standard output" : outputs[k]);
  }
  return exit_ok;
}

}  // namespace cover::app
