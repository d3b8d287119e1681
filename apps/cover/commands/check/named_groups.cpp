// Tested by tests/unit/app/named_groups_test.cpp.
#include "commands/check/named_groups.hpp"

#include <utility>

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

}  // namespace cover::app
