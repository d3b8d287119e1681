// cover check: the promises on any mesh, from the files alone.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <spdlog/logger.h>
#include <CLI/CLI.hpp>

#include <cover/attribute.hpp>
#include <cover/check_in_parts.hpp>
#include <cover/cover_mesh.hpp>
#include <cover/files.hpp>
#include <cover/option_table.hpp>
#include <cover/options.hpp>
#include <cover/periodic.hpp>
#include <cover/pslg.hpp>
#include <cover/read_mesh.hpp>
#include <cover/read_origin.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>
#include <cover/text.hpp>
#include <cover/verify.hpp>
#include <cover/verify_curved.hpp>

#include "commands/check/cut_input.hpp"
#include "commands/check/layer_rows.hpp"
#include "commands/check/named_groups.hpp"
#include "commands/check/named_lines.hpp"
#include "commands/check/own_run.hpp"
#include "commands/check/rounded_points.hpp"
#include "commands/check/told_names.hpp"
#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "files/file_check.hpp"
#include "files/input_file.hpp"
#include "files/mesh_file.hpp"
#include "terminal/console.hpp"
#include "terminal/interrupt.hpp"
#include "words/check_text.hpp"

namespace cover::app {
namespace {

constexpr const char* kFooter = R"(Promises:
  1  every input point is a vertex, bit for bit; every segment is one edge of the mesh
  2  the triangles are valid, conform, and cover each region exactly
  3  the largest angle of each region keeps the proven bound
  4  every triangle has the material of its region
With --periodic, or such pairs in the input, every vertex and edge of these lines has a partner.
Where the mesh names lines, those that the input names have their edges and no others.

Examples:
  cover check device.poly device.vtu
  cover check oxide.json gate.json both.vtu
  cover check device.poly from_another_tool.vtu --allow-split --no-bound
  cover check cell.json cell.msh --periodic left=right
  cover check device.json device.msh --layers gate@channel=0.2,1.3
)";

/// Everything that the command line of `cover check` says.
struct CheckCommand {
  CheckCommand()
      : app("Check that a mesh keeps every promise on its input; exit 0, or 6 where it does not",
            "cover check") {
    app.set_help_flag("-h,--help", "Show this help");
    app.footer(kFooter);
    input.add(app, true)->required();
    app.add_option("mesh", mesh_path,
                   fmt::format("Mesh of any tool: {}; {}", listed(mesh_formats()), kMeshStreamHelp))
        ->type_name("");  // the inputs take it, as CLI11 has it
    app.add_flag("--allow-split", verify.allow_split,
                 "Segments may have vertices inside; promise 3 is not checked then");
    app.add_flag("--no-bound", no_bound, "Do not check promise 3");
    app.add_flag("--hull", verify.hull, "The mesh covers the convex hull");
    app.add_flag("--box-method", box_method,
                 "List negative couplings of the box method, by exact signs; 6 if there is one");
    app.add_option("--layers", layers,
                   "Tell which rows of triangles lie along a line; with numbers, 6 if the first is "
                   "not as thick, or there are nowhere that many")
        ->type_name("LINE[@REGION][=first,growth[,count]]")
        ->allow_extra_args(false);
    app.add_option(
           "--stream", stream,
           "Look at some regions of a .vtu or .vtkhdf at a time, without holding the mesh: on, "
           "off, or auto: a large one; a broken one is read as a whole")
        ->check(one_of({"auto", "on", "off"}))
        ->type_name("WHEN")
        ->capture_default_str();
    library.add(app, OptionGroup::cleaning);
    add_target("max-angle",
               "Largest angle beside which regions are put; unless given that of the "
               "run that made the mesh, where the mesh or its manifest tells it, else 100");
    add_target("min-angle", "Smallest angle beside which regions are put; likewise, else 20");
    library.add_threads(app);
    add_verbosity(app, verbosity);
  }

