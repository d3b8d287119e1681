// cover mesh: options, one call of cover_mesh, files, report.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/core.h>

#include <cover/cover_mesh.hpp>
#include <cover/estimate.hpp>
#include <cover/read_size_field.hpp>
#include <cover/regions.hpp>
#include <cover/remesh.hpp>
#include <cover/stream_mesh.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include "commands/commands.hpp"
#include "commands/format_options.hpp"
#include "commands/options.hpp"
#include "commands/requirements.hpp"
#include "files/dump_stages.hpp"
#include "files/file_check.hpp"
#include "files/input_file.hpp"
#include "files/job_file.hpp"
#include "files/mesh_file.hpp"
#include "files/output_files.hpp"
#include "terminal/console.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/progress_line.hpp"
#include "words/group_text.hpp"
#include "words/text_report.hpp"

namespace cover::app {
namespace {

constexpr const char* kExamples = R"(Examples:
  cover mesh device.poly -o device.vtu
  cover mesh device.poly -o device.vtu -o device.vtm --report device.html
  cover mesh device.poly -o device.vtu --require bound,max-angle --max-angle 130
  cover mesh device.poly --only gate oxide --onto device.vtu --size 2 -o finer.vtu
  cover mesh --config job.toml
  generate | cover mesh - -o - --format vtu > device.vtu

Exit codes: 0 done, 1 defect of cover, 2 usage, 3 bad geometry, 4 bound missed (nothing
written), 5 files, 6 --require not met, 7 out of memory, 130 interrupted.
)";

/// Everything that the command line of `cover mesh` says.
struct MeshCommand {
  explicit MeshCommand() : app("Triangulate all regions of a geometry file", "cover mesh") {
    app.footer(kExamples);
    app.set_help_flag("-h,--help", "Show this help");
    add_input_and_output();
    library.add(app, OptionGroup::meshing);
    library.add(app, OptionGroup::cleaning);
    add_meshing_again();
    add_files();
    add_configuration();
    add_messages();
  }

  void add_input_and_output() {
    input.add(app, true);
    app.add_option(
           "-o,--output", outputs,
           fmt::format(
               "File to write, several if repeated: {}; '-' is stdout, in the format of --format",
               mesh_extensions()))
        ->type_name("FILE")
        ->allow_extra_args(false);
  }

  void add_meshing_again() {
    const char* again = "Meshing again";
    CLI::Option* only_option =
        app.add_option("--only", only, "Mesh only these regions, called as for --size")
            ->type_name("NAME")
            ->group(again);
    CLI::Option* onto_option =
        app.add_option("--onto", onto,
                       "Mesh of this input in which they are replaced; all else stays, bit for bit")
            ->type_name("MESH")
            ->group(again);
    only_option->needs(onto_option);
    onto_option->needs(only_option);
  }

  void add_files() {
    const char* files = "Files";
    app.add_option("--format", format, "Format of '-o -'")
        ->type_name("EXT")
        ->capture_default_str()
        ->group(files);
    formats.add(app, files);
    app.add_option("--report", reports,
                   "Write a report on every region: .json for programs, .html to read")
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->group(files);
    app.add_option("--dump-stages", dump_folder,
                   "Write pictures of the disk packing into this folder (method nonobtuse)")
        ->type_name("DIR")
        ->group(files);
    app.add_option("--stream", stream,
                   "Keep the mesh on the disk until it is written, region by region: on, off, or "
                   "auto: a large one whose files allow it")
        ->check(one_of({"auto", "on", "off"}))
        ->type_name("WHEN")
        ->capture_default_str()
        ->group(files);
    app.add_flag("--keep-partial", keep_partial, "Write files even where a bound was missed")
        ->group(files);
    app.add_flag(
           "--dry-run", dry_run,
           "Check the input, say what would be done and estimate triangles and memory; no mesh")
        ->group(files)
        ->configurable(false);
  }

  void add_configuration() {
    const char* files = "Files";
    app.set_config("--config", "", "Read options from a TOML file")
        ->type_name("FILE")
        ->group(files);
    app.allow_config_extras(CLI::config_extras_mode::error);
    app.config_formatter(std::make_shared<JobFile>(app));
    app.add_flag("--print-config", print_config, "Print these options as a --config file")
        ->group(files)
        ->configurable(false);
  }

  void add_messages() {
    app.add_option("--stats", stats, "Report on stdout as text or json")
        ->check(one_of({"text", "json"}))
        ->type_name("FORM")
        ->capture_default_str()
        ->group("Messages");
    app.add_option("--progress", progress, "Progress on stderr: auto, on, off")
        ->check(one_of({"auto", "on", "off"}))
        ->type_name("WHEN")
        ->capture_default_str()
        ->group("Messages");
    add_verbosity(app, verbosity);
  }

