// What the chord from corner i to a later corner j cuts off is best triangulated on its own; that
// does not depend on the vertex. Around a vertex at a given place, the star of which is a closed
// way along such chords, the best one is found by dynamic programming again. Then the vertex is
// placed anew inside the star.
// Tested by tests/unit/quality/optimum/min_max_polygon_with_vertex_test.cpp.
#include "quality/optimum/min_max_polygon_with_vertex.hpp"

#include <array>
#include <vector>

#include "geom/vector.hpp"
#include "quality/optimum/min_max_polygon.hpp"
#include "quality/optimum/placement.hpp"

namespace cover {
namespace {

constexpr int kBest = 3;                  ///< places that are improved
constexpr int kRepeats = 3;               ///< stars chosen and improved in turn
constexpr std::uint64_t kTableCost = 20;  ///< in star evaluations
constexpr std::uint64_t kWayCost = 12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class PolygonWithVertex {
 public:
  PolygonWithVertex(const MutableMesh& mesh, const Cavity& cavity)
      : mesh_(mesh), cavity_(cavity), size_(cavity.size()) {
    fill_table();
  }

  PlacedVertex run(double most, Patch& patch) {
    std::uint64_t evaluations = kTableCost;
    struct Start {
      double value;
      Point p;
    };
    std::array<Start, kBest> starts;
    starts.fill({kInverted, {}});
    const Point centre = Hole(mesh_, cavity_).centre();
    const auto look_at = [&](Point p) {
      Start start{best_star(p, kInverted), p};
      evaluations += kWayCost;
      for (Start& other : starts) {
        if (start.value < other.value) std::swap(start, other);
      }
    };
    look_at(centre);
    for (int k = 0; k < size_; ++k) {
      look_at(midpoint(centre, corner(k)));
      look_at(midpoint(centre, midpoint(corner(k), corner(next(k)))));
    }
    double best = most;
    for (const Start& start : starts) {
      if (start.value == kInverted) continue;
      double value = best_star(start.p, kInverted);
      Point p = start.p;
      for (int k = 0; k < kRepeats; ++k) {
        if (value < best) {
          best = value;
          collect(p, patch);
        }
        if (best <= 0) return {best < most ? best : kInverted, evaluations};
        const Placement placement = place(star_hole(), p, best);
        evaluations += placement.evaluations;
        if (!(placement.worst < value)) break;
        p = placement.at;
        const double now = best_star(p, kInverted);
        evaluations += kWayCost;
        if (!(now < value)) break;
        value = now;
      }
      if (value < best) {
        best = value;
        collect(p, patch);
      }
    }
    return {best < most ? best : kInverted, evaluations};
  }

 private:
  [[nodiscard]] int next(int k) const { return k + 1 == size_ ? 0 : k + 1; }
  [[nodiscard]] int wrapped(int k) const { return k >= size_ ? k - size_ : k; }
  [[nodiscard]] Point corner(int k) const { return mesh_.points[cavity_.vertex(k)]; }
  /// What is across the chord to the corner `length` on.
  [[nodiscard]] std::uint32_t across(int i, int length) const {
    return length == 1 ? cavity_.outer(i) : kSomeTriangle;
  }

  /// best_[i][length]: of the corners from i to i + length.
  void fill_table() {
    for (int i = 0; i < size_; ++i) best_[at(i)][1] = -kInverted;
    for (int length = 2; length < size_; ++length) {
      for (int i = 0; i < size_; ++i) {
        double best = kInverted;
        for (int k = 1; k < length; ++k) {
          const int middle = wrapped(i + k), end = wrapped(i + length);
          const double parts = std::max(best_[at(i)][at(k)], best_[at(middle)][at(length - k)]);
          if (!(parts < best)) continue;
          const double value = std::max(
              parts,
              mesh_.excess_of({cavity_.vertex(i), cavity_.vertex(middle), cavity_.vertex(end)},
                              {across(middle, length - k), kSomeTriangle, across(i, k)}));
          if (!(value < best)) continue;
          best = value;
          third_[at(i)][at(length)] = k;
        }
        best_[at(i)][at(length)] = best;
      }
    }
  }

  /// The best star around `p`, kept in star_, or anything not below `most`.
  double best_star(Point p, double most) {
    double cost[kPolygonLimit][kPolygonLimit];
    for (int i = 0; i < size_; ++i) {
      for (int length = 1; length < size_; ++length) {
        const double part = best_[at(i)][at(length)];
        cost[i][length] = part < most ? std::max(part, excess_at(i, length, p)) : kInverted;
      }
    }
    double best = most;
    for (int first = 0; first < size_; ++first) {
      // reach[j]: the least largest cost of a way from `first` to j; size_ stands for `first`
      // again.
      double reach[kPolygonLimit + 1];
      int before[kPolygonLimit + 1];
      for (int j = first + 1; j <= size_; ++j) {
        reach[j] = kInverted;
        const int end = j == size_ ? size_ + first : j;
        for (int i = first; i < j; ++i) {
          const int length = end - i;
          if (length >= size_) continue;
          const double value = std::max(i == first ? -kInverted : reach[i], cost[i][length]);
          if (!(value < reach[j])) continue;
          reach[j] = value;
          before[j] = i;
        }
      }
      if (!(reach[size_] < best)) continue;
      best = reach[size_];
      star_.clear();
      for (int j = size_; j != first; j = before[j]) star_.insert(star_.begin(), before[j]);
    }
    return best;
  }

  [[nodiscard]] double excess_at(int i, int length, Point p) const {
    const Point a = corner(i), b = corner(wrapped(i + length));
    const SideAllowances sides{nullptr, nullptr, mesh_.allowance(across(i, length))};
    return excess(mesh_.goal(), a, b, p, sides);
  }

  /// The hole that the star fills.
  [[nodiscard]] Hole star_hole() {
    edges_.clear();
    for (std::size_t k = 0; k < star_.size(); ++k) {
      const int i = star_[k], j = star_[(k + 1) % star_.size()];
      edges_.push_back(
          Hole::edge(corner(i), corner(j), mesh_.allowance(across(i, length_to(i, j)))));
    }
    return Hole(mesh_.goal(), edges_);
  }

  [[nodiscard]] int length_to(int i, int j) const { return j > i ? j - i : j - i + size_; }

  void collect(Point p, Patch& patch) const {
    patch.clear();
    patch.inserted = p;
    for (std::size_t k = 0; k < star_.size(); ++k) {
      const int i = star_[k], j = star_[(k + 1) % star_.size()];
      patch.add(i, j, size_);
      collect_part(i, length_to(i, j), patch);
    }
  }

  void collect_part(int i, int length, Patch& patch) const {
    if (length < 2) return;
    const int k = third_[at(i)][at(length)], middle = wrapped(i + k);
    patch.add(i, middle, wrapped(i + length));
    collect_part(i, k, patch);
    collect_part(middle, length - k, patch);
  }

  const MutableMesh& mesh_;
  const Cavity& cavity_;
  int size_;
  std::array<std::array<double, kPolygonLimit>, kPolygonLimit> best_{};
  std::array<std::array<int, kPolygonLimit>, kPolygonLimit> third_{};
  std::vector<int> star_;  ///< corners joined with the vertex, in order
  std::vector<Hole::Edge> edges_;
};

}  // namespace

PlacedVertex min_max_polygon_with_vertex(const MutableMesh& mesh, const Cavity& cavity, double most,
                                         Patch& patch) {
  if (cavity.size() > kPolygonLimit) return {};
  return PolygonWithVertex(mesh, cavity).run(most, patch);
}

}  // namespace cover
