// Tested by tests/mpi/mpi_test.py.
#include "rank_read.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <optional>
#include <system_error>
#include <utility>

#include "read_geometry.hpp"

namespace cover::mpi {
namespace {

/// By rank: numbers of files. The largest goes first, each to the rank with the fewest bytes.
std::vector<std::vector<std::size_t>> shares(const std::vector<std::string>& paths, int ranks) {
  std::vector<std::uintmax_t> size;
  for (const std::string& path : paths) {
    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
    size.push_back(unknown ? 0 : bytes);
  }
  std::vector<std::size_t> order(paths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t k, std::size_t l) { return size[k] > size[l]; });
  std::vector<std::vector<std::size_t>> share(static_cast<std::size_t>(ranks));
  std::vector<std::uintmax_t> bytes(share.size(), 0);
  for (const std::size_t k : order) {
    const auto least = std::min_element(bytes.begin(), bytes.end()) - bytes.begin();
    share[static_cast<std::size_t>(least)].push_back(k);
    bytes[static_cast<std::size_t>(least)] += size[k] + 1;
  }
  for (std::vector<std::size_t>& files : share) std::sort(files.begin(), files.end());
  return share;
}

}  // namespace

Result<std::vector<Input>> read_among_ranks(
    const FilesToRead& files, const std::function<Result<Input>(const std::string& path)>& here) {
  const std::vector<std::vector<std::size_t>> share = shares(files.paths, rank_count());
  int at_work = 0;  // other ranks
  for (std::size_t rank = 1; rank < share.size(); ++rank) {
    if (share[rank].empty()) continue;
    FilesToRead part{{}, files.options};
    for (const std::size_t k : share[rank]) part.paths.push_back(files.paths[k]);
    send(bytes_of_files(part), static_cast<int>(rank), Tag::files);
    ++at_work;
  }
  std::vector<std::optional<Result<Input>>> read(files.paths.size());
  for (const std::size_t k : share[0]) read[k] = here(files.paths[k]);
  for (; at_work > 0; --at_work) {
    const Message message = receive();
    const std::vector<std::size_t>& numbers = share[static_cast<std::size_t>(message.rank)];
    std::vector<Parcel> parcels = unpack(message.bytes);
    for (std::size_t k = 0; k < std::min(parcels.size(), numbers.size()); ++k) {
      Result<Input> input = input_of_bytes(parcels[k].bytes);
      if (input) read[numbers[k]] = std::move(input);
    }
  }
  std::vector<Input> inputs;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (!read[k]) read[k] = here(files.paths[k]);
    if (!*read[k]) return read[k]->error();
    inputs.push_back(**std::move(read[k]));
  }
  return inputs;
}

void read_for_rank_0(std::span<const std::byte> files, const RankCores& cores) {
  Result<FilesToRead> asked = files_of_bytes(files);
  std::vector<Parcel> parcels;
  if (asked) {
    ReadOptions& options = asked->options;
    options.threads = threads_of_rank(options.threads, cores);
    for (const std::string& path : asked->paths)
      parcels.push_back({parcels.size(), bytes_of_input(reading::read_geometry(path, options))});
  }
  send(pack(parcels), 0, Tag::inputs);
}

}  // namespace cover::mpi
