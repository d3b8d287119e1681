// Warnings about thin voids between painted polygons.
#pragma once

#include <vector>

#include <cover/pslg.hpp>
#include <cover/report.hpp>

#include "faces/faces.hpp"
#include "faces/seeds.hpp"

namespace cover {

/// Appends a warning to `notes` if thin voids lie between different polygons: neighbours whose
/// common border is curved and was cut differently leave them, too wide to be welded.
/// So are thin parts of a wider void, as those that open to the outside or to a street
/// (open_gaps.hpp). Those that are far wider than the others, or as wide as streets beside their
/// polygons, are taken as meant. `weld` is the tolerance in force.
///
/// Cost: O(n log n)
void warn_of_gaps(const Pslg& pslg, const Faces& faces, const SeededFaces& seeded, double weld,
                  std::vector<Note>& notes);

}  // namespace cover
