// Tested by tests/unit/io/write_mesh/mesh_view_test.cpp.
#include "io/text/array_names.hpp"

#include <algorithm>
#include <iterator>

#include "base/words/safe_names.hpp"

namespace cover {
namespace {

constexpr std::string_view kOwnArrays[] = {
    "material",     "MaterialID",   "max_angle",    "mat_id",   "RegionId",   "min_angle",
    "LineID",       "LeftRegion",   "RightRegion",  "LineKind", "marker",     "GlobalNodeId",
    "PeriodicNode", "vtkGhostType", "GlobalCellId", "Owner",    "ManifoldID", "GroupID"};

}  // namespace

bool is_own_array(std::string_view name) {
  return std::find(std::begin(kOwnArrays), std::end(kOwnArrays), name) != std::end(kOwnArrays);
}

std::vector<std::string> array_names(std::vector<std::string> names) {
  for (std::string& name : names) std::replace(name.begin(), name.end(), '/', '_');
  names.insert(names.begin(), std::begin(kOwnArrays), std::end(kOwnArrays));
  names = unique_legible_names(names);
  names.erase(names.begin(), names.begin() + std::size(kOwnArrays));
  return names;
}

std::string words_name(const std::string& array) { return array + "_names"; }

}  // namespace cover
