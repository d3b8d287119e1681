// The triangulation of a region while it is being changed: plain arrays, places reused.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <cover/point.hpp>

#include "base/containers/unset_vector.hpp"
#include "base/numbers.hpp"
#include "base/team.hpp"
#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"
#include "quality/mutable/allowances.hpp"
#include "target/goal.hpp"
#include "target/side_limit.hpp"

namespace cover {

/// Set in MeshTriangle::n where the edge is a side: the rest is the index of the side. The two
/// sides of a slit are two sides, so that nothing ever crosses a side.
inline constexpr std::uint32_t kSideBit = 0x80000000U;
constexpr bool is_side(std::uint32_t neighbour) { return (neighbour & kSideBit) != 0; }
/// In place of a triangle across an edge that is not known yet: couplings across it do not count.
inline constexpr std::uint32_t kSomeTriangle = kSideBit - 1;
constexpr std::uint32_t side_index(std::uint32_t neighbour) { return neighbour & ~kSideBit; }

/// A counter-clockwise triangle. Edge i is opposite to corner i; n[i] is the triangle or the side
/// across it.
struct MeshTriangle {
  std::array<std::uint32_t, 3> v{kNone, kNone, kNone};
  std::array<std::uint32_t, 3> n{};

  [[nodiscard]] Corner corner_of(std::uint32_t w) const { return corner_with(v, w); }
  /// The edge from a to b.
  /// REQUIRES: it is one.
  [[nodiscard]] Corner edge_from(std::uint32_t a) const { return corner_of(a).previous(); }
};

/// The limits of the sides of a region, which its meshes have in common: they take 88 bytes each,
/// more than four triangles.
class SideLimits {
 public:
  SideLimits() = default;
  SideLimits(std::vector<SideLimit> limits)
      : limits_(std::make_shared<std::vector<SideLimit>>(std::move(limits))) {}

  [[nodiscard]] std::size_t size() const { return limits_ ? limits_->size() : 0; }
  const SideLimit& operator[](std::size_t s) const { return (*limits_)[s]; }
  [[nodiscard]] const SideLimit* begin() const { return limits_ ? limits_->data() : nullptr; }
  [[nodiscard]] const SideLimit* end() const { return begin() + size(); }

  /// One more side with the limits of side `s`; other meshes keep what they have.
  void repeat(std::size_t s) {
    if (limits_.use_count() > 1) limits_ = std::make_shared<std::vector<SideLimit>>(*limits_);
    limits_->push_back(SideLimit((*limits_)[s]));
  }

 private:
  std::shared_ptr<std::vector<SideLimit>> limits_;  ///< changed only where nobody else has it
};

/// What `goal` allows to the triangle on a side.
Allowance allowance_for(const SideLimit& side, const Goal& goal);

/// Triangles over fixed vertices (those of the boundary, numbered first) and free ones.
///
/// Keeps with every triangle its excess over the goal, which changes with the goal only through
/// `set_goal`. Triangles and free vertices that were taken away leave holes (v[0] == kNone, home
/// kNone) that are used again.
class MutableMesh {
 public:
  /// Nothing.
  MutableMesh() = default;
  /// Takes over `triangulation`, whose first `fixed` points stay where they are.
  /// Side s, with limits[s], is the edge side_at[s].
  ///
  /// REQUIRES: the sides are all the edges that border on the outside or must not be crossed
  /// Errors:   throws an InternalFault if a side is nowhere, or an edge on the outside is no side
  MutableMesh(const Triangulation& triangulation, std::uint32_t fixed,
              std::span<const EdgeRef> side_at, SideLimits limits, const Team& team = {});

  /// A part of `whole` with its first `fixed` vertices fixed, without anything yet. Its goal is
  /// that of `whole` for good: it has allowances, but no limits of its sides.
  static MutableMesh part_of(const MutableMesh& whole, std::uint32_t fixed) {
    MutableMesh part;
    part.goal_ = whole.goal_;
    part.fixed_ = fixed;
    return part;
  }

  UnsetVector<Point> points;
  UnsetVector<MeshTriangle> triangles;
  UnsetVector<double> excess;       ///< by triangle; -inf for a hole
  UnsetVector<std::uint32_t> home;  ///< by vertex: one of its triangles
  SideLimits sides;
  Allowances allowances;  ///< by side, for the present goal

  [[nodiscard]] const Goal& goal() const { return goal_; }
  /// ENSURES: all excesses are by `goal`, if they were by the goal before
  void set_goal(const Goal& goal, const Team& team = {});
  /// The same for whoever does not look at excesses before measure_all() or arrange().
  void set_goal_unmeasured(const Goal& goal, const Team& team = {});
  /// Computes all excesses anew.
  void measure_all(const Team& team = {});

