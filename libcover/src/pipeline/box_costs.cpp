// Tested by tests/unit/cuts/boxes/cut_encroached_test.cpp.
#include <cover/cover_mesh.hpp>
#include <cover/option_table.hpp>

#include "base/faults/out_of_memory.hpp"
#include "box/forced_cuts.hpp"
#include "cdt/cdt.hpp"
#include "cuts/before_meshing/split_interfaces.hpp"
#include "cuts/boxes/cut_encroached.hpp"
#include "region/region_graph.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/for_each_region.hpp"

namespace cover {
namespace {

/// The encroached segments of each region.
Result<std::vector<std::vector<EncroachedSegment>>> encroached_in(
    const std::vector<RegionBoundary>& boundaries, const Options& options,
    const Callbacks& callbacks) {
  std::vector<std::vector<EncroachedSegment>> encroached(boundaries.size());
  Status found = for_each_region(
      boundaries, worker_count(options), "box method", callbacks, [&](std::size_t r) {
        const CdtResult cdt = triangulate_domain(boundaries[r].points, boundaries[r].sides);
        encroached[r] = encroached_segments(boundaries[r], cdt.triangulation);
      });
  if (!found) return std::move(found).error();
  return encroached;
}

/// Thin layers around each other have cuts of one cut the next, in as many passes as there are
/// layers: such a cascade is not counted to its end.
constexpr std::size_t kLooksPerPoint = 64;
constexpr std::size_t kLooksAtLeast = 1'000'000;

/// Cuts copies as --box-method does, and as --split-interfaces=90 does without sizes.
Status try_cuts(const Pslg& pslg, const RegionTable& table, BoxCosts& costs) {
  const std::size_t looks = kLooksAtLeast + kLooksPerPoint * pslg.points.size();
  if (const auto counted = count_box_cuts({pslg, table, {}}, looks)) {
    costs.cuts = counted->cuts;
    costs.uncut = counted->uncut;
  }
  Options right;
  right.split_interfaces = Angle::degrees(90);
  right.input_sizes = false;  // what sizes cut is no price of right angles, and may be without end
  const auto counted = count_interface_cuts(pslg, table, right, looks);
  if (!counted) return counted.error();
  costs.cuts_for_right_angles = *counted;
  return ok();
}

Result<BoxCosts> count_costs(const Prepared& prepared, const Options& options,
                             const Callbacks& callbacks) {
  const std::vector<RegionBoundary> boundaries = split_regions(prepared.pslg, prepared.table);
  const auto encroached = encroached_in(boundaries, options, callbacks);
  if (!encroached) return encroached.error();
  BoxCosts costs;
  for (std::size_t r = 0; r < boundaries.size(); ++r) {
    costs.sides += boundaries[r].sides.size();
    costs.encroached_sides += (*encroached)[r].size();
    for (const EncroachedSegment& e : (*encroached)[r])
      costs.encroached.push_back(
          {NegativeCoupling::Kind::encroached, boundaries[r].id, e.a, e.b, e.by});
  }
  const ForcedCuts forced = forced_cuts(*encroached);
  costs.encroached_segments = forced.segments;
  costs.least_cuts = forced.least;
  Status cut = errors_as_values("box method",
                                [&] { return try_cuts(prepared.pslg, prepared.table, costs); });
  if (!cut) return std::move(cut).error();
  return costs;
}

}  // namespace

Result<BoxCosts> box_costs(const Prepared& prepared, const Options& options,
                           const Callbacks& callbacks) {
  return memory_as_value("box method", [&]() -> Result<BoxCosts> {
    if (Status status = check_options(options); !status) return std::move(status).error();
    return count_costs(prepared, options, callbacks);
  });
}

}  // namespace cover
