// A minimax problem in the plane whose functions are quotients of quadratics. Two methods in turn:
// - Polyak's subgradient step: the worst triangle alone says in which direction and how far to go
//   so that it would just meet the level. Where the goal can be met this mostly gets there within
//   a few steps.
// - a pattern search around the best place found, with steps halved, for what is left: there two or
// three
//   triangles tie and single gradients mislead. Candidates that are worse are dropped at the
//   first triangle that shows it.
// Tested by tests/unit/quality/cavity_test.cpp.
#include "quality/placement.hpp"

#include <cmath>

namespace cover {
namespace {

constexpr double kMargin = 0.06;  ///< aim this far below the goal, to arrive in finite time
constexpr int kSubgradientSteps = 8;
constexpr int kFailures = 2;         ///< steps that were none, before the gradients are left
constexpr double kFirstStep = 0.25;  ///< of the pattern search, times the distance to the loop
constexpr int kHalvings = 4;
constexpr int kCandidates = 120;  ///< at most, of the pattern search

}  // namespace

Hole::Hole(const MutableMesh& mesh, const Cavity& cavity)
    : goal_(&mesh.goal()), edges_(own_.data()), size_(cavity.size()) {
  for (int k = 0; k < size_; ++k) {
    own_[static_cast<std::size_t>(k)] =
        edge(mesh.points[cavity.vertex(k)], mesh.points[cavity.vertex(cavity.next(k))],
             mesh.allowance(cavity.outer(k)));
  }
}

Hole::Hole(const Goal& goal, std::span<const Edge> edges)
    : goal_(&goal), edges_(edges.data()), size_(static_cast<int>(edges.size())) {}

/// An excess as a quotient: many are compared and few are needed.
struct Hole::Ratio {
  double above, area;
  [[nodiscard]] bool is_inverted() const { return !(area > 0); }
  [[nodiscard]] bool exceeds(double excess) const { return above > excess * area; }
  [[nodiscard]] bool exceeds(const Ratio& other) const {
    return above * other.area > other.above * area;
  }
  [[nodiscard]] double value() const { return above / area; }
};

inline Hole::Ratio Hole::excess_at(const Edge& edge, Point p) const {
  const double ux = edge.ax - p.x, uy = edge.ay - p.y, vx = edge.bx - p.x, vy = edge.by - p.y;
  const double ex = edge.bx - edge.ax, ey = edge.by - edge.ay;
  const double area = ux * vy - uy * vx;
  const double apex = ux * vx + uy * vy, at_a = -(ux * ex + uy * ey), at_b = vx * ex + vy * ey;
  const double most = std::max(apex, std::max(at_a, at_b));
  const double large = std::max(-apex - edge.large * area, -std::min(at_a, at_b));
  const double small = goal_->weight * (most - (goal_->small + edge.small) * area);
  return {std::max(large - goal_->large * area, small), area};
}

double Hole::worst(Point p, double limit) const {
  Ratio worst{-kInverted, 1};
  for (const Edge& edge : edges()) {
    const Ratio here = excess_at(edge, p);
    if (here.is_inverted()) return kInverted;
    if (here.exceeds(limit)) return here.value();
    if (here.exceeds(worst)) worst = here;
  }
  return worst.value();
}

int Hole::worst_edge(Point p, const std::array<bool, Cavity::kCapacity>& skip) const {
  int result = -1;
  Ratio worst{-kInverted, 1};
  for (int k = 0; k < size_; ++k) {
    if (skip[static_cast<std::size_t>(k)]) continue;
    const Ratio here = excess_at(edges_[k], p);
    if (here.is_inverted()) return k;
    if (!here.exceeds(worst)) continue;
    worst = here;
    result = k;
  }
  return result;
}

Vector Hole::step_to(Point p, double level, double& value) const {
  value = kInverted;
  Ratio worst{-kInverted, 1};
  const Edge* at = nullptr;
  for (const Edge& edge : edges()) {
    const Ratio here = excess_at(edge, p);
    if (here.is_inverted()) return {};
    if (!here.exceeds(worst)) continue;
    worst = here;
    at = &edge;
  }
  if (at == nullptr) return {};
  value = worst.value();
  const Vector slope = slope_at(*at, p);
  const double size = squared_length(slope);
  return size > 0 ? ((level - value) / size) * slope : Vector{};
}

Vector Hole::slope_at(const Edge& edge, Point p) const {
  const Point a = edge.a(), b = edge.b();
  const Vector u = a - p, v = b - p, e = b - a;
  const double area = cross(u, v);
  // The excess is (factor dot - ...) / area with one of six dot products and factors.
  const double dots[3] = {dot(u, v), -dot(u, e), dot(v, e)};
  const Vector of_dots[3] = {-1.0 * (u + v), e, -1.0 * e};
  double most = -kInverted, factor = 0;
  int corner = 0;
  for (int i = 0; i < 3; ++i) {
    const double large = -dots[i] - (goal_->large + (i == 0 ? edge.large : 0)) * area;
    const double small = goal_->weight * (dots[i] - (goal_->small + edge.small) * area);
    if (large <= most && small <= most) continue;
    most = std::max(large, small);
    factor = large > small ? -1 : goal_->weight;
    corner = i;
  }
  const double cot = dots[corner] / area;
  return (factor / area) * (of_dots[corner] - cot * left_normal(e));
}

double Hole::shortest_spoke(Point p) const {
  double shortest = kInverted;
  for (std::size_t k = 0; k < static_cast<std::size_t>(size_); ++k) {
    shortest = std::min(shortest, squared_length(edges_[k].a() - p));
  }
  return std::sqrt(shortest);
}

Point Hole::centre() const {
  Vector sum;
  for (std::size_t k = 1; k < static_cast<std::size_t>(size_); ++k) {
    sum = sum + (edges_[k].a() - edges_[0].a());
  }
  return edges_[0].a() + (1.0 / size_) * sum;
}

namespace {

/// Polyak's steps from `best.at`.
void follow_gradients(const Hole& hole, Placement& best, std::uint64_t& evaluations) {
  Point p = best.at;
  double share = 1;
  int failures = 0;
  for (int k = 0; k < kSubgradientSteps; ++k) {
    double value = kInverted;
    const Vector step = hole.step_to(p, -kMargin, value);
    ++evaluations;
    if (value < best.worst) {
      best = {p, value};
      if (value <= 0) return;
    } else {
      share /= 2;
      if (k == 0 || ++failures == kFailures)
        return;  // k = 0: the start does not see all of the loop
    }
    p = value == kInverted ? midpoint(p, best.at) : p + share * step;
  }
}

/// Four directions around `best.at`, along the axes and the diagonals in turn; the step is halved
/// where none of them is better.
void search_around(const Hole& hole, Placement& best, std::uint64_t& evaluations) {
  constexpr double kDiagonal = 0.7071067811865476;
  constexpr Vector kDirections[] = {
      {1, 0},  {kDiagonal, kDiagonal},   {0, 1},  {-kDiagonal, kDiagonal},
      {-1, 0}, {-kDiagonal, -kDiagonal}, {0, -1}, {kDiagonal, -kDiagonal}};
  double step = kFirstStep * hole.shortest_spoke(best.at);
  int first = 0, left = kCandidates;
  for (int halvings = 0; halvings <= kHalvings && left > 0;) {
    bool better = false;
    for (int d = 0; d < 8 && !better; d += 2) {
      const int direction = (first + d + halvings % 2) % 8;
      const Point p = best.at + step * kDirections[direction];
      const double value = hole.worst(p, best.worst);
      ++evaluations;
      --left;
      if (!(value < best.worst)) continue;
      best = {p, value};
      if (value <= 0) return;
      first = direction;  // go on that way
      better = true;
    }
    if (better) continue;
    step /= 2;
    ++halvings;
  }
}

}  // namespace

Placement place(const Hole& hole, Point start, double promising, std::uint64_t& evaluations) {
  Placement best{start, kInverted};
  follow_gradients(hole, best, evaluations);
  if (best.worst > 0 && best.worst < promising) search_around(hole, best, evaluations);
  return best;
}

}  // namespace cover