  [[nodiscard]] ShowProgress show_progress() const {
    return progress == "on"                       ? ShowProgress::on
           : progress == "off" || verbosity.quiet ? ShowProgress::off
                                                  : ShowProgress::automatic;
  }
  [[nodiscard]] std::vector<NamedFile> read_files() const {
    std::vector<NamedFile> files = input.read_files();
    files.push_back({"--onto", onto, true});
    files.push_back(library.size_field_file());
    files.push_back(config_file(app));
    return files;
  }
  [[nodiscard]] std::vector<NamedFile> written_files() const {
    std::vector<NamedFile> files;
    for (const std::string& path : outputs) files.push_back({"-o", path, true});
    for (const std::string& path : reports) files.push_back({"--report", path});
    files.push_back(log_file(verbosity));
    return files;
  }
  [[nodiscard]] bool to_stdout() const {
    return std::find(outputs.begin(), outputs.end(), "-") != outputs.end();
  }

  CLI::App app;
  LibraryOptions library;
  Verbosity verbosity;
  GeometryFile input;
  std::vector<std::string> only;
  std::string onto;
  std::vector<std::string> outputs;
  std::vector<std::string> reports;
  std::string format = "vtu";
  FormatOptions formats;
  std::string stats = "text";
  std::string progress = "auto";
  std::string dump_folder;
  std::string stream = "auto";
  bool keep_partial = false;
  bool dry_run = false;
  bool print_config = false;
};

struct File {
  std::string path;
  Writer write;
};

/// Finds out before the work whether every file can be written in the format it asks for.
Result<std::vector<File>> plan_files(const MeshCommand& command) {
  std::vector<File> files;
  for (const std::string& path : command.outputs) {
    Result<Writer> writer = path == "-" ? stdout_writer(command.format, command.formats.make())
                                        : mesh_writer(path, command.formats.make());
    if (!writer) return writer.error();
    files.push_back({path, *writer});
  }
  for (const std::string& path : command.reports) {
    Result<Writer> writer = report_writer(path, command.formats.make().order);
    if (!writer) return writer.error();
    files.push_back({path, *writer});
  }
  return files;
}

int dry_run(const MeshCommand& command, const Input& input, const Options& options,
            spdlog::logger& log) {
  const Result<Prepared> prepared = prepare(input, options);
  if (!prepared) return fail(log, prepared.error());
  if (!command.onto.empty()) {
    if (const Result<MeshTriangles> onto = read_triangles(command.onto, log); !onto)
      return fail(log, onto.error());
  }
  log_notes(log, prepared->report.notes);
  const bool as_json = command.stats == "json";
  if (as_json) fmt::print("{}\n", report_json(*prepared));
  if (!as_json) {
    const Result<Estimate> all = estimate(*prepared, options);
    if (!all) return fail(log, all.error());
    log_notes(log, all->notes);
    fmt::print("{}{}", info_text(*prepared, command.verbosity.verbose > 0), estimate_text(*all));
  }
  for (const std::string& name : command.only) {
    const std::vector<RegionId> regions = named_regions(prepared->table, name);
    if (regions.empty()) return fail(log, no_such_region(prepared->table, "only", name));
    for (const RegionId id : regions) {
      if (as_json) continue;
      fmt::print("\nWould mesh region {} '{}' again in {}", id.value(),
                 printable(prepared->table.region(id).name), command.onto);
    }
  }
  if (as_json) return exit_ok;
  for (const auto& paths : {command.outputs, command.reports})
    for (const std::string& path : paths) fmt::print("\nWould write {}", path);
  fmt::print("\n");
  return exit_ok;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int write_files(const MeshCommand& command, const std::vector<File>& files,
                StreamedOutput& streamed, const std::stop_token& stop, spdlog::logger& log) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t k = 0; k < files.size(); ++k) {
    const File& file = files[k];
    WriteOptions format = command.formats.make();
    format.stop = stop;
    const bool is_report = k >= command.outputs.size();  // they come last
    ProgressLine line(file.path == "-" ? ShowProgress::off : command.show_progress());
    line.update({"write", 0, 0});
    const Status written = !streamed.is_streamed() ? write_to(file.write, streamed.output,
                                                              file.path, "." + command.format, stop)
                           : is_report             ? write_report_json(streamed, file.path)
                                       : write_streamed_mesh(streamed, file.path, format);
    line.clear();
    if (!written) return fail(log, written.error());
    log.info("wrote {}", file.path == "-" ? "to standard output" : file.path);
  }
  streamed.output.report.times.push_back({"write", seconds_since(start)});
  return exit_ok;
}

