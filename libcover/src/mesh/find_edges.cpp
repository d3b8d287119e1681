// Pairs are sorted by their lower vertex, then by the upper one; each half-edge looks itself up.
// Tested by tests/unit/mesh/stitch_test.cpp.
#include "mesh/find_edges.hpp"

#include <algorithm>
#include <atomic>

#include "base/none.hpp"
#include "geom/topology/corner.hpp"

namespace cover {
namespace {

using Ends = std::array<std::uint32_t, 2>;

std::uint32_t lower(const Ends& pair) { return std::min(pair[0], pair[1]); }
std::uint32_t upper(const Ends& pair) { return std::max(pair[0], pair[1]); }

/// Keeps the larger of half-edges that several threads find. "None" is the largest number, and one
/// more than that is 0.
void keep_last(std::uint32_t h, std::uint32_t& kept) {
  const std::atomic_ref shared(kept);
  std::uint32_t other = shared.load(std::memory_order_relaxed);
  while (other + 1 < h + 1 && !shared.compare_exchange_weak(other, h, std::memory_order_relaxed)) {
  }
}

}  // namespace

std::vector<std::uint32_t> find_edges(std::size_t vertices, std::span<const IndexTriple> triangles,
                                      std::span<const Ends> pairs, const Team& team) {
  std::vector<std::uint32_t> first(vertices + 2, 0);
  const auto may_be = [&](const Ends& pair) { return lower(pair) < vertices; };
  for (const Ends& pair : pairs) {
    if (may_be(pair)) ++first[lower(pair) + std::size_t{2}];
  }
  for (std::size_t v = 2; v < first.size(); ++v) first[v] += first[v - 1];
  // first[v + 1] is where the next pair of v goes; in the end it is where v + 1 begins.
  std::vector<std::uint32_t> sorted(first.back());
  for (std::uint32_t k = 0; k < pairs.size(); ++k) {
    if (may_be(pairs[k])) sorted[first[lower(pairs[k]) + std::size_t{1}]++] = k;
  }
  team.each_range(vertices, kItemsAtATime, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::sort(
          sorted.begin() + first[v], sorted.begin() + first[v + 1],
          [&](std::uint32_t j, std::uint32_t k) { return upper(pairs[j]) < upper(pairs[k]); });
    }
  });
  std::vector<std::uint32_t> found(pairs.size(), kNone);
  const auto look_at = [&](const Ends& edge, std::uint32_t h) {
    if (!may_be(edge)) return;
    const auto end = sorted.begin() + first[lower(edge) + std::size_t{1}];
    auto k = std::lower_bound(
        sorted.begin() + first[lower(edge)], end, upper(edge),
        [&](std::uint32_t pair, std::uint32_t v) { return upper(pairs[pair]) < v; });
    for (; k != end && upper(pairs[*k]) == upper(edge); ++k) keep_last(h, found[*k]);
  };
  team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t begin, std::size_t end) {
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
      for (const Corner i : kCorners) look_at({triangles[t][i], triangles[t][i.next()]}, 3 * t + i);
    }
  });
  return found;
}

}  // namespace cover
