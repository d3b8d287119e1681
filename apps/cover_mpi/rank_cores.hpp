// The cores that the ranks of a machine may use.
#pragma once

namespace cover::mpi {

/// Of the machine that a rank is on.
struct RankCores {
  unsigned own = 1;      ///< this rank's part of those that it may use
  unsigned of_all = 1;   ///< that its ranks may use together
  unsigned unbound = 1;  ///< that they might use if mpirun had not bound them to some
};

/// To be called by each rank.
RankCores find_rank_cores();

/// The threads that a rank uses for meshing: what `asked` says; 0 is its part of the cores.
unsigned threads_of_rank(unsigned asked, const RankCores& cores);

}  // namespace cover::mpi
