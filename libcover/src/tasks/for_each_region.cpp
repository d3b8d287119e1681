// A region needs nothing of its neighbours and writes only its own slot of the results, so tasks
// share nothing but the progress count. What is thrown inside a region becomes the error of that
// region.
// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include "tasks/for_each_region.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "base/containers/order.hpp"
#include "base/faults/errors.hpp"
#include "base/run_all.hpp"
#include "sizes/expected_triangles.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/progress_count.hpp"

namespace cover {
namespace {

/// Region indices [first, last) of the order in which regions are meshed.
struct Batch {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t cost = 0;
};

/// More than any mesh has triangles; sums of it do not overflow.
constexpr double kMostCost = 0x1p40;

/// Batches are filled up to this cost: some milliseconds of work against microseconds of overhead.
constexpr std::size_t kBatchCost = 1000;

std::vector<std::size_t> largest_first(std::span<const std::size_t> costs) {
  return sorted_numbers<std::size_t>(
      costs.size(), [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
}

std::vector<Batch> make_batches(std::span<const std::size_t> costs,
                                std::span<const std::size_t> order) {
  std::vector<Batch> batches;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (batches.empty() || batches.back().cost >= kBatchCost) batches.push_back({k, k, 0});
    batches.back().last = k + 1;
    batches.back().cost += costs[order[k]];
  }
  return batches;
}

}  // namespace

std::vector<std::size_t> costs_of(std::span<const RegionBoundary> boundaries) {
  std::vector<std::size_t> costs;
  costs.reserve(boundaries.size());
  for (const RegionBoundary& boundary : boundaries) {
    const double triangles = std::clamp(most_triangles(boundary), 0.0, kMostCost);
    costs.push_back(boundary.sides.size() + boundary.points.size() +
                    static_cast<std::size_t>(triangles));
  }
  return costs;
}

unsigned worker_count(const Options& options) { return worker_count(options.threads); }

Status for_each_region(std::span<const RegionBoundary> boundaries, unsigned workers,
                       std::string_view stage, const Callbacks& callbacks,
                       const std::function<void(std::size_t, const Team&)>& task) {
  const std::vector<std::size_t> costs = costs_of(boundaries);
  const std::vector<std::size_t> order = largest_first(costs);
  const std::vector<Batch> batches = make_batches(costs, order);
  std::size_t total = 0;
  for (const Batch& batch : batches) total += batch.cost;
  ProgressCount progress(stage, total, callbacks);
  progress.add(0);
  std::vector<std::optional<Error>> errors(boundaries.size());

  const auto run = [&](const Batch& batch, const Team& team) {
    for (std::size_t k = batch.first; k < batch.last; ++k) {
      if (callbacks.stop.stop_requested()) return;
      constexpr std::string_view kWord = "region ";
      std::array<char, 32> name{};  // no allocation, which may fail
      char* const digits = std::copy(kWord.begin(), kWord.end(), name.begin());
      const auto end = std::to_chars(digits, name.end(), boundaries[order[k]].id.value());
      Status status = errors_as_values({name.begin(), end.ptr}, [&] {
        task(order[k], team);
        return ok();
      });
      if (!status) errors[order[k]] = std::move(status).error();
    }
    progress.add(batch.cost);
  };
  run_all(batches.size(), workers, [&](std::size_t k, const Team& team) { run(batches[k], team); });

  if (callbacks.stop.stop_requested()) return interrupted();
  for (std::optional<Error>& error : errors) {
    if (error) return std::move(*error);
  }
  return ok();
}

Status for_each_region(std::span<const RegionBoundary> boundaries, unsigned workers,
                       std::string_view stage, const Callbacks& callbacks,
                       const std::function<void(std::size_t)>& task) {
  return for_each_region(boundaries, workers, stage, callbacks,
                         [&task](std::size_t k, const Team&) { task(k); });
}

}  // namespace cover
