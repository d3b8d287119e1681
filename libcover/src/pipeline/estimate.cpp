// Tested by tests/unit/pipeline/estimate_test.cpp.
#include <cover/estimate.hpp>
#include <cover/option_table.hpp>

#include "base/faults/machine_memory.hpp"
#include "region/region_graph.hpp"
#include "sizes/expected_triangles.hpp"
#include "sizes/sizes.hpp"
#include "tasks/errors_as_values.hpp"

namespace cover {
namespace {

/// Measured: 27 to 85 in maps and devices, and up to 360 where lines come close to each other. A
/// region without an almond needs no disks, so that is no ground to refuse a run.
constexpr double kTrianglesPerSideOfDisks = 40;

bool packs_disks(const Options& options) {
  return options.method == Method::nonobtuse ||
         (options.method == Method::almond && options.fill == Fill::disks);
}

Result<Estimate> add_up(const Prepared& prepared, const Options& options) {
  std::vector<RegionBoundary> boundaries = split_regions(prepared.pslg, prepared.table);
  if (Status status = resolve_sizes(prepared.pslg, prepared.table, options, boundaries); !status)
    return std::move(status).error();
  Estimate all;
  all.by_disks = packs_disks(options);
  std::size_t sides = 0;
  for (const RegionBoundary& boundary : boundaries) {
    all.triangles += about_triangles(boundary, options);
    sides += boundary.sides.size();
  }
  if (all.by_disks) all.triangles = kTrianglesPerSideOfDisks * static_cast<double>(sides);
  warn_of_sizes(prepared.pslg, options, boundaries, true, all.notes);
  all.bytes = memory_for(all.triangles, sides);
  all.available = machine_memory();
  return all;
}

}  // namespace

Result<Estimate> estimate(const Prepared& prepared, const Options& options) {
  return errors_as_values("estimate", [&]() -> Result<Estimate> {
    if (Status status = check_options(options); !status) return std::move(status).error();
    return add_up(prepared, options);
  });
}

}  // namespace cover
