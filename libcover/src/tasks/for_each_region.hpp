// Regions as tasks for several threads.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// The number of workers that `options` ask for: at least one.
unsigned worker_count(const Options& options);

/// Calls `task` with the index of every boundary, on `workers` threads, the largest
/// boundaries first. Tiny regions travel in batches, so that ten thousand of them cost no more
/// than one big one.
///
/// ENSURES: the error of the first region (by index) that failed, whatever the schedule was.
/// Errors:  cancelled; those of errors_as_values() if a task threw.
/// Threads: `task` runs in several threads at a time, `callbacks.progress` in one. The team that it
///          is given are all of these threads, see run_all().
Status for_each_region(std::span<const RegionBoundary> boundaries, unsigned workers,
                       std::string_view stage, const Callbacks& callbacks,
                       const std::function<void(std::size_t, const Team&)>& task);

/// For tasks that do not divide their work.
Status for_each_region(std::span<const RegionBoundary> boundaries, unsigned workers,
                       std::string_view stage, const Callbacks& callbacks,
                       const std::function<void(std::size_t)>& task);

/// Estimated work of each region. All methods are near linear in the size of the boundary and in
/// the number of triangles.
std::vector<std::size_t> costs_of(std::span<const RegionBoundary> boundaries);

}  // namespace cover
