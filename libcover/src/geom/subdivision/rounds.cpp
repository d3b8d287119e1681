// Tested by tests/unit/geom/subdivision/rounds_test.cpp.
#include "geom/subdivision/rounds.hpp"

#include <array>
#include <bit>
#include <numeric>

#include "base/random.hpp"

namespace cover {

std::vector<std::uint32_t> rounds(std::size_t n) {
  const auto round_of = [](std::uint32_t k) {
    const std::uint64_t mixed = splitmix64((k + std::uint64_t{1}) * kSplitmixStep);
    return 21 - static_cast<std::size_t>(std::countr_zero(mixed)) / 3;
  };
  std::array<std::uint32_t, 23> next{};  // a counting sort by round
  for (std::uint32_t k = 0; k < n; ++k) ++next[round_of(k) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t k = 0; k < n; ++k) order[next[round_of(k)]++] = k;
  return order;
}

}  // namespace cover
