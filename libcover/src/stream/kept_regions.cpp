// Tested by tests/unit/stream/kept_regions_test.cpp.
#include <cover/kept_regions.hpp>

#include <fstream>
#include <utility>

#include "base/faults/out_of_memory.hpp"
#include "base/run_all.hpp"
#include "io/files/temporary_file.hpp"
#include "stream/keep_bytes.hpp"
#include "stream/spool_region.hpp"
#include "tasks/share_out_regions.hpp"

namespace cover {
namespace {

/// Whether this process has the same folder as the one that offers.
bool sees(const OfferToKeep& offer) {
  std::uint64_t word = 0;
  std::ifstream file(offer.seen, std::ios::binary);
  return file.read(reinterpret_cast<char*>(&word), sizeof word) && word == offer.word;
}

}  // namespace

struct KeptRegions::Spool {
  MeshSpool meshes;
};

KeptRegions::KeptRegions(std::unique_ptr<Spool> spool) : spool_(std::move(spool)) {}
KeptRegions::KeptRegions(KeptRegions&& other) noexcept = default;
KeptRegions& KeptRegions::operator=(KeptRegions&& other) noexcept = default;
KeptRegions::~KeptRegions() = default;

Result<KeptRegions> KeptRegions::open(std::span<const std::byte> how) {
  return memory_as_value("keep", [&]() -> Result<KeptRegions> {
    const Result<OfferToKeep> offer = value_of<OfferToKeep>(how);
    if (!offer) return offer.error();
    if (!sees(*offer)) return cannot_write(offer->beside, ENOENT);
    Result<MeshSpool> spool =
        MeshSpool::without_input(offer->beside, offer->input_vertices, offer->regions);
    if (!spool) return std::move(spool).error();
    return KeptRegions(std::make_unique<Spool>(Spool{*std::move(spool)}));
  });
}

void KeptRegions::mesh(std::span<const std::size_t> numbers, std::span<Bytes> regions,
                       const Options& options, unsigned threads) {
  run_all(regions.size(), threads, [&](std::size_t k, const Team& team) {
    const auto keep = [&](const RegionBoundary& boundary, RegionMesh mesh) {
      KeptMesh told;
      told.report = std::move(mesh.report);
      told.steiner = static_cast<std::uint32_t>(mesh.steiner.size());
      told.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
      told.half_edges =
          spool_region(numbers[k], boundary, boundary.vertices, std::move(mesh), spool_->meshes);
      return told;
    };
    regions[k] = keep_region_bytes(regions[k], options, team, keep);
  });
  if (const Status status = spool_->meshes.status(); !status)
    for (Bytes& region : regions) region = to_bytes(Result<KeptMesh>(status.error()));
}

Status KeptRegions::write(std::span<const std::byte> bytes, unsigned threads) const {
  return memory_as_value("write", [&]() -> Status {
    const Result<ColumnPlan> plan = value_of<ColumnPlan>(bytes);
    if (!plan) return plan.error();
    Status status = ok();
    with_team(threads,
              [&](const Team& team) { status = write_columns(spool_->meshes, *plan, {}, team); });
    return status;
  });
}

}  // namespace cover
