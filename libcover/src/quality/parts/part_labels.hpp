// Which part of a large mesh each triangle belongs to.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/containers/unset_vector.hpp"
#include "base/team.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Parts of a mesh that depend on the mesh alone.
struct PartLabels {
  UnsetVector<std::uint32_t> of_triangle;  ///< kNone for holes
  std::size_t count = 0;
};

/// Some `parts` of about the same size: cells of a k-d tree over the middles of the triangles, or
/// branches where the mesh has fixed vertices alone. Its triangles reach from one end of the region
/// to the other then, and neighbours have their middles far apart: any line through the plane would
/// have a border beside half of them. But going from triangle to triangle is going along a tree,
/// but for holes, of which whole branches are taken off.
///
/// Cost: O(triangles)
PartLabels label_parts(const MutableMesh& mesh, std::size_t parts, const Team& team);

}  // namespace cover
