// Tested by tests/unit/pipeline/estimate_test.cpp.
#include <cover/estimate.hpp>

#include "base/faults/machine_memory.hpp"
#include "base/faults/out_of_memory.hpp"
#include "region/region_graph.hpp"
#include "sizes/expected_triangles.hpp"
#include "sizes/sizes.hpp"
#include "tasks/errors_as_values.hpp"

namespace cover {
namespace {

Result<Estimate> add_up(const Prepared& prepared, const Options& options) {
  std::vector<RegionBoundary> boundaries = split_regions(prepared.pslg, prepared.table);
  if (Status status = resolve_sizes(prepared.pslg, prepared.table, options, boundaries); !status)
    return std::move(status).error();
  Estimate all;
  std::size_t sides = 0;
  for (const RegionBoundary& boundary : boundaries) {
    all.triangles += about_triangles(boundary, options);
    sides += boundary.sides.size();
  }
  all.bytes = memory_for(all.triangles, sides);
  all.available = machine_memory();
  return all;
}

}  // namespace

Result<Estimate> estimate(const Prepared& prepared, const Options& options) {
  return errors_as_values("estimate", [&] { return add_up(prepared, options); });
}

}  // namespace cover
