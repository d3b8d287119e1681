// The disk packing fill: nonobtuse triangulation of a polygon with holes.
#pragma once

#include <memory>
#include <span>

#include <cover/packing.hpp>

#include "disks/filler.hpp"

namespace cover {

/// How to fill.
struct DiskFillOptions {
  bool removes_spare_vertices = true;  ///< remove vertices that no angle needs; false: as published
  PackingRecord* record = nullptr;     ///< receives the packing; must outlive the filler
};

/// The filler. It aims at no angle above 90 degrees; target_reached allows kLargestSnapped.
///
/// A chord that is locked, or given in both directions (a slit), cannot be kept whole, because
/// corner disks put points on every chord. Such a task, and one on which rounding defeats every
/// attempt, is filled by its constrained Delaunay triangulation, with target_reached = false and a
/// remark. A task that is no domain at all (its chords cross) gives no triangles.
///
/// Cost: about 25 vertices per vertex of the task (36 without thinning); near O(n log n).
/// Ref:  bmr_1995; thinning is ours
std::unique_ptr<Filler> make_disk_filler(const DiskFillOptions& options = {});

/// Triangulates a domain that has disks centred on its whole boundary, without another point on a
/// chord: fills both sides of an interface so that they fit.
///
/// `radii`, by point: see disks::place_boundary_disks().
/// ENSURES:  as the disk filler; locked chords and slits are welcome.
Filling fill_between_disks(const FillTask& task, std::span<const double> radii,
                           const std::stop_token& stop, const DiskFillOptions& options = {});

}  // namespace cover
