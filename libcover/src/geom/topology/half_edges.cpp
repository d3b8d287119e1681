// A counting sort by source vertex, then a small sort around each vertex: linear for meshes, and
// n log n for a hub that all triangles share. Nothing is hashed, so nothing depends on a hash.
// Several threads deal half-edges out by spans of vertices first, which have nothing in common.
#include "geom/topology/half_edges.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <tuple>
#include <utility>

namespace cover {

namespace {

constexpr std::size_t kSpans = 128;  // of vertices: enough for some tens of threads

/// Whether several threads are to divide so much work.
bool is_for_team(const Team& team, std::span<const IndexTriple> triangles) {
  return team.workers() > 1 && triangles.size() > 2 * kItemsAtATime;
}

/// Half-edges by spans of vertices, in each span in the order of their numbers.
struct Dealt {
  std::vector<std::uint32_t> half_edges;
  std::size_t vertices_of_span = 1;
  std::vector<std::uint32_t> first_of_span;  ///< in half_edges; and the end
};

/// `vertex_of(a, b)` is that end of the half-edge from a to b by which it is dealt.
template <class VertexOf>
Dealt deal(std::size_t vertices, std::span<const IndexTriple> triangles, const VertexOf& vertex_of,
           const Team& team) {
  Dealt dealt;
  std::size_t bits = 0;
  while ((vertices >> bits) >= kSpans) ++bits;
  dealt.vertices_of_span = std::size_t{1} << bits;
  const std::size_t ranges = Team::ranges(triangles.size(), kItemsAtATime);
  std::vector<std::array<std::uint32_t, kSpans>> place(ranges);  // of the next half-edge
  const auto for_each = [&](std::size_t first, std::size_t last, const auto& use) {
    for (std::size_t t = first; t < last; ++t) {
      const auto& [a, b, c] = triangles[t];
      const auto h = static_cast<std::uint32_t>(3 * t);
      use(vertex_of(a, b) >> bits, h);
      use(vertex_of(b, c) >> bits, h + 1);
      use(vertex_of(c, a) >> bits, h + 2);
    }
  };
  team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    auto& counts = place[first / kItemsAtATime];
    for_each(first, last, [&](std::size_t span, std::uint32_t) { ++counts[span]; });
  });
  std::uint32_t sum = 0;
  for (std::size_t span = 0; span < kSpans; ++span) {
    dealt.first_of_span.push_back(sum);
    for (auto& counts : place) sum += std::exchange(counts[span], sum);
  }
  dealt.first_of_span.push_back(sum);
  dealt.half_edges.resize(3 * triangles.size());
  team.each_range(triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    auto& next = place[first / kItemsAtATime];
    for_each(first, last,
             [&](std::size_t span, std::uint32_t h) { dealt.half_edges[next[span]++] = h; });
  });
  return dealt;
}

}  // namespace

HalfEdges::HalfEdges(std::size_t vertices, std::span<const IndexTriple> triangles, const Team& team)
    : triangles_(triangles), first_(vertices + 2, 0), sorted_(3 * triangles.size()) {
  if (is_for_team(team, triangles)) {
    sort_by_spans(team);
  } else {
    sort_all();
  }
}

void HalfEdges::sort_all() {
  for (const IndexTriple& t : triangles_) {
    for (const std::uint32_t v : t) ++first_[v + 2];
  }
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  // first_[v + 1] is where the next entry of v goes; in the end it is where v + 1 begins.
  for (std::uint32_t h = 0; h < sorted_.size(); ++h)
    sorted_[first_[source(h) + 1]++] = {target(h), h};
  for (std::size_t v = 0; v + 2 < first_.size(); ++v) sort_around(v);
}

/// The same, span by span.
void HalfEdges::sort_by_spans(const Team& team) {
  const std::size_t vertices = first_.size() - 2;
  const Dealt dealt = deal(
      vertices, triangles_, [](std::uint32_t from, std::uint32_t) { return from; }, team);
  const std::span<const std::uint32_t> all = dealt.half_edges;
  team.each_range(vertices, dealt.vertices_of_span, [&](std::size_t first, std::size_t last) {
    const std::size_t span = first / dealt.vertices_of_span;
    const std::uint32_t begin = dealt.first_of_span[span], end = dealt.first_of_span[span + 1];
    std::vector<std::uint32_t> next(last - first + 1, 0);
    for (const std::uint32_t h : all.subspan(begin, end - begin)) ++next[source(h) - first + 1];
    next[0] = begin;
    for (std::size_t k = 1; k < next.size(); ++k) next[k] += next[k - 1];
    std::copy(next.begin(), next.end() - 1, first_.data() + first);
    for (const std::uint32_t h : all.subspan(begin, end - begin))
      sorted_[next[source(h) - first]++] = {target(h), h};
  });
  first_[vertices] = first_[vertices + 1] = size();
  team.each_range(vertices, dealt.vertices_of_span, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) sort_around(v);
  });
}

