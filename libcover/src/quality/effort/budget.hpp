// The unit in which all work on a region is counted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stop_token>

namespace cover {

/// Points of a region in which random restarts (restart.hpp) take the place of searches.
inline constexpr std::size_t kTinyRegion = 16;

/// What becomes of Budget::was_too_small when a part of it was.
enum class WhenTooSmall {
  is_told,
  is_kept,  ///< as it was: the part was small on purpose, and more of the whole would not help
};

/// Star evaluations that remain for a region: the unit in which all work on it is counted.
struct Budget {
  std::uint64_t left = 0;
  std::stop_token stop;
  bool was_too_small = false;  ///< something was left undone for want of budget

  /// Also true once the caller wants to stop: the mesh is then thrown away.
  [[nodiscard]] bool is_used_up() const { return left == 0 || stop.stop_requested(); }
  /// Takes a part of what is left, one in `parts`, for a stage that must not use up all of it.
  Budget share(std::uint64_t parts) {
    Budget part{left / parts, stop, false};
    left -= part.left;
    return part;
  }
  /// Gives back what is left of a share.
  void take_back(const Budget& part) {
    left += part.left;
    was_too_small = was_too_small || part.was_too_small;
  }
  void spend(std::uint64_t evaluations) { left -= evaluations < left ? evaluations : left; }
  /// Calls `run`, for which at most `most` of what is left are there, and takes away what it has
  /// spent. What `run` adds to them goes to nobody else.
  template <class Run>
  void within(std::uint64_t most, Run run, WhenTooSmall tells = WhenTooSmall::is_told) {
    const std::uint64_t before = left, given = std::min(left, most);
    const bool was_before = was_too_small;
    left = given;
    run();
    left = before - (given - std::min(given, left));
    if (tells == WhenTooSmall::is_kept) was_too_small = was_before;
  }
};

}  // namespace cover
