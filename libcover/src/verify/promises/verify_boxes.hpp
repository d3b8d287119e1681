// Negative couplings of the box method: for verify_cover().
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <cover/report.hpp>
#include <cover/triangle_soup.hpp>

#include "geom/topology/soup_edges.hpp"
#include "verify/expected_domain.hpp"
#include "verify/verify_regions.hpp"

namespace cover {

/// What the box method meets.
struct BoxCheck {
  std::vector<NegativeCoupling> negative;  ///< inner edges first
  std::size_t obtuse = 0;                  ///< triangles with an angle above 90 degrees
  std::size_t obtuse_by_rounding = 0;  ///< those of them that are no more than Blunt::by_rounding
};

/// The edges with a negative coupling in their region. `side_of` is by edge an index into the sides
/// of `domain`, whose points these are; `region` by triangle.
///
/// EXACT: yes
/// Cost:  O(n log n)
BoxCheck verify_boxes(const TriangleSoup& mesh, const SoupEdges& edges,
                      std::span<const std::uint32_t> side_of, const ExpectedDomain& domain,
                      std::span<const RegionId> region, std::span<const Point> points);

}  // namespace cover
