// cot a + cot b = sin(a + b) / (sin a sin b), so the sum is negative just where a + b is above 180
// degrees: where each of the two triangles has the other's corner inside its circle.
// Tested by tests/unit/cdt/couplings_test.cpp.
#include "cdt/couplings.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "geom/predicates.hpp"

namespace cover {

std::vector<std::uint32_t> across_edges(std::size_t points, std::span<const IndexTriple> triangles,
                                        std::span<const IndexPair> sides, const Team& team) {
  std::vector<std::uint32_t> across = opposite_half_edges(points, triangles, team);
  std::atomic<std::ptrdiff_t> outer = 0;
  team.each_range(across.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
    outer += std::count(across.data() + first, across.data() + last, kNone);
  });
  if (outer == static_cast<std::ptrdiff_t>(sides.size())) return across;
  const HalfEdges half_edges(points, triangles, team);  // slits have triangles on both sides
  for (const auto& [a, b] : sides) {
    const std::uint32_t h = half_edges.find(a, b);
    if (h != kNone) across[h] = kNone;
  }
  return across;
}

std::size_t make_delaunay(std::span<const Point> points, std::vector<IndexTriple>& triangles,
                          std::span<const IndexPair> sides,
                          const std::function<bool(const IndexTriple&)>& is_allowed) {
  std::vector<std::uint32_t> across = across_edges(points.size(), triangles, sides);
  const auto source = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };
  std::vector<std::uint32_t> stack;
  for (std::uint32_t h = 0; h < across.size(); ++h) stack.push_back(h);
  std::size_t flips = 0;
  while (!stack.empty()) {
    const std::uint32_t h = stack.back();
    stack.pop_back();
    const std::uint32_t twin = across[h];
    if (twin == kNone) continue;
    const std::uint32_t a = source(h), b = source(HalfEdges::next(h)),
                        c = source(HalfEdges::previous(h)), d = source(HalfEdges::previous(twin));
    if (in_circle(points[a], points[b], points[c], points[d]) != Sign::positive) continue;
    if (is_allowed && !(is_allowed({c, a, d}) && is_allowed({d, b, c}))) continue;
    // d inside the circle and beyond ab: the four corners are those of a convex quadrilateral.
    const std::uint32_t t = h / 3, u = twin / 3;
    const std::uint32_t ca = across[HalfEdges::previous(h)], ad = across[HalfEdges::next(twin)];
    const std::uint32_t db = across[HalfEdges::previous(twin)], bc = across[HalfEdges::next(h)];
    triangles[t] = {c, a, d};
    triangles[u] = {d, b, c};
    const auto join = [&](std::uint32_t edge, std::uint32_t other) {
      across[edge] = other;
      if (other != kNone) across[other] = edge;
    };
    join(3 * t, ca);
    join(3 * t + 1, ad);
    join(3 * t + 2, 3 * u + 2);
    join(3 * u, db);
    join(3 * u + 1, bc);
    for (const std::uint32_t edge : {3 * t, 3 * t + 1, 3 * u, 3 * u + 1}) stack.push_back(edge);
    ++flips;
  }
  return flips;
}

namespace {

/// Negative edges among those half-edges for which `is_doubtful`.
template <class IsDoubtful>
std::vector<NegativeEdge> negative_among(std::span<const Point> points,
                                         std::span<const IndexTriple> triangles,
                                         std::span<const std::uint32_t> across,
                                         const IsDoubtful& is_doubtful, const Team& team) {
  const auto source = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };
  std::vector<std::vector<NegativeEdge>> found(Team::ranges(across.size(), kManyAtATime));
  const auto look_at = [&](std::uint32_t h, std::vector<NegativeEdge>& own) {
    const std::uint32_t twin = across[h];
    if ((twin != kNone && twin < h) || !is_doubtful(h)) return;
    const std::uint32_t a = source(h), b = source(HalfEdges::next(h)),
                        c = source(HalfEdges::previous(h));
    if (twin == kNone) {
      if (compare_with_90_degrees(points[a], points[c], points[b]) == Sign::positive)
        own.push_back({{a, b}, c, true});
    } else if (in_circle(points[a], points[b], points[c],
                         points[source(HalfEdges::previous(twin))]) == Sign::positive) {
      own.push_back({{a, b}, c, false});
    }
  };
  team.each_range(across.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
    for (auto h = static_cast<std::uint32_t>(first); h < last; ++h)
      look_at(h, found[first / kManyAtATime]);
  });
  std::vector<NegativeEdge> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

/// Up to this size a cotangent in doubles is off by less than 1e-8: differences of coordinates are
/// rounded once, and their cross product is no smaller than a thousandth of the lengths' product.
constexpr double kSureCot = 1e3;
constexpr double kSureSum = 1e-6;

}  // namespace

std::vector<NegativeEdge> negative_edges(std::span<const Point> points,
                                         std::span<const IndexTriple> triangles,
                                         std::span<const IndexPair> sides) {
  return negative_among(
      points, triangles, across_edges(points.size(), triangles, sides),
      [](std::uint32_t) { return true; }, Team());
}

std::vector<NegativeEdge> negative_edges(std::span<const Point> points,
                                         std::span<const IndexTriple> triangles,
                                         std::span<const std::uint32_t> across,
                                         std::span<const double> cots, const Team& team) {
  const auto is_sure = [&](double cot) { return std::abs(cot) < kSureCot; };
  const auto is_doubtful = [&](std::uint32_t h) {
    const std::uint32_t twin = across[h];
    const double other = twin == kNone ? 0 : cots[twin];
    return !(is_sure(cots[h]) && is_sure(other) && cots[h] + other > kSureSum);
  };
  return negative_among(points, triangles, across, is_doubtful, team);
}

}  // namespace cover
