// Sequential linear programming: the excess of each triangle around is made linear in the places of
// its corners, the lowest point of that within a box is tried, and the box grows or shrinks as the
// triangles follow the model or not.
#include "quality/moves/joint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/containers/order.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "quality/fault/keep_rules.hpp"
#include "quality/optimum/linear_program.hpp"

namespace cover {
namespace {

constexpr std::size_t kVertices = 6;
constexpr int kSteps = 10;
constexpr double kFirstBox = 0.25;  ///< times the shortest edge at a vertex
constexpr double kLeastBox = 0.002;
constexpr double kMargin = 0.02;         ///< aim so far below the goal
constexpr std::uint64_t kStepCost = 60;  ///< star evaluations in the time of one step

class JointPlacement {
 public:
  JointPlacement(MutableMesh& mesh, std::uint32_t t) : mesh_(mesh) {
    choose_vertices(t);
    for (const std::uint32_t v : vertices_) {
      before_.push_back(mesh_.points[v]);
      reach_.push_back(std::sqrt(shortest2_at(v)));
    }
  }

  JointMove run() {
    if (vertices_.size() < 2) return {};
    std::uint64_t evaluations = 0;
    double worst = worst_now();
    const double first = worst;
    double box = kFirstBox;
    std::vector<double> step;
    for (int k = 0; k < kSteps && worst > 0 && box >= kLeastBox; ++k) {
      evaluations += kStepCost;
      const double expected = std::max(lowest_in_box(model(box), step), -kMargin);
      if (!(worst - expected > kWorthwhileGain * worst)) break;
      const std::vector<Point> old = places();
      for (std::size_t m = 0; m < vertices_.size(); ++m) {
        mesh_.points[vertices_[m]] =
            old[m] + box * reach_[m] * Vector{step[2 * m], step[2 * m + 1]};
      }
      const double now = worst_now();
      if (!(now < worst)) {
        put(old);
        box /= 3;
        continue;
      }
      const double kept = (worst - now) / (worst - expected);
      worst = now;
      if (kept > 0.75) box *= 2;
      if (kept < 0.25) box /= 2;
    }
    if (!(worst < first) || !is_valid()) {
      put(before_);
      return {false, evaluations};
    }
    for (const std::uint32_t s : triangles_) mesh_.measure(s);
    for (const std::uint32_t s : triangles_) {
      for (const std::uint32_t n : mesh_.triangles[s].n) mesh_.measure_beyond(n);
    }
    return {true, evaluations};
  }

 private:
  /// Free corners of `t`, then free vertices beside those, as long as there is room.
  void choose_vertices(std::uint32_t t) {
    for (const std::uint32_t v : mesh_.triangles[t].v) take(v);
    for (std::size_t m = 0; m < vertices_.size() && vertices_.size() < kVertices; ++m) {
      for_star(vertices_[m], [&](std::uint32_t s) {
        for (const std::uint32_t v : mesh_.triangles[s].v) take(v);
      });
    }
    for (const std::uint32_t v : vertices_) {
      for_star(v, [&](std::uint32_t s) { triangles_.push_back(s); });
    }
    sort_unique(triangles_);
  }

  void take(std::uint32_t v) {
    if (mesh_.is_fixed(v) || vertices_.size() == kVertices || index_of(v) < vertices_.size())
      return;
    vertices_.push_back(v);
  }

  /// The place of `v` among the vertices that move; their number if it does not.
  [[nodiscard]] std::size_t index_of(std::uint32_t v) const {
    return static_cast<std::size_t>(std::find(vertices_.begin(), vertices_.end(), v) -
                                    vertices_.begin());
  }

  template <class Visit>
  void for_star(std::uint32_t v, Visit visit) const {
    std::uint32_t s = mesh_.home[v];
    do {
      visit(s);
      s = mesh_.triangles[s].n[mesh_.triangles[s].corner_of(v).next()];
    } while (s != mesh_.home[v]);
  }

  [[nodiscard]] double shortest2_at(std::uint32_t v) const {
    double shortest = kInverted;
    for_star(v, [&](std::uint32_t s) {
      for (const std::uint32_t w : mesh_.triangles[s].v) {
        if (w != v)
          shortest = std::min(shortest, squared_length(mesh_.points[w] - mesh_.points[v]));
      }
    });
    return shortest;
  }

  [[nodiscard]] double worst_now() const {
    double worst = -kInverted;
    for (const std::uint32_t s : triangles_) {
      worst = std::max(worst, mesh_.excess_of(mesh_.triangles[s].v, mesh_.triangles[s].n));
    }
    return worst;
  }

  [[nodiscard]] bool is_valid() const {
    return std::all_of(triangles_.begin(), triangles_.end(), [&](std::uint32_t s) {
      return orientation(mesh_.corner(s, 0), mesh_.corner(s, 1), mesh_.corner(s, 2)) ==
             Sign::positive;
    });
  }

  [[nodiscard]] std::vector<Point> places() const {
    std::vector<Point> result;
    for (const std::uint32_t v : vertices_) result.push_back(mesh_.points[v]);
    return result;
  }
  void put(const std::vector<Point>& places) {
    for (std::size_t m = 0; m < vertices_.size(); ++m) mesh_.points[vertices_[m]] = places[m];
  }

