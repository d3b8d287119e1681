// Tested by tests/unit/pipeline/share_out_test.cpp.
#include "tasks/share_out_regions.hpp"

#include <mutex>
#include <optional>

#include <fmt/core.h>

#include "sizes/sizes.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/region_bytes.hpp"
#include "tasks/region_task.hpp"

namespace cover {
namespace {

Result<RegionMesh> try_region(const RegionBoundary& boundary, const Options& options,
                              const std::stop_token& stop) {
  return errors_as_values(fmt::format("region {}", boundary.id.value()), [&] {
    return Result<RegionMesh>(mesh_one_region(boundary, options, stop));
  });
}

/// Every result has a slot of its own; only the progress is common.
class Jobs final : public RegionJobs {
 public:
  Jobs(std::span<const RegionBoundary> boundaries, const Options& options,
       const Callbacks& callbacks)
      : boundaries_(boundaries),
        options_(options),
        callbacks_(callbacks),
        meshes_(boundaries.size()),
        progress_{"mesh", 0, 0} {
    for (const RegionBoundary& boundary : boundaries) progress_.total += cost_of(boundary);
  }

  [[nodiscard]] std::size_t size() const override { return boundaries_.size(); }
  [[nodiscard]] std::size_t cost(std::size_t region) const override {
    return cost_of(boundaries_[region]);
  }
  [[nodiscard]] Bytes boundary(std::size_t region) const override {
    return to_bytes(boundaries_[region]);
  }
  [[nodiscard]] Bytes options() const override { return to_bytes(options_); }
  [[nodiscard]] std::stop_token stop() const override { return callbacks_.stop; }

  void mesh_here(std::size_t region) override {
    keep(region, try_region(boundaries_[region], options_, callbacks_.stop));
  }
  void accept(std::size_t region, std::span<const std::byte> result) override {
    keep(region, mesh_of_bytes(result));
  }

  /// All meshes, or the error of the first region that has none.
  Result<std::vector<RegionMesh>> take() {
    std::vector<RegionMesh> meshes;
    meshes.reserve(meshes_.size());
    for (std::optional<Result<RegionMesh>>& mesh : meshes_) {
      if (!mesh) return internal_error("sharing out", "a region was left out");
      if (!*mesh) return std::move(*mesh).error();
      meshes.push_back(**std::move(mesh));
    }
    return meshes;
  }

 private:
  void keep(std::size_t region, Result<RegionMesh> mesh) {
    meshes_[region] = std::move(mesh);
    if (!callbacks_.progress) return;
    const std::lock_guard lock(mutex_);
    progress_.done += cost_of(boundaries_[region]);
    callbacks_.progress(progress_);
  }

  std::span<const RegionBoundary> boundaries_;
  const Options& options_;
  const Callbacks& callbacks_;
  std::vector<std::optional<Result<RegionMesh>>> meshes_;
  std::mutex mutex_;
  Progress progress_;
};

}  // namespace

Result<std::vector<RegionMesh>> share_out_regions(std::span<const RegionBoundary> boundaries,
                                                  const Options& options,
                                                  const Callbacks& callbacks) {
  Jobs jobs(boundaries, options, callbacks);
  Status shared = callbacks.share_out(jobs);
  if (!shared) return std::move(shared).error();
  if (callbacks.stop.stop_requested()) return Error{ErrorCode::cancelled, "interrupted", {}, {}};
  return jobs.take();
}

Bytes mesh_region_bytes(std::span<const std::byte> boundary, const Options& options,
                        const std::stop_token& stop) {
  Result<RegionBoundary> read = boundary_of_bytes(boundary);
  if (read) {
    if (Status status = read_expressions(*read); !status) read = std::move(status).error();
  }
  return to_bytes(read ? try_region(*read, options, stop) : Result<RegionMesh>(read.error()));
}

}  // namespace cover
