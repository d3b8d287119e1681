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

/// Whether `name` is made of the names of the regions beside `line`, in either order.
bool is_of_both(const RegionTable& table, const Interface& line, std::string_view name) {
  if (line.kind != InterfaceKind::interface) return false;
  const std::string &left = table.region(line.left).name, &right = table.region(line.right).name;
  const auto is_made_of = [&](const std::string& first, const std::string& second) {
    return name.size() == first.size() + 1 + second.size() && name.starts_with(first) &&
           name[first.size()] == '_' && name.ends_with(second);
  };
  return is_made_of(left, right) || is_made_of(right, left);
}

/// The segments of the lines that pass the test.
template <class Test>
std::vector<SegmentId> segments_where(const RegionTable& table, Test test) {
  std::vector<SegmentId> found;
  for (const Interface& line : table.interfaces) {
    if (test(line)) found.insert(found.end(), line.segments.begin(), line.segments.end());
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
  std::vector<SegmentId> found =
      segments_where(table, [&](const Interface& line) { return line.name == name; });
  // A name that the input gives is no other line's, wherever that line lies.
  const bool is_given = std::find(pslg.names.begin(), pslg.names.end(), name) != pslg.names.end();
  if (found.empty() && !is_given)
    found =
        segments_where(table, [&](const Interface& line) { return is_of_both(table, line, name); });
  if (found.empty()) {
    if (name.starts_with(kByMarker)) name.remove_prefix(kByMarker.size());
    const auto marker = parse_number<int>(name);
    for (std::size_t s = 0; s < pslg.segments.size() && marker && *marker != 0; ++s)
      if (pslg.segments[s].marker == *marker) found.emplace_back(s);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string line_in_void(const Pslg& pslg, std::string_view name) {
  const auto line = std::find_if(pslg.segments.begin(), pslg.segments.end(), [&](const Segment& s) {
    return s.name != 0 && pslg.names[s.name] == name;
  });
  if (line == pslg.segments.end()) return "";
  return fmt::format(
      "the line '{}' touches no region that is meshed: it lies in the void, first "
      "from {} to {}",
      name, describe(pslg.points[line->a.index()]), describe(pslg.points[line->b.index()]));
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
