// Vertices where no coupling of a side becomes negative.
#pragma once

#include <stop_token>

#include "limits/couplings/half_disc_room.hpp"
#include "mend/mesh_with_undo.hpp"

namespace cover {

/// Adds vertices, in no half disc of `room`, until no more than `most_grave` triangles are gravely
/// bad: one of many short attempts, each from the mesh as it was. False, and nothing has changed,
/// if none comes to that.
///
/// Room is often found only in cusps between two discs, near flat corners, where no projection from
/// afar ends.
/// REQUIRES: `room` is of the region of the mesh, the only one
/// ENSURES: the same mesh for the same input, whatever the machine
/// Cost:    `most_circles` searches for room and 9 more; one, where a proof says that there is none
bool fill_room(MeshWithUndo& mesh, const HalfDiscRoom& room, std::size_t most_grave,
               int most_circles, const std::stop_token& stop);

}  // namespace cover
