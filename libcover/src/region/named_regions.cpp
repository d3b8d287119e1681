// Tested by tests/unit/region/named_regions_test.cpp.
#include <cover/regions.hpp>

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include <cover/pslg.hpp>
#include <cover/text.hpp>

#include "base/words/parse_number.hpp"

namespace cover {
namespace {

constexpr std::string_view kById = "region:";
constexpr std::string_view kByMarker = "marker ";

template <class Test>
std::vector<RegionId> regions_where(const RegionTable& table, Test test) {
  std::vector<RegionId> found;
  for (const Region& region : table.regions) {
    if (test(region)) found.push_back(region.id);
  }
  return found;
}

}  // namespace

std::vector<RegionId> named_regions(const RegionTable& table, std::string_view name) {
  auto found = regions_where(
      table, [&](const Region& r) { return r.name == name || r.material_name == name; });
  if (!found.empty()) return found;
  if (const auto material = parse_number<int>(name)) {
    return regions_where(table, [&](const Region& r) { return r.material == *material; });
  }
  if (!name.starts_with(kById)) return {};
  const auto id = parse_number<int>(name.substr(kById.size()));
  if (!id || *id < 1) return {};
  return regions_where(table, [&](const Region& r) { return r.id == RegionId{*id}; });
}

std::vector<SegmentId> named_segments(const Pslg& pslg, const RegionTable& table,
                                      std::string_view name) {
  std::vector<SegmentId> found;
  for (const Interface& part : table.interfaces) {
    if (part.name == name) found.insert(found.end(), part.segments.begin(), part.segments.end());
  }
  if (found.empty()) {
    if (name.starts_with(kByMarker)) name.remove_prefix(kByMarker.size());
    const auto marker = parse_number<int>(name);
    for (std::size_t s = 0; s < pslg.segments.size() && marker && *marker != 0; ++s)
      if (pslg.segments[s].marker == *marker) found.emplace_back(s);
  }
  std::sort(found.begin(), found.end());
  return found;
}

Error no_such_region(const RegionTable& table, const std::string& what, const std::string& name) {
  std::vector<std::string> names;
  for (const Region& region : table.regions) {
    names.push_back(region.name);
    names.push_back(region.material_name);
  }
  return {ErrorCode::bad_option,
          fmt::format("{} '{}': there is no region or material of that name{}", what, name,
                      did_you_mean(name, names)),
          {},
          {}};
}

}  // namespace cover
