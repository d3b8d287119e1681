// If all triangles (side, hub) are counter-clockwise, the boundary winds around the hub once: a
// hole's loop does not wind around a point outside it, so that one of its triangles would be
// clockwise. Tested by tests/unit/quality/starts/one_star_test.cpp.
#include "quality/starts/one_star.hpp"

#include <utility>

#include "geom/predicates.hpp"
#include "quality/optimum/placement.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostSides = 64;  ///< where small angles count

}  // namespace

OneStar one_star(const MutableMesh& mesh, const RegionBoundary& boundary) {
  const std::size_t n = boundary.sides.size();
  if (n < 4 || n != boundary.points.size()) return {};      // isolated points, or pinched
  if (n > kMostSides && mesh.goal().weight > 0) return {};  // small angles at the hub
  std::vector<Hole::Edge> edges;
  edges.reserve(n);
  for (std::size_t s = 0; s < n; ++s) {
    const auto& [a, b] = boundary.sides[s];
    edges.push_back(Hole::edge(mesh.points[a], mesh.points[b], &mesh.allowances[s]));
  }
  const Hole hole(mesh.goal(), edges);
  const Placement hub = place(hole, hole.centre(), kInverted);
  if (hub.worst == kInverted) return {{}, hub.evaluations};
  for (const Hole::Edge& e : edges) {
    if (orientation(e.a(), e.b(), hub.at) != Sign::positive) return {{}, hub.evaluations};
  }

  Triangulation star;
  star.points.assign(mesh.points.begin(), mesh.points.begin() + static_cast<std::ptrdiff_t>(n));
  star.points.push_back(hub.at);
  star.triangles.resize(n);
  std::vector<std::uint32_t> starts_at(n), ends_at(n);
  for (std::uint32_t s = 0; s < n; ++s) {
    starts_at[boundary.sides[s][0]] = s;
    ends_at[boundary.sides[s][1]] = s;
  }
  for (std::uint32_t s = 0; s < n; ++s) {
    const auto& [a, b] = boundary.sides[s];
    star.triangles[s].v = {a, b, static_cast<std::uint32_t>(n)};
    star.triangles[s].n = {starts_at[b], ends_at[a], kNone};
    star.triangles[s].set_locked(2, true);
  }
  return {std::move(star), hub.evaluations};
}

}  // namespace cover
