// Names that a mesh, or the manifest beside it, tells, beside those of the input.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/ids.hpp>
#include <cover/point.hpp>
#include <cover/read_origin.hpp>

#include "commands/check/named_groups.hpp"
#include "files/mesh_file.hpp"

namespace cover::app {

/// A point of the input that has another name in the mesh.
struct WrongPoint {
  std::string name;
  std::string there;  ///< empty: none
  Point at;
};

/// What is called otherwise in the mesh.
struct ToldNames {
  std::vector<WrongRegion> regions;    ///< in the order of the regions
  std::vector<WrongPoint> points;      ///< in the order of the input
  std::vector<std::string> unchecked;  ///< what cannot be compared
};

/// Compares names of regions with materials, and of points, where a mesh tells them that has
/// numbers of regions. Names that the input has nowhere may be those of a format, so regions, or
/// points, are compared only if all are names of the input's.
///
/// `told` by RegionId - 1 of the mesh, or empty; `regions` as Verification::triangle_regions.
/// Cost: O(n log n)
ToldNames check_told_names(const Prepared& input, std::span<const RegionId> regions,
                           std::span<const RegionNames> told, const MeshTriangles& mesh);

}  // namespace cover::app
