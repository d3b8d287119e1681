// See restar.hpp.
#include "quality/moves/restar.hpp"

#include <algorithm>

#include "geom/vector.hpp"
#include "quality/optimum/placement.hpp"

namespace cover {
namespace {

constexpr int kLargestCavity = 4;  ///< triangles: larger ones succeed once in thirty times,
/// but for those that a new vertex needs. With 6 a few cells of 2,000 end otherwise, with 12 none.
constexpr int kLargestDelaunayCavity = 8;

/// Grows the cavity across the edge with the worst triangle among those that can be taken in and
/// whose new vertex `p` sees.
bool grow_towards(Cavity& cavity, Point p, const Hole& hole) {
  std::array<bool, Cavity::kCapacity> tried{};
  for (int count = 0; count < 4; ++count) {
    const int k = hole.worst_edge(p, tried);
    if (k < 0) return false;
    tried[static_cast<std::size_t>(k)] = true;
    if (!cavity.sees_beyond(k, p)) continue;
    if (cavity.grow(k)) return true;
  }
  return false;
}

/// Grows the cavity until it is that of `p` in a Delaunay triangulation, which is all that a star
/// may replace where no coupling may become negative.
///
/// ENSURES: false if `p` would make the coupling of a side negative, or if more triangles are in
///          its way than a star can replace well
bool grow_to_delaunay(const MutableMesh& mesh, Cavity& cavity, Point p) {
  for (int k = 0; k < cavity.size();) {
    const std::uint32_t end = cavity.vertex(cavity.next(k)), beyond = cavity.outer(k);
    const Vector u = mesh.points[cavity.vertex(k)] - p, v = mesh.points[end] - p;
    const double area = cross(u, v);
    if (!(area > 0)) return false;
    const double cot = dot(u, v) / area;
    if (is_side(beyond)) {
      if (cot < mesh.allowance(beyond)->least_cot) return false;
    } else if (cot + mesh.cot_opposite(beyond, end) < 0) {
      if (cavity.triangle_count() == kLargestDelaunayCavity || !cavity.grow(k)) return false;
      k = 0;
      continue;
    }
    ++k;
  }
  return true;
}

/// The middle of the edge of `t` that loop edge i of Cavity::start is.
Point midpoint_of_loop_edge(const MutableMesh& mesh, std::uint32_t t, Corner i) {
  return midpoint(mesh.corner(t, i), mesh.corner(t, i.next()));
}

}  // namespace

bool try_restar(Workplace& work, std::uint32_t t) {
  MutableMesh& mesh = work.mesh;
  Cavity& cavity = work.cavity;
  Cavity best_cavity(mesh);
  Placement best;
  double best_gain = 0;
  for (int i = -1; i < 3; ++i) {
    cavity.start(t);
    if (i >= 0 && !cavity.grow(i)) continue;
    Point p = i < 0 ? Hole(mesh, cavity).centre()
                    : midpoint_of_loop_edge(mesh, t, static_cast<std::uint32_t>(i));
    // In vain in most cases where couplings count: that must be told soon.
    const CouplingGoal& coupling = mesh.goal().coupling;
    if (coupling.strict && coupling.takes_whole_cavities && !grow_to_delaunay(mesh, cavity, p)) {
      ++work.evaluations;
      continue;
    }
    for (;;) {
      const Hole hole(mesh, cavity);
      const double most = improvement_of(cavity.worst());
      Placement placement{p, kInverted};
      ++work.evaluations;
      if (has_room(mesh, cavity, most)) {
        placement = place(hole, p, 0);
        work.evaluations += placement.evaluations;
        if (!(placement.worst < kInverted)) break;
        p = placement.at;
      } else if (hole.worst(p, kInverted) == kInverted) {
        break;
      }
      const double gain = most - placement.worst;
      if (gain > best_gain || (best_gain == 0 && placement.worst < best.worst)) {
        best_cavity = cavity;
        best = placement;
        best_gain = std::max(gain, 0.0);
      }
      if (placement.worst <= 0 || cavity.triangle_count() >= kLargestCavity) break;
      if (!grow_towards(cavity, p, hole)) break;
    }
    if (best_gain > 0 && best.worst <= 0) break;
  }
  if (!(best.worst < kInverted)) return false;
  const double most = improvement_of(best_cavity.worst());
  if (best.worst > 0) {
    best = place(Hole(mesh, best_cavity), best.at, most);
    work.evaluations += best.evaluations;
  }
  if (!(best.worst < most)) return false;
  if (!install_star(mesh, best_cavity, best.at, work.installed)) return false;
  work.look_around_installed();
  return true;
}

}  // namespace cover
