// A counting sort by source vertex, then a small sort around each vertex: linear for meshes, and
// n log n for a hub that all triangles share. Nothing is hashed, so nothing depends on a hash.
#include "geom/topology/half_edges.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cover {

HalfEdges::HalfEdges(std::size_t vertices, std::span<const IndexTriple> triangles)
    : triangles_(triangles), first_(vertices + 2, 0), sorted_(3 * triangles.size()) {
  for (const IndexTriple& t : triangles) {
    for (const std::uint32_t v : t) ++first_[v + 2];
  }
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  // first_[v + 1] is where the next entry of v goes; in the end it is where v + 1 begins.
  for (std::uint32_t h = 0; h < sorted_.size(); ++h)
    sorted_[first_[source(h) + 1]++] = {target(h), h};
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(sorted_.begin() + first_[v], sorted_.begin() + first_[v + 1],
              [](const Entry& a, const Entry& b) {
                return std::tie(a.target, a.half_edge) < std::tie(b.target, b.half_edge);
              });
  }
}

std::uint32_t HalfEdges::find(std::uint32_t a, std::uint32_t b) const {
  const auto end = sorted_.begin() + first_[a + 1];
  const auto found = std::lower_bound(sorted_.begin() + first_[a], end, b,
                                      [](const Entry& e, std::uint32_t v) { return e.target < v; });
  return found != end && found->target == b ? found->half_edge : kAbsent;
}

bool HalfEdges::all_different() const {
  for (std::size_t k = 1; k < sorted_.size(); ++k) {
    if (sorted_[k - 1].target == sorted_[k].target &&
        source(sorted_[k - 1].half_edge) == source(sorted_[k].half_edge)) {
      return false;
    }
  }
  return true;
}

namespace {

/// Lists are left for sorting where so many of their links were passed on average: at hubs.
constexpr std::size_t kPassedPerHalfEdge = 16;

/// O(n log n), whatever vertices have in common.
std::vector<std::uint32_t> sorted_opposites(std::size_t vertices,
                                            std::span<const IndexTriple> triangles) {
  const HalfEdges half_edges(vertices, triangles);
  std::vector<std::uint32_t> opposite(3 * triangles.size());
  for (std::uint32_t h = 0; h < opposite.size(); ++h) opposite[h] = half_edges.twin(h);
  return opposite;
}

}  // namespace

std::vector<std::uint32_t> opposite_half_edges(std::size_t vertices,
                                               std::span<const IndexTriple> triangles) {
  constexpr std::uint32_t kAbsent = HalfEdges::kAbsent;
  // Half-edges that wait for their opposite hang on the lower one of their ends, in a list whose
  // links stand where the opposite will.
  std::vector<std::uint32_t> waiting(vertices, kAbsent), opposite(3 * triangles.size());
  const auto source = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };
  const auto target = [&](std::uint32_t h) { return source(HalfEdges::next(h)); };
  std::size_t passed = 0;
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    const std::uint32_t a = source(h), b = target(h);
    std::uint32_t* link = &waiting[std::min(a, b)];
    while (*link != kAbsent && (source(*link) != b || target(*link) != a)) {
      link = &opposite[*link];
      ++passed;
    }
    if (passed > kPassedPerHalfEdge * opposite.size()) return sorted_opposites(vertices, triangles);
    if (*link == kAbsent) {
      opposite[h] = waiting[std::min(a, b)];
      waiting[std::min(a, b)] = h;
    } else {
      opposite[h] = *link;
      *link = std::exchange(opposite[*link], h);
    }
  }
  for (std::uint32_t h : waiting) {  // in vain
    while (h != kAbsent) h = std::exchange(opposite[h], kAbsent);
  }
  return opposite;
}

}  // namespace cover
