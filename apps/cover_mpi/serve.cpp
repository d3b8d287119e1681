#include "serve.hpp"

#include <optional>
#include <utility>
#include <vector>

#include <cover/kept_regions.hpp>
#include <cover/options.hpp>
#include <cover/read_size_field.hpp>

#include "messages.hpp"
#include "rank_read.hpp"
#include "rank_share_out.hpp"

namespace cover::mpi {
namespace {

/// Meshes parcels in place, on some threads; what is kept says of its meshes where they stay.
void mesh_all(std::vector<Parcel>& parcels, const Options& options, unsigned threads,
              std::optional<KeptRegions>& kept) {
  std::vector<std::size_t> numbers;
  std::vector<Bytes> regions;
  for (Parcel& parcel : parcels) {
    numbers.push_back(parcel.number);
    regions.push_back(std::move(parcel.bytes));
  }
  if (kept)
    kept->mesh(numbers, regions, options, threads);
  else
    mesh_region_bytes(regions, options, threads);
  for (std::size_t k = 0; k < parcels.size(); ++k) parcels[k].bytes = std::move(regions[k]);
}

/// The options of the run, with the size field, which every rank reads by itself.
Result<Options> options_here(std::span<const std::byte> bytes) {
  Result<Options> options = options_of_bytes(bytes);
  if (!options) return options;
  if (const Status status = load_size_field(*options); !status) return status.error();
  return options;
}

/// Nothing, if all is well.
void tell(const Status& status, Tag tag) { send(bytes_of_status(status), 0, tag); }

/// What has to stay here, if all ranks can keep it.
std::optional<KeptRegions> agree_to_keep(std::span<const std::byte> how) {
  Result<KeptRegions> opened = KeptRegions::open(how);
  if (!all_agree(opened.has_value())) return std::nullopt;
  return *std::move(opened);
}

/// Writes what stays here, and tells of it.
void write_kept(const std::optional<KeptRegions>& kept, unsigned threads) {
  Bytes plan;
  spread(plan);
  tell(kept ? kept->write(plan, threads) : ok(), Tag::written);
}

}  // namespace

void serve(const RankCores& cores) {
  Options options;
  std::optional<KeptRegions> kept;
  unsigned threads = 1;
  bool failed = false;
  while (true) {
    const Message message = receive();
    if (message.tag == Tag::end) return;
    if (message.tag == Tag::options) {
      Result<Options> sent = options_here(message.bytes);
      threads = threads_of_rank(sent ? sent->threads : 1, cores);
      failed = !sent;
      if (failed) tell(sent.error(), Tag::failed);
      if (!failed) options = *std::move(sent);
    } else if (message.tag == Tag::files) {
      read_for_rank_0(message.bytes, cores);
    } else if (message.tag == Tag::keep) {
      kept = agree_to_keep(message.bytes);
    } else if (message.tag == Tag::write) {
      write_kept(kept, threads);
    } else if (!failed) {
      std::vector<Parcel> parcels = unpack(message.bytes);
      mesh_all(parcels, options, threads, kept);
      send(pack(parcels), 0, Tag::meshes);
    }
  }
}

}  // namespace cover::mpi
