// The arcs of a region with everything that lies on them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "almond/almond.hpp"
#include "base/team.hpp"

namespace cover {

/// A vertex of an arc.
struct ArcVertex {
  std::uint32_t vertex = 0;
  double place = 0;  ///< 0 at u, 1 at v
};

/// The arcs with their vertices in order.
struct ArcLayer {
  std::vector<Point> points;         ///< those of the triangulation, then the meetings
  std::vector<std::uint32_t> first;  ///< by almond, into `vertices`; one more at the end
  std::vector<ArcVertex> vertices;   ///< from u to v, both included; no vertex twice in a row
  std::size_t visits = 0;            ///< of almonds in triangles, and pairs of them looked at

  [[nodiscard]] std::span<const ArcVertex> of(std::size_t almond) const {
    return std::span(vertices).subspan(first[almond], first[almond + 1] - first[almond]);
  }
};

/// Finds the visible meetings of all arcs.
///
/// Vertices of one arc that are no farther apart than rounding are united: three arcs through one
/// point are ordinary. `unite` scales that distance (1, or more when a repair asks for it).
/// Cost: O(n log n); meetings are linear in number because no point lies in three almonds (Lemma 5)
/// Ref:  mitchell_1993_covering, section 3
ArcLayer lay_arcs(const Triangulation& cdt, std::span<const Almond> almonds, double unite,
                  const Team& team = {});

}  // namespace cover
