// What triangles or sides come to by region, found by several threads.
// Tested by tests/unit/verify/by_region_test.cpp.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <cover/ids.hpp>

#include "base/team.hpp"

namespace cover {

/// Calls add(value, k) for each k below `count`, with values that begin as `none` and are of
/// region_of(k) alone; then merge(values[region], value) for these, in the order of the k. What is
/// in the void is left out.
///
/// REQUIRES: `add` may be called by several threads at a time; to merge two values is to have added
///           what was added to either, in this order
/// Cost:     O(count); memory for a value wherever the region changes from one k to the next
template <class Value, class RegionOf, class Add, class Merge>
void fold_by_region(std::size_t count, const RegionOf& region_of, const Value& none, const Add& add,
                    const Merge& merge, std::vector<Value>& values, const Team& team) {
  using Run = std::pair<RegionId, Value>;
  std::vector<std::vector<Run>> runs(Team::ranges(count, kFewAtATime));
  team.each_range(count, kFewAtATime, [&](std::size_t first, std::size_t last) {
    std::vector<Run>& here = runs[first / kFewAtATime];
    for (std::size_t k = first; k < last; ++k) {
      const RegionId region = region_of(k);
      if (region == kVoid) continue;
      if (here.empty() || here.back().first != region) here.emplace_back(region, none);
      add(here.back().second, k);
    }
  });
  for (const std::vector<Run>& here : runs) {
    for (const auto& [region, value] : here) merge(values[region.index()], value);
  }
}

}  // namespace cover
