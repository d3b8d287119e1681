// Ears are cut off, one after the other, in whose circle no corner that is left lies. After a
// vertex of a Delaunay triangulation is taken away there always is one.
#include "quality/optimum/delaunay_polygon.hpp"

#include <algorithm>

#include "geom/predicates.hpp"

namespace cover {
namespace {

/// A corner that is left, and what is across the edge from it to the next one.
struct Left {
  int corner;
  std::uint32_t outer;
};

class EarCutter {
 public:
  EarCutter(const MutableMesh& mesh, const Cavity& cavity)
      : mesh_(mesh), cavity_(cavity), size_(cavity.size()) {
    for (int k = 0; k < size_; ++k) left_[place(k)] = {k, cavity.outer(k)};
  }

  double run(Patch& patch) {
    patch.clear();
    double worst = -kInverted;
    while (size_ > 3) {
      const int k = find_ear();
      if (k < 0) return kInverted;
      worst = std::max(worst, cut(k, patch));
    }
    if (orientation(at(0), at(1), at(2)) != Sign::positive) return kInverted;
    patch.add(left_[0].corner, left_[1].corner, left_[2].corner);
    return std::max(worst, excess(0, 1, 2, left_[2].outer));
  }

 private:
  static std::size_t place(int k) { return static_cast<std::size_t>(k); }
  [[nodiscard]] int next(int k) const { return k + 1 == size_ ? 0 : k + 1; }
  [[nodiscard]] std::uint32_t vertex(int k) const { return cavity_.vertex(left_[place(k)].corner); }
  [[nodiscard]] Point at(int k) const { return mesh_.points[vertex(k)]; }

  /// The first of three corners in a row; -1: there are none.
  [[nodiscard]] int find_ear() const {
    for (int k = 0; k < size_; ++k) {
      if (is_ear(k)) return k;
    }
    return -1;
  }

  [[nodiscard]] bool is_ear(int k) const {
    const int m = next(k), n = next(m);
    const Point a = at(k), b = at(m), c = at(n);
    if (orientation(a, b, c) != Sign::positive) return false;
    for (int other = next(n); other != k; other = next(other)) {
      if (in_circle(a, b, c, at(other)) == Sign::positive) return false;
    }
    return true;
  }

  [[nodiscard]] double excess(int k, int m, int n, std::uint32_t across_nk) const {
    return mesh_.excess_of({vertex(k), vertex(m), vertex(n)},
                           {left_[place(m)].outer, across_nk, left_[place(k)].outer});
  }

  /// Cuts off the ear from corner k on, and returns its excess.
  double cut(int k, Patch& patch) {
    const int m = next(k), n = next(m);
    patch.add(left_[place(k)].corner, left_[place(m)].corner, left_[place(n)].corner);
    const double worst = excess(k, m, n, kSomeTriangle);
    left_[place(k)].outer = kSomeTriangle;
    for (int j = m; j + 1 < size_; ++j) left_[place(j)] = left_[place(j + 1)];
    --size_;
    return worst;
  }

  const MutableMesh& mesh_;
  const Cavity& cavity_;
  int size_;
  std::array<Left, Cavity::kCapacity> left_;
};

}  // namespace

double delaunay_polygon(const MutableMesh& mesh, const Cavity& cavity, Patch& patch) {
  return EarCutter(mesh, cavity).run(patch);
}

}  // namespace cover
