// What a covering mesh must look like, from the PSLG alone: for verify_cover().
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>

#include "base/team.hpp"
#include "cdt/cdt.hpp"

namespace cover {

/// A side of a segment, or of the convex hull, directed so that its region lies on the left.
struct ExpectedSide {
  std::uint32_t a = 0;  ///< VertexId
  std::uint32_t b = 0;
  RegionId region;    ///< kVoid: no triangle may lie here
  bool hull = false;  ///< a side of the hull that is no segment: it may be split
  /// VertexId of the point that sees the side under the largest angle; its own where none does.
  std::uint32_t apex = 0;
};

/// The domain of a PSLG.
struct ExpectedDomain {
  std::vector<ExpectedSide> sides;     ///< two per segment, in order; then those of the hull
  std::vector<std::uint8_t> is_used;   ///< by VertexId: whether some region has the point
  std::vector<double> nu_opt;          ///< by RegionId, in radians; pi where nothing is forced
  Triangulation cdt;                   ///< of the whole PSLG,
  std::vector<RegionId> cdt_region;    ///< and the region of each of its triangles
  std::vector<CdtConflict> conflicts;  ///< not empty: the PSLG is not clean, all else is empty
};

/// Finds the domain by one constrained Delaunay triangulation of the whole PSLG. Its triangles on
/// the sides of a region have the angles of the region's own: a point that is not visible from a
/// segment is on no triangle with it, and apices on one circle see it under the same angle.
///
/// Cost: O(n log n)
ExpectedDomain expected_domain(const Pslg& pslg, const RegionTable& table, bool hull,
                               const Team& team = {});

}  // namespace cover