int print_report(const MeshCommand& command, const StreamedOutput& streamed, spdlog::logger& log) {
  if (command.stats == "json") {
    const Status written = write_to("-", ".json", [&](const std::string& target) {
      return write_report_json(streamed, target);
    });
    return written ? exit_ok : fail(log, written.error());
  }
  if (command.verbosity.quiet) return exit_ok;
  // What is piped out of stdout must be the mesh alone.
  std::FILE* to = command.to_stdout() ? stderr : stdout;
  fmt::print(to, "{}", mesh_text(streamed, command.verbosity.verbose > 0));
  for (const auto& paths : {command.outputs, command.reports}) {
    for (const std::string& path : paths) {
      if (path != "-") fmt::print(to, "Wrote {}\n", path);
    }
  }
  fmt::print(
      to, "{}",
      group_text(streamed, command.outputs, command.formats.make(), command.verbosity.verbose > 0));
  return exit_ok;
}

/// Meshes parts of a mesh again.
Result<Output> mesh_again(const MeshCommand& command, const Input& input, const Options& options,
                          const Callbacks& callbacks, spdlog::logger& log) {
  Result<MeshTriangles> onto = read_triangles(command.onto, log);
  if (!onto) return std::move(onto).error();
  if (!onto->has_materials) onto->soup.material.clear();
  Result<Output> output = remesh(input, onto->soup, command.only, options, callbacks);
  if (!output && output.error().code == ErrorCode::bad_option &&
      std::any_of(command.only.begin(), command.only.end(),
                  [](const std::string& name) { return name.find(',') != name.npos; })) {
    Error error = std::move(output).error();
    error.message += "; blanks separate the names of --only";
    return error;
  }
  if (output) {
    output->report.provenance.settings.push_back({"onto", command.onto});
  } else if (output.error().code == ErrorCode::other_mesh) {
    return Error{ErrorCode::other_mesh, command.onto + ": " + output.error().message,
                 output.error().where, output.error().inputs};
  }
  return output;
}

/// Whether the files can hold what the input asks for, too.
Status check_files_hold(const MeshCommand& command, const Input& input, const Options& options) {
  if (input.periodic.empty() && options.periodic.empty()) return ok();
  Status status = ok();
  for (const std::string& path : command.outputs)
    if (status) status = can_write_periodic(path, command.formats.make());
  return status;
}

/// What needs the whole mesh in memory; empty if nothing does.
std::string needs_whole_mesh(const MeshCommand& command, const Input& input,
                             const Options& options) {
  if (!command.onto.empty()) return "--onto";
  if (std::string why = cover::needs_whole_mesh(input, options); !why.empty()) return why;
  for (const std::string& path : command.outputs) {
    if (path == "-") return "writing to standard output";
    if (std::string why = cover::needs_whole_mesh(path, command.formats.make()); !why.empty())
      return why;
  }
  for (const std::string& path : command.reports)
    if (std::filesystem::path(path).extension() == ".html") return "a report that shows the mesh";
  return {};
}

/// Whether other processes may keep their meshes until they write them.
bool may_stay(const MeshCommand& command) {
  return std::all_of(command.outputs.begin(), command.outputs.end(), [&](const std::string& path) {
    return can_write_from_elsewhere(path, command.formats.make());
  });
}

/// Makes the mesh, in memory or on the disk, or parts of it again.
Result<StreamedOutput> make_mesh(const MeshCommand& command, Input input, const Options& options,
                                 const Callbacks& callbacks, spdlog::logger& log) {
  // A run in memory takes half a gigabyte for so many.
  constexpr double kManyTriangles = 2e6;
  if (command.stream != "off") {
    const std::string why = needs_whole_mesh(command, input, options);
    if (why.empty()) {
      const StreamOptions stream{
          command.outputs.empty() ? command.reports.front() : command.outputs.front(),
          command.stream == "on" ? 0 : kManyTriangles, may_stay(command)};
      return stream_mesh(std::move(input), options, stream, callbacks);
    }
    if (command.stream == "on")
      return Error{ErrorCode::bad_option,
                   fmt::format("--stream on: the whole mesh is needed in memory for {}", why),
                   {},
                   {}};
    log.info("the mesh is held in memory: the whole of it is needed for {}", why);
  }
  Result<Output> output = command.onto.empty()
                              ? cover_mesh(std::move(input), options, callbacks)
                              : mesh_again(command, input, options, callbacks, log);
  if (!output) return std::move(output).error();
  const MeshCounts counts = count_of(output->mesh);
  return StreamedOutput{*std::move(output), counts, nullptr};
}

