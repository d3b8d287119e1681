// What every rank but the first does.
#pragma once

#include "rank_cores.hpp"

namespace cover::mpi {

/// Meshes what rank 0 sends, and writes what stays here, until it sends no more.
void serve(const RankCores& cores);

}  // namespace cover::mpi
