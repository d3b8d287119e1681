// Attributes of regions and values at points that came with the input of a run, as a file of its
// mesh holds them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>

namespace cover {

/// What arrays of words mean, by their names.
using ArrayWords = std::map<std::string, std::vector<std::string>>;

/// Puts arrays into the order of `names`, that of the input; others stay behind them.
template <class Array>
void sort_arrays(const std::vector<std::string>& names, std::vector<Array>& arrays) {
  std::map<std::string_view, std::size_t> places;
  for (const std::string& name : names) places.emplace(name, places.size());
  const auto place = [&](const Array& array) {
    const auto at = places.find(array.name);
    return at != places.end() ? at->second : names.size();
  };
  std::stable_sort(arrays.begin(), arrays.end(),
                   [&](const Array& a, const Array& b) { return place(a) < place(b); });
}

/// Gives `stored` the arrays of its file that are not our own: those of triangles as attributes of
/// regions, those of points as fields. What a file beside it said of them before names them and
/// tells their words; the values are those of the mesh's own file, where that holds them.
/// `holds_all_attributes`: what it does not hold is no attribute of this mesh. `of_regions` are
/// those of `of_points`, as Output::region_values.
///
/// REQUIRES: the regions of the triangles are known, in the order of the file; arrays fit the mesh
/// Returns:  a sentence for what is left out: arrays that differ within a region, attributes and
///           fields that the file does not have
std::vector<std::string> take_arrays(std::vector<CellArray> of_triangles,
                                     std::vector<PlaneField::Array> of_points,
                                     const ArrayWords& words, StoredMesh& stored,
                                     bool holds_all_attributes = false,
                                     RegionValues of_regions = {});

}  // namespace cover
