// The smallest and the largest angle of a mesh.
#pragma once

#include "base/team.hpp"
#include "limits/angles/angle_range.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// The extreme angles of all triangles.
AngleRange extreme_angles(const MutableMesh& mesh, const Team& team = {});

}  // namespace cover
