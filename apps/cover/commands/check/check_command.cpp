// cover check: the promises on any mesh, from the files alone.
#include <algorithm>
#include <cmath>
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

#include <cover/check_in_parts.hpp>
#include <cover/cover_mesh.hpp>
#include <cover/files.hpp>
#include <cover/option_table.hpp>
#include <cover/options.hpp>
#include <cover/periodic.hpp>
#include <cover/pslg.hpp>
#include <cover/read_mesh.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>
#include <cover/text.hpp>
#include <cover/verify.hpp>
#include <cover/verify_curved.hpp>
#include <cover/verify_layers.hpp>

#include "commands/check/cut_input.hpp"
#include "commands/check/named_groups.hpp"
#include "commands/check/named_lines.hpp"
#include "commands/check/rounded_points.hpp"
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
    library.add_threads(app);
    add_verbosity(app, verbosity);
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
    verify.bound = !no_bound;
    return options;
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

/// Whether lines that the input names have their edges in the mesh.
int print_lines(const NamedLines& lines) {
  fmt::print("{}", wrong_lines_text(lines));
  return lines.wrong.empty() ? exit_ok : exit_unmet;
}

/// What holds, and what was not looked at: the last words of a check that ends with `code`.
void print_summary(const Verification& found, std::size_t triangles, const NamedLines& lines,
                   int code) {
  if (found.violations.empty()) fmt::print("{}", sound_text(found, triangles, code == exit_ok));
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

/// Checks a large mesh in parts; nothing where it is to be read as a whole.
std::optional<int> check_parts(const CheckCommand& command, const MeshSource& source,
                               Subject& subject, const Options& options, spdlog::logger& log) {
  if (wants_whole(command, subject) || !is_to_stream(command.stream, source.file()))
    return std::nullopt;
  subject.prepared.report = {};
  if (const auto parts = check_in_parts(subject.prepared, source.file(), command.verify, options)) {
    const int code = print_promises(parts->found);
    if (!command.verbosity.quiet)
      print_summary(parts->found, parts->triangles,
                    lines_not_checked(subject.prepared.pslg, subject.prepared.table), code);
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

/// How many points of the input are no vertices of the mesh.
std::size_t missing_points(const Pslg& pslg, const TriangleSoup& mesh) {
  std::vector<Point> there = mesh.points;
  std::sort(there.begin(), there.end());
  return static_cast<std::size_t>(
      std::count_if(pslg.points.begin(), pslg.points.end(),
                    [&](Point p) { return !std::binary_search(there.begin(), there.end(), p); }));
}

/// Which options may be missing, where promises are broken by what they would allow.
void print_hints(const Verification& found, const Pslg& pslg, const TriangleSoup& mesh, bool hull) {
  // Missing points make everything else fail.
  const std::size_t missing = found.violations.empty() ? 0 : missing_points(pslg, mesh);
  fmt::print("{}", missing_text(missing));
  if (missing > 0) return;
  if (!hull) fmt::print("{}", in_void_text(found.in_void));
  fmt::print("{}", other_ids_text(found.other_ids));
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

/// What `text` asks of layers: a line, and what they should be like where it has numbers.
struct LayersAsked {
  LayerRule rule;
  bool has_numbers = false;
  std::size_t number = 0;  ///< among all rules, if it has numbers
};

/// LINE[@REGION][=first,growth[,count]], as the option of mesh takes it.
Result<LayersAsked> layers_asked(const std::string& text) {
  const OptionEntry& entry = *find_option("layers");
  Options options;
  Status status = entry.set(entry, text, options);
  if (status) return LayersAsked{options.layers.front(), true};
  // Without numbers a line is all that there is; any will do to read it.
  if (entry.set(entry, text + "=1,1,1", options)) return LayersAsked{options.layers.front(), false};
  return std::move(status).error();
}

/// All that --layers asks, and the rules that count.
struct LayerWishes {
  std::vector<LayersAsked> asked;
  std::vector<LayerRule> rules;  ///< of those for one side of a line the last counts
};

/// What `lines` ask, after `known`, the rules of the input.
Result<LayerWishes> layer_wishes(const std::vector<std::string>& lines,
                                 const std::vector<LayerRule>& known) {
  LayerWishes wishes{{}, known};
  for (const std::string& line : lines) {
    Result<LayersAsked> asked = layers_asked(line);
    if (!asked) return std::move(asked).error();
    asked->number = wishes.rules.size();
    if (asked->has_numbers) wishes.rules.push_back(asked->rule);
    wishes.asked.push_back(*std::move(asked));
  }
  return wishes;
}

/// Whether the rows are those of the rule.
bool are_as_asked(const LayersFound& layers, const LayerRule& rule) {
  constexpr double kSame = 1e-3;  // of a layer's thickness: so much alike are cells of one row
  const auto is_first = [&](double thickness) {
    return std::abs(thickness - rule.first) <= kSame * rule.first;
  };
  return layers.layered > 0 && is_first(layers.first_least) && is_first(layers.first_most) &&
         layers.most >= rule.count;
}

/// Tells which rows lie along lines; fails where numbers are asked for that they do not have.
/// `known` are the rules of the input.
Result<int> print_layers(const CutInput& cut, const std::vector<std::string>& lines,
                         const std::vector<LayerRule>& known, const TriangleSoup& mesh,
                         bool quiet) {
  const Result<LayerWishes> wishes = layer_wishes(lines, known);
  if (!wishes) return wishes.error();
  const std::vector<LayerRule>& rules = wishes->rules;
  int code = exit_ok;
  for (const LayersAsked& asked : wishes->asked) {
    const LayerRule& rule = asked.rule;
    Result<std::vector<LayersFound>> found =
        verify_layers(cut.pslg, cut.table, mesh, rule.line, rule.region, rules);
    if (!found) return std::move(found).error();
    for (const LayersFound& layers : *found) {
      const Region& region = cut.table.region(layers.region);
      const LayerRule* counts = layer_rule_for(region, rule.line, rules);
      if (asked.has_numbers && counts != &rules[asked.number]) continue;
      const bool is_met = !asked.has_numbers || are_as_asked(layers, rule);
      if (!is_met) code = exit_unmet;
      if (!is_met || !quiet) fmt::print("{}", layers_text(layers, rule.line, region.name, is_met));
    }
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
int check_whole(const CheckCommand& command, const std::string& mesh_path, Subject& subject,
                MeshTriangles& mesh) {
  const bool quiet = command.verbosity.quiet;
  Prepared& prepared = subject.prepared;
  const RoundedPoints rounded = restore_digits(mesh_path, prepared.pslg, mesh.soup);
  fmt::print("{}", rounded_text(rounded));
  VerifyOptions verify = command.verify;
  verify.material_numbers =
      mesh.has_materials || take_materials_by_name(prepared.table, mesh.group_names, mesh.soup);
  Verification found = verify_cover(prepared.pslg, prepared.table, mesh.soup, verify);
  heed_groups(mesh_path, prepared, mesh.soup, verify, found);
  const auto cuts = take_own_cuts(mesh_path, mesh, verify, prepared, found);
  if (cuts && (!quiet || !cuts->are_meant)) fmt::print("{}", cuts_text(*cuts));
  print_hints(found, prepared.pslg, mesh.soup, verify.hull);
  int code = print_promises(found);
  if (rounded.count > 0) code = exit_unmet;

  // A piece of a segment is a side of its own to all that follows but for curves.
  const bool needs_pieces = !subject.periodic.empty() || !command.layers.empty() ||
                            command.box_method || has_named_lines(prepared.pslg, prepared.table);
  const CutInput cut = needs_pieces ? cut_as(prepared, mesh.soup) : CutInput{};
  const NamedLines lines = check_named_lines(cut, mesh);
  code = first_failure(code, print_lines(lines));
  code = first_failure(code, print_periodic(cut, subject.periodic, quiet));
  if (code == exit_ok) code = print_curved(prepared.pslg, mesh, quiet);
  const Result<int> rows = print_layers(cut, command.layers, subject.layers, mesh.soup, quiet);
  if (!rows) return usage_error(command.app, rows.error().message);
  code = first_failure(code, *rows);
  if (command.box_method)
    code = first_failure(code, print_couplings(cut, mesh.soup, verify, quiet));
  if (!quiet) print_summary(found, mesh.soup.triangles.size(), lines, code);
  return code;
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
  if (const auto code = check_parts(command, *source, *subject, *options, *log)) return *code;
  Result<MeshTriangles> mesh = read_whole(*source, *log);
  if (!mesh) return fail(*log, mesh.error());
  return check_whole(command, source->file(), *subject, *mesh);
}

}  // namespace cover::app
