// What every rank but the first does.
#pragma once

namespace cover::mpi {

/// Meshes what rank 0 sends, and writes what stays here, until it sends no more.
void serve();

}  // namespace cover::mpi
