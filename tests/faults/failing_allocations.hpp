// The n-th allocation fails, and what is not given back is counted.
#pragma once

#include <cstddef>

namespace cover::testing {

/// What became of the allocations of a run.
struct Allocations {
  std::size_t count = 0;      ///< those that were asked for, the one that failed among them
  bool failed = false;        ///< one did
  std::size_t left = 0;       ///< blocks that were not given back
  std::size_t left_size = 0;  ///< bytes in them
  /// The size of the block that the thread asked for just before the failure, if it is among those
  /// left; else 0.
  std::size_t left_before_failure = 0;
};

/// Counts all that operator new hands out from now on, in every thread; the `at`-th (from 1 on; 0:
/// none) throws std::bad_alloc, and so do those after it, `in_a_row` in all.
void fail_allocation(std::size_t at, std::size_t in_a_row = 1);

/// No allocation fails any more. Those that are still there count as left.
Allocations end_of_failing_allocations();

/// Gives back the block of Allocations::left_before_failure, which nobody else will.
void free_block_before_failure();

}  // namespace cover::testing
