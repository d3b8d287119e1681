// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/promises/verify_labels.hpp"

#include <map>

#include <fmt/core.h>

#include <cover/text.hpp>

namespace cover {
namespace {

/// "triangle 7 at (0, 0)".
std::string triangle_text(const TriangleSoup& mesh, std::uint32_t t) {
  return fmt::format("triangle {} at {}", t, describe(mesh.points[mesh.triangles[t][0]]));
}

}  // namespace

void verify_region_ids(const TriangleSoup& mesh, std::span<const RegionId> region,
                       const TellViolation& tell) {
  std::map<RegionId, std::int64_t> id_of;
  std::map<std::int64_t, RegionId> region_of;
  RegionId right = kVoid;  // of the triangle before, if its number was right
  std::int64_t right_id = 0;
  for (std::uint32_t t = 0; t < region.size(); ++t) {
    const std::int64_t id = mesh.region[t];
    if (region[t] == kVoid || (region[t] == right && id == right_id)) continue;
    const std::int64_t its = id_of.emplace(region[t], id).first->second;
    const RegionId its_region = region_of.emplace(id, region[t]).first->second;
    if (its == id && its_region == region[t]) {
      right = region[t], right_id = id;
      continue;
    }
    tell(t, fmt::format("{} has RegionId {}, as others of region {}, but lies in region {} with "
                        "RegionId {}",
                        triangle_text(mesh, t), id, its_region.value(), region[t].value(), its));
  }
}

void verify_materials(const TriangleSoup& mesh, std::span<const RegionId> region,
                      const RegionTable& table, bool numbered, const TellViolation& tell) {
  std::map<std::int64_t, std::uint32_t> first_of;  // triangle with a number
  for (std::uint32_t t = 0; t < region.size(); ++t) {
    if (region[t] == kVoid) continue;
    const std::int64_t number = mesh.material[t];
    const int wanted = table.region(region[t]).material;
    if (numbered) {
      if (number == wanted) continue;
      tell(t, fmt::format("{} in region {} has material {} instead of {}", triangle_text(mesh, t),
                          region[t].value(), number, wanted));
      continue;
    }
    const std::uint32_t first = first_of.emplace(number, t).first->second;
    if (table.region(region[first]).material == wanted) continue;
    tell(t, fmt::format("{} in region {} of material {} is in group {}, as is {} in region {} of "
                        "material {}",
                        triangle_text(mesh, t), region[t].value(), wanted, number,
                        triangle_text(mesh, first), region[first].value(),
                        table.region(region[first]).material));
  }
}

}  // namespace cover
