// Work for several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace cover {

/// Calls `run` with 0, 1, ..., count - 1, which begin in this order, in up to `workers` threads of
/// which the caller's is one. Where the system has no more threads, fewer do the work.
///
/// REQUIRES: `run` throws nothing when there are several workers
/// ENSURES:  all calls have returned
/// Throws:   std::bad_alloc, before the first call
void run_all(std::size_t count, unsigned workers, const std::function<void(std::size_t)>& run);

}  // namespace cover
