// Tested by tests/unit/geom/subdivision/rounds_test.cpp.
#include "geom/subdivision/rounds.hpp"

#include <array>
#include <bit>
#include <numeric>

namespace cover {

std::vector<std::uint32_t> rounds(std::size_t n) {
  const auto round_of = [](std::uint32_t k) {
    std::uint64_t mixed = (k + std::uint64_t{1}) * 0x9E3779B97F4A7C15U;  // splitmix64
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EBU;
    return 21 - static_cast<std::size_t>(std::countr_zero(mixed ^ mixed >> 31)) / 3;
  };
  std::array<std::uint32_t, 23> next{};  // a counting sort by round
  for (std::uint32_t k = 0; k < n; ++k) ++next[round_of(k) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t k = 0; k < n; ++k) order[next[round_of(k)]++] = k;
  return order;
}

}  // namespace cover
