// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include "pipeline/prepare_regions.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/option_table.hpp>
#include <cover/periodic.hpp>
#include <cover/text.hpp>
#include <cover/version.hpp>

#include "base/words/parse_number.hpp"
#include "clean/pslg.hpp"
#include "cuts/before_meshing/cut_for_layers.hpp"
#include "cuts/before_meshing/split_interfaces.hpp"
#include "cuts/boxes/cut_for_boxes.hpp"
#include "cuts/periodic/periodic_sides.hpp"
#include "method/boundaries_with_wishes.hpp"
#include "region/region_graph.hpp"
#include "tasks/begin_stage.hpp"
#include "tasks/by_team.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/for_each_region.hpp"

namespace cover {
namespace {

/// Before segments are cut for sizes that no mesh can have, or a dry run ends with a wrong name.
Status check_wishes(const Pslg& pslg, const RegionTable& table, const Options& options, Held held) {
  if (options.sizes.empty() && options.layers.empty() && !options.split_interfaces) return ok();
  const auto boundaries = boundaries_with_wishes(pslg, table, options);
  return boundaries ? check_expected_triangles(table, *boundaries, options, held)
                    : boundaries.error();
}

/// What the report tells of an input as it was read.
Report report_on(const Input& input, const Options& options) {
  Report report;
  report.provenance = {input.source, COVER_VERSION, describe_options(options)};
  report.unit = input.unit;
  report.scale = input.scale;
  for (const std::string& warning : input.warnings)
    report.notes.push_back({Note::Kind::warning, kVoid, warning, {}});
  report.threads = worker_count(options);
  return report;
}

/// Cuts segments as far as that can be told before anything is meshed.
Status cut_before_meshing(Prepared& prepared, const Options& options, Held held) {
  Status status = check_wishes(prepared.pslg, prepared.table, options, held);
  if (status) status = cut_before_sizes(prepared, options);
  if (status)
    status = split_interfaces(prepared.pslg, prepared.table, options, prepared.report.notes);
  if (status) status = cut_for_layers(prepared, options);
  if (status) cut_for_boxes(prepared, options);
  return status;
}

/// "there is no region or material 'coper'; did you mean 'copper'? " of names in options that no
/// seed has. Where seeds are refused, nothing else looks at names.
std::string names_of_no_seed(const Pslg& pslg, const Options& options) {
  std::vector<std::string> given;
  for (const RegionSeed& seed : pslg.seeds) {
    given.push_back(seed.region);
    given.push_back(seed.material);
  }
  std::string told;
  const auto look_at = [&](const std::string& name) {
    const bool is_made = parse_number<int>(name) || name.starts_with("region:") ||
                         name.starts_with("material_") || name == "unnamed";
    if (is_made || std::find(given.begin(), given.end(), name) != given.end()) return;
    const std::string meant = did_you_mean(name, given);
    told +=
        fmt::format("there is no region or material '{}'{} ", name, meant.empty() ? ";" : meant);
  };
  for (const LayerRule& rule : options.layers)
    if (!rule.region.empty()) look_at(rule.region);
  for (const SizeRule& rule : options.sizes)
    if (!rule.at && !rule.name.empty()) look_at(rule.name);
  return told;
}

/// `release` gives the input back, if it may go.
template <class Release>
Result<PreparedRegions> prepared_from(const Input& input, Release release, const Options& options,
                                      const Callbacks& callbacks, StageClock& clock, Held held) {
  if (Status status = check_options(options); !status) return std::move(status).error();
  Prepared prepared;
  Report& report = prepared.report;
  report = report_on(input, options);
  if (Status status = begin_stage("clean", callbacks); !status) return std::move(status).error();
  std::optional<Triangulation> whole;
  Result<Pslg> pslg = by_team("clean", worker_count(options), [&](const Team& team) {
    return make_pslg(input, options, report, &whole, team);
  });
  if (!pslg) return std::move(pslg).error();
  prepared.pslg = *std::move(pslg);
  const std::vector<PeriodicRule> rules = periodic_rules(input, options);
  release();
  clock.note("clean", report.times);
  if (Status status = begin_stage("regions", callbacks); !status) return std::move(status).error();
  Result<TriangulatedTable> made = by_team("regions", worker_count(options), [&](const Team& team) {
    return build_triangulated_table(prepared.pslg, options, report.notes, std::move(whole), team);
  });
  if (!made) {
    Error error = std::move(made).error();
    if (std::string told = names_of_no_seed(prepared.pslg, options); !told.empty())
      error.message = std::move(told) + error.message;
    return error;
  }
  prepared.table = std::move(made->table);
  Status joined = errors_as_values("periodic sides", [&] {
    return join_periodic_sides(prepared.pslg, prepared.table, rules, options, report);
  });
  if (!joined) return std::move(joined).error();
  clock.note("regions", report.times);
  report.input_points = prepared.pslg.points.size();
  report.input_segments = prepared.pslg.segments.size();
  Status cut = errors_as_values("split interfaces",
                                [&] { return cut_before_meshing(prepared, options, held); });
  if (!cut) return std::move(cut).error();
  return PreparedRegions{std::move(prepared), std::move(made->triangulated)};
}

}  // namespace

Result<PreparedRegions> prepare_regions(const Input& input, const Options& options,
                                        const Callbacks& callbacks, StageClock& clock, Held held) {
  return prepared_from(
      input, [] {}, options, callbacks, clock, held);
}

Result<PreparedRegions> prepare_regions(Input&& input, const Options& options,
                                        const Callbacks& callbacks, StageClock& clock, Held held) {
  return prepared_from(
      input, [&input] { input = {}; }, options, callbacks, clock, held);
}

}  // namespace cover
