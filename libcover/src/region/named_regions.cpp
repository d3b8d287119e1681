// Tested by tests/unit/region/named_regions_test.cpp.
#include <cover/regions.hpp>

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/core.h>

#include <cover/pslg.hpp>
#include <cover/text.hpp>

#include "base/words/meant_or_there.hpp"
#include "base/words/parse_number.hpp"
#include "region/lines_between.hpp"

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

/// Whether `name` is made of two names.
bool is_made_of(std::string_view name, std::string_view first, std::string_view second) {
  return name.size() == first.size() + 1 + second.size() && name.starts_with(first) &&
         name[first.size()] == '_' && name.ends_with(second);
}

/// Whether `name` is made of the names of the regions beside `line`, in either order.
bool is_of_both(const RegionTable& table, const Interface& line, std::string_view name) {
  if (line.kind != InterfaceKind::interface) return false;
  const std::string &left = table.region(line.left).name, &right = table.region(line.right).name;
  return is_made_of(name, left, right) || is_made_of(name, right, left);
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

std::string lines_between(const RegionTable& table, std::string_view name) {
  std::vector<std::string> lines;
  std::string left, right;
  for (const Interface& line : table.interfaces) {
    if (line.left == kVoid || line.right == kVoid || line.left == line.right) continue;
    const auto names = [&](RegionId id) {
      const Region& region = table.region(id);
      return std::array{region.name, region.material_name};
    };
    for (const std::string& one : names(line.left)) {
      for (const std::string& other : names(line.right)) {
        const bool is_left_first = is_made_of(name, one, other);
        if (!is_left_first && !is_made_of(name, other, one)) continue;
        left = is_left_first ? one : other;
        right = is_left_first ? other : one;
        lines.push_back(fmt::format("'{}'", line.name));
      }
    }
  }
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  if (lines.empty()) return "";
  constexpr std::size_t kMostLines = 8;
  const std::size_t more = lines.size() - std::min(lines.size(), kMostLines);
  lines.resize(lines.size() - more);
  return fmt::format("; between '{}' and '{}' {} {}{}", left, right,
                     lines.size() == 1 ? "lies" : "lie", listed(lines),
                     more == 0 ? "" : fmt::format(" and {} more", more));
}

Error no_such_region(const RegionTable& table, const std::string& what, const std::string& name) {
  std::vector<std::string> names;
  for (const Region& region : table.regions) {
    names.push_back(region.name);
    names.push_back(region.material_name);
  }
  return {ErrorCode::bad_option,
          fmt::format("{} '{}': there is no region or material of that name{}", what, name,
                      meant_or_there(name, names)),
          {},
          {}};
}

}  // namespace cover
