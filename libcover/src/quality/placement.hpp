// Where to put a vertex inside a hole so that the worst triangle of its star is as good as can be.
#pragma once

#include <array>
#include <cstdint>

#include "geom/vector.hpp"
#include "quality/cavity.hpp"

namespace cover {

/// The loop around a hole as plain coordinates.
class Hole {
 public:
  Hole(const MutableMesh& mesh, const Cavity& cavity);

  /// The worst excess of the star from `p`, or anything above `limit` once that is passed.
  [[nodiscard]] double worst(Point p, double limit) const;
  /// A step that lowers the worst excess of the star from `p` to `level` if that one triangle were
  /// linear; `value` receives the worst excess: infinite where `p` does not see the whole loop.
  [[nodiscard]] Vector step_to(Point p, double level, double& value) const;
  /// The loop edge with the worst triangle of the star from `p`, but for those to `skip`; -1: none.
  [[nodiscard]] int worst_edge(Point p, const std::array<bool, Cavity::kCapacity>& skip) const;
  /// The distance to the nearest vertex of the loop.
  [[nodiscard]] double shortest_spoke(Point p) const;
  /// The mean of the loop's vertices.
  [[nodiscard]] Point centre() const;

 private:
  [[nodiscard]] double excess_at(std::size_t k, Point p) const;
  /// The gradient of excess_at by p.
  [[nodiscard]] Vector slope_at(std::size_t k, Point p) const;

  const Goal* goal_;
  int size_;
  bool plain_ = true;  ///< no side has an allowance
  std::array<Point, Cavity::kCapacity + 1> loop_;
  std::array<Allowance, Cavity::kCapacity> allowance_;
};

/// A place and the worst excess there.
struct Placement {
  Point at;
  double worst = kInverted;
};

/// Looks for a place for a vertex, from `start`. Stops early where all triangles meet the goal, and
/// after a first attempt that ends at `promising` or above.
///
/// ENSURES: never worse than `start`; `evaluations` is raised by the stars that were looked at.
///          A start that does not see the whole loop is the end, with `worst` infinite.
Placement place(const Hole& hole, Point start, double promising, std::uint64_t& evaluations);

}  // namespace cover
