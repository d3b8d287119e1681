// What a mesh file says of regions and lines, where no manifest says it better.
#pragma once

#include <string>
#include <vector>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>

namespace cover {

/// Regions, their names, and lines as far as the file has them. Regions that the file does not tell
/// are the connected pieces of one group or material, in the order of their first triangles. A line
/// whose name is not made from its regions is a contact; a line without a name has its number as
/// its boundary marker. Materials whose numbers do not fit into Region::material get others, of
/// which `notes` tell.
///
/// REQUIRES: stored.soup is that of `file`, with indices in range
/// Returns:  what stays unknown, for a message.
std::string complete_from_file(const MeshFile& file, StoredMesh& stored,
                               std::vector<std::string>& notes);

/// Gives triangles without a material that of their region; false if there is no such region.
bool take_materials(StoredMesh& stored);

/// Triangles by region, as cover has them; within a region in the order in which they are.
void sort_by_region(TriangleSoup& soup);

}  // namespace cover
