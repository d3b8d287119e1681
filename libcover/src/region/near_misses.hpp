// Warnings about what nearly touches and may have been meant to.
#pragma once

#include <vector>

#include <cover/pslg.hpp>
#include <cover/report.hpp>

#include "cdt/triangulation.hpp"

namespace cover {

/// Appends a warning to `notes` for points that are very near to each other or to a segment that
/// they do not belong to, compared with the lengths around them.
///
/// REQUIRES: `triangulation` is the constrained Delaunay triangulation of the PSLG's hull: what is
///           near each other in sight of each other shares a triangle in it
/// Cost:     O(n).
void warn_of_near_misses(const Pslg& pslg, const Triangulation& triangulation,
                         std::vector<Note>& notes);

}  // namespace cover
