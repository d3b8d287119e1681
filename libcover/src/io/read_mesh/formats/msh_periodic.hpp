// Which nodes of a .msh are images of each other.
#pragma once

#include <string_view>
#include <vector>

#include <cover/periodic.hpp>

#include "io/read_mesh/formats/msh_file.hpp"

namespace cover {

/// What $Periodic says of the curves of `file`, which was read from `text`: rules between the names
/// of their groups, or their numbers where these have none. Nothing where it is binary, not as gmsh
/// writes it, without maps, of surfaces, or where images of lines are no lines, maps are no
/// isometries or do not take nodes to their images: then no part of it is taken.
///
/// Cost: O(n log n)
std::vector<PeriodicNodes> periodic_of_msh(std::string_view text, const MshFile& file);

}  // namespace cover
