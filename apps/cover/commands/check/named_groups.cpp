// Tested by tests/unit/app/named_groups_test.cpp.
#include "commands/check/named_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

namespace cover::app {
namespace {

constexpr int kSeveral = 0;  ///< materials are positive

/// Materials by all that they and their regions are called.
std::map<std::string, int> materials_by_name(const RegionTable& table) {
  std::map<std::string, int> materials;
  for (const Region& region : table.regions) {
    for (const std::string& name : {region.material_name, region.name}) {
      const auto [known, is_new] = materials.emplace(lower(name), region.material);
      if (!is_new && known->second != region.material) known->second = kSeveral;
    }
  }
  return materials;
}

}  // namespace

bool take_materials_by_name(const RegionTable& table,
                            const std::map<std::int64_t, std::string>& names, TriangleSoup& mesh) {
  const std::map<std::string, int> materials = materials_by_name(table);
  std::map<std::int64_t, int> material_of;
  for (const std::int64_t group : mesh.material) {
    const auto [known, is_new] = material_of.emplace(group, kSeveral);
    if (!is_new) continue;
    const auto name = names.find(group);
    if (name == names.end()) return false;
    const auto material = materials.find(lower(name->second));
    if (material == materials.end() || material->second == kSeveral) return false;
    known->second = material->second;
  }
  for (std::int64_t& number : mesh.material) number = material_of.at(number);
  return true;
}

std::vector<WrongRegion> check_named_regions(const RegionTable& table,
                                             std::span<const RegionId> regions,
                                             std::span<const std::int64_t> groups,
                                             const std::map<std::int64_t, std::string>& names,
                                             const TriangleSoup& mesh) {
  std::map<RegionId, WrongRegion> wrong;
  for (std::size_t t = 0; t < regions.size(); ++t) {
    if (regions[t] == kVoid) continue;
    const Region& region = table.region(regions[t]);
    const std::string& group = names.at(groups[t]);
    if (lower(group) == lower(region.name) || lower(group) == lower(region.material_name)) continue;
    const auto at = mesh.points[mesh.triangles[t][0]];
    ++wrong.try_emplace(region.id, WrongRegion{region.name, group, 0, at}).first->second.triangles;
  }
  std::vector<WrongRegion> found;
  for (auto& [id, region] : wrong) found.push_back(std::move(region));
  return found;
}

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
