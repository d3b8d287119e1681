// Input files shared out among ranks, by rank 0.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <cover/read_elsewhere.hpp>

#include "messages.hpp"
#include "rank_cores.hpp"

namespace cover::mpi {

/// Has files read by all ranks, each about as many bytes, and returns what is in them in their
/// order. What another rank cannot read is read here: it may be on this machine alone.
///
/// Threads: called by the main thread of rank 0
/// Errors:  that of the first file that cannot be read here
Result<std::vector<Input>> read_among_ranks(
    const FilesToRead& files, const std::function<Result<Input>(const std::string& path)>& here);

/// What another rank does: reads files and sends what is in them.
///
/// Threads: called by the main thread of that rank
void read_for_rank_0(std::span<const std::byte> files, const RankCores& cores);

}  // namespace cover::mpi