  struct AngleOf {
    std::uint32_t triangle;
    const Corners& corners;  ///< of the triangle
    Corner at;
  };

  /// The excesses as functions of the steps, in boxes.
  [[nodiscard]] LinearFunctions model(double box) const {
    LinearFunctions f;
    f.dimension = 2 * vertices_.size();
    for (const std::uint32_t s : triangles_) {
      const MeshTriangle& triangle = mesh_.triangles[s];
      const Corners k(mesh_.corner(s, 0), mesh_.corner(s, 1), mesh_.corner(s, 2));
      const SideAllowances sides = mesh_.allowances_beside(triangle.n);
      const double allowed = allowed_small(sides);
      double large = -kInverted, small = -kInverted;
      Corner large_at, small_at;
      for (const Corner i : kCorners) {
        const double cot = k.dot[i] / k.cross;
        // Not wanted_large(): a sum rounds in another way, and ties would end elsewhere.
        const double above = -cot - mesh_.goal().large - allowed_large(sides[i]);
        if (above > large) large = above, large_at = i;
        if (is_between_sides(sides, i)) continue;
        const double below = mesh_.goal().weight * (cot - mesh_.goal().small - allowed);
        if (below > small) small = below, small_at = i;
      }
      add(f, {s, k, large_at}, large, -1, box);
      if (mesh_.goal().weight > 0 && small > -kInverted) {
        add(f, {s, k, small_at}, small, mesh_.goal().weight, box);
      }
      if (mesh_.goal().coupling.weight > 0) add_couplings(f, s, k, box);
    }
    return f;
  }

  /// Adds the couplings of the edges of `s`, and its largest angle by the bound.
  void add_couplings(LinearFunctions& f, std::uint32_t s, const Corners& k, double box) const {
    const CouplingGoal& coupling = mesh_.goal().coupling;
    const MeshTriangle& triangle = mesh_.triangles[s];
    Corner widest;
    for (const Corner i : kCorners) {
      if (k.dot[i] < k.dot[widest]) widest = i;
      const double cot = k.dot[i] / k.cross;
      const std::uint32_t n = triangle.n[i];
      if (is_side(n)) {
        const double least = mesh_.allowance(n)->least_cot;
        if (least > -kInverted)
          add(f, {s, k, i}, coupling.weight * (least - cot), -coupling.weight, box);
      } else if (coupling.inside) {
        const Corner j = mesh_.triangles[n].edge_from(triangle.v[i.previous()]);
        const Corners o(mesh_.corner(n, 0), mesh_.corner(n, 1), mesh_.corner(n, 2));
        const double sum = cot + o.dot[j] / o.cross;
        add(f, {s, k, i}, coupling.weight * (kLeastCoupling - sum), -coupling.weight, box);
        add_slopes(f, f.rows.size() - f.dimension - 1, {n, o, j}, -coupling.weight, box);
      }
    }
    if (coupling.bound < kInverted)
      add(f, {s, k, widest}, kBoundFirst * (-k.dot[widest] / k.cross - coupling.bound),
          -kBoundFirst, box);
  }

  /// Adds `factor` times the cotangent of an angle, whose value is `value` now.
  void add(LinearFunctions& f, const AngleOf& angle, double value, double factor,
           double box) const {
    const std::size_t row = f.rows.size();
    f.rows.resize(row + 1 + f.dimension, 0.0);
    f.rows[row] = value;
    add_slopes(f, row, angle, factor, box);
  }

  void add_slopes(LinearFunctions& f, std::size_t row, const AngleOf& angle, double factor,
                  double box) const {
    const auto& [s, k, i] = angle;
    const Point a = mesh_.corner(s, i);
    const Vector u = mesh_.corner(s, i.next()) - a, v = mesh_.corner(s, i.previous()) - a;
    const double cot = k.dot[i] / k.cross;
    const Vector by_b = (factor / k.cross) * (v + cot * left_normal(v));
    const Vector by_c = (factor / k.cross) * (u - cot * left_normal(u));
    const std::array<std::pair<Corner, Vector>, 3> by{
        {{i.next(), by_b}, {i.previous(), by_c}, {i, -1.0 * (by_b + by_c)}}};
    for (const auto& [corner, slope] : by) {
      const std::size_t m = index_of(mesh_.triangles[s].v[corner]);
      if (m == vertices_.size()) continue;
      f.rows[row + 1 + 2 * m] += box * reach_[m] * slope.x;
      f.rows[row + 2 + 2 * m] += box * reach_[m] * slope.y;
    }
  }

  MutableMesh& mesh_;
  std::vector<std::uint32_t> vertices_;   ///< that move
  std::vector<std::uint32_t> triangles_;  ///< around them
  std::vector<Point> before_;
  std::vector<double> reach_;  ///< by vertex: its shortest edge at first
};

}  // namespace

JointMove place_jointly(MutableMesh& mesh, std::uint32_t t) {
  return JointPlacement(mesh, t).run();
}

}  // namespace cover
