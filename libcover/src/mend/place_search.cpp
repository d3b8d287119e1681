// Tested by tests/unit/mend/place_search_test.cpp.
#include "mend/place_search.hpp"

#include <cmath>

#include "base/containers/order.hpp"
#include "geom/foot.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr int kProjections = 4;     ///< rims on which a place is improved
constexpr int kCycles = 3;          ///< over the edges of one rim
constexpr double kBeyond = 1.02;    ///< of a projection
constexpr std::size_t kMovers = 8;  ///< vertices around a bad triangle that are moved
constexpr double kCheaper = 1e-12;  ///< of the cost: less is rounding

/// No triangle is bad then: places that are tried after it are wasted.
bool is_best_of_all(const VertexPlace& place) { return place.cost < kCheaper; }

}  // namespace

void PlaceSearch::add_one(std::uint32_t t, std::span<const Point> starts, VertexPlace& best) {
  std::vector<Point> all = starts_around(t);
  all.insert(all.end(), starts.begin(), starts.end());
  try_all(all, t, kNone, best);
  const MeshWithUndo::Triangle now = mesh_.triangles()[t];
  for (const Corner i : kCorners) {
    if (now.line[i] != JoinedMesh::kInside)
      improve(mesh_.on_line(mesh_.at(now.v[i]), t, i), kNone, best);
  }
}

void PlaceSearch::move_one(std::uint32_t t, std::span<const std::uint32_t> stays,
                           VertexPlace& best) {
  std::vector<Point> starts = starts_around(t);
  starts.insert(starts.begin(), Point{});
  for (const std::uint32_t u : movers(t)) {
    if (is_best_of_all(best)) return;
    if (std::find(stays.begin(), stays.end(), u) != stays.end()) continue;
    const std::size_t mark = mesh_.mark();
    const MeshWithUndo::Vertex old = mesh_.vertices()[u];
    left_.spend(kRemoval);
    if (mesh_.remove(u)) {
      starts[0] = old.at;
      const std::uint32_t from = a_triangle_written_since(mark);
      if (old.line == JoinedMesh::kInside) {
        try_all(starts, from, u, best);
      } else {
        try_on_line(starts, old.line, mark, u, best);
      }
    }
    mesh_.undo(mark);
  }
}

/// The foot of the blunt corner, the centroid, the middle of the longest edge and a place over it.
std::vector<Point> PlaceSearch::starts_around(std::uint32_t t) const {
  const std::array<std::uint32_t, 3>& v = mesh_.triangles()[t].v;
  const std::array<Point, 3> p{mesh_.at(v[0]), mesh_.at(v[1]), mesh_.at(v[2])};
  const auto across = [&](Corner i) { return squared_length(p[i.previous()] - p[i.next()]); };
  const Corner i = across(0) >= across(1) && across(0) >= across(2) ? 0U
                   : across(1) >= across(2)                         ? 1U
                                                                    : 2U;
  const Point a = p[i.next()], b = p[i.previous()], c = p[i];
  const Vector ab = b - a;
  const Point foot = a + part_on_line(a, b, c) * ab;
  // On the perpendicular bisector of the longest edge, seen at a right angle from beyond.
  const Vector n = left_normal(ab);
  const Point m = midpoint(a, b);
  const double side = cross(ab, c - a) > 0 ? -0.5 : 0.5;
  return {foot, centroid(c, a, b), m + side * n, m};
}

/// Corners of `t` and of its neighbours that may be moved.
std::vector<std::uint32_t> PlaceSearch::movers(std::uint32_t t) const {
  std::vector<std::uint32_t> found;
  const auto add = [&](std::uint32_t s) {
    for (const std::uint32_t v : mesh_.triangles()[s].v) {
      if (mesh_.is_movable(v) && std::find(found.begin(), found.end(), v) == found.end())
        found.push_back(v);
    }
  };
  add(t);
  for (const std::uint32_t n : mesh_.triangles()[t].n) {
    if (n != kNone) add(n);
  }
  if (found.size() > kMovers) found.resize(kMovers);
  return found;
}

/// From `starts`, looked for from triangle `from` on.
void PlaceSearch::try_all(std::span<const Point> starts, std::uint32_t from, std::uint32_t vertex,
                          VertexPlace& best) {
  for (const Point& start : starts) improve(mesh_.locate(start, from), vertex, best);
}

/// The same on the piece of `line` that was made whole since `mark`.
void PlaceSearch::try_on_line(std::span<const Point> starts, std::uint32_t line, std::size_t mark,
                              std::uint32_t vertex, VertexPlace& best) {
  std::vector<std::uint32_t> all = mesh_.written_since(mark);
  sort_unique(all);
  for (const std::uint32_t t : all) {
    const MeshWithUndo::Triangle triangle = mesh_.triangles()[t];
    if (triangle.v[0] == kNone) continue;
    for (const Corner i : kCorners) {
      if (triangle.line[i] != line) continue;
      for (const Point& start : starts) improve(mesh_.on_line(start, t, i), vertex, best);
      improve(mesh_.on_line(mesh_.at(triangle.v[i]), t, i), vertex, best);
      return;
    }
  }
}

/// Moves a place to where fewer triangles around it are bad.
void PlaceSearch::improve(Spot spot, std::uint32_t vertex, VertexPlace& best) {
  if (is_best_of_all(best)) return;
  const double cost = mesh_.cost();
  for (int k = 0; k <= kProjections && spot.triangle != kNone; ++k) {
    left_.spend(1);
    const double then = cost + mesh_.change_with(spot, best.cost - cost);
    if (!std::isfinite(then)) return;
    if (then < best.cost - kCheaper) best = {then, vertex, spot};
    if (then < kCheaper || k == kProjections) return;
    const Point p = projected(spot);
    spot = spot.edge.has_value() ? mesh_.on_line(p, spot.triangle, *spot.edge)
                                 : mesh_.locate(p, spot.triangle);
  }
}

/// `spot`, moved towards where all triangles on its rim would be good.
Point PlaceSearch::projected(const Spot& spot) const {
  Point p = spot.at;
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    const Point before = p;
    for (const RimEdge& e : mesh_.rim()) {
      const Point a = mesh_.at(e.a), b = mesh_.at(e.b);
      const Vector ab = b - a;
      const double length2 = squared_length(ab), product = dot(p - a, ab);
      if (product < 0) p = p + (-(product / length2) * kBeyond) * ab;
      if (product > length2) p = p + ((1 - product / length2) * kBeyond) * ab;
      const Point m = midpoint(a, b);
      const double far2 = squared_length(p - m);
      if (far2 < length2 / 4 && far2 > 0)
        p = m + (kBeyond * std::sqrt(length2 / 4 / far2)) * (p - m);
    }
    if (spot.edge.has_value()) p = mesh_.on_line(p, spot.triangle, *spot.edge).at;
    if (p == before) break;  // nothing is violated
  }
  return p;
}

/// A triangle that is there and was written since `mark`.
std::uint32_t PlaceSearch::a_triangle_written_since(std::size_t mark) const {
  for (const std::uint32_t t : mesh_.written_since(mark)) {
    if (mesh_.triangles()[t].v[0] != kNone) return t;
  }
  return kNone;
}

}  // namespace cover
