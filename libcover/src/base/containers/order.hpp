// The numbers 0, 1, 2, ... in another order, and lists put into it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <ranges>
#include <vector>

namespace cover {

/// The numbers below `n` in the order of `less`. Of equal ones the lower comes first.
template <class Number = std::uint32_t, class Less>
std::vector<Number> sorted_numbers(std::size_t n, Less less) {
  std::vector<Number> order(n);
  std::iota(order.begin(), order.end(), Number{0});
  std::stable_sort(order.begin(), order.end(), less);
  return order;
}

/// Sorts `list`, and leaves one of equal elements.
template <class List>
void sort_unique(List& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// The elements of `list` that `order` names, in that order.
template <class List, class Number>
std::vector<std::ranges::range_value_t<List>> in_order(const List& list,
                                                       const std::vector<Number>& order) {
  std::vector<std::ranges::range_value_t<List>> out;
  out.reserve(order.size());
  for (const Number k : order) out.push_back(list[k]);
  return out;
}

/// By number: where it stands in `order`.
///
/// REQUIRES: `order` has each number below its size once
inline std::vector<std::uint32_t> places_in(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  return place;
}

}  // namespace cover