  [[nodiscard]] bool is_fixed(std::uint32_t v) const { return v < fixed_; }
  [[nodiscard]] std::uint32_t fixed_vertices() const { return fixed_; }
  [[nodiscard]] bool is_hole(std::uint32_t t) const { return triangles[t].v[0] == kNone; }
  [[nodiscard]] std::size_t triangle_count() const {
    return triangles.size() - free_triangles_.size();
  }

  [[nodiscard]] Point corner(std::uint32_t t, Corner i) const { return points[triangles[t].v[i]]; }
  /// The allowance of the side in place of neighbour `n`, null for a triangle.
  [[nodiscard]] const Allowance* allowance(std::uint32_t n) const {
    return is_side(n) ? &allowances[side_index(n)] : nullptr;
  }
  /// Those of the sides among the neighbours `n` of a triangle.
  [[nodiscard]] SideAllowances allowances_beside(const std::array<std::uint32_t, 3>& n) const {
    return {allowance(n[0]), allowance(n[1]), allowance(n[2])};
  }
  /// Whether no side forces more than the goal on the triangle beside it.
  [[nodiscard]] bool is_unforced() const;
  /// The excess of a triangle that need not exist, from its corners and what is across its edges.
  [[nodiscard]] double excess_of(const std::array<std::uint32_t, 3>& v,
                                 const std::array<std::uint32_t, 3>& n) const;

  /// The cotangent at the corner of triangle `t` opposite to its edge that starts at `from`.
  [[nodiscard]] double cot_opposite(std::uint32_t t, std::uint32_t from) const;
  /// Whether nothing can change the coupling of an inner edge: all corners of its two triangles are
  /// fixed. What is negative then is so by rounding, or for good.
  [[nodiscard]] bool is_given(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                              std::uint32_t d) const {
    return is_fixed(a) && is_fixed(b) && is_fixed(c) && is_fixed(d);
  }
  /// What the cotangents opposite to an inner edge must add up to.
  static double least_sum(bool given) { return given ? -kSameCot : kLeastCoupling; }
  /// The excess of the coupling of an inner edge with these ends and corners opposite, whose
  /// cotangents add up to `sum`.
  [[nodiscard]] double inner_excess(double sum, bool given) const {
    const double least = least_sum(given);
    if (goal_.coupling.strict && sum < std::min(least, 0.0)) return kInverted;
    return goal_.coupling.weight * (least - sum);
  }

  /// Tells the triangle or side `n`, across the edge from a to b of `t`, of its new neighbour.
  void link(std::uint32_t n, std::uint32_t a, std::uint32_t b, std::uint32_t t);
  /// Computes the excess of `t` anew.
  void measure(std::uint32_t t) { excess[t] = excess_of(triangles[t].v, triangles[t].n); }
  /// The same for what lies across an edge of a triangle that has changed, if that may matter.
  void measure_beyond(std::uint32_t n) {
    if (goal_.coupling.inside && !is_side(n)) measure(n);
  }

  /// Makes room for so many more, so that adding them moves nothing.
  void reserve_more(std::size_t more_triangles, std::size_t more_vertices, const Team& team = {});
  /// As many calls of add_triangle() and add_vertex(), whose places are written by the caller.
  void add_triangles(std::span<std::uint32_t> places);
  void add_vertices(std::span<std::uint32_t> places);
  std::uint32_t add_vertex(Point p);
  void drop_vertex(std::uint32_t v);
  std::uint32_t add_triangle();
  void drop_triangle(std::uint32_t t);

  /// The excess that the two triangles have after a flip of edge i of `t`, or anything above
  /// `most` once that is passed.
  ///
  /// REQUIRES: that edge is no side
  [[nodiscard]] double excess_after_flip(std::uint32_t t, Corner i, double most) const;
  /// Flips edge i of `t`. Both triangles keep their places.
  ///
  /// ENSURES: false, and nothing has changed, if exact arithmetic finds one of the new triangles
  ///          not counter-clockwise
  bool flip(std::uint32_t t, Corner i);

  /// Renumbers triangles and free vertices from the sides inwards, so that neighbours are near each
  /// other in memory and no holes are left. Computes all excesses anew.
  void arrange(const Team& team = {});

  /// Whether exact arithmetic finds all triangles counter-clockwise.
  [[nodiscard]] bool is_valid() const;

 private:
  /// The triangles from the sides inwards, and where each is in this order.
  std::vector<std::uint32_t> order_from_sides(UnsetVector<std::uint32_t>& number,
                                              const Team& team) const;
  /// Renumbers the free vertices in the order of the triangles, none of which is a hole.
  void number_vertices(const Team& team);
  [[nodiscard]] double coupled_excess(const std::array<std::uint32_t, 3>& v,
                                      const std::array<std::uint32_t, 3>& n) const;

  Goal goal_{kNoNumber, 0, 0};  ///< none yet: equal to no goal
  std::uint32_t fixed_ = 0;
  std::vector<std::uint32_t> free_triangles_;
  std::vector<std::uint32_t> free_vertices_;
};

}  // namespace cover
