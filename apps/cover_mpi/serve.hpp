// What every rank but the first does.
#pragma once

#include <stop_token>

#include <cover/result.hpp>

#include "rank_cores.hpp"

namespace cover::mpi {

/// Reads and meshes what rank 0 sends, and writes what stays here, until it sends no more.
///
/// Errors: cancelled where `stop` asks for the end before that
Status serve(const RankCores& cores, const std::stop_token& stop);

}  // namespace cover::mpi
