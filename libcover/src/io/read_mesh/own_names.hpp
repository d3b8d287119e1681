// Where a file beside a mesh, which an earlier run may have left, contradicts the mesh's own file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>

namespace cover {

/// Puts names and numbers of materials that the mesh's own file holds into `stored`, which has them
/// from a file beside it. Names that a format only writes in another way stay as they are.
///
/// REQUIRES: the regions of the triangles are known; names stand in `stored`
void take_own_names(const MeshFile& file, StoredMesh& stored);

/// In what `told`, names and attributes of a file beside the mesh, differs from `stored`, that of
/// the mesh's own file: the first few in words. Empty: in nothing.
std::string contradictions(const StoredMesh& told, const StoredMesh& stored);

}  // namespace cover
