// Sorting by several threads.
// Tested by tests/unit/base/sort_by_team_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/team.hpp"

namespace cover {

/// Merges two sorted lists as far as the items from `begin` on, as many as `out` holds, go: so
/// ranges of what they become are nothing to each other.
///
/// REQUIRES: begin + out.size() <= one.size() + other.size()
template <class T, class IsBefore>
void merge_range(std::span<const T> one, std::span<const T> other, std::size_t begin,
                 std::span<T> out, const IsBefore& is_before) {
  // Of the items before `begin` so many are of the first list.
  std::size_t i = begin > other.size() ? begin - other.size() : 0;
  for (std::size_t end = std::min(begin, one.size()); i < end;) {
    const std::size_t middle = i + (end - i) / 2;
    if (is_before(other[begin - 1 - middle], one[middle])) {
      end = middle;
    } else {
      i = middle + 1;
    }
  }
  std::size_t j = begin - i;
  for (T& item : out) {
    const bool takes_other = i == one.size() || (j != other.size() && is_before(other[j], one[i]));
    item = takes_other ? other[j++] : one[i++];
  }
}

/// Sorts a list: pieces of it, then two and two of what is sorted, also these by ranges. Short
/// lists are sorted as one.
///
/// REQUIRES: no two items are equal, or none can be told from one that is equal; is_before() throws
///           nothing
/// Cost:     O(n log n), and the list's memory
template <class T, class IsBefore>
void sort_by_team(std::vector<T>& list, const IsBefore& is_before, const Team& team) {
  constexpr std::size_t kShort = 1 << 16, kPieces = 32, kRange = 1 << 14;
  if (team.workers() < 2 || list.size() < kShort) {
    std::sort(list.begin(), list.end(), is_before);
    return;
  }
  const std::size_t n = list.size();
  const auto place = [n](std::size_t piece) { return n * piece / kPieces; };
  team.each(kPieces, [&](std::size_t k) {
    std::sort(list.data() + place(k), list.data() + place(k + 1), is_before);
  });
  std::vector<T> merged(n);
  for (std::size_t step = 1; step < kPieces; step *= 2) {
    // Ranges of each pair apart, so that none has items of two.
    const std::size_t ranges = Team::ranges(Team::ranges(n, kPieces) * 2 * step, kRange);
    team.each(kPieces / (2 * step) * ranges, [&](std::size_t k) {
      const std::size_t first = k / ranges * 2 * step;
      const std::size_t low = place(first), middle = place(first + step),
                        high = place(first + 2 * step);
      const std::size_t begin = std::min(high, low + k % ranges * kRange),
                        end = std::min(high, begin + kRange);
      const std::span<const T> all(list);
      merge_range(all.subspan(low, middle - low), all.subspan(middle, high - middle), begin - low,
                  std::span(merged).subspan(begin, end - begin), is_before);
    });
    list.swap(merged);
  }
}

}  // namespace cover
