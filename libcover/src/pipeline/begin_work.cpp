// The input made clean, and its regions as pieces of work.
// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include <cover/cover_mesh.hpp>
#include <cover/periodic.hpp>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "layers/layer_rules.hpp"
#include "method/boundaries_with_wishes.hpp"
#include "pipeline/prepare_regions.hpp"
#include "pipeline/steps.hpp"
#include "region/region_graph.hpp"
#include "sizes/sizes.hpp"
#include "tasks/by_team.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/followed_run.hpp"
#include "tasks/for_each_region.hpp"
#include "tasks/mesh_regions.hpp"

namespace cover {
namespace {

/// One piece of work per region.
Status split(Work& work, const Options& options, Held held,
             std::span<TriangulatedRegion> triangulated) {
  return by_team("split", worker_count(options), [&](const Team& team) -> Status {
    auto boundaries = boundaries_with_wishes(work.pslg, work.table, options, team);
    if (!boundaries) return std::move(boundaries).error();
    work.boundaries = *std::move(boundaries);
    if (work.pslg.points.size() == work.report.input_points)
      add_known_triangles(triangulated, work.pslg.points.size(), work.boundaries, team);
    return check_expected_triangles(work.table, work.boundaries, options, held);
  });
}

/// `input` is given back early if it may be moved from.
template <class AnyInput>
Result<Work> work_of(AnyInput&& input, const Options& options, Held held,
                     const Callbacks& callbacks, StageClock& clock) {
  std::vector<PeriodicRule> rules = periodic_rules(input, options);
  std::shared_ptr<const PlaneField> field = input.field;
  Result<PreparedRegions> regions =
      prepare_regions(std::forward<AnyInput>(input), options, callbacks, clock, held);
  if (!regions) return std::move(regions).error();
  Work work{std::move(regions->prepared)};
  work.rules = std::move(rules);
  work.field = std::move(field);
  if (Status status = split(work, options, held, regions->triangulated); !status)
    return std::move(status).error();
  Status warned = errors_as_values("sizes", [&] {
    warn_of_sizes(work.pslg, options, work.boundaries, true, work.report.notes);
    return ok();
  });
  if (!warned) return std::move(warned).error();
  clock.note("split", work.report.times);
  return work;
}

}  // namespace

Result<Work> begin_work(Input&& input, const Options& options, Held held,
                        const Callbacks& callbacks, StageClock& clock) {
  return work_of(std::move(input), options, held, callbacks, clock);
}

Result<Work> begin_work(const Input& input, const Options& options, Held held,
                        const Callbacks& callbacks, StageClock& clock) {
  return work_of(input, options, held, callbacks, clock);
}

Result<Prepared> prepare(const Input& input, const Options& asked, const Callbacks& caller,
                         Held held) {
  return followed("prepare", caller, [&](const Callbacks& callbacks) -> Result<Prepared> {
    StageClock clock;
    const Options options = with_layers_of(input, asked);
    Result<PreparedRegions> regions = prepare_regions(input, options, callbacks, clock, held);
    if (!regions) return std::move(regions).error();
    Prepared prepared = std::move(regions->prepared);
    Result<std::vector<RegionReport>> limits =
        bound_regions(split_regions(prepared.pslg, prepared.table), options, callbacks);
    if (!limits) return std::move(limits).error();
    prepared.report.regions = *std::move(limits);
    clock.note("limits", prepared.report.times);
    return prepared;
  });
}

}  // namespace cover
