// Arrays of pairs of numbers in JSON: points, and segments by their ends.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <cover/point.hpp>

#include "base/team.hpp"

namespace cover {

/// The point that `[x, y]` stands for, with the doubles that a tree of it would have; nothing for
/// all else, which is not always an error.
///
/// Cost: some 0.05 us, a tenth of what a tree takes, and no memory
std::optional<Point> read_pair(std::string_view element);

/// The same for a pair of integers.
std::optional<std::array<long, 2>> read_integer_pair(std::string_view element);

/// The pairs that an array begins with.
template <class Number>
struct Pairs {
  std::vector<std::vector<std::array<Number, 2>>> ranges;  ///< one after the other
  std::size_t size = 0;
  std::size_t end = 0;     ///< where in the text the first other element begins, or the "]"
  bool is_closed = false;  ///< whether that is the array's "]", right behind a pair

  /// Calls `use` with the number of each pair and the pair, ranges at a time.
  template <class Use>
  void for_each(const Team& team, const Use& use) const {
    std::vector<std::size_t> first{0};
    for (const auto& range : ranges) first.push_back(first.back() + range.size());
    team.each(ranges.size(), [&](std::size_t r) {
      for (std::size_t k = 0; k < ranges[r].size(); ++k) use(first[r] + k, ranges[r][k]);
    });
  }
};

/// Reads the pairs that an array begins with, by ranges of the text; what is no such pair, whether
/// right or wrong, is left to whoever reads on from `end`. `begin` is the place behind the "[".
template <class Number>
Pairs<Number> read_pairs(std::string_view text, std::size_t begin, const Team& team);

extern template Pairs<double> read_pairs(std::string_view, std::size_t, const Team&);
extern template Pairs<long> read_pairs(std::string_view, std::size_t, const Team&);

}  // namespace cover
