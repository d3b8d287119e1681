// cover check: the promises on any mesh, from the files alone.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/check_in_parts.hpp>
#include <cover/cover_mesh.hpp>
#include <cover/option_table.hpp>
#include <cover/periodic.hpp>
#include <cover/read_mesh.hpp>
#include <cover/remesh.hpp>
#include <cover/text.hpp>
#include <cover/verify.hpp>
#include <cover/verify_curved.hpp>
#include <cover/verify_layers.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "files/input_file.hpp"
#include "files/mesh_file.hpp"
#include "terminal/console.hpp"
#include "words/limits_text.hpp"

namespace cover::app {
namespace {

std::string place(const Violation& violation) {
  std::string text;
  // The message names the place of the first ones itself; the list is for scripts and large views.
  for (const Point& p : violation.where)
    text += fmt::format("\n    at ({:.17g}, {:.17g})", p.x, p.y);
  return text;
}

int print(const Verification& found, std::size_t triangles, bool quiet) {
  for (const Violation& violation : found.violations) {
    const char* const what = violation.promise == 4 ? " (materials)" : "";
    fmt::print("FAILED promise {}{}: {}{}\n", violation.promise, what, printable(violation.message),
               place(violation));
  }
  if (found.violation_count > found.violations.size()) {
    fmt::print("... and {} more\n", grouped(found.violation_count - found.violations.size()));
  }
  if (!found.violations.empty()) return exit_unmet;
  if (!quiet) {
    fmt::print("{}: {} triangles, {} region{}, {} segments whole",
               found.unchecked.empty() ? "Every promise holds" : "All that was checked holds",
               grouped(triangles), grouped(found.regions), found.regions == 1 ? "" : "s",
               grouped(found.segments_whole));
    if (found.within_rounding > 0) {
      fmt::print("; {} of the regions meet the bound up to the rounding of coordinates",
                 grouped(found.within_rounding));
    }
    fmt::print("\n");
    LimitCounts limits;
    for (const RegionLimits& region : found.limits) limits.add(region);
    if (const std::string text = limits_text(limits); !text.empty())
      fmt::print("Regions beside their targets and proven limits: {}\n", text);
    for (const std::string& what : found.unchecked)
      fmt::print("Not checked: {}\n", printable(what));
  }
  return exit_ok;
}

bool is_of_material(const Violation& violation) { return violation.promise == 4; }

/// Whether all is well where segments are cut: numbers of materials have no part in that.
bool is_sound_but_for_materials(const Verification& found) {
  return std::all_of(found.violations.begin(), found.violations.end(), is_of_material);
}

bool has_wrong_material(const Verification& found) {
  return std::any_of(found.violations.begin(), found.violations.end(), is_of_material);
}

/// Whether the mesh is sound but for vertices inside segments, angles, and materials.
bool is_split_only(const Verification& found, const Prepared& prepared, const TriangleSoup& mesh,
                   VerifyOptions verify) {
  const auto is_split = [](const Violation& violation) { return violation.promise == 1; };
  if (verify.allow_split ||
      std::none_of(found.violations.begin(), found.violations.end(), is_split))
    return false;
  verify.allow_split = true;
  return is_sound_but_for_materials(verify_cover(prepared.pslg, prepared.table, mesh, verify));
}

/// An input that was cut as a mesh is.
struct CutInput {
  Pslg pslg;
  RegionTable table;
  std::size_t points = 0;
  Verification found;
};

/// Where a mesh is sound but for materials and for vertices on arcs, which are beside their chords:
/// the input with these vertices, on which all promises hold.
std::optional<CutInput> cut_on_arcs(const Verification& found, const Prepared& prepared,
                                    const TriangleSoup& mesh, const VerifyOptions& verify) {
  if (found.violations.empty() || prepared.pslg.circles.empty()) return std::nullopt;
  CutInput cut{prepared.pslg, prepared.table, 0, {}};
  cut.points = adopt_cuts(cut.pslg, cut.table, mesh);
  if (cut.points == 0) return std::nullopt;
  cut.found = verify_cover(cut.pslg, cut.table, mesh, verify);
  if (!is_sound_but_for_materials(cut.found)) return std::nullopt;
  return cut;
}

/// The negative couplings of a mesh that has cut segments or not.
Verification couplings_of(const Prepared& prepared, const TriangleSoup& mesh,
                          VerifyOptions verify) {
  Pslg pslg = prepared.pslg;
  RegionTable table = prepared.table;
  adopt_cuts(pslg, table, mesh);  // a piece of a segment is a side of its own
  verify.allow_split = verify.box_method = true;
  return verify_cover(pslg, table, mesh, verify);
}

std::string obtuse_triangles(const Verification& found) {
  std::string text = fmt::format("{} obtuse triangles", grouped(found.obtuse));
  if (found.obtuse_by_rounding > 0)
    text += fmt::format(", {} more by no more than rounding of coordinates",
                        grouped(found.obtuse_by_rounding));
  return text;
}

int print_couplings(const Verification& found, bool quiet) {
  constexpr std::size_t kListed = 20;
  using Kind = NegativeCoupling::Kind;
  const auto& all = found.negative_couplings;
  const auto count = [&](Kind kind) {
    return grouped(static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](const NegativeCoupling& c) { return c.kind == kind; })));
  };
  if (all.empty()) {
    if (!quiet) fmt::print("Box method: no negative coupling; {}\n", obtuse_triangles(found));
    return exit_ok;
  }
  fmt::print(
      "FAILED box method: {} negative couplings: {} on inner edges, {} on sides that a "
      "vertex of the boundary encroaches, {}{} on other sides\n",
      grouped(all.size()), count(Kind::inside), count(Kind::encroached),
      count(Kind::forced) == "0"
          ? ""
          : fmt::format("{} that the bound on angles forces, ", count(Kind::forced)),
      count(Kind::given_up));
  fmt::print("    {}\n", obtuse_triangles(found));
  for (std::size_t k = 0; k < std::min(kListed, all.size()); ++k) {
    const NegativeCoupling& c = all[k];
    fmt::print("    region {}: {} from {} to {}, {} {}\n", c.region.value(),
               c.kind == Kind::inside ? "inner edge" : "side", describe(c.a), describe(c.b),
               c.kind == Kind::encroached ? "encroached by" : "seen from", describe(c.apex));
  }
  if (all.size() > kListed) fmt::print("    ... and {} more\n", grouped(all.size() - kListed));
  return exit_unmet;
}

