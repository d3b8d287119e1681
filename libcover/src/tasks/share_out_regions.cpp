// Tested by tests/unit/pipeline/share_out_test.cpp.
#include "tasks/share_out_regions.hpp"

#include <mutex>
#include <new>
#include <numeric>
#include <optional>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "base/run_all.hpp"
#include "method/mesh_one_region.hpp"
#include "sizes/sizes.hpp"
#include "tasks/between_processes/region_bytes.hpp"
#include "tasks/errors_as_values.hpp"
#include "tasks/for_each_region.hpp"
#include "tasks/mesh_regions.hpp"
#include "tasks/progress_count.hpp"

namespace cover {
namespace {

Result<RegionMesh> try_region(const RegionBoundary& boundary, const Options& options,
                              const std::stop_token& stop, const Team& team = {}) {
  return errors_as_values(fmt::format("region {}", boundary.id.value()), [&] {
    return Result<RegionMesh>(mesh_one_region(boundary, options, stop, team));
  });
}

Result<RegionBoundary> read_boundary(std::span<const std::byte> bytes, const Options& options) {
  Result<RegionBoundary> read = boundary_of_bytes(bytes);
  if (read) {
    if (Status status = read_expressions(*read, options); !status) read = std::move(status).error();
  }
  return read;
}

/// What `make` makes, or why that fails, for another process; nothing where there is no memory to
/// tell of it.
template <class Made, class Make>
Bytes made_bytes(Make make) {
  Result<Bytes> bytes = errors_as_values(
      "sending a region", [&] { return Result<Bytes>(to_bytes(Result<Made>(make()))); });
  if (bytes) return *std::move(bytes);
  try {
    return to_bytes(Result<Made>(std::move(bytes).error()));
  } catch (const std::bad_alloc&) {
    return {};
  }
}

Bytes mesh_bytes(std::span<const std::byte> boundary, const Options& options,
                 const std::stop_token& stop, const Team& team = {}) {
  return made_bytes<RegionMesh>([&]() -> Result<RegionMesh> {
    const Result<RegionBoundary> read = read_boundary(boundary, options);
    if (!read) return read.error();
    return try_region(*read, options, stop, team);
  });
}

/// What became of a region.
enum class State : std::uint8_t { left_out, done, failed };

/// Every region has a slot of its own; progress and errors are common.
class Jobs final : public RegionJobs {
 public:
  Jobs(std::span<const RegionBoundary> boundaries, const Options& options,
       const Callbacks& callbacks, const RegionSink& sink, const std::function<bool()>& is_good,
       const Staying* staying)
      : boundaries_(boundaries),
        costs_(costs_of(boundaries)),
        options_(options),
        callbacks_(callbacks),
        sink_(sink),
        is_good_(is_good),
        staying_(staying),
        states_(boundaries.size(), State::left_out),
        errors_(boundaries.size()),
        progress_("mesh", std::accumulate(costs_.begin(), costs_.end(), std::size_t{0}),
                  callbacks) {}

  [[nodiscard]] std::size_t size() const override { return boundaries_.size(); }
  [[nodiscard]] std::size_t cost(std::size_t region) const override { return costs_[region]; }
  [[nodiscard]] Bytes boundary(std::size_t region) const override {
    if (!is_staying_) return to_bytes(boundaries_[region]);
    RegionBoundary boundary = boundaries_[region];
    boundary.vertices = staying_->vertices(region);
    return to_bytes(boundary);
  }
  bool offer_to_keep(const std::function<bool(const Bytes& how)>& offer) override {
    is_staying_ = staying_ != nullptr && staying_->offer(offer);
    return is_staying_;
  }
  [[nodiscard]] Bytes options() const override { return to_bytes(options_); }
  [[nodiscard]] std::stop_token stop() const override { return callbacks_.stop; }

