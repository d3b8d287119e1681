// Where to put a vertex inside a hole so that the worst triangle of its star is as good as can be.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geom/vector.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/optimum/minimax.hpp"

namespace cover {

/// The edges around a hole as plain coordinates.
class Hole {
 public:
  /// An edge with the hole on its left.
  struct Edge {
    double ax, ay, bx, by;  ///< no constructor: many are made and few are used
    double large, small;    ///< the allowance of the side; zero where the edge is none
    double least_cot;       ///< at the new vertex, for the coupling of the edge; -inf: any
    double lowest_cot;      ///< below this the triangle counts as inverted
    [[nodiscard]] Point a() const { return {ax, ay}; }
    [[nodiscard]] Point b() const { return {bx, by}; }
  };
  static Edge edge(Point a, Point b, const Allowance* side) {
    const Allowance allowance = side != nullptr ? *side : Allowance();
    return {a.x,
            a.y,
            b.x,
            b.y,
            allowance.large,
            allowance.small,
            allowance.least_cot,
            allowance.lowest_cot};
  }

  Hole(const MutableMesh& mesh, const Cavity& cavity);
  /// A hole with any number of edges, in any order.
  /// REQUIRES: both arguments outlive it
  Hole(const Goal& goal, std::span<const Edge> edges);
  Hole(const Hole&) = delete;
  Hole& operator=(const Hole&) = delete;

  /// The worst excess of the star from `p`, or anything above `most` once that is passed.
  [[nodiscard]] double worst(Point p, double most) const;
  /// The worst excess of the star from `p`, and the excesses there as linear functions of the step
  /// from `p`, but for those that no step as long as `reach` brings above `level`; or anything
  /// above `most` once that is passed.
  [[nodiscard]] double linearise(Point p, double most, double reach, double level,
                                 LinearPieces& pieces) const;
  /// The loop edge with the worst triangle of the star from `p`, but for those to `skip`; -1: none.
  [[nodiscard]] int worst_edge(Point p, const std::array<bool, Cavity::kCapacity>& skip) const;
  /// The distance to the nearest vertex of the loop.
  [[nodiscard]] double shortest_spoke(Point p) const;
  /// The mean of the vertices.
  [[nodiscard]] Point centre() const;

 private:
  struct Ratio;
  class Spokes;
  /// Whether couplings of the new edges count.
  [[nodiscard]] bool has_spokes() const { return edges_ == own_.data() && goal_->coupling.inside; }
  [[nodiscard]] std::span<const Edge> edges() const {
    return {edges_, static_cast<std::size_t>(size_)};
  }
  /// The excess of the triangle from an edge to `p`.
  [[nodiscard]] Ratio excess_at(const Edge& edge, Point p) const;

  const Goal* goal_;
  const Edge* edges_;
  int size_;
  std::array<Edge, Cavity::kCapacity> own_;  ///< behind edges_, for the hole of a cavity
};

/// Tells corners of a loop that are too wide for a star with excesses up to `most`: its edges halve
/// them.
class WidestCorner {
 public:
  WidestCorner(const Goal& goal, double most);
  /// Whether the corner at `p` is narrow enough, between the vertices before and after it.
  [[nodiscard]] bool allows(Point before, Point p, Point after) const {
    const Vector u = after - p, v = before - p;
    const double area = cross(u, v);
    return !(area < 0 && dot(u, v) > cot_ * area);
  }

 private:
  double cot_;  ///< of what the widest corner has beyond 180 degrees
};

/// Whether all corners of the loop are neither too wide for a star with excesses up to `most` nor
/// too narrow. Where not, no place needs to be looked for.
bool has_room(const MutableMesh& mesh, const Cavity& cavity, double most);

/// A place and the worst excess there.
struct Placement {
  Point at;
  double worst = kInverted;
  std::uint64_t evaluations = 0;  ///< stars that were looked at to find it
};

/// Looks for a place for a vertex, from `start`. Stops where all triangles meet the goal, and where
/// the lowest point of the linear model is at `wanted` or above.
///
/// ENSURES: never worse than `start`. A start that does not see the whole loop is the end, with
///          `worst` infinite.
Placement place(const Hole& hole, Point start, double wanted);

}  // namespace cover