/// Meshes, writes, reports.
int run(const MeshCommand& command, Input input, const Options& options,
        const std::vector<File>& files, const OtherProcesses& others, spdlog::logger& log) {
  Interrupt interrupt;
  ProgressLine line(command.show_progress());
  Callbacks callbacks;
  callbacks.progress = [&](const Progress& step) { line.update(step); };
  callbacks.stop = interrupt.token();
  callbacks.share_out = others.share_out;
  callbacks.write_elsewhere = others.write_elsewhere;
  std::vector<PackingRecord> packings;
  if (!command.dump_folder.empty()) {
    callbacks.packing = [&](RegionId, const PackingRecord& packing) {
      packings.push_back(packing);
    };
  }
  Result<StreamedOutput> meshed = make_mesh(command, std::move(input), options, callbacks, log);
  line.clear();
  if (!meshed) return fail(log, meshed.error());

  Output& output = meshed->output;
  for (Provenance::Setting& setting : command.input.settings())
    output.report.provenance.settings.push_back(std::move(setting));
  log_notes(log, output.report.notes);
  for (const RegionReport& region : output.report.regions) log_notes(log, region.notes);
  const bool complete = !missed_bound(output.report);
  if (!complete && !command.keep_partial) {
    log.error("{}; nothing was written (--keep-partial writes it anyway)",
              describe_missed_bound(output));
    return exit_incomplete;
  }
  if (interrupt.token().stop_requested()) {
    return fail(log, {ErrorCode::cancelled, "interrupted; nothing was written", {}, {}});
  }
  if (const std::string rounded =
          files_that_round(output, command.outputs, command.format, command.formats.make());
      !rounded.empty())
    log.warn("{}", rounded);
  if (const int code = write_files(command, files, *meshed, interrupt.token(), log);
      code != exit_ok)
    return code;
  if (!command.dump_folder.empty()) {
    const Status dumped = dump_stages(packings, command.dump_folder);
    if (!dumped) return fail(log, dumped.error());
  }
  interrupt.finish();
  if (const int code = print_report(command, *meshed, log); code != exit_ok) return code;
  if (!complete) return exit_incomplete;

  const std::vector<std::string> unmet = unmet_requirements(output, options);
  for (const std::string& what : unmet) log.error("required, but not met: {}", what);
  return unmet.empty() ? exit_ok : exit_unmet;
}

}  // namespace

int run_mesh(Arguments arguments, const OtherProcesses& others) {
  MeshCommand command;
  if (const auto code = parse(command.app, std::move(arguments))) return *code;
  if (command.print_config) {
    fmt::print("{}", configuration(command.app));
    return exit_ok;
  }
  if (command.input.path().empty()) return usage_error(command.app, "no input file given");
  if (command.outputs.empty() && command.reports.empty() && !command.dry_run) {
    return usage_error(command.app, "nothing to write: give -o FILE, --report FILE or --dry-run");
  }
  if (command.stats == "json" && command.to_stdout()) {
    return usage_error(command.app, "-o - and --stats json both write to standard output");
  }
  Result<Options> options = command.library.make();
  if (!options) return usage_error(command.app, options.error().message);
  if (!command.dump_folder.empty() && options->method != Method::nonobtuse) {
    return usage_error(command.app,
                       "--dump-stages shows disk packings: it needs --method nonobtuse");
  }
  const Result<std::vector<File>> files = plan_files(command);
  if (!files) return usage_error(command.app, files.error().message);
  const Status checked = check_files(command.read_files(), command.written_files());
  if (!checked) return usage_error(command.app, checked.error());

  const auto log = make_logger(command.verbosity);
  Result<Input> input = command.input.read(options->threads, others.read_elsewhere);
  if (!input) return fail(*log, input.error());
  if (const Status hold = check_files_hold(command, *input, *options); !hold)
    return usage_error(command.app, hold.error().message);
  if (const Status status = load_size_field(*options, *input); !status)
    return fail(*log, status.error());
  log->info("read {}: {} points, {} segments, {} polygons, {} lines", command.input.path(),
            input->points.size(), input->segments.size(), input->polygons.size(),
            input->lines.size());
  for (const std::string& option : command.library.ignored()) log->warn("{}", option);
  for (const std::string& option : command.input.ignored()) log->warn("{}", option);
  for (const std::string& option : command.formats.ignored(command.outputs, command.format))
    log->warn("{}", option);
  if (const std::string lost = files_without(input->attributes, command.outputs, command.format);
      !lost.empty())
    log->warn("{}", lost);
  return command.dry_run ? dry_run(command, *input, *options, *log)
                         : run(command, *std::move(input), *options, *files, others, *log);
}

}  // namespace cover::app
