// Tested by tests/cli/check_test.py.
#include "commands/check/told_names.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

namespace cover::app {
namespace {

using NameAt = std::pair<Point, std::string>;

/// The first of the names that is none of the others; null if all are.
const std::string* first_unknown(const std::set<std::string>& names,
                                 const std::set<std::string>& others) {
  const auto unknown = std::find_if(
      names.begin(), names.end(), [&](const std::string& name) { return !others.contains(name); });
  return unknown != names.end() ? &*unknown : nullptr;
}

void compare_regions(const RegionTable& table, std::span<const RegionId> regions,
                     std::span<const RegionNames> told, const TriangleSoup& mesh,
                     ToldNames& found) {
  const auto called = [](const std::string& region, const std::string& material) {
    return region == material ? region : fmt::format("{}' of '{}", region, material);
  };
  std::set<std::string> names, known;
  for (const RegionNames& region : told) names.insert(called(region.region, region.material));
  for (const Region& region : table.regions)
    known.insert(called(region.name, region.material_name));
  if (const std::string* unknown = first_unknown(names, known)) {
    found.unchecked.push_back(
        fmt::format("names of regions: '{}' is none of the input's", printable(*unknown)));
    return;
  }
  std::map<RegionId, WrongRegion> wrong;
  for (std::size_t t = 0; t < regions.size(); ++t) {
    const std::int64_t there = mesh.region[t];
    if (regions[t] == kVoid || there < 1 || there > static_cast<std::int64_t>(told.size()))
      continue;
    const Region& region = table.region(regions[t]);
    const RegionNames& other = told[static_cast<std::size_t>(there) - 1];
    if (other.region == region.name && other.material == region.material_name) continue;
    WrongRegion first{called(region.name, region.material_name),
                      called(other.region, other.material), 0, mesh.points[mesh.triangles[t][0]]};
    ++wrong.try_emplace(region.id, std::move(first)).first->second.triangles;
  }
  for (auto& [id, region] : wrong) found.regions.push_back(std::move(region));
}

void compare_points(const Pslg& pslg, const MeshTriangles& mesh, ToldNames& found) {
  std::set<std::string> names, known;
  std::set<NameAt> there;
  std::map<Point, std::string> name_at;
  for (const NamedPoint& point : mesh.named_points) {
    const Point at = mesh.soup.points[point.vertex.index()];
    names.insert(point.name);
    there.insert({at, point.name});
    name_at.emplace(at, point.name);
  }
  for (const NamedPoint& point : pslg.named_points) known.insert(point.name);
  if (const std::string* unknown = first_unknown(names, known)) {
    found.unchecked.push_back(
        fmt::format("names of points: '{}' is none of the input's", printable(*unknown)));
    return;
  }
  for (const NamedPoint& point : pslg.named_points) {
    const Point at = pslg.points[point.vertex.index()];
    if (there.contains({at, point.name})) continue;
    const auto other = name_at.find(at);
    found.points.push_back({point.name, other != name_at.end() ? other->second : "", at});
  }
}

}  // namespace

ToldNames check_told_names(const Prepared& input, std::span<const RegionId> regions,
                           std::span<const RegionNames> told, const MeshTriangles& mesh) {
  ToldNames found;
  if (!told.empty() && mesh.soup.region.size() == regions.size())
    compare_regions(input.table, regions, told, mesh.soup, found);
  if (!mesh.named_points.empty()) compare_points(input.pslg, mesh, found);
  return found;
}

}  // namespace cover::app
