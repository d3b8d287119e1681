// Regions shared out among ranks, by rank 0.
#pragma once

#include <functional>

#include <cover/share_out.hpp>

#include "rank_cores.hpp"

namespace cover::mpi {

/// Gives regions to whoever has nothing to do, the largest first: threads of this process and other
/// ranks. What goes last is small, so all end at nearly the same time.
///
/// Threads: called by the main thread of rank 0
/// Errors:  internal with the reason that another rank gave for going on no more
Status share_out_among_ranks(RegionJobs& jobs, const RankCores& cores);

/// Has a plan carried out by all ranks, by this one with `here`: see Callbacks::write_elsewhere.
///
/// Threads: as share_out_among_ranks()
/// Errors:  those of `here`; else of another rank, which is named
Status write_among_ranks(const Bytes& plan, const std::function<Status()>& here);

/// Lets the other ranks end.
void dismiss_ranks();

}  // namespace cover::mpi
