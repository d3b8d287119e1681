// The vertices of a mesh that are images of each other.
#pragma once

#include <vector>

#include <cover/mesh_class.hpp>
#include <cover/periodic.hpp>
#include <cover/pslg.hpp>

namespace cover {

/// By rule: pairs of vertices and edges of `mesh`, a mesh of `pslg`. Segments that touch no region
/// are left out, as in the mesh.
///
/// REQUIRES: `rules` are those that Pslg::isometries stand for
/// Cost:     O(n log n)
std::vector<PeriodicNodes> periodic_nodes(const Pslg& pslg, const std::vector<PeriodicRule>& rules,
                                          const Mesh& mesh);

}  // namespace cover
