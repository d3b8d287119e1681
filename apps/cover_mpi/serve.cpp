#include "serve.hpp"

#include <string>
#include <utility>
#include <vector>

#include <cover/options.hpp>
#include <cover/read_size_field.hpp>

#include "messages.hpp"
#include "rank_share_out.hpp"

namespace cover::mpi {
namespace {

/// Meshes parcels in place, on some threads.
void mesh_all(std::vector<Parcel>& parcels, const Options& options, unsigned threads) {
  std::vector<Bytes> regions;
  for (Parcel& parcel : parcels) regions.push_back(std::move(parcel.bytes));
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

void tell_failure(const std::string& why) {
  send(std::as_bytes(std::span(why.data(), why.size())), 0, Tag::failed);
}

}  // namespace

void serve() {
  Options options;
  unsigned threads = 1;
  bool failed = false;
  while (true) {
    const Message message = receive();
    if (message.tag == Tag::end) return;
    if (message.tag == Tag::options) {
      Result<Options> sent = options_here(message.bytes);
      threads = threads_of_rank(sent ? sent->threads : 1);
      failed = !sent;
      if (failed) tell_failure(sent.error().message);
      if (!failed) options = *std::move(sent);
    } else if (!failed) {
      std::vector<Parcel> parcels = unpack(message.bytes);
      mesh_all(parcels, options, threads);
      send(pack(parcels), 0, Tag::meshes);
    }
  }
}

}  // namespace cover::mpi