  /// Adds an option that `cover mesh` has too, whose default is another here.
  void add_target(const char* name, const std::string& help) {
    library.add_one(app, name);
    app.get_option(fmt::format("--{}", name))->description(help)->default_str("");
  }

  /// Takes the mesh from behind the inputs; false: there is none.
  [[nodiscard]] bool take_mesh_path() {
    std::optional<std::string> last = input.take_last();
    if (!last) return false;
    mesh_path = *std::move(last);
    return true;
  }
  /// The library's options, with which `verify` is made to agree.
  ///
  /// Errors: bad_option
  [[nodiscard]] Result<Options> take_options() {
    Result<Options> options = library.make();
    if (!options) return options;
    options->hull = verify.hull;
    verify.threads = options->threads;
    usual_targets.largest = options->max_angle;
    usual_targets.smallest = options->min_angle;
    take_targets(usual_targets);
    verify.bound = !no_bound;
    return options;
  }

  void take_targets(const AngleTargets& those) {
    targets = those;
    verify.max_angle = those.largest;
    verify.min_angle = those.smallest;
  }

  [[nodiscard]] std::vector<NamedFile> read_files() const {
    std::vector<NamedFile> files = input.read_files();
    files.push_back({"", mesh_path});
    return files;
  }

  CLI::App app;
  GeometryFile input;
  std::string mesh_path;
  VerifyOptions verify;
  LibraryOptions library;
  bool no_bound = false, box_method = false;
  std::vector<std::string> layers;
  std::string stream = "auto";
  Verbosity verbosity;
  AngleTargets usual_targets;  ///< of the command line, else the defaults
  AngleTargets targets;        ///< those of `verify`
};

/// What a mesh is checked against.
struct Subject {
  Prepared prepared;
  std::vector<PeriodicRule> periodic;
  std::vector<LayerRule> layers;  ///< of the input
};

Result<Subject> read_subject(CheckCommand& command, const Options& options, spdlog::logger& log) {
  Result<Input> input = command.input.read(options.threads);
  if (!input) return std::move(input).error();
  for (const std::string& option : command.input.ignored()) log.warn("{}", option);
  std::vector<PeriodicRule> periodic = periodic_rules(*input, options);
  std::vector<LayerRule> layers = input->layers;
  Result<Prepared> prepared = prepare_to_check(*std::move(input), options);
  if (!prepared) return std::move(prepared).error();
  return Subject{*std::move(prepared), std::move(periodic), std::move(layers)};
}

/// The code of a whole check, of which `first` and then `second` was found out.
int first_failure(int first, int second) { return first == exit_ok ? second : first; }

int print_promises(const Verification& found) {
  fmt::print("{}", violations_text(found));
  return found.violations.empty() ? exit_ok : exit_unmet;
}

/// Whether triangles have the names of their regions.
int print_regions(const std::vector<WrongRegion>& wrong) {
  fmt::print("{}", wrong_regions_text(wrong));
  return wrong.empty() ? exit_ok : exit_unmet;
}

/// Whether regions and points are called as the input calls them.
int print_names(const ToldNames& names) {
  fmt::print("{}", wrong_points_text(names.points));
  return first_failure(names.points.empty() ? exit_ok : exit_unmet, print_regions(names.regions));
}

/// Whether lines that the input names have their edges in the mesh.
int print_lines(const NamedLines& lines) {
  fmt::print("{}", wrong_lines_text(lines));
  return lines.wrong.empty() ? exit_ok : exit_unmet;
}

/// `lines`, and that what the input says of its regions beside their names was not looked at.
NamedLines with_attributes(NamedLines lines, const RegionTable& table) {
  std::vector<std::string> names;
  for (const Attribute& attribute : table.attributes) names.push_back(printable(attribute.name));
  if (!names.empty()) lines.unchecked.push_back(fmt::format("attributes ({})", listed(names)));
  return lines;
}

/// What holds, and what was not looked at: the last words of a check that ends with `code`.
void print_summary(const CheckCommand& command, const Verification& found, std::size_t triangles,
                   const NamedLines& lines, int code) {
  if (found.violations.empty())
    fmt::print("{}", sound_text(found, triangles, code == exit_ok, command.targets));
  fmt::print("{}", unchecked_lines_text(lines));
}

/// Whether a mesh is looked at in parts.
bool is_to_stream(const std::string& when, const std::string& mesh_path) {
  constexpr std::uintmax_t kLarge = 64 << 20;  // some 800,000 triangles
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(mesh_path, failed);
  return when == "on" || (when == "auto" && !failed && size >= kLarge);
}

/// Whether something is asked that check_in_parts() does not tell.
bool wants_whole(const CheckCommand& command, const Subject& subject) {
  return command.verify.allow_split || command.verify.hull || command.box_method ||
         !subject.periodic.empty() || !command.layers.empty();
}

/// Forgets the run of a mesh of so many triangles, where it was that of another mesh.
void heed_count(CheckCommand& command, std::optional<MeshOrigin>& origin, std::size_t triangles) {
  if (!origin || origin->triangles == 0 || origin->triangles == triangles) return;
  origin.reset();
  command.take_targets(command.usual_targets);
}

/// Checks a large mesh in parts; nothing where it is to be read as a whole.
std::optional<int> check_parts(CheckCommand& command, const MeshSource& source,
                               std::optional<MeshOrigin>& origin, Subject& subject,
                               const Options& options, spdlog::logger& log) {
  if (wants_whole(command, subject) || !is_to_stream(command.stream, source.file()))
    return std::nullopt;
  subject.prepared.report = {};
  auto parts = check_in_parts(subject.prepared, source.file(), command.verify, options);
  if (parts && origin) {
    heed_count(command, origin, parts->triangles);
    if (!origin)  // counted beside targets of another mesh
      parts = check_in_parts(subject.prepared, source.file(), command.verify, options);
  }
  if (parts) {
    const int code = print_promises(parts->found);
    if (!command.verbosity.quiet)
      print_summary(
          command, parts->found, parts->triangles,
          with_attributes(lines_not_checked(subject.prepared.pslg, subject.prepared.table),
                          subject.prepared.table),
          code);
    return code;
  }
  log.info("{} is read as a whole, to say more", source.name());
  return std::nullopt;
}

Error only_a_part(const std::string& path, std::size_t parts) {
  return {
      ErrorCode::unsupported_format,
      fmt::format("{} is one of {} files of a mesh: only a whole mesh can be checked", path, parts),
      {},
      {}};
}

Result<MeshTriangles> read_whole(const MeshSource& source, spdlog::logger& log) {
  Result<MeshTriangles> mesh = read_triangles(source, log);
  if (mesh && mesh->parts > 0) return only_a_part(source.name(), mesh->parts);
  return mesh;
}

bool has_wrong_material(const Verification& found) {
  return std::any_of(found.violations.begin(), found.violations.end(),
                     [](const Violation& violation) { return violation.promise == 4; });
}

/// The numbers of a mesh in Medit's format are those of materials or, with --ids, of groups: it
/// does not say which. They are taken as the latter where they are sound as such alone.
void heed_groups(const std::string& path, const Prepared& prepared, const TriangleSoup& mesh,
                 VerifyOptions& verify, Verification& found) {
  if (extension_of(path) != ".mesh" || !has_wrong_material(found)) return;
  verify.material_numbers = false;
  Verification as_groups = verify_cover(prepared.pslg, prepared.table, mesh, verify);
  verify.material_numbers = has_wrong_material(as_groups);
  if (!verify.material_numbers) found = std::move(as_groups);
}

/// The options that can make other points of the input, but those that were given.
std::vector<std::string> options_that_move(const CheckCommand& command) {
  std::vector<std::string> options;
  for (const char* const name : {"weld", "overlap"})
    if (!has_option(command.app, name)) options.push_back(fmt::format("--{}", name));
  for (std::string& option : command.input.other_readings(AboutReading::places))
    options.push_back(std::move(option));
  return options;
}

/// The options of the run that made the mesh which the check has not.
std::vector<std::string> missing_of_run(const CheckCommand& command,
                                        const std::optional<MeshOrigin>& origin) {
  return origin ? options_to_repeat(command.app, *origin) : std::vector<std::string>();
}

/// Which options may be missing, where promises are broken by what they would allow.
/// Returns: whether those of the run were told
bool print_hints(const CheckCommand& command, const std::optional<MeshOrigin>& origin,
                 const Verification& found) {
  if (found.points_missing > 0) {  // what makes everything else fail
    fmt::print("{}", missing_text(found.points_missing, missing_of_run(command, origin),
                                  options_that_move(command)));
    return true;
  }
  if (!command.verify.hull) fmt::print("{}", in_void_text(found.in_void));
  fmt::print("{}", other_ids_text(found.other_ids));
  return false;
}

/// Whether the middle nodes of a mesh of second order are sound; nothing is said of others.
int print_curved(const Pslg& pslg, const MeshTriangles& mesh, bool quiet) {
  if (mesh.middles.size() != mesh.soup.triangles.size()) return exit_ok;
  const CurvedVerification found = verify_curved(pslg, mesh.soup, mesh.middles);
  fmt::print("{}", curved_violations_text(found));
  if (!found.violations.empty()) return exit_unmet;
  if (!quiet) fmt::print("{}", curved_sound_text(found));
  return exit_ok;
}

/// Whether the sides that `rules` name have partners for all their vertices and edges in the mesh.
int print_periodic(const CutInput& cut, const std::vector<PeriodicRule>& rules, bool quiet) {
  int code = exit_ok;
  for (const PeriodicRule& rule : rules) {
    const Result<std::size_t> pairs = verify_periodic_sides(cut.pslg, cut.table, rule);
    if (!pairs) code = exit_unmet;
    if (!pairs || !quiet) fmt::print("{}", periodic_text(rule, pairs));
  }
  return code;
}

/// The negative couplings of a mesh that has cut segments or not.
int print_couplings(const CutInput& cut, const TriangleSoup& mesh, VerifyOptions verify,
                    bool quiet) {
  verify.allow_split = verify.box_method = true;
  const Verification found = verify_cover(cut.pslg, cut.table, mesh, verify);
  const bool is_met = found.negative_couplings.empty();
  if (!is_met || !quiet) fmt::print("{}", couplings_text(found));
  return is_met ? exit_ok : exit_unmet;
}

/// Checks the promises, and what else is asked for.
int check_whole(const CheckCommand& command, const std::string& mesh_path,
                const std::optional<MeshOrigin>& origin, Subject& subject, MeshTriangles& mesh) {
  const bool quiet = command.verbosity.quiet;
  Prepared& prepared = subject.prepared;
  const RoundedPoints rounded = restore_digits(mesh_path, prepared.pslg, mesh.soup);
  fmt::print("{}", rounded_text(rounded));
  VerifyOptions verify = command.verify;
  const std::vector<std::int64_t> groups =
      mesh.has_materials ? std::vector<std::int64_t>() : mesh.soup.material;
  const bool has_names =
      !mesh.has_materials && take_materials_by_name(prepared.table, mesh.group_names, mesh.soup);
  verify.material_numbers = mesh.has_materials || has_names;
  Verification found = verify_cover(prepared.pslg, prepared.table, mesh.soup, verify);
  heed_groups(mesh_path, prepared, mesh.soup, verify, found);
  const auto cuts = take_own_cuts(mesh_path, mesh, verify, prepared, found);
  if (cuts && (!quiet || !cuts->are_meant))
    fmt::print("{}", cuts_text(*cuts, !subject.periodic.empty()));
  const bool is_run_told = print_hints(command, origin, found);
  int code = print_promises(found);
  if (rounded.count > 0) code = exit_unmet;
  if (has_names)
    code = first_failure(
        code, print_regions(check_named_regions(prepared.table, found.triangle_regions, groups,
                                                mesh.group_names, mesh.soup)));

  // A piece of a segment is a side of its own to all that follows but for curves.
  const bool needs_pieces = !subject.periodic.empty() || !command.layers.empty() ||
                            command.box_method || has_named_lines(prepared.pslg, prepared.table);
  const CutInput cut = needs_pieces ? cut_as(prepared, mesh.soup) : CutInput{};
  NamedLines lines = with_attributes(check_named_lines(cut, mesh), prepared.table);
  ToldNames names;
  if (mesh.has_materials && found.violations.empty())
    names = check_told_names(prepared, found.triangle_regions,
                             origin ? origin->regions : std::vector<RegionNames>(), mesh);
  std::move(names.unchecked.begin(), names.unchecked.end(), std::back_inserter(lines.unchecked));
  code = first_failure(code, print_names(names));
  code = first_failure(code, print_lines(lines));
  if (!is_run_told && (!lines.wrong.empty() || has_wrong_material(found)))
    fmt::print("{}", repeat_text(missing_of_run(command, origin)));
  if (!origin && has_wrong_material(found))
    fmt::print("{}", materials_text(command.input.other_readings(AboutReading::names)));
  code = first_failure(code, print_periodic(cut, subject.periodic, quiet));
  if (code == exit_ok) code = print_curved(prepared.pslg, mesh, quiet);
  const Result<int> rows = print_layers(cut, command.layers, subject.layers, mesh.soup, quiet);
  if (!rows) return usage_error(command.app, rows.error().message);
  code = first_failure(code, *rows);
  if (command.box_method)
    code = first_failure(code, print_couplings(cut, mesh.soup, verify, quiet));
  if (!quiet) print_summary(command, found, mesh.soup.triangles.size(), lines, code);
  return code;
}

/// The run that made the mesh. What of it a .vtkhdf alone tells is left, where that is looked at in
/// parts: it would be read as a whole.
std::optional<MeshOrigin> origin_of(const CheckCommand& command, const std::string& path) {
  if (extension_of(path) == ".vtkhdf" && is_to_stream(command.stream, path)) return std::nullopt;
  return read_origin(path);
}

}  // namespace

