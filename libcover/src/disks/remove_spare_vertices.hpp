// After the gaps: vertices that are not needed go.
#pragma once

#include "disks/packing/packing.hpp"

namespace cover::disks {

/// Removes vertices from `first` on whose neighbours can be triangulated without them and without
/// an angle above `most` (radians). Compacts the vertices.
///
/// The packing makes every triangle right-angled, so that each can be proved; most of that is more
/// than nonobtuse needs. Vertices on a chord are removed likewise, from its one side.
/// Cost: O(n)
void remove_spare_vertices(TriangleDraft& draft, Index first, double most);

}  // namespace cover::disks
