// Tested by tests/unit/cuts/before_meshing/cut_encroached_test.cpp.
#include <cover/cover_mesh.hpp>

#include "base/faults/out_of_memory.hpp"
#include "box/forced_cuts.hpp"
#include "cdt/cdt.hpp"
#include "cuts/before_meshing/cut_encroached.hpp"
#include "cuts/before_meshing/split_interfaces.hpp"
#include "region/region_graph.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/region_task.hpp"

namespace cover {
namespace {

Result<BoxCosts> count_costs(const Prepared& prepared, const Options& options,
                             const Callbacks& callbacks) {
  const Pslg& pslg = prepared.pslg;
  const RegionTable& table = prepared.table;
  const std::vector<RegionBoundary> boundaries = split_regions(pslg, table);
  std::vector<std::vector<EncroachedSegment>> encroached(boundaries.size());
  Status found = for_each_region(
      boundaries, worker_count(options), "box method", callbacks, [&](std::size_t r) {
        const CdtResult cdt = triangulate_domain(boundaries[r].points, boundaries[r].sides);
        encroached[r] = encroached_segments(boundaries[r], cdt.triangulation);
      });
  if (!found) return std::move(found).error();
  BoxCosts costs;
  for (std::size_t r = 0; r < boundaries.size(); ++r) {
    costs.sides += boundaries[r].sides.size();
    costs.encroached_sides += encroached[r].size();
    for (const EncroachedSegment& e : encroached[r])
      costs.encroached.push_back(
          {NegativeCoupling::Kind::encroached, boundaries[r].id, e.a, e.b, e.by});
  }
  const ForcedCuts forced = forced_cuts(encroached);
  costs.encroached_segments = forced.segments;
  costs.least_cuts = forced.least;
  Status cut = errors_as_values("box method", [&] {
    Pslg cut_pslg = pslg;
    RegionTable cut_table = table;
    std::vector<BoxCut> cuts;
    std::vector<Point> stuck;
    cut_encroached(cut_pslg, cut_table, pslg.points.size(), VertexId{pslg.points.size()}, cuts,
                   stuck);
    costs.cuts = cuts.size();
    costs.uncut = stuck.size();
    cut_pslg = pslg;
    cut_table = table;
    Options right;
    right.split_interfaces = Angle::degrees(90);
    std::vector<Note> notes;
    Status split = split_interfaces(cut_pslg, cut_table, right, notes);
    costs.cuts_for_right_angles = cut_pslg.points.size() - pslg.points.size();
    return split;
  });
  if (!cut) return std::move(cut).error();
  return costs;
}

}  // namespace

Result<BoxCosts> box_costs(const Prepared& prepared, const Options& options,
                           const Callbacks& callbacks) {
  return memory_as_value("box method", [&] { return count_costs(prepared, options, callbacks); });
}

}  // namespace cover
