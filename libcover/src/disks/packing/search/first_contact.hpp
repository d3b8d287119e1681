// The first disk that gets stuck when it is pushed out of a cusp.
#pragma once

#include <optional>

#include "disks/packing/packing.hpp"

namespace cover::disks {

/// A disk that touches three sides of a cycle: a node of its medial axis.
struct MedialDisk {
  Circle circle;
  Contact i, j, third;
};

/// Follows the disks that touch the sides `i` and `j` on, from the one that touches `i` in `from`,
/// moving backwards on `i` and forwards on `j`, to the first that touches a third side.
///
/// REQUIRES: j = next(i) and `from` is their common point, or j = next(next(i)) and `from` is where
///           a disk touches i that also touches j and the side between.
/// Cost:     about two queries for the nearest obstacle.
std::optional<MedialDisk> first_contact(const Packing& packing, Index i, Index j, Point from);

}  // namespace cover::disks
