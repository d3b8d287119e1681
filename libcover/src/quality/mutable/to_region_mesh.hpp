// From the mesh that was worked on to the triangles of the region.
#pragma once

#include <span>

#include <cover/point.hpp>

#include "base/team.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "region/region_mesh.hpp"
#include "target/local_frame.hpp"

namespace cover {

/// The triangles of `mesh`, which is in `frame`, and its free vertices back in the plane; without
/// a report.
///
/// REQUIRES: the fixed vertices of `mesh` are `points`, in the frame
/// ENSURES:  no triangles if rounding on the way back turned one over
RegionMesh to_region_mesh(const MutableMesh& mesh, const LocalFrame& frame,
                          std::span<const Point> points, const Team& team = {});

}  // namespace cover
