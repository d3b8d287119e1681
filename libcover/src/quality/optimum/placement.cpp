// A minimax problem in the plane whose functions are quotients of quadratics: sequential linear
// programming. The excesses are made linear at the best place so far, the lowest point of these
// within a trusted distance is tried (minimax.hpp), and that distance grows or shrinks as they
// follow the model or not. Where three triangles tie, which is the rule, this converges fast; a
// pattern search took three times the evaluations and stuck where two triangles tie. What the model
// promises tells early where there is nothing to be had.
// Tested by tests/unit/quality/optimum/placement_test.cpp.
#include "quality/optimum/placement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cover {
namespace {

constexpr double kMargin = 0.1;  ///< aim this far below the goal, to arrive in finite time
constexpr int kModelSteps = 8;
constexpr std::uint64_t kStepCost = 8;  ///< star evaluations in the time of one step
constexpr double kFirstStep = 0.5;      ///< times the distance to the loop
constexpr double kLeastGain = 0.1;      ///< of the excess: less is not worth a step;
constexpr double kLeastGainFar = 0.01;  ///< beyond 140 degrees, where each degree is a large part

}  // namespace

Hole::Hole(const MutableMesh& mesh, const Cavity& cavity)
    : goal_(&mesh.goal()), size_(cavity.size()) {
  edges_ = own_.data();
  const Point* const points = mesh.points.data();
  Point a = points[cavity.vertex(0)];
  for (int k = 0; k < size_; ++k) {
    Edge& own = own_[static_cast<std::size_t>(k)];
    const std::uint32_t end = cavity.vertex(cavity.next(k)), outer = cavity.outer(k);
    const Point b = points[end];
    own = edge(a, b, mesh.allowance(outer));
    a = b;
    if (!goal_->coupling.inside || is_side(outer)) continue;
    const double lowest = -mesh.cot_opposite(outer, end);
    own.least_cot = lowest + kLeastCoupling;
    if (goal_->coupling.strict) own.lowest_cot = lowest;
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
  const double worst = std::max(large - goal_->large * area, small);
  if (!(goal_->coupling.weight > 0) || !(area > 0)) return {worst, area};
  if (apex < edge.lowest_cot * area) return {worst, -1};
  const double coupling = goal_->coupling.weight * (edge.least_cot * area - apex);
  const double beyond =
      kBoundFirst * (-std::min(apex, std::min(at_a, at_b)) - goal_->coupling.bound * area);
  return {std::max(worst, std::max(coupling, beyond)), area};
}

/// The couplings of the edges to the new vertex, from the cotangents at both ends of each edge of
/// the loop, in order.
class Hole::Spokes {
 public:
  struct Cot {
    double value;
    Vector slope;
  };
  template <class Visit>
  void add(const Cot& at_a, const Cot& at_b, Visit visit) {
    if (is_first_) {
      first_b_ = at_b;
    } else {
      join(last_a_, at_b, visit);
    }
    is_first_ = false;
    last_a_ = at_a;
  }
  template <class Visit>
  void finish(Visit visit) const {
    join(last_a_, first_b_, visit);
  }

 private:
  template <class Visit>
  static void join(const Cot& a, const Cot& b, Visit visit) {
    visit(kLeastCoupling - a.value - b.value, -1.0 * (a.slope + b.slope));
  }
  Cot last_a_{}, first_b_{};
  bool is_first_ = true;
};

double Hole::worst(Point p, double most) const {
  Ratio worst{-kInverted, 1};
  for (const Edge& edge : edges()) {
    const Ratio here = excess_at(edge, p);
    if (here.is_inverted()) return kInverted;
    if (here.exceeds(most)) return here.value();
    if (here.exceeds(worst)) worst = here;
  }
  if (!has_spokes()) return worst.value();
  double value = worst.value();
  Spokes spokes;
  const auto look = [&](double excess, Vector) {
    const bool is_negative = goal_->coupling.strict && excess > kLeastCoupling;
    value = std::max(value, is_negative ? kInverted : goal_->coupling.weight * excess);
  };
  for (const Edge& edge : edges()) {
    const Vector u = edge.a() - p, v = edge.b() - p, e = edge.b() - edge.a();
    const double inverse = 1 / cross(u, v);
    spokes.add({-dot(u, e) * inverse, {}}, {dot(v, e) * inverse, {}}, look);
  }
  spokes.finish(look);
  return value;
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

double Hole::linearise(Point p, double most, double reach, double level,
                       LinearPieces& pieces) const {
  pieces.clear();
  double worst = -kInverted;
  const double weight = goal_->weight;
  const CouplingGoal& coupling = goal_->coupling;
  const auto add = [&](double excess, Vector slope) {
    pieces.add_if(excess + reach * (std::abs(slope.x) + std::abs(slope.y)) > level, excess, slope);
  };
  const auto add_weighted = [&](double by, double excess, Vector slope) {
    worst = std::max(worst, by * excess);
    add(by * excess, by * slope);
  };
  const auto add_spoke = [&](double excess, Vector slope) {
    if (coupling.strict && excess > kLeastCoupling) worst = kInverted;
    add_weighted(coupling.weight, excess, slope);
  };
  Spokes spokes;
  for (const Edge& edge : edges()) {
    const Vector u = edge.a() - p, v = edge.b() - p, e = edge.b() - edge.a();
    const double area = cross(u, v);
    if (!(area > 0)) return kInverted;
    const double inverse = 1 / area;
    const Vector across = inverse * left_normal(e);
    // Cotangents at p, a, b, times the area, and how they change with p. Which of them count
    // nobody can predict: they are looked up, without a branch.
    const double dots[3] = {dot(u, v), -dot(u, e), dot(v, e)};
    const Vector of_dots[3] = {-1.0 * (u + v), e, -1.0 * e};
    const int base_large = dots[1] < dots[2] ? 1 : 2, base_small = 3 - base_large;
    const double apex = -dots[0] - edge.large * area, base = -dots[base_large];
    const int large_at = apex > base ? 0 : base_large;
    const int small_at = dots[0] > dots[base_small] ? 0 : base_small;
    const double large = (std::max(apex, base) - goal_->large * area) / area;
    const double small = weight * (dots[small_at] - (goal_->small + edge.small) * area) / area;
    const double value = std::max(large, small);
    if (value > most) return value;
    worst = std::max(worst, value);
    add(large, -inverse * (of_dots[large_at] - dots[large_at] * across));
    if (weight > 0) add(small, inverse * weight * (of_dots[small_at] - dots[small_at] * across));
    if (!(coupling.weight > 0)) continue;
    const auto cot = [&](int i) {
      return Spokes::Cot{inverse * dots[i], inverse * (of_dots[i] - dots[i] * across)};
    };
    const Spokes::Cot opposite = cot(0);
    if (opposite.value < edge.lowest_cot) return kInverted;
    if (edge.least_cot > -kInverted)
      add_weighted(coupling.weight, edge.least_cot - opposite.value, -1.0 * opposite.slope);
    if (coupling.bound < kInverted) {
      const int widest = dots[0] < dots[base_large] ? 0 : base_large;
      const Spokes::Cot least = cot(widest);
      add_weighted(kBoundFirst, -least.value - coupling.bound, -1.0 * least.slope);
    }
    if (has_spokes()) spokes.add(cot(1), cot(2), add_spoke);
    if (worst > most) return worst;
  }
  if (has_spokes()) spokes.finish(add_spoke);
  return worst;
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

/// Steps to the lowest point of a linear model of the star, as far as it can be trusted.
Placement place(const Hole& hole, Point start, double wanted) {
  Placement best{start};
  LinearPieces buffers[2];
  LinearPieces *here = &buffers[0], *there = &buffers[1];
  double radius = kFirstStep * hole.shortest_spoke(best.at);
  best.worst = hole.linearise(best.at, kInverted, radius, -kMargin, *here);
  best.evaluations += kStepCost;
  if (!(best.worst > 0) || best.worst == kInverted) return best;
  for (int k = 0; k < kModelSteps; ++k) {
    const Descent down = descend(*here, -kMargin, radius);
    const double gain = best.worst - down.value;
    if (!(gain > (best.worst > 1 ? kLeastGainFar : kLeastGain) * best.worst)) return best;
    if (!down.is_cut_short && !(down.value < wanted)) return best;
    Point p = best.at + down.step;
    double value = hole.linearise(p, kInverted, 2 * radius, -kMargin, *there);
    best.evaluations += kStepCost;
    if (value >= best.worst && value < kInverted) {  // back into a valley that is curved
      p = p + descend(*there, -kMargin, length(down.step)).step;
      value = hole.linearise(p, best.worst, 2 * radius, -kMargin, *there);
      best.evaluations += kStepCost;
    }
    if (!(value < best.worst)) {
      radius = length(down.step) / 2;
      continue;
    }
    const double kept = (best.worst - value) / gain;
    best.at = p;
    best.worst = value;
    if (value <= 0) return best;
    if (kept < 0.25) radius = length(down.step) / 2;
    if (kept > 0.75 && down.is_cut_short) radius *= 2;
    std::swap(here, there);
  }
  return best;
}

WidestCorner::WidestCorner(const Goal& goal, double most) {
  const double largest = goal.large + most;  // twice that angle is 180 degrees and another one
  cot_ = largest > 0 ? (1 - largest * largest) / (2 * largest) : kInverted;
}

namespace {

/// Whether an edge of a star that halves a corner leaves angles so small that their excess is above
/// `most`, however it does that: the smaller half has half of it at most. With c = cot of half the
/// angle, its own cotangent is (c^2 - 1) / 2c.
bool is_too_narrow(const Goal& goal, double most, double allowed, Point before, Point p,
                   Point after) {
  const double half = most / goal.weight + goal.small + allowed;
  const Vector u = after - p, v = before - p;
  const double area = cross(u, v);
  return area > 0 && half > 0 && 2 * half * dot(u, v) > (half * half - 1) * area;
}

}  // namespace

bool has_room(const MutableMesh& mesh, const Cavity& cavity, double most) {
  const Goal& goal = mesh.goal();
  const WidestCorner widest(goal, most);
  const auto allowed_at = [&](int k) { return allowed_small(mesh.allowance(cavity.outer(k))); };
  const int last = cavity.size() - 1;
  const Point* const points = mesh.points.data();
  Point before = points[cavity.vertex(last)], p = points[cavity.vertex(0)];
  double allowed_before = allowed_at(last);
  for (int k = 0; k < cavity.size(); ++k) {
    const Point after = points[cavity.vertex(cavity.next(k))];
    if (!widest.allows(before, p, after)) return false;
    const double allowed = allowed_at(k);
    if (goal.weight > 0 &&
        is_too_narrow(goal, most, std::max(allowed, allowed_before), before, p, after))
      return false;
    before = std::exchange(p, after);
    allowed_before = allowed;
  }
  return true;
}

}  // namespace cover
