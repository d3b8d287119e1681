// Groups of a mesh that has no materials, known by their names.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <cover/regions.hpp>
#include <cover/triangle_soup.hpp>

namespace cover::app {

/// Puts materials of the input in the place of groups, if all groups have the name of one, or of a
/// region, in capitals or not. False, and nothing is done: some have not, or a name is that of two
/// materials.
///
/// REQUIRES: mesh.material holds the number of a group per triangle
bool take_materials_by_name(const RegionTable& table,
                            const std::map<std::int64_t, std::string>& names, TriangleSoup& mesh);

}  // namespace cover::app
