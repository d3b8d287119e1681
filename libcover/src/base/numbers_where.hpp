// A search through a list by several threads.
// Tested by tests/unit/base/numbers_where_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/team.hpp"

namespace cover {

/// The numbers below `count` for which `is` holds, ascending.
///
/// REQUIRES: `is` may be asked by several threads at a time
template <class Is>
std::vector<std::uint32_t> numbers_where(std::size_t count, const Is& is, const Team& team) {
  std::vector<std::vector<std::uint32_t>> found(Team::ranges(count, kItemsAtATime));
  team.each_range(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t>& here = found[first / kItemsAtATime];
    for (std::size_t k = first; k < last; ++k) {
      if (is(static_cast<std::uint32_t>(k))) here.push_back(static_cast<std::uint32_t>(k));
    }
  });
  std::vector<std::uint32_t> all;
  for (const std::vector<std::uint32_t>& here : found)
    all.insert(all.end(), here.begin(), here.end());
  return all;
}

}  // namespace cover
