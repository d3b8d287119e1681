// How much memory a piece of the program needs, counted and not guessed.
#pragma once

#include <functional>

namespace cover::bench {

/// The most bytes from operator new that `work` has in use at a time, in all threads. (The resident
/// set says less: it stays where the largest case before has brought it.)
///
/// REQUIRES: one call at a time
double heap_peak_of(const std::function<void()>& work);

}  // namespace cover::bench