  void mesh_here(std::size_t region) override {
    if (is_over()) return;
    keep(region, try_region(boundaries_[region], options_, callbacks_.stop));
  }
  void mesh_here(unsigned threads, const std::function<std::vector<std::size_t>()>& take) override {
    // As many calls as there may be batches: those behind the last one find nothing.
    run_all(boundaries_.size(), threads, [&](std::size_t, const Team& team) {
      Status status = errors_as_values("sharing out", [&] {
        if (is_over()) return ok();
        for (const std::size_t region : take())
          keep(region, try_region(boundaries_[region], options_, callbacks_.stop, team));
        return ok();
      });
      if (status) return;
      const std::lock_guard lock(mutex_);
      if (!of_sharing_) of_sharing_ = std::move(status).error();
    });
  }
  void accept(std::size_t region, std::span<const std::byte> result) override {
    if (is_staying_)
      keep(region, kept_of_bytes(result), staying_->sink);
    else
      keep(region, mesh_of_bytes(result));
  }

  /// The error of the first region that has no mesh.
  Status finish() {
    if (callbacks_.stop.stop_requested()) return interrupted();
    for (std::size_t region = 0; region < states_.size(); ++region) {
      if (states_[region] == State::failed) return *std::move(errors_[region]);
      if (states_[region] == State::done || !is_good_()) continue;
      return of_sharing_ ? *std::move(of_sharing_)
                         : internal_error("sharing out", "a region was left out");
    }
    return ok();
  }

 private:
  void keep(std::size_t region, Result<RegionMesh> mesh) { keep(region, std::move(mesh), sink_); }
  template <class Made, class Sink>
  void keep(std::size_t region, Result<Made> mesh, const Sink& sink) {
    Status kept = mesh ? errors_as_values("keeping a region",
                                          [&] {
                                            sink(region, *std::move(mesh));
                                            return ok();
                                          })
                       : Status(std::move(mesh).error());
    states_[region] = kept ? State::done : State::failed;
    if (!kept) errors_[region] = std::move(kept).error();
    progress_.add(costs_[region]);
  }

  /// Whether no further region is to be begun here.
  [[nodiscard]] bool is_over() const { return callbacks_.stop.stop_requested() || !is_good_(); }

  std::span<const RegionBoundary> boundaries_;
  /// By region. Each takes time in proportion to its sides, and sorting asks for them again and
  /// again.
  std::vector<std::size_t> costs_;
  const Options& options_;
  const Callbacks& callbacks_;
  const RegionSink& sink_;
  const std::function<bool()>& is_good_;
  const Staying* staying_;
  bool is_staying_ = false;  ///< what is meshed elsewhere
  std::vector<State> states_;
  std::vector<std::optional<Error>> errors_;  ///< by region
  ProgressCount progress_;
  std::mutex mutex_;
  std::optional<Error> of_sharing_;  ///< the first one beside those of regions
};

}  // namespace

Status share_out_regions(std::span<const RegionBoundary> boundaries, const Options& options,
                         const Callbacks& callbacks, const RegionSink& sink,
                         const std::function<bool()>& is_good, const Staying* staying) {
  Jobs jobs(boundaries, options, callbacks, sink, is_good, staying);
  Status shared = callbacks.share_out(jobs);
  return shared ? jobs.finish() : shared;
}

Bytes keep_region_bytes(
    std::span<const std::byte> boundary, const Options& options, const Team& team,
    const std::function<KeptMesh(const RegionBoundary& boundary, RegionMesh mesh)>& keep) {
  return made_bytes<KeptMesh>([&]() -> Result<KeptMesh> {
    const Result<RegionBoundary> read = read_boundary(boundary, options);
    if (!read) return read.error();
    Result<RegionMesh> mesh = try_region(*read, options, {}, team);
    if (!mesh) return std::move(mesh).error();
    return keep(*read, *std::move(mesh));
  });
}

Bytes mesh_region_bytes(std::span<const std::byte> boundary, const Options& options,
                        const std::stop_token& stop) {
  return mesh_bytes(boundary, options, stop);
}

void mesh_region_bytes(std::span<Bytes> regions, const Options& options, unsigned threads) {
  run_all(regions.size(), threads, [&](std::size_t k, const Team& team) {
    regions[k] = mesh_bytes(regions[k], options, {}, team);
  });
}

}  // namespace cover
