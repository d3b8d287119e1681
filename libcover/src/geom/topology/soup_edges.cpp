// Tested by tests/unit/verify/verify_test.cpp.
#include "geom/topology/soup_edges.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/numbers_where.hpp"
#include "base/sort_by_team.hpp"
#include "geom/topology/half_edges.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

bool is_usable(const TriangleSoup& soup, const std::array<std::uint32_t, 3>& t) {
  const auto is_finite = [&](std::uint32_t v) {
    return v < soup.points.size() && std::isfinite(soup.points[v].x) &&
           std::isfinite(soup.points[v].y);
  };
  return std::all_of(t.begin(), t.end(), is_finite) && t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

}  // namespace

double offset_on_segment(double scale) { return 8 * spacing_at(scale); }

SoupEdges::SoupEdges(const TriangleSoup& soup, const Team& team) : soup_(soup) {
  const auto is_fine = [&](std::uint32_t k) { return is_usable(soup, soup.triangles[k]); };
  unusable_ = numbers_where(
      soup.triangles.size(), [&](std::uint32_t k) { return !is_fine(k); }, team);
  if (unusable_.empty()) {
    sort_edges(HalfEdges(soup.points.size(), soup.triangles, team), {}, team);
  } else {
    const std::vector<std::uint32_t> usable = numbers_where(soup.triangles.size(), is_fine, team);
    std::vector<IndexTriple> triangles;
    for (const std::uint32_t k : usable) triangles.push_back(soup.triangles[k]);
    sort_edges(HalfEdges(soup.points.size(), triangles, team), usable, team);
  }
  by_place_ = numbers_where(
      soup.points.size(), [&](std::uint32_t v) { return first_[v] != first_[v + 1]; }, team);
  sort_by_team(
      by_place_,
      [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(soup.points[a], a) < std::tie(soup.points[b], b);
      },
      team);
}

/// `number_of`, by triangle of `sorted`: its number in the soup; empty if it is the same.
void SoupEdges::sort_edges(const HalfEdges& sorted, std::span<const std::uint32_t> number_of,
                           const Team& team) {
  first_.resize(soup_.points.size() + 1);
  edges_.resize(sorted.size());
  team.each_range(first_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) first_[v] = sorted.first_leaving(v);
  });
  team.each_range(edges_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t h = sorted.in_order(k);
      const std::uint32_t triangle = number_of.empty() ? h / 3 : number_of[h / 3];
      edges_[k] = {sorted.source(h), sorted.target(h), triangle};
    }
  });
}

std::span<const SoupEdges::Edge> SoupEdges::leaving(std::uint32_t vertex) const {
  return all().subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
}

std::optional<std::size_t> SoupEdges::find(std::uint32_t from, std::uint32_t to) const {
  const auto edges = leaving(from);
  const auto it =
      std::partition_point(edges.begin(), edges.end(), [&](const Edge& e) { return e.to < to; });
  if (it == edges.end() || it->to != to) return std::nullopt;
  return first_[from] + static_cast<std::size_t>(it - edges.begin());
}

std::vector<std::uint32_t> SoupEdges::twins(const Team& team) const {
  std::vector<std::uint32_t> twins(edges_.size());
  team.each_range(edges_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto twin = find(edges_[k].to, edges_[k].from);
      twins[k] = twin ? static_cast<std::uint32_t>(*twin) : kNone;
    }
  });
  return twins;
}

std::vector<std::size_t> SoupEdges::along(std::uint32_t from, std::uint32_t to, double offset,
                                          const std::vector<bool>& barred, bool outer,
                                          const Banks& banks) const {
  std::vector<std::size_t> between = along_between(from, to, offset, barred, outer, banks);
  if (!between.empty()) return between;
  return follow({from, to, offset, barred, outer, nullptr});
}

std::vector<std::size_t> SoupEdges::along_between(std::uint32_t from, std::uint32_t to,
                                                  double offset, const std::vector<bool>& barred,
                                                  bool outer, const Banks& banks) const {
  if (soup_.region.size() != soup_.triangles.size()) return {};
  return follow({from, to, offset, barred, outer, &banks});
}

std::vector<std::size_t> SoupEdges::follow(const Way& way) const {
  std::vector<std::size_t> edges;
  for (std::uint32_t at = way.from; at != way.to;) {
    const auto edge = next_of(way, at);
    if (!edge) return {};
    edges.push_back(*edge);
    at = edges_[*edge].to;
  }
  return edges;
}

bool SoupEdges::lies_between(const Edge& edge, const Banks& banks) const {
  if (soup_.region.size() != soup_.triangles.size()) return false;
  if (soup_.region[edge.triangle] != banks.left) return false;
  const auto twin = find(edge.to, edge.from);
  if (twin.has_value() != banks.right.has_value()) return false;
  return !twin || soup_.region[edges_[*twin].triangle] == *banks.right;
}

/// The edge that leaves `at` along a way.
std::optional<std::size_t> SoupEdges::next_of(const Way& way, std::uint32_t at) const {
  const Point origin = soup_.points[way.from], end = soup_.points[way.to];
  const Vector along = end - origin;
  const double tolerance = way.offset * length(along);
  std::optional<std::size_t> best;
  double best_slope = 0;
  for (std::size_t k = first_[at]; k < first_[at + 1]; ++k) {
    const std::uint32_t next = edges_[k].to;
    if (next != way.to && way.barred[next]) continue;
    if (way.outer && find(next, at)) continue;
    const Point p = soup_.points[next];
    const Vector step = p - soup_.points[at];
    if (dot(step, along) <= 0 || std::abs(cross(along, p - origin)) > tolerance) continue;
    if (next != way.to && dot(end - p, along) <= 0) continue;
    if (way.banks != nullptr && !lies_between(edges_[k], *way.banks)) continue;
    const double slope = std::abs(cross(along, step)) / length(step);
    if (best && slope >= best_slope) continue;
    best = k;
    best_slope = slope;
  }
  return best;
}

std::optional<std::uint32_t> SoupEdges::vertex_at(Point p) const {
  const auto it = std::partition_point(by_place_.begin(), by_place_.end(),
                                       [&](std::uint32_t v) { return soup_.points[v] < p; });
  if (it == by_place_.end() || soup_.points[*it] != p) return std::nullopt;
  return *it;
}

std::vector<std::array<std::uint32_t, 2>> SoupEdges::doubles(const Team& team) const {
  const auto place = [&](std::uint32_t k) { return soup_.points[by_place_[k]]; };
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const std::uint32_t k : numbers_where(
           by_place_.size(), [&](std::uint32_t k) { return k > 0 && place(k - 1) == place(k); },
           team))
    pairs.push_back({by_place_[k - 1], by_place_[k]});
  return pairs;
}

}  // namespace cover
