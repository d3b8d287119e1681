// Work for several threads.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>

#include "base/team.hpp"

namespace cover {

/// The workers that somebody wishes for: all cores if none are given, and at least one.
unsigned worker_count(unsigned threads);

/// Calls `run` with 0, 1, ..., count - 1, which begin in this order, in up to `workers` threads of
/// which the caller's is one. Where the system has no more threads, fewer do the work.
///
/// The team that each call is given are the same threads: parts of a call that has begun are taken
/// before the next call begins, and whoever finds no call any more helps until all are done.
///
/// REQUIRES: `run` throws nothing when there are several workers
/// ENSURES:  all calls have returned
/// Throws:   std::bad_alloc, before the first call
void run_all(std::size_t count, unsigned workers,
             const std::function<void(std::size_t, const Team&)>& run);

/// For calls that do not divide their work.
void run_all(std::size_t count, unsigned workers, const std::function<void(std::size_t)>& run);

/// Calls `body` with a team of up to `workers` threads, of which the caller's is one.
///
/// Throws: what `body` throws
template <class Body>
void with_team(unsigned workers, const Body& body) {
  std::exception_ptr thrown;
  run_all(1, workers, [&](std::size_t, const Team& team) {
    try {
      body(team);
    } catch (...) {
      thrown = std::current_exception();
    }
  });
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace cover