void HalfEdges::sort_around(std::size_t vertex) {
  std::sort(sorted_.begin() + first_[vertex], sorted_.begin() + first_[vertex + 1],
            [](const Entry& a, const Entry& b) {
              return std::tie(a.target, a.half_edge) < std::tie(b.target, b.half_edge);
            });
}

std::uint32_t HalfEdges::find(std::uint32_t a, std::uint32_t b) const {
  const auto end = sorted_.begin() + first_[a + 1];
  const auto found = std::lower_bound(sorted_.begin() + first_[a], end, b,
                                      [](const Entry& e, std::uint32_t v) { return e.target < v; });
  return found != end && found->target == b ? found->half_edge : kNone;
}

bool HalfEdges::all_different(const Team& team) const {
  std::atomic<bool> all_differ = true;
  team.each_range(sorted_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = std::max<std::size_t>(first, 1); k < last; ++k) {
      if (sorted_[k - 1].target == sorted_[k].target &&
          source(sorted_[k - 1].half_edge) == source(sorted_[k].half_edge)) {
        all_differ = false;
        return;
      }
    }
  });
  return all_differ;
}

namespace {

/// Lists are left for sorting where so many of their links were passed on average: at hubs.
constexpr std::size_t kPassedPerHalfEdge = 16;

/// O(n log n), whatever vertices have in common.
std::vector<std::uint32_t> sorted_opposites(std::size_t vertices,
                                            std::span<const IndexTriple> triangles,
                                            const Team& team) {
  const HalfEdges half_edges(vertices, triangles, team);
  std::vector<std::uint32_t> opposite(3 * triangles.size());
  team.each_range(opposite.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (auto h = static_cast<std::uint32_t>(first); h < last; ++h)
      opposite[h] = half_edges.twin(h);
  });
  return opposite;
}

/// Half-edges that wait for their opposite hang on the lower one of their ends, in a list whose
/// links stand where the opposite will.
class Pairing {
 public:
  Pairing(std::size_t vertices, std::span<const IndexTriple> triangles)
      : triangles_(triangles), waiting_(vertices, kNone), opposite_(3 * triangles.size()) {}

  /// Takes half-edges, all that have one of some vertices for their lower end; `half_edge(k)` is
  /// one of them. False if lists are so long that sorting takes less.
  template <class HalfEdge>
  bool take(std::size_t count, const HalfEdge& half_edge) {
    std::size_t passed = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t h = half_edge(k), a = source(h), b = source(HalfEdges::next(h));
      std::uint32_t& list = waiting_[std::min(a, b)];
      std::uint32_t* link = &list;
      while (*link != kNone && (source(*link) != b || source(HalfEdges::next(*link)) != a)) {
        link = &opposite_[*link];
        ++passed;
      }
      if (passed > kPassedPerHalfEdge * opposite_.size()) return false;
      if (*link == kNone) {
        opposite_[h] = std::exchange(list, h);
      } else {
        opposite_[h] = *link;
        *link = std::exchange(opposite_[*link], h);
      }
    }
    return true;
  }
  /// What waits at vertices from `first` to before `last` does so in vain.
  void end(std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      for (std::uint32_t h = waiting_[v]; h != kNone;) h = std::exchange(opposite_[h], kNone);
    }
  }
  [[nodiscard]] std::vector<std::uint32_t> opposites() { return std::move(opposite_); }

 private:
  [[nodiscard]] std::uint32_t source(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }

  std::span<const IndexTriple> triangles_;
  std::vector<std::uint32_t> waiting_, opposite_;
};

}  // namespace

std::vector<std::uint32_t> opposite_half_edges(std::size_t vertices,
                                               std::span<const IndexTriple> triangles,
                                               const Team& team) {
  Pairing pairing(vertices, triangles);
  std::atomic<bool> is_good = true;
  if (is_for_team(team, triangles)) {
    const Dealt dealt = deal(
        vertices, triangles, [](std::uint32_t a, std::uint32_t b) { return std::min(a, b); }, team);
    team.each_range(vertices, dealt.vertices_of_span, [&](std::size_t first, std::size_t last) {
      const std::size_t span = first / dealt.vertices_of_span;
      const std::uint32_t begin = dealt.first_of_span[span];
      if (pairing.take(dealt.first_of_span[span + 1] - begin,
                       [&](std::size_t k) { return dealt.half_edges[begin + k]; })) {
        pairing.end(first, last);
      } else {
        is_good = false;
      }
    });
  } else if (pairing.take(3 * triangles.size(),
                          [](std::size_t k) { return static_cast<std::uint32_t>(k); })) {
    pairing.end(0, vertices);
  } else {
    is_good = false;
  }
  return is_good ? pairing.opposites() : sorted_opposites(vertices, triangles, team);
}

}  // namespace cover
