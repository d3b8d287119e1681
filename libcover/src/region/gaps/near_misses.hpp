// Warnings about what nearly touches and may have been meant to.
#pragma once

#include <string>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/report.hpp>

#include "base/team.hpp"
#include "cdt/triangulation.hpp"
#include "faces/faces.hpp"

namespace cover {

/// Appends a warning to `notes` for points that are very near to each other or to a segment that
/// they do not belong to, compared with the lengths around them; for ends of lines in regions that
/// are near to something compared with their line.
///
/// REQUIRES: the triangulation of `faces` is the constrained Delaunay one of the hull: what is near
///           each other in sight of each other shares a triangle in it
/// Cost:     O(n).
void warn_of_near_misses(const Pslg& pslg, const Faces& faces, const std::vector<bool>& is_void,
                         const Team& team, std::vector<Note>& notes);

/// The same as an end of a sentence about faces that are not as they should be, "; point 4 at ...
/// is only ...": where lines do not quite meet, that is why. Empty where nothing nearly touches.
std::string near_misses_behind(const Pslg& pslg, const Triangulation& triangulation);

}  // namespace cover