/// Whether the middle nodes of a mesh of second order are sound; nothing is said of others.
int print_curved(const Pslg& pslg, const MeshTriangles& mesh, bool quiet) {
  if (mesh.middles.size() != mesh.soup.triangles.size()) return exit_ok;
  const CurvedVerification found = verify_curved(pslg, mesh.soup, mesh.middles);
  for (const Violation& violation : found.violations)
    fmt::print("FAILED second order: {}{}\n", violation.message, place(violation));
  if (found.violation_count > found.violations.size())
    fmt::print("... and {} more\n", grouped(found.violation_count - found.violations.size()));
  if (!found.violations.empty()) return exit_unmet;
  if (!quiet)
    fmt::print("Second order: every Jacobian is positive everywhere; {} edges lie on arcs{}\n",
               grouped(found.on_arcs),
               found.straight == 0
                   ? ""
                   : fmt::format(", {} of arcs are straight", grouped(found.straight)));
  return exit_ok;
}

/// Whether the sides that `rules` name have partners for all their vertices and edges in the mesh.
int print_periodic(const Prepared& prepared, const std::vector<PeriodicRule>& rules,
                   const TriangleSoup& mesh, bool quiet) {
  if (rules.empty()) return exit_ok;
  Pslg pslg = prepared.pslg;
  RegionTable table = prepared.table;
  adopt_cuts(pslg, table, mesh);
  int code = exit_ok;
  for (const PeriodicRule& rule : rules) {
    const Result<std::size_t> pairs = verify_periodic_sides(pslg, table, rule);
    if (!pairs) {
      fmt::print("FAILED {}\n", pairs.error().message);
      for (const Point& p : pairs.error().where)
        fmt::print("    at ({:.17g}, {:.17g})\n", p.x, p.y);
      code = exit_unmet;
    } else if (!quiet) {
      fmt::print("Periodic: {} pairs of vertices on {}, none without a partner\n", grouped(*pairs),
                 describe(rule));
    }
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

/// Tells which rows lie along lines; fails where numbers are asked for that they do not have.
/// `known` are the rules of the input.
Result<int> print_layers(const Prepared& prepared, const std::vector<std::string>& lines,
                         const std::vector<LayerRule>& known, const TriangleSoup& mesh,
                         bool quiet) {
  constexpr double kSame = 1e-3;  // of a layer's thickness: so much alike are cells of one row
  Pslg pslg = prepared.pslg;
  RegionTable table = prepared.table;
  if (!lines.empty()) adopt_cuts(pslg, table, mesh);
  std::vector<LayersAsked> wishes;
  std::vector<LayerRule> rules = known;  // of those for one side of a line the last counts
  for (const std::string& line : lines) {
    Result<LayersAsked> asked = layers_asked(line);
    if (!asked) return std::move(asked).error();
    asked->number = rules.size();
    if (asked->has_numbers) rules.push_back(asked->rule);
    wishes.push_back(*std::move(asked));
  }
  int code = exit_ok;
  for (const LayersAsked& asked : wishes) {
    const LayerRule& rule = asked.rule;
    Result<std::vector<LayersFound>> found =
        verify_layers(pslg, table, mesh, rule.line, rule.region, rules);
    if (!found) return std::move(found).error();
    for (const LayersFound& layers : *found) {
      const LayerRule* counts = layer_rule_for(table.region(layers.region), rule.line, rules);
      if (asked.has_numbers && counts != &rules[asked.number]) continue;
      const bool is_first = std::abs(layers.first_least - rule.first) <= kSame * rule.first &&
                            std::abs(layers.first_most - rule.first) <= kSame * rule.first;
      const bool is_met =
          !asked.has_numbers || (layers.layered > 0 && is_first && layers.most >= rule.count);
      if (!is_met) code = exit_unmet;
      if (is_met && quiet) continue;
      fmt::print("{}Layers along '{}' in '{}': ", is_met ? "" : "FAILED ", rule.line,
                 table.region(layers.region).name);
      if (layers.layered == 0) {
        fmt::print("none over {}\n", counted(layers.edges, "edge"));
        continue;
      }
      fmt::print(
          "{} to {} over {} of {}; the first {:.10g} to {:.10g} thick, all {:.10g}; {} triangles, "
          "largest angle {:.6f}, {} above 90 degrees; {}\n",
          layers.fewest, layers.most, grouped(layers.layered), counted(layers.edges, "edge"),
          layers.first_least, layers.first_most, layers.thickness, grouped(layers.triangles),
          layers.largest.in_degrees(), grouped(layers.above_90),
          counted(layers.negative, "negative coupling"));
    }
  }
  return code;
}

/// What made the run that wrote the mesh cut segments, as its manifest or the mesh itself tells;
/// else empty.
std::string cutting_option(const std::string& path, const MeshTriangles& mesh) {
  std::string by_itself = mesh.cut_vertices > 0 ? "its field data say so" : "";
  const Result<Output> known = read_output(path);
  if (!known) return by_itself;
  if (by_itself.empty() && known->report.input_points < known->pslg.points.size())
    by_itself = "its file says so";
  for (const auto& [name, value] : known->report.provenance.settings) {
    if (name == "split-interfaces" || name == "box-method" ||
        (name == "method" && value == "nonobtuse"))
      return fmt::format("--{} {}", name, value);
  }
  return by_itself;
}

/// Whether a mesh is looked at in parts.
bool is_to_stream(const std::string& when, const std::string& mesh_path) {
  constexpr std::uintmax_t kLarge = 64 << 20;  // some 800,000 triangles
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(mesh_path, failed);
  return when == "on" || (when == "auto" && !failed && size >= kLarge);
}

constexpr const char* kFooter = R"(Promises:
  1  every input point is a vertex, bit for bit; every segment is one edge of the mesh
  2  the triangles are valid, conform, and cover each region exactly
  3  the largest angle of each region keeps the proven bound
  4  every triangle has the material of its region
With --periodic, or such pairs in the input, every vertex and edge of these lines has a partner.

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
    app.add_option("mesh", mesh_path, fmt::format("Mesh of any tool: {}", listed(mesh_formats())))
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

/// Of what is found on a mesh that is sound but for `points` in its segments: each cut one once,
/// and what is found on the input that is cut likewise, materials. All else follows from the cuts.
void keep_cut_segments(Verification& found, const Verification& on_pieces, std::size_t points) {
  std::vector<Violation> cut;
  for (Violation& violation : found.violations) {
    const bool is_cut = violation.promise == 1;
    const bool is_known = std::any_of(cut.begin(), cut.end(), [&](const Violation& other) {
      return std::is_permutation(other.where.begin(), other.where.end(), violation.where.begin(),
                                 violation.where.end());
    });
    if (is_cut && !is_known) cut.push_back(std::move(violation));
  }
  found.violations = std::move(cut);
  found.violations.insert(found.violations.end(), on_pieces.violations.begin(),
                          on_pieces.violations.end());
  found.violation_count =
      on_pieces.segments_whole - points - found.segments_whole + on_pieces.violation_count;
}

const char* all_else(const Verification& on_pieces) {
  return on_pieces.violations.empty() ? "all else" : "all else but materials";
}

/// Where the mesh is sound but for materials and cuts of segments, and the run that made it was to
/// cut them: the input with these cuts, and what is found on it. Says what was cut, or how cuts are
/// allowed.
void take_own_cuts(const CheckCommand& command, const MeshTriangles& mesh, Prepared& prepared,
                   Verification& found) {
  const VerifyOptions& verify = command.verify;
  const auto own = [&] { return cutting_option(command.mesh_path, mesh); };
  if (auto cut = cut_on_arcs(found, prepared, mesh.soup, verify)) {
    const std::string option = own();
    if (!verify.allow_split && option.empty()) {
      fmt::print(
          "Segments are cut at {} points, those of arcs on their circles; {} is sound. "
          "If they were to be cut, as by --split-interfaces, add --allow-split\n",
          grouped(cut->points), all_else(cut->found));
      keep_cut_segments(found, cut->found, cut->points);
      return;
    }
    if (!command.verbosity.quiet)
      fmt::print("Segments are cut at {} points, those of arcs on their circles{}{}\n",
                 grouped(cut->points), option.empty() ? "" : ": ", option);
    found = std::move(cut->found);
    prepared.pslg = std::move(cut->pslg);
    prepared.table = std::move(cut->table);
  } else if (is_split_only(found, prepared, mesh.soup, verify)) {
    const std::string option = own();
    const std::size_t cuts = adopt_cuts(prepared.pslg, prepared.table, mesh.soup);
    Verification on_pieces = verify_cover(prepared.pslg, prepared.table, mesh.soup, verify);
    if (option.empty()) {
      fmt::print(
          "Segments have vertices inside; {} is sound. If they were to be cut, as by "
          "--split-interfaces, --box-method or --method nonobtuse, add --allow-split\n",
          all_else(on_pieces));
      keep_cut_segments(found, on_pieces, cuts);
      return;
    }
    if (!command.verbosity.quiet)
      fmt::print("Segments are cut at {} by the run itself: {}\n", counted(cuts, "point"), option);
    found = std::move(on_pieces);
  }
}

/// The numbers of a mesh in Medit's format are those of materials or, with --ids, of groups: it
/// does not say which. They are taken as the latter where they are sound as such alone.
void heed_groups(const CheckCommand& command, const Prepared& prepared, const TriangleSoup& mesh,
                 VerifyOptions& verify, Verification& found) {
  if (std::filesystem::path(command.mesh_path).extension() != ".mesh" || !has_wrong_material(found))
    return;
  verify.material_numbers = false;
  Verification as_groups = verify_cover(prepared.pslg, prepared.table, mesh, verify);
  verify.material_numbers = has_wrong_material(as_groups);
  if (!verify.material_numbers) found = std::move(as_groups);
}

Error only_a_part(const std::string& path, std::size_t parts) {
  return {
      ErrorCode::unsupported_format,
      fmt::format("{} is one of {} files of a mesh: only a whole mesh can be checked", path, parts),
      {},
      {}};
}

/// Where points of the input are missing in the mesh, what else would make everything fail. False
/// where none is missing.
bool say_what_may_have_moved(const Verification& found, const Prepared& prepared,
                             const TriangleSoup& mesh) {
  if (found.violations.empty()) return false;
  std::vector<Point> there = mesh.points;
  std::sort(there.begin(), there.end());
  const auto is_missing = [&](Point p) {
    return !std::binary_search(there.begin(), there.end(), p);
  };
  const auto& points = prepared.pslg.points;
  const auto missing = std::count_if(points.begin(), points.end(), is_missing);
  if (missing == 0) return false;
  fmt::print(
      "{} of the input missing in the mesh. If the run that made it moved them, repeat its --weld, "
      "--overlap, --scale or --crs here\n",
      counted(static_cast<std::size_t>(missing), "point"));
  return true;
}

}  // namespace

int run_check(Arguments arguments) {
  CheckCommand command;
  if (const auto code = parse(command.app, std::move(arguments))) return *code;
  std::optional<std::string> last = command.input.take_last();
  if (!last) return usage_error(command.app, "mesh is required");
  command.mesh_path = *std::move(last);
  VerifyOptions& verify = command.verify;
  verify.bound = !command.no_bound;
  const bool quiet = command.verbosity.quiet;
  Result<Options> options = command.library.make();
  if (!options) return usage_error(command.app, options.error().message);
  options->hull = verify.hull;
  verify.threads = options->threads;
  const Status files = check_files(command.read_files(), {log_file(command.verbosity)});
  if (!files) return usage_error(command.app, files.error());

  const auto log = make_logger(command.verbosity);
  Result<Input> input = command.input.read(options->threads);
  if (!input) return fail(*log, input.error());
  for (const std::string& option : command.input.ignored()) log->warn("{}", option);
  const std::vector<PeriodicRule> rules = periodic_rules(*input, *options);
  const std::vector<LayerRule> known_layers = input->layers;
  Result<Prepared> prepared = prepare_to_check(*std::move(input), *options);
  if (!prepared) return fail(*log, prepared.error());
  const bool wants_whole = verify.allow_split || verify.hull || command.box_method ||
                           !rules.empty() || !command.layers.empty();
  if (!wants_whole && is_to_stream(command.stream, command.mesh_path)) {
    prepared->report = {};
    if (const auto parts = check_in_parts(*prepared, command.mesh_path, verify, *options))
      return print(parts->found, parts->triangles, quiet);
    log->info("{} is read as a whole, to say more", command.mesh_path);
  }
  const Result<MeshTriangles> mesh = read_triangles(command.mesh_path, *log);
  if (!mesh) return fail(*log, mesh.error());
  if (mesh->parts > 0) return fail(*log, only_a_part(command.mesh_path, mesh->parts));
  verify.material_numbers = mesh->has_materials;
  Verification found = verify_cover(prepared->pslg, prepared->table, mesh->soup, verify);
  heed_groups(command, *prepared, mesh->soup, verify, found);
  take_own_cuts(command, *mesh, *prepared, found);
  const bool is_moved = say_what_may_have_moved(found, *prepared, mesh->soup);
  if (found.in_void > 0 && !verify.hull && !is_moved)
    fmt::print(
        "{} along segments in the void. If the mesh is to cover the convex hull, add --hull\n",
        found.in_void == 1 ? "1 triangle lies"
                           : fmt::format("{} triangles lie", grouped(found.in_void)));
  int code = print(found, mesh->soup.triangles.size(), quiet);
  const int sides = print_periodic(*prepared, rules, mesh->soup, quiet);
  code = code == exit_ok ? sides : code;
  if (code == exit_ok) code = print_curved(prepared->pslg, *mesh, quiet);
  const Result<int> rows = print_layers(*prepared, command.layers, known_layers, mesh->soup, quiet);
  if (!rows) return usage_error(command.app, rows.error().message);
  code = code == exit_ok ? *rows : code;
  if (!command.box_method) return code;
  const int boxes = print_couplings(couplings_of(*prepared, mesh->soup, verify), quiet);
  return code == exit_ok ? boxes : code;
}

}  // namespace cover::app
