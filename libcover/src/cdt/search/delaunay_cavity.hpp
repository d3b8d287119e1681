// The triangles that a new vertex replaces in a constrained Delaunay triangulation, as Bowyer and
// Watson find them. Tested by tests/unit/cdt/search/delaunay_cavity_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <cover/point.hpp>

#include "base/containers/stamped_set.hpp"
#include "base/none.hpp"
#include "cdt/triangulation.hpp"
#include "geom/predicates.hpp"
#include "geom/topology/corner.hpp"

namespace cover {

/// Triangles that are to be replaced, in the order in which they were found. It begins with those
/// that hold the new vertex, and grows over the edges that let pass. One object serves for many
/// vertices, and forgets the last one in no time.
///
/// EXACT: yes
/// Cost:  the triangles in the cavity and beside it
class DelaunayCavity {
 public:
  static constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

  /// Forgets all triangles but `first`; they have numbers below `count`.
  void begin(std::size_t count, std::uint32_t first) {
    triangles_.clear();
    members_.resize(count);
    members_.clear();
    add(first);
  }
  /// Room for triangles with numbers below `count`.
  void reserve(std::size_t count) { members_.reserve(count); }

  /// REQUIRES: it does not have `t`
  void add(std::uint32_t t) {
    members_.insert(t);
    triangles_.push_back(t);
  }

  /// Adds what is connected with the triangles of the cavity by triangles whose circles hold `p`.
  ///
  /// `across(t, i)` is the triangle across edge i of t, or kNone if that is a wall; `corners(t)`
  /// are the points of a triangle. `at_rim(t, i)` is told of each edge that is a wall or has a
  /// triangle beyond it that stays, in the order of the cavity, and answers whether to go on.
  /// ENSURES: false if it said no, or if there are more than `most` triangles
  template <class Across, class Corners, class AtRim>
  bool grow(Point p, const Across& across, const Corners& corners, const AtRim& at_rim,
            std::size_t most = kAny) {
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      if (triangles_.size() > most) return false;
      const std::uint32_t t = triangles_[k];
      for (const Corner i : kCorners) {
        const std::uint32_t n = across(t, i);
        if (n != kNone) {
          if (members_.contains(n)) continue;
          const std::array<Point, 3> beyond = corners(n);
          if (in_circle(beyond[0], beyond[1], beyond[2], p) == Sign::positive) {
            add(n);
            continue;
          }
        }
        if (!at_rim(t, i)) return false;
      }
    }
    return true;
  }
  /// The same in a triangulation whose locked edges are walls.
  template <class AtRim>
  bool grow(Point p, const Triangulation& cdt, const AtRim& at_rim) {
    return grow(
        p,
        [&](std::uint32_t t, Corner i) {
          const Triangle& triangle = cdt.triangles[t];
          return triangle.is_locked(i) ? kNone : triangle.n[i];
        },
        [&](std::uint32_t t) {
          const auto& [a, b, c] = cdt.triangles[t].v;
          return std::array{cdt.points[a], cdt.points[b], cdt.points[c]};
        },
        at_rim);
  }

  [[nodiscard]] const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  [[nodiscard]] std::size_t size() const { return triangles_.size(); }

 private:
  std::vector<std::uint32_t> triangles_;
  StampedSet members_;
};

}  // namespace cover