int run_check(Arguments arguments) {
  CheckCommand command;
  if (const auto code = parse(command.app, std::move(arguments))) return *code;
  if (!command.take_mesh_path()) return usage_error(command.app, "mesh is required");
  const Result<Options> options = command.take_options();
  if (!options) return usage_error(command.app, options.error().message);
  const Status files = check_files(command.read_files(), {log_file(command.verbosity)});
  if (!files) return usage_error(command.app, files.error());

  const auto log = make_logger(command.verbosity);
  const Interrupt interrupt;
  command.input.heed(interrupt.token());
  Result<Subject> subject = read_subject(command, *options, *log);
  if (!subject) return fail(*log, subject.error());
  const Result<MeshSource> source = MeshSource::open(command.mesh_path);
  if (!source) return fail(*log, source.error());
  std::optional<MeshOrigin> origin = origin_of(command, source->file());
  if (origin) command.take_targets(targets_with_run(command.app, *origin, command.usual_targets));
  if (const auto code = check_parts(command, *source, origin, *subject, *options, *log))
    return *code;
  Result<MeshTriangles> mesh = read_whole(*source, *log);
  if (!mesh) return fail(*log, mesh.error());
  heed_count(command, origin, mesh->soup.triangles.size());
  return check_whole(command, source->file(), origin, *subject, *mesh);
}

}  // namespace cover::app
