// Tested by tests/unit/region/named_regions_test.cpp.
#include <cover/regions.hpp>

#include <charconv>
#include <optional>

#include <fmt/core.h>

#include <cover/text.hpp>

namespace cover {
namespace {

constexpr std::string_view kById = "region:";

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

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
  if (const auto material = whole_number(name)) {
    return regions_where(table, [&](const Region& r) { return r.material == *material; });
  }
  if (!name.starts_with(kById)) return {};
  const auto id = whole_number(name.substr(kById.size()));
  if (!id || *id < 1) return {};
  return regions_where(table, [&](const Region& r) { return r.id == RegionId{*id}; });
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
