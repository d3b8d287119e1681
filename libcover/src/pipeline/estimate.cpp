// Tested by tests/unit/pipeline/estimate_test.cpp.
#include <cover/estimate.hpp>
#include <cover/option_table.hpp>

#include <cstddef>
#include <map>
#include <span>

#include "base/faults/machine_memory.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"
#include "layers/front/thickness.hpp"
#include "layers/layer_rules.hpp"
#include "layers/layered_region.hpp"
#include "region/region_graph.hpp"
#include "sizes/expected_triangles.hpp"
#include "sizes/segment_sizes.hpp"
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

double length_of(const RegionBoundary& boundary, std::size_t s) {
  const auto& [a, b] = boundary.sides[s];
  return length(boundary.points[b] - boundary.points[a]);
}

/// Segments with layers, and what regions on both sides want of them.
std::map<SegmentId, SegmentSizes> layered_segments(std::span<const RegionBoundary> boundaries,
                                                   const Pslg& pslg, const Options& options) {
  std::map<SegmentId, SegmentSizes> sizes;
  for (const RegionBoundary& boundary : boundaries) {
    for (std::size_t s = 0; s < boundary.layers.size(); ++s) {
      if (boundary.layers[s] == 0) continue;
      const Segment& segment = pslg.segments[boundary.segments[s].index()];
      sizes.try_emplace(boundary.segments[s], pslg.points[segment.a.index()],
                        pslg.points[segment.b.index()], options);
    }
  }
  for (const RegionBoundary& boundary : boundaries) {
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      const auto at = sizes.find(boundary.segments[s]);
      if (at != sizes.end()) at->second.add(boundary, s);
    }
  }
  return sizes;
}

/// How high layers may be on average: so high, they fill the region.
double room_for_layers(const RegionBoundary& boundary) {
  double area = 0, layered = 0;
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    const auto& [a, b] = boundary.sides[s];
    area += doubled_area(boundary.points.front(), boundary.points[a], boundary.points[b]) / 2;
    if (boundary.layers[s] != 0) layered += length_of(boundary, s);
  }
  return area / layered;
}

/// What layers take: two triangles for each row over each piece that sizes cut their lines to.
double triangles_of_layers(std::span<const RegionBoundary> boundaries, const Pslg& pslg,
                           const Options& options) {
  const std::map<SegmentId, SegmentSizes> sizes = layered_segments(boundaries, pslg, options);
  double all = 0;
  for (const RegionBoundary& boundary : boundaries) {
    if (!has_layers(boundary)) continue;
    const double room = room_for_layers(boundary);
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      if (boundary.layers[s] == 0) continue;
      const LayerRule& rule = options.layers[boundary.layers[s] - 1];
      const layers::Thickness thickness(rule, room);
      double pieces = 1;
      if (options.split_interfaces)
        pieces += static_cast<double>(sizes.at(boundary.segments[s]).cuts().size());
      const double piece = length_of(boundary, s) / pieces;
      int rows = 0;
      while (rows < thickness.rows() &&
             (rule.count > 0 || rows == 0 || thickness.layer(rows) <= piece))
        ++rows;
      all += 2 * rows * pieces;
    }
  }
  return all;
}

Result<Estimate> add_up(const Prepared& prepared, const Options& options) {
  std::vector<RegionBoundary> boundaries = split_regions(prepared.pslg, prepared.table);
  if (Status status = resolve_sizes(prepared.pslg, prepared.table, options, boundaries); !status)
    return std::move(status).error();
  if (Status status = resolve_layers(prepared.pslg, prepared.table, options, boundaries); !status)
    return std::move(status).error();
  Estimate all;
  all.by_disks = packs_disks(options);
  std::size_t sides = 0;
  for (const RegionBoundary& boundary : boundaries) {
    all.triangles += about_triangles(boundary, options);
    sides += boundary.sides.size();
  }
  if (all.by_disks) all.triangles = kTrianglesPerSideOfDisks * static_cast<double>(sides);
  all.triangles += triangles_of_layers(boundaries, prepared.pslg, options);
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
