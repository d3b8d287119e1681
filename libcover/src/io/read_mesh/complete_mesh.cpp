// Tested by tests/unit/io/read_mesh/read_output_test.cpp.
#include "io/read_mesh/complete_mesh.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <unordered_set>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {
namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

/// Numbers the pieces of triangles that are joined by edges which are no lines, and have the same
/// material.
void find_regions(const std::vector<MeshLine>& lines, TriangleSoup& soup) {
  std::unordered_set<std::uint64_t> walls;
  for (const MeshLine& line : lines) walls.insert(key_of(line.a, line.b));
  const HalfEdges edges(soup.points.size(), soup.triangles);
  soup.region.assign(soup.triangles.size(), 0);
  std::int64_t regions = 0;
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t first = 0; first < soup.triangles.size(); ++first) {
    if (soup.region[first] != 0) continue;
    soup.region[first] = ++regions;
    waiting.push_back(first);
    while (!waiting.empty()) {
      const std::uint32_t t = waiting.back();
      waiting.pop_back();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::uint32_t twin = edges.twin(h);
        if (twin == kNone) continue;
        const std::uint32_t other = twin / 3;
        if (soup.region[other] != 0 || soup.material[other] != soup.material[t] ||
            walls.contains(key_of(edges.source(h), edges.target(h))))
          continue;
        soup.region[other] = regions;
        waiting.push_back(other);
      }
    }
  }
}

/// Gives materials whose numbers no Region can hold the lowest ones that are free, and appends a
/// sentence on each to `notes`.
void renumber_materials(TriangleSoup& soup, std::vector<std::string>& notes) {
  using Number = decltype(Region::material);
  constexpr std::int64_t kLeast = std::numeric_limits<Number>::min();
  constexpr std::int64_t kMost = std::numeric_limits<Number>::max();
  std::set<std::int64_t> numbers(soup.material.begin(), soup.material.end());
  std::map<std::int64_t, std::int64_t> instead;
  std::int64_t free = 1;
  for (const std::int64_t number : numbers) {
    if (number >= kLeast && number <= kMost) continue;
    while (numbers.contains(free)) ++free;
    instead.emplace(number, free);
    notes.push_back(fmt::format("material {} is {} than {}: it becomes number {}", number,
                                number > kMost ? "larger" : "smaller",
                                number > kMost ? kMost : kLeast, free));
    ++free;
  }
  if (instead.empty()) return;
  for (std::int64_t& material : soup.material) {
    const auto other = instead.find(material);
    if (other != instead.end()) material = other->second;
  }
}

/// Regions with the names of their groups, or of their materials by the `numbers` of the file; none
/// if the numbers of regions are not 1, 2, 3, ...
std::vector<Region> named_regions(const MeshFile& file, const TriangleSoup& soup,
                                  const std::vector<std::int64_t>& numbers) {
  std::vector<Region> regions;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const std::int64_t id = soup.region[t];
    if (id < 1 || id > static_cast<std::int64_t>(soup.triangles.size())) return {};
    if (static_cast<std::size_t>(id) > regions.size()) regions.resize(static_cast<std::size_t>(id));
    Region& region = regions[static_cast<std::size_t>(id) - 1];
    if (region.material != 0) continue;
    region.id = RegionId(static_cast<std::uint32_t>(id));
    region.material = static_cast<int>(soup.material[t]);
    region.material_name = fmt::format("material_{}", region.material);
    const auto name = file.region_names.find(file.group.empty() ? numbers[t] : file.group[t]);
    region.name = name == file.region_names.end() ? region.material_name : name->second;
  }
  return regions;
}

/// Whether cover would give this name to a line between regions by itself, as "Si_SiO2",
/// "Si_outline" or "Si_slit_2"; a deck of Abaqus has it in capitals.
bool is_made_up(const std::string& name, const std::set<std::string>& regions) {
  const auto is_word = [](const std::string& word) {
    return word == "outline" || word == "slit" || word == "OUTLINE" || word == "SLIT";
  };
  if (name == "hull" || name == "HULL") return true;
  for (std::size_t k = name.find('_'); k != std::string::npos; k = name.find('_', k + 1)) {
    if (!regions.contains(name.substr(0, k))) continue;
    const std::string rest = name.substr(k + 1);
    const std::string bare = rest.substr(0, rest.find_last_of('_'));
    for (const std::string& other : {rest, bare})
      if (is_word(other) || regions.contains(other)) return true;
  }
  return false;
}

void take_lines(const MeshFile& file, StoredMesh& stored) {
  std::set<std::string> regions;
  for (const Region& region : stored.regions) regions.insert(region.name);
  // Contacts are numbered as the groups of lines are.
  std::map<std::int64_t, std::uint32_t> contact;
  for (const auto& [group, name] : file.line_names) {
    if (is_made_up(name, regions)) continue;
    contact.emplace(group, static_cast<std::uint32_t>(stored.names.size()));
    stored.names.push_back(name);
  }
  for (const MeshLine& line : file.lines) {
    StoredEdge edge{line.a, line.b, kNoInterface, line.marker, 0};
    const auto found = contact.find(line.group);
    if (found != contact.end()) edge.name = found->second;
    if (file.line_names.empty()) edge.marker = static_cast<int>(line.group);
    stored.edges.push_back(edge);
  }
}

}  // namespace

std::string complete_from_file(const MeshFile& file, StoredMesh& stored,
                               std::vector<std::string>& notes) {
  std::vector<std::string> missing;
  TriangleSoup& soup = stored.soup;
  if (soup.material.empty()) {
    missing.emplace_back(file.region_names.empty() ? "numbers of materials"
                                                   : "numbers and names of materials");
    soup.material = file.group.empty() ? soup.region : file.group;
  }
  const std::vector<std::int64_t> numbers = soup.material;
  renumber_materials(soup, notes);
  if (soup.region.empty()) {
    missing.emplace_back("numbers of regions");
    find_regions(file.lines, soup);
  }
  if (!file.region_names.empty()) {
    stored.regions = named_regions(file, soup, numbers);
    // Groups are named after regions.
    if (!file.group.empty() && !file.soup.material.empty())
      missing.emplace_back("names of materials");
  } else {
    missing.emplace_back("names of regions");
  }
  if (file.lines.empty()) {
    missing.emplace_back("contacts and boundary markers");
  } else if (file.line_names.empty()) {
    missing.emplace_back("names of contacts");
  }
  take_lines(file, stored);
  return listed(missing);
}

bool take_materials(StoredMesh& stored) {
  if (!stored.soup.material.empty()) return true;
  for (const std::int64_t region : stored.soup.region) {
    if (region < 1 || region > static_cast<std::int64_t>(stored.regions.size())) return false;
    stored.soup.material.push_back(stored.regions[static_cast<std::size_t>(region) - 1].material);
  }
  return true;
}

void sort_by_region(TriangleSoup& soup) {
  if (std::is_sorted(soup.region.begin(), soup.region.end())) return;
  const auto order = sorted_numbers<std::size_t>(
      soup.triangles.size(),
      [&](std::size_t a, std::size_t b) { return soup.region[a] < soup.region[b]; });
  soup.triangles = in_order(soup.triangles, order);
  soup.region = in_order(soup.region, order);
  soup.material = in_order(soup.material, order);
}

}  // namespace cover
