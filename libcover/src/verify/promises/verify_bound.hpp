// Promise 3 on a mesh whose triangles are known to fill the regions: for verify_cover().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/angle.hpp>
#include <cover/ids.hpp>
#include <cover/verify.hpp>

#include "verify/expected_domain.hpp"

namespace cover {

/// A region that misses its bound, as pi minus angle.
struct BoundMissed {
  RegionId region;
  std::uint32_t triangle = 0;  ///< the one that misses it most, with rounding in its favour
  Angle nu;                    ///< of this triangle
  Angle bound;
};

/// All regions against their bounds.
struct BoundCheck {
  std::vector<BoundMissed> missed;  ///< by region
  std::size_t within_rounding = 0;  ///< regions that keep it up to the rounding of coordinates
};

/// Compares pi - gamma of every region with min((pi - gamma_opt) / 2, pi / 6). `region` is by
/// triangle, kVoid for triangles to be passed over; `scale` is the largest coordinate.
/// `without_room` are triangles, ascending, that lie so flat on a side of the hull that doubles
/// hold no vertex to split it: they count as kept by rounding.
BoundCheck verify_bound(const TriangleSoup& mesh, std::span<const RegionId> region,
                        const ExpectedDomain& domain, double scale,
                        std::span<const std::uint32_t> without_room, const Team& team = {});

}  // namespace cover
