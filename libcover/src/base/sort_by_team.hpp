// Sorting by several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/team.hpp"

namespace cover {

/// Sorts a list: eighths of it, then two and two of what is sorted. Short lists are sorted as one.
///
/// REQUIRES: no two items are equal, or none can be told from one that is equal; is_before() throws
///           nothing
/// Cost:     O(n log n), and half of the list's memory
template <class T, class IsBefore>
void sort_by_team(std::vector<T>& list, const IsBefore& is_before, const Team& team) {
  constexpr std::size_t kShort = 1 << 16, kPieces = 8;
  if (team.workers() < 2 || list.size() < kShort) {
    std::sort(list.begin(), list.end(), is_before);
    return;
  }
  const auto place = [&](std::size_t piece) {
    return list.begin() + static_cast<std::ptrdiff_t>(list.size() * piece / kPieces);
  };
  team.each(kPieces, [&](std::size_t k) { std::sort(place(k), place(k + 1), is_before); });
  for (std::size_t step = 1; step < kPieces; step *= 2) {
    team.each(kPieces / (2 * step), [&](std::size_t k) {
      const std::size_t first = 2 * k * step;
      std::inplace_merge(place(first), place(first + step), place(first + 2 * step), is_before);
    });
  }
}

}  // namespace cover
