// An almond is convex and has no vertex inside, so the triangles that it reaches form a tree with
// the side's triangle as root, and an edge leads on just where the open almond crosses it. At a
// vertex that is known to lie on the circle the edge is judged by its direction against the
// tangent: a computed distance there would be noise, and the walk would leak around the apex.
// Tested by tests/unit/almond/arc_walk_test.cpp.
#include "almond/arc_walk.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace cover {
namespace {

class Walker {
 public:
  Walker(const Triangulation& cdt, std::span<const Almond> almonds)
      : cdt_(cdt),
        almonds_(almonds),
        seen_(cdt.triangles.size(), kNone),
        side_of_(cdt.triangles.size(), {kNone, kNone, kNone}) {
    reach_.first_known.reserve(almonds.size() + 1);
    reach_.known.reserve(2 * almonds.size());
    for (std::uint32_t k = 0; k < almonds.size(); ++k) {
      side_of_[almonds[k].base.triangle][almonds[k].base.edge] = k;
    }
  }

  Reach run() {
    for (current_ = 0; current_ < almonds_.size(); ++current_) walk(current_);
    reach_.first_known.push_back(static_cast<std::uint32_t>(reach_.known.size()));
    index_visits();
    return std::move(reach_);
  }

 private:
  struct Visit {
    std::uint32_t triangle, almond;
  };

  void walk(std::uint32_t k) {
    almond_ = &almonds_[k];
    start_ = reach_.known.size();
    reach_.first_known.push_back(static_cast<std::uint32_t>(start_));
    reach_.known.push_back({almond_->u, 0});
    reach_.known.push_back({almond_->v, kInfinity});
    if (almond_->passes_apex()) add_known(almond_->apex);
    if (almond_->has_arc()) {
      visit(almond_->base.triangle, k);
      if (!almond_->passes_apex()) take_if_on_arc(almond_->apex);
      if (almond_->kind != AlmondKind::hull_side) leave(almond_->base.triangle, almond_->base.edge);
      while (!stack_.empty()) {
        const EdgeRef at = stack_.back();
        stack_.pop_back();
        if (seen_[at.triangle] == k) continue;
        visit(at.triangle, k);
        take_if_on_arc(cdt_.triangles[at.triangle].v[at.edge]);
        leave(at.triangle, at.edge);
      }
    }
    std::sort(reach_.known.begin() + static_cast<std::ptrdiff_t>(start_), reach_.known.end(),
              [](const KnownVertex& a, const KnownVertex& b) { return a.ratio < b.ratio; });
  }

  void visit(std::uint32_t triangle, std::uint32_t k) {
    seen_[triangle] = k;
    visits_.push_back({triangle, k});
  }

  [[nodiscard]] bool is_known(std::uint32_t vertex) const {
    return std::any_of(reach_.known.begin() + static_cast<std::ptrdiff_t>(start_),
                       reach_.known.end(),
                       [&](const KnownVertex& a) { return a.vertex == vertex; });
  }

  void add_known(std::uint32_t vertex) {
    reach_.known.push_back({vertex, almond_->ratio_of(cdt_.points[vertex])});
  }

  void take_if_on_arc(std::uint32_t vertex) {
    const Point x = cdt_.points[vertex];
    if (std::abs(almond_->power(x)) <= kArcRounding * almond_->length * almond_->length &&
        almond_->on_the_arc(x) && !is_known(vertex)) {
      add_known(vertex);
    }
  }

  /// Puts the triangles behind the edges that the almond crosses on the stack, but not the one
  /// behind edge `entered`.
  void leave(std::uint32_t triangle, Corner entered) {
    const Triangle& f = cdt_.triangles[triangle];
    for (const Corner i : kCorners) {
      const std::uint32_t next = f.n[i];
      if (i == entered || f.is_locked(i) || next == kNone) continue;
      if (crosses(f.v[i.next()], f.v[i.previous()])) {
        const Corner back = cdt_.triangles[next].edge_to(triangle);
        stack_.push_back({next, back});
      }
    }
  }

  /// True if the open almond meets the open edge from `p` to `q`, neither of which is inside it.
  /// Along the edge the power is a parabola; its lowest place, if that is below zero, shows whether
  /// the edge passes on the side's left or behind the side (it cannot pass through the side).
  [[nodiscard]] bool crosses(std::uint32_t p, std::uint32_t q) const {
    const bool p_known = is_known(p), q_known = is_known(q);
    const Point a = cdt_.points[p], b = cdt_.points[q];
    const Vector d = b - a;
    const double slope_a = almond_->power_slope(a, d), slope_b = almond_->power_slope(b, d);
    if (p_known && q_known) return true;
    double lowest = 0.5;
    if (p_known || q_known) {
      if (p_known ? slope_a >= 0 : slope_b <= 0) return false;
    } else {
      const double curvature = almond_->sin_nu * squared_length(d);
      if (slope_a >= 0 || slope_b <= 0) return false;
      if (slope_a * slope_a <= 4 * curvature * almond_->power(a)) return false;
    }
    if (slope_b > slope_a) lowest = std::clamp(-slope_a / (slope_b - slope_a), 0.0, 1.0);
    return cross(almond_->chord(), (a + lowest * d) - almond_->from) > 0;
  }

  /// Turns the visits into lists by triangle.
  void index_visits() {
    reach_.first_visitor.assign(cdt_.triangles.size() + 1, 0);
    for (const Visit& visit : visits_) ++reach_.first_visitor[visit.triangle + 1];
    for (std::size_t t = 1; t < reach_.first_visitor.size(); ++t) {
      reach_.first_visitor[t] += reach_.first_visitor[t - 1];
    }
    reach_.visitors.resize(visits_.size());
    std::vector<std::uint32_t> next(reach_.first_visitor.begin(), reach_.first_visitor.end() - 1);
    for (const Visit& visit : visits_) reach_.visitors[next[visit.triangle]++] = visit.almond;
  }

  const Triangulation& cdt_;
  std::span<const Almond> almonds_;
  const Almond* almond_ = nullptr;   ///< whose walk it is
  std::size_t start_ = 0;            ///< of its known vertices
  std::uint32_t current_ = 0;        ///< its number
  std::vector<std::uint32_t> seen_;  ///< by triangle: the last almond that visited it
  std::vector<std::array<std::uint32_t, 3>> side_of_;  ///< by triangle and edge, kNone if no side
  std::vector<EdgeRef> stack_;  ///< triangles to visit, with the edge by which they are entered
  std::vector<Visit> visits_;
  Reach reach_;
};

}  // namespace

Reach walk_almonds(const Triangulation& cdt, std::span<const Almond> almonds) {
  return Walker(cdt, almonds).run();
}

}  // namespace cover
