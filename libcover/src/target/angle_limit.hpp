// How small the largest angle of a region can possibly be made (Lemma 1 of the paper).
#pragma once

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include <cover/ids.hpp>

#include "base/team.hpp"
#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// gamma_opt of a region and of its sides, kept as nu = pi - gamma_opt.
struct AngleLimit {
  double nu = std::numbers::pi;  ///< B: the smallest of side_nu; pi if no side has a limit
  std::vector<double> side_nu;   ///< by side, in radians; pi for kHullSide
  std::vector<EdgeRef> at;       ///< by side: its triangle, whose opposite corner is the apex
  std::size_t above_120 = 0;     ///< sides with gamma_opt above 120 degrees
  std::size_t above_150 = 0;     ///< sides with gamma_opt above 150 degrees

  /// min(B/2, 30 degrees): what promise 3 asks of every triangle.
  [[nodiscard]] double promised_nu() const;
};

/// The limits that the sides set. The apex of a side is the vertex that sees it, from inside the
/// region, under the largest angle; the constrained Delaunay triangle on the side has it as corner.
///
/// REQUIRES: `cdt` is the constrained Delaunay triangulation of the domain left of `sides`, which
///           are in lexicographic order; `segments` by side.
/// EXACT:    the apexes; nu to a few units in the last place, however flat the triangle.
/// Cost:     O(n)
/// Ref:      mitchell_1993_covering, Lemma 1
AngleLimit angle_limit(const Triangulation& cdt, std::span<const IndexPair> sides,
                       std::span<const SegmentId> segments, const Team& team = {});

/// pi minus the angle a-p-b, to a few units in the last place even where that angle is so flat
/// that the differences of the coordinates lose what counts.
double accurate_nu_at(Point a, Point p, Point b);

}  // namespace cover
