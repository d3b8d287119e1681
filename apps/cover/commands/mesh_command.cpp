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
    files.add_meshes(app, "stdout, in the format of --format");
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
    const char* group = "Files";
    files.add_formats(app, group)->group(group);
    files.add_reports(app, group);
    app.add_option("--dump-stages", dump_folder,
                   "Write pictures of the disk packing into this folder (method nonobtuse)")
        ->type_name("DIR")
        ->group(group);
    app.add_option("--stream", stream,
                   "Keep the mesh on the disk until it is written, region by region: on, off, or "
                   "auto: a large one whose files allow it")
        ->check(one_of({"auto", "on", "off"}))
        ->type_name("WHEN")
        ->capture_default_str()
        ->group(group);
    app.add_flag("--keep-partial", keep_partial, "Write files even where a bound was missed")
        ->group(group);
    app.add_flag(
           "--dry-run", dry_run,
           "Check the input, say what would be done and estimate triangles and memory; no mesh")
        ->group(group)
        ->configurable(false);
  }

  void add_configuration() {
    const char* group = "Files";
    app.set_config("--config", "", "Read options from a TOML file")
        ->type_name("FILE")
        ->group(group);
    app.allow_config_extras(CLI::config_extras_mode::error);
    app.config_formatter(std::make_shared<JobFile>(app));
    app.add_flag("--print-config", print_config, "Print these options as a --config file")
        ->group(group)
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
    std::vector<NamedFile> read = input.read_files();
    read.push_back({"--onto", onto, true});
    read.push_back(library.size_field_file());
    read.push_back(config_file(app));
    return read;
  }
  [[nodiscard]] std::vector<NamedFile> written_files() const {
    std::vector<NamedFile> written = files.named_files();
    written.push_back(log_file(verbosity));
    return written;
  }

  CLI::App app;
  LibraryOptions library;
  Verbosity verbosity;
  GeometryFile input;
  std::vector<std::string> only;
  std::string onto;
  OutputFiles files;
  std::string stats = "text";
  std::string progress = "auto";
  std::string dump_folder;
  std::string stream = "auto";
  bool keep_partial = false;
  bool dry_run = false;
  bool print_config = false;
};

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
  for (const std::string& path : command.files.paths()) fmt::print("\nWould write {}", path);
  fmt::print("\n");
  return exit_ok;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int write_files(const MeshCommand& command, StreamedOutput& streamed, const std::stop_token& stop,
                spdlog::logger& log) {
  const auto start = std::chrono::steady_clock::now();
  const Status written = command.files.write(streamed, stop, command.show_progress(), log);
  if (!written) return fail(log, written.error());
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
  std::FILE* to = command.files.has_stdout() ? stderr : stdout;
  const bool all = command.verbosity.verbose > 0;
  fmt::print(to, "{}", mesh_text(streamed, all));
  for (const std::string& path : command.files.paths())
    if (path != "-") fmt::print(to, "Wrote {}\n", path);
  fmt::print(to, "{}",
             group_text(streamed, command.files.meshes(), command.files.write_options(), all));
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
  return command.files.can_hold_periodic();
}

/// What needs the whole mesh in memory; empty if nothing does.
std::string needs_whole_mesh(const MeshCommand& command, const Input& input,
                             const Options& options) {
  if (!command.onto.empty()) return "--onto";
  if (std::string why = cover::needs_whole_mesh(input, options); !why.empty()) return why;
  const WriteOptions format = command.files.write_options();
  for (const std::string& path : command.files.meshes()) {
    if (path == "-") return "writing to standard output";
    if (std::string why = cover::needs_whole_mesh(path, format); !why.empty()) return why;
  }
  for (const std::string& path : command.files.reports())
    if (std::filesystem::path(path).extension() == ".html") return "a report that shows the mesh";
  return {};
}

/// Whether other processes may keep their meshes until they write them.
bool may_stay(const OutputFiles& files) {
  const WriteOptions format = files.write_options();
  return std::all_of(files.meshes().begin(), files.meshes().end(), [&](const std::string& path) {
    return can_write_from_elsewhere(path, format);
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
      const StreamOptions stream{command.files.paths().front(),
                                 command.stream == "on" ? 0 : kManyTriangles,
                                 may_stay(command.files)};
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
        const OtherProcesses& others, spdlog::logger& log) {
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
  if (const std::string rounded = command.files.rounding(output); !rounded.empty())
    log.warn("{}", rounded);
  if (const int code = write_files(command, *meshed, interrupt.token(), log); code != exit_ok)
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
  if (command.files.paths().empty() && !command.dry_run) {
    return usage_error(command.app, "nothing to write: give -o FILE, --report FILE or --dry-run");
  }
  if (command.stats == "json" && command.files.has_stdout()) {
    return usage_error(command.app, "-o - and --stats json both write to standard output");
  }
  Result<Options> options = command.library.make();
  if (!options) return usage_error(command.app, options.error().message);
  if (!command.dump_folder.empty() && options->method != Method::nonobtuse) {
    return usage_error(command.app,
                       "--dump-stages shows disk packings: it needs --method nonobtuse");
  }
  if (const Status planned = command.files.plan(); !planned)
    return usage_error(command.app, planned.error().message);
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
  for (const std::string& warning : command.files.warnings(input->attributes))
    log->warn("{}", warning);
  return command.dry_run ? dry_run(command, *input, *options, *log)
                         : run(command, *std::move(input), *options, others, *log);
}

}  // namespace cover::app
