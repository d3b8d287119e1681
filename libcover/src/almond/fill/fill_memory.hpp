// What was made of the parts of a remainder, for trials that lay the same parts out again.
#pragma once

#include <cstddef>
#include <map>
#include <stop_token>
#include <vector>

#include "disks/filler.hpp"

namespace cover {

/// Fillings by task. A trial that repairs a few almonds leaves most parts of the remainder as they
/// were, among them those that are dear because every attempt to fill them fails.
class FillMemory {
 public:
  /// What `filler` makes of `task`, `which` being its place among the fillers of one plan.
  ///
  /// REQUIRES: the same filler for the same `which`
  /// Cost:     the filler's the first time; then O(points and chords), a logarithm of the tasks
  ///           known, and a copy
  [[nodiscard]] Filling filling(const Filler& filler, std::size_t which, const FillTask& task,
                                const std::stop_token& stop);

 private:
  std::map<std::vector<double>, Filling> known_;
  std::size_t numbers_ = 0;  ///< that are kept
};

}  // namespace cover
