// Groups of a mesh that has no materials, known by their names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <cover/ids.hpp>
#include <cover/point.hpp>
#include <cover/regions.hpp>
#include <cover/triangle_soup.hpp>

namespace cover::app {

/// Puts materials of the input in the place of groups, if all groups have the name of one, or of a
/// region, in capitals or not. False, and nothing is done: some have not, or a name is that of two
/// materials.
///
/// REQUIRES: mesh.material holds the number of a group per triangle
bool take_materials_by_name(const RegionTable& table,
                            const std::map<std::int64_t, std::string>& names, TriangleSoup& mesh);

/// A region of the input with triangles in a group that is called neither as it nor as its
/// material, be it in capitals or not.
struct WrongRegion {
  std::string name;
  std::string group;  ///< that of the first such triangle
  std::size_t triangles = 0;
  Point at;  ///< a corner of the first one
};

/// Compares the names of groups with those of the regions in which their triangles lie.
///
/// `regions` as Verification::triangle_regions, `groups` the number of a group per triangle.
/// REQUIRES: take_materials_by_name() knows all of them
/// Returns:  in the order of the regions
/// Cost:     O(n log n)
std::vector<WrongRegion> check_named_regions(const RegionTable& table,
                                             std::span<const RegionId> regions,
                                             std::span<const std::int64_t> groups,
                                             const std::map<std::int64_t, std::string>& names,
                                             const TriangleSoup& mesh);

}  // namespace cover::app
