// What every filling must satisfy, checked without the fill's own code.
#pragma once

#include <cstddef>
#include <string>

#include "disks/filler.hpp"
#include "region/region_boundary.hpp"

namespace cover::testing {

/// The figures of a filling.
struct FillingFacts {
  std::string fault;         ///< empty: a valid triangulation of the task
  double largest_angle = 0;  ///< degrees
  std::size_t vertices = 0;  ///< in triangles, boundary included
  std::size_t triangles = 0;
};

/// The task of filling a whole region; no chord is locked.
FillTask task_of(const RegionBoundary& boundary);

/// Exact orientation, area to 1e-10, every chord a chain of edges, every other edge used twice,
/// every input point a vertex.
FillingFacts check_filling(const FillTask& task, const Filling& filling);

}  // namespace cover::testing
