// cover mesh: options, one call of cover_mesh, files, report.
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <spdlog/logger.h>
#include <CLI/CLI.hpp>

#include <cover/cover_mesh.hpp>
#include <cover/estimate.hpp>
#include <cover/options.hpp>
#include <cover/packing.hpp>
#include <cover/periodic.hpp>
#include <cover/progress.hpp>
#include <cover/read_size_field.hpp>
#include <cover/regions.hpp>
#include <cover/requirements.hpp>
#include <cover/result.hpp>
#include <cover/stream_mesh.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include "commands/commands.hpp"
#include "commands/mesh/make_mesh.hpp"
#include "commands/options.hpp"
#include "files/dump_stages.hpp"
#include "files/file_check.hpp"
#include "files/input_file.hpp"
#include "files/job_file.hpp"
#include "files/mesh_file.hpp"
#include "files/output_files.hpp"
#include "files/writers.hpp"
#include "terminal/console.hpp"
#include "terminal/interrupt.hpp"
#include "terminal/progress_line.hpp"
#include "words/estimate_text.hpp"
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
written), 5 files, 6 --require not met (the mesh is written), 7 out of memory,
130 interrupted.
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
    files.add_meshes(app, "stdout, in the format of --format, by way of $TMPDIR");
  }

  void add_meshing_again() {
    const char* again = "Meshing again";
    CLI::Option* only_option =
        app.add_option("--only", plan.only, "Mesh only these regions, called as for --size")
            ->type_name("NAME")
            ->group(again);
    CLI::Option* onto_option =
        app.add_option("--onto", plan.onto,
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
    app.add_option("--stream", plan.stream,
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
    app.config_formatter(std::make_shared<JobFile>());
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

  /// What is wrong with the words, apart from each alone; nothing where they make sense.
  [[nodiscard]] std::optional<std::string> check_usage() const {
    if (input.path().empty()) return "no input file given";
    if (files.paths().empty() && !dry_run)
      return "nothing to write: give -o FILE, --report FILE or --dry-run";
    if (is_json() && files.has_stdout())
      return "-o - and --stats json both write to standard output";
    return std::nullopt;
  }
  /// The same with the library's options.
  [[nodiscard]] std::optional<std::string> check_usage_with(const Options& options) const {
    if (!dump_folder.empty() && options.method != Method::nonobtuse)
      return "--dump-stages shows disk packings: it needs --method nonobtuse";
    return std::nullopt;
  }

  [[nodiscard]] bool is_json() const { return stats == "json"; }
  [[nodiscard]] bool is_verbose() const { return verbosity.verbose > 0; }
  [[nodiscard]] ShowProgress show_progress() const {
    return progress == "on"                       ? ShowProgress::on
           : progress == "off" || verbosity.quiet ? ShowProgress::off
                                                  : ShowProgress::automatic;
  }
  [[nodiscard]] std::vector<NamedFile> read_files() const {
    std::vector<NamedFile> read = input.read_files();
    read.push_back({"--onto", plan.onto, true});
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
  MeshPlan plan;
  OutputFiles files;
  std::string stats = "text";
  std::string progress = "auto";
  std::string dump_folder;
  bool keep_partial = false;
  bool dry_run = false;
  bool print_config = false;
};

/// The regions that a name of --only stands for.
Result<std::vector<RegionId>> regions_called(const std::string& name, const RegionTable& table) {
  std::vector<RegionId> regions = named_regions(table, name);
  if (regions.empty()) return no_such_region(table, "only", name);
  return regions;
}

int print_plan_as_json(const MeshCommand& command, const Prepared& prepared, const Estimate& all,
                       spdlog::logger& log) {
  fmt::print("{}\n", report_json(prepared, all));
  for (const std::string& name : command.plan.only) {
    if (const auto regions = regions_called(name, prepared.table); !regions)
      return fail(log, regions.error());
  }
  return exit_ok;
}

int print_plan(const MeshCommand& command, const Prepared& prepared, const Estimate& all,
               bool stays_on_disk, spdlog::logger& log) {
  fmt::print("{}{}", info_text(prepared, command.is_verbose()), estimate_text(all, stays_on_disk));
  for (const std::string& name : command.plan.only) {
    const auto regions = regions_called(name, prepared.table);
    if (!regions) return fail(log, regions.error());
    for (const RegionId id : *regions) {
      fmt::print("\nWould mesh region {} '{}' again in {}", id.value(),
                 printable(prepared.table.region(id).name), command.plan.onto);
    }
  }
  for (const std::string& path : command.files.paths()) fmt::print("\nWould write {}", path);
  fmt::print("\n");
  return exit_ok;
}

/// Tells the report how files were read, too.
void add_read_options(const MeshCommand& command, Report& report) {
  for (Provenance::Setting& setting : command.input.settings())
    report.provenance.settings.push_back(std::move(setting));
}

int dry_run(const MeshCommand& command, const Input& input, const Options& options,
            spdlog::logger& log) {
  // What memory may not do for is large.
  constexpr double kMany = std::numeric_limits<double>::infinity();
  const bool is_held = !stays_on_disk(command.plan, command.files, input, options, kMany);
  Result<Prepared> prepared = prepare(input, options, {}, is_held ? Held::all : Held::one_region);
  if (!prepared) return fail(log, prepared.error());
  add_read_options(command, prepared->report);
  if (!command.plan.onto.empty()) {
    const Result<MeshSource> source = MeshSource::open(command.plan.onto);
    if (!source) return fail(log, source.error());
    if (const auto onto = read_triangles(*source, log); !onto) return fail(log, onto.error());
  }
  log_notes(log, not_yet_told(prepared->report.notes, input.warnings));
  Options with_layers = options;
  with_layers.layers.insert(with_layers.layers.begin(), input.layers.begin(), input.layers.end());
  const Result<Estimate> all = estimate(*prepared, with_layers);
  if (!all) return fail(log, all.error());
  log_notes(log, all->notes);
  if (!command.files.reports().empty())
    log.warn("--report writes nothing in a dry run: --stats json prints what is known before");
  return command.is_json()
             ? print_plan_as_json(command, *prepared, *all, log)
             : print_plan(
                   command, *prepared, *all,
                   stays_on_disk(command.plan, command.files, input, options, all->triangles), log);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int print_report(const MeshCommand& command, const StreamedOutput& streamed, spdlog::logger& log) {
  if (command.is_json()) {
    const Status written = write_to("-", ".json", [&](const std::string& target) {
      return write_report_json(streamed, target);
    });
    return written ? exit_ok : fail(log, written.error());
  }
  if (command.verbosity.quiet) return exit_ok;
  // What is piped out of stdout must be the mesh alone.
  std::string text = mesh_text(streamed, command.is_verbose());
  for (const std::string& path : command.files.paths())
    if (path != "-") text += fmt::format("Wrote {}\n", path);
  text += group_text(streamed, command.files.names_with_formats(), command.files.write_options(),
                     command.is_verbose());
  if (command.files.has_stdout())
    print_on_stderr(text);
  else
    fmt::print("{}", text);
  return exit_ok;
}

/// What a run made, before any of it is written.
struct Made {
  StreamedOutput mesh;
  std::vector<PackingRecord> packings;  ///< for --dump-stages
  bool is_complete = true;              ///< no region misses its bound
};

/// Makes the mesh, and nothing else.
Result<Made> make(const MeshCommand& command, Input input, const Options& options,
                  const OtherProcesses& others, const std::stop_token& stop, spdlog::logger& log) {
  std::vector<PackingRecord> packings;
  ProgressLine line(command.show_progress());
  Callbacks callbacks;
  callbacks.progress = [&](const Progress& step) { line.update(step); };
  callbacks.stop = stop;
  callbacks.share_out = others.share_out;
  callbacks.write_elsewhere = others.write_elsewhere;
  if (!command.dump_folder.empty()) {
    callbacks.packing = [&](RegionId, const PackingRecord& packing) {
      packings.push_back(packing);
    };
  }
  Result<StreamedOutput> mesh =
      make_mesh(command.plan, command.files, std::move(input), options, callbacks, log);
  if (!mesh) return std::move(mesh).error();
  const bool is_complete = !missed_bound(mesh->output.report);
  return Made{*std::move(mesh), std::move(packings), is_complete};
}

/// Whether the mesh may be written; tells what is to be said of it and was not `told` before.
int judge(const MeshCommand& command, Made& made, const std::vector<std::string>& told,
          const std::stop_token& stop, spdlog::logger& log) {
  Output& output = made.mesh.output;
  add_read_options(command, output.report);
  log_notes(log, not_yet_told(output.report.notes, told));
  for (const RegionReport& region : output.report.regions) log_notes(log, region.notes);
  if (!made.is_complete && !command.keep_partial) {
    log.error("{}; nothing was written (--keep-partial writes it anyway)",
              describe_missed_bound(output));
    return exit_incomplete;
  }
  if (stop.stop_requested())
    return fail(log, {ErrorCode::cancelled, "interrupted; nothing was written", {}, {}});
  return exit_ok;
}

int write_all(const MeshCommand& command, Made& made, const std::stop_token& stop,
              spdlog::logger& log) {
  Output& output = made.mesh.output;
  for (const std::string& sentence : command.files.warnings_of(output)) log.warn("{}", sentence);
  const auto start = std::chrono::steady_clock::now();
  const Status written = command.files.write(made.mesh, stop, command.show_progress(), log);
  if (!written) return fail(log, written.error());
  output.report.times.push_back({"write", seconds_since(start)});
  if (!command.dump_folder.empty()) {
    const Status dumped = dump_stages(made.packings, command.dump_folder);
    if (!dumped) return fail(log, dumped.error());
  }
  return exit_ok;
}

int report_unmet(const Output& output, const Options& options, spdlog::logger& log) {
  const std::vector<std::string> unmet = unmet_requirements(output, options);
  for (const std::string& what : unmet) log.error("required, but not met: {}", what);
  return unmet.empty() ? exit_ok : exit_unmet;
}

/// Meshes, writes, reports.
int run(const MeshCommand& command, Input input, const Options& options,
        const OtherProcesses& others, Interrupt& interrupt, spdlog::logger& log) {
  const std::vector<std::string> told = input.warnings;
  Result<Made> made = make(command, std::move(input), options, others, interrupt.token(), log);
  if (!made) return fail(log, made.error());
  if (const int code = judge(command, *made, told, interrupt.token(), log); code != exit_ok)
    return code;
  if (const int code = write_all(command, *made, interrupt.token(), log); code != exit_ok)
    return code;
  interrupt.finish();
  if (const int code = print_report(command, made->mesh, log); code != exit_ok) return code;
  return made->is_complete ? report_unmet(made->mesh.output, options, log) : exit_incomplete;
}

/// Tells what was read, what of the command line has no effect on it, and what readers warn of: a
/// long run may be in vain.
void log_input(const MeshCommand& command, const Input& input, const Options& options,
               spdlog::logger& log) {
  log.info("read {}: {} points, {} segments, {} polygons, {} lines", command.input.path(),
           input.points.size(), input.segments.size(), input.polygons.size(), input.lines.size());
  for (const std::string& option : command.library.ignored()) log.warn("{}", option);
  for (const std::string& option : command.input.ignored()) log.warn("{}", option);
  const std::vector<PlaneField::Array> none;
  const auto& values = input.field ? input.field->arrays : none;
  std::vector<std::string> points;
  for (const PointName& point : input.point_names) points.push_back(point.name);
  for (const std::string& warning :
       command.files.warnings(input.attributes, values, periodic_rules(input, options), points))
    log.warn("{}", warning);
  for (const std::string& left : command.files.left_beside()) log.warn("{}", left);
  log_warnings(log, input.warnings);
}

/// Whether the files can hold what the input asks for, too.
Status check_files_hold(const MeshCommand& command, const Input& input, const Options& options) {
  if (input.periodic.empty() && options.periodic.empty()) return ok();
  return command.files.can_hold_periodic();
}

}  // namespace

int run_mesh(Arguments arguments, const OtherProcesses& others) {
  MeshCommand command;
  if (const auto code = parse(command.app, std::move(arguments))) return *code;
  if (command.print_config) {
    fmt::print("{}", configuration(command.app));
    return exit_ok;
  }
  if (const auto wrong = command.check_usage()) return usage_error(command.app, *wrong);
  Result<Options> options = command.library.make();
  if (!options) return usage_error(command.app, options.error().message);
  if (const auto wrong = command.check_usage_with(*options))
    return usage_error(command.app, *wrong);
  if (const Status planned = command.files.plan(); !planned)
    return usage_error(command.app, planned.error().message);
  if (const Status checked = check_files(command.read_files(), command.written_files()); !checked)
    return usage_error(command.app, checked.error());

  const auto log = make_logger(command.verbosity);
  Interrupt interrupt;
  command.input.heed(interrupt.token());
  Result<Input> input = command.input.read(options->threads, others.read_elsewhere);
  if (!input) return fail(*log, input.error());
  if (const Status hold = check_files_hold(command, *input, *options); !hold)
    return usage_error(command.app, hold.error().message);
  if (const Status status = load_size_field(*options, *input); !status)
    return fail(*log, status.error());
  log_input(command, *input, *options, *log);
  return command.dry_run ? dry_run(command, *input, *options, *log)
                         : run(command, *std::move(input), *options, others, interrupt, *log);
}

}  // namespace cover::app
