// A name in a file is compared with all that cover would call the group there: formats bear fewer
// letters, and groups are other ones with WriteOptions::ids.
// Tested by tests/unit/io/read_mesh/stale_names_test.cpp.
#include "io/read_mesh/own_names.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <cover/mesh_view.hpp>
#include <cover/text.hpp>

#include "io/read_mesh/complete_mesh.hpp"

namespace cover {
namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;
using Line = std::pair<InterfaceId, int>;  ///< with the marker
using Forms = std::set<std::string>;

/// What regions, lines and named points of a mesh may be called in its files.
struct NameForms {
  std::vector<Forms> of_region;  ///< by RegionId - 1
  std::map<Line, Forms> of_line;
  std::map<std::uint32_t, Forms> of_point;  ///< by vertex
};

/// Edges of one line have one name.
Line line_of(const StoredEdge& edge) { return {edge.interface, edge.marker}; }

void add_forms(const Group& group, const std::string& set, Forms& forms) {
  forms.insert({group.name, group.label, group.original, set});
}

NameForms forms_of(const StoredMesh& stored) {
  RegionTable table;
  table.regions = stored.regions;
  table.interfaces = stored.interfaces;
  std::vector<LineEdge> lines;
  for (const StoredEdge& edge : stored.edges) {
    const bool is_known =
        edge.interface != kNoInterface && place_of(edge.interface) < table.interfaces.size();
    lines.push_back(
        {lines.size(), 0, is_known ? edge.interface : kNoInterface, edge.marker, edge.a, edge.b});
  }
  NameForms forms;
  forms.of_region.resize(table.regions.size());
  for (const char* ids : {"", "region", "material"}) {
    WriteOptions options;
    options.ids = ids;
    const MeshView view = view_of_lines(table, lines, options, stored.points);
    std::vector<std::string> sets = abaqus_names(view.region_groups);
    for (std::size_t r = 0; r < table.regions.size(); ++r) {
      const std::uint32_t group = view.region_group[r];
      add_forms(view.region_groups[group], sets[group], forms.of_region[r]);
    }
    sets = abaqus_names(node_sets(view));
    std::set<Line> are_done;
    for (std::size_t l = 0; l < view.lines.size(); ++l) {
      const Line line{view.interface[l], view.marker[l]};
      if (are_done.insert(line).second)
        add_forms(view.group_of_line(l), sets[view.line_group[l]], forms.of_line[line]);
    }
    for (std::size_t k = 0; k < view.named.size(); ++k)
      add_forms(view.point_groups[view.named_group[k]],
                sets[view.line_groups.size() + view.named_group[k]], forms.of_point[view.named[k]]);
  }
  return forms;
}

/// The number that `numbers` have for all triangles of a region, by RegionId - 1; nothing where
/// they differ.
std::optional<std::vector<std::int64_t>> by_region(const std::vector<std::int64_t>& numbers,
                                                   const StoredMesh& stored) {
  constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();
  std::vector<std::int64_t> found(stored.regions.size(), kUnknown);
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    std::int64_t& number = found[static_cast<std::size_t>(stored.soup.region[t]) - 1];
    if (number != kUnknown && number != numbers[t]) return std::nullopt;
    number = numbers[t];
  }
  return found;
}

/// Materials of the file's own triangles. WriteOptions::ids may have put ids of regions there.
void take_own_materials(const std::vector<std::int64_t>& materials, StoredMesh& stored) {
  using Number = decltype(Region::material);
  const auto found = by_region(materials, stored);
  if (!found || materials.empty()) return;
  bool are_ids = true, are_numbers = true;
  for (std::size_t r = 0; r < found->size(); ++r) {
    are_ids &= (*found)[r] == static_cast<std::int64_t>(r + 1);
    are_numbers &= (*found)[r] > 0 && (*found)[r] <= std::numeric_limits<Number>::max();
  }
  if (are_ids || !are_numbers) return;
  std::map<std::int64_t, std::string> names;
  for (const Region& region : stored.regions) names.emplace(region.material, region.material_name);
  for (std::size_t r = 0; r < found->size(); ++r) {
    Region& region = stored.regions[r];
    if (region.material == (*found)[r]) continue;
    region.material = static_cast<Number>((*found)[r]);
    const auto name = names.find(region.material);
    region.material_name =
        name != names.end() ? name->second : fmt::format("material_{}", region.material);
  }
}

void take_own_regions(const MeshFile& file, const NameForms& forms, StoredMesh& stored) {
  std::vector<bool> is_done(stored.regions.size());
  for (std::size_t t = 0; t < file.group.size(); ++t) {
    const std::size_t r = static_cast<std::size_t>(stored.soup.region[t]) - 1;
    const auto name = file.region_names.find(file.group[t]);
    if (is_done[r] || name == file.region_names.end() || name->second.empty()) continue;
    is_done[r] = true;
    if (forms.of_region[r].contains(name->second)) continue;
    Region& region = stored.regions[r];
    // A region without a name is called after its material.
    if (region.name == region.material_name) region.material_name = name->second;
    region.name = name->second;
  }
}

void take_own_lines(const MeshFile& file, const NameForms& forms, StoredMesh& stored) {
  std::map<Ends, const std::string*> names;
  for (const MeshLine& line : file.lines) {
    const auto name = file.line_names.find(line.group);
    if (name != file.line_names.end() && !name->second.empty())
      names.emplace(std::minmax(line.a, line.b), &name->second);
  }
  for (const StoredEdge& edge : stored.edges) {
    const Ends ends = std::minmax(edge.a, edge.b);
    const auto name = names.find(ends);
    const auto known = forms.of_line.find(line_of(edge));
    // A line with a marker is called after that.
    if (name == names.end() || known == forms.of_line.end() || edge.marker != 0 ||
        edge.interface == kNoInterface || place_of(edge.interface) >= stored.interfaces.size())
      continue;
    if (!known->second.contains(*name->second))
      stored.interfaces[place_of(edge.interface)].name = *name->second;
  }
}

void take_own_points(const MeshFile& file, const NameForms& forms, StoredMesh& stored) {
  std::map<std::uint32_t, const std::string*> names;
  for (const NamedPoint& point : file.named_points)
    if (!point.name.empty()) names.emplace(point.vertex.value(), &point.name);
  for (NamedPoint& point : stored.points) {
    const auto name = names.find(point.vertex.value());
    const auto known = forms.of_point.find(point.vertex.value());
    if (name != names.end() && known != forms.of_point.end() &&
        !known->second.contains(*name->second))
      point.name = *name->second;
  }
}

/// Sentences of which a message has the first few.
class Differences {
 public:
  template <class... Args>
  void add(fmt::format_string<Args...> text, Args&&... args) {
    if (++count_ <= kMost) first_.push_back(fmt::format(text, std::forward<Args>(args)...));
  }

  [[nodiscard]] std::string text() const {
    std::string all = listed(first_, "; ");
    if (count_ > kMost) all += fmt::format("; and {} more", count_ - kMost);
    return all;
  }

 private:
  static constexpr std::size_t kMost = 3;
  std::vector<std::string> first_;
  std::size_t count_ = 0;
};

/// A value as messages have it, with what its number means.
std::string value_text(const Attribute& attribute, double value) {
  if (std::isnan(value) || (attribute.is_text && value == 0)) return "none";
  if (!attribute.is_text) return describe(value);
  return fmt::format("'{}'", printable(attribute.words[static_cast<std::size_t>(value) - 1]));
}

void compare(const Attribute& told, const Attribute& own, Differences& differences) {
  const std::size_t regions = std::min(told.values.size(), own.values.size());
  const bool mean_the_same =
      told.is_text == own.is_text && (!told.is_text || told.words == own.words);
  for (std::size_t r = 0; r < regions; ++r) {
    if (mean_the_same && own.values[r] == told.values[r]) continue;
    const std::string a = value_text(own, own.values[r]), b = value_text(told, told.values[r]);
    // Numbers of words that are out of range are numbers in `own` alone.
    if (a != b && !(told.is_text && !own.is_text && own.values[r] == told.values[r]))
      differences.add("'{}' of region {} is {}, not {}", printable(own.name), r + 1, a, b);
  }
}

}  // namespace

void take_own_names(const MeshFile& file, StoredMesh& stored) {
  const auto is_known = [&](std::int64_t region) {
    return region >= 1 && region <= static_cast<std::int64_t>(stored.regions.size());
  };
  const auto& region = stored.soup.region;
  // Else rebuild() tells what is wrong.
  if (region.size() != stored.soup.triangles.size() ||
      !std::all_of(region.begin(), region.end(), is_known))
    return;
  if (!file.region_names.empty() || !file.line_names.empty() || !file.named_points.empty()) {
    const NameForms forms = forms_of(stored);
    take_own_regions(file, forms, stored);
    take_own_lines(file, forms, stored);
    take_own_points(file, forms, stored);
  }
  take_own_materials(file.soup.material, stored);
  stored.soup.material.clear();
  take_materials(stored);
}

std::string contradictions(const StoredMesh& told, const StoredMesh& stored) {
  Differences differences;
  const std::size_t regions = std::min(told.regions.size(), stored.regions.size());
  for (std::size_t r = 0; r < regions; ++r) {
    const Region &a = stored.regions[r], &b = told.regions[r];
    if (a.name != b.name)
      differences.add("region {} is '{}', not '{}'", r + 1, printable(a.name), printable(b.name));
    if (a.material != b.material)
      differences.add("the material of region {} is {}, not {}", r + 1, a.material, b.material);
    else if (a.material_name != b.material_name && a.name != a.material_name)
      differences.add("the material of region {} is '{}', not '{}'", r + 1,
                      printable(a.material_name), printable(b.material_name));
  }
  for (const Attribute& attribute : told.attributes) {
    const auto own =
        std::find_if(stored.attributes.begin(), stored.attributes.end(),
                     [&](const Attribute& candidate) { return candidate.name == attribute.name; });
    if (own != stored.attributes.end()) compare(attribute, *own, differences);
  }
  const std::size_t lines = std::min(told.interfaces.size(), stored.interfaces.size());
  for (std::size_t i = 0; i < lines; ++i) {
    const std::string &a = stored.interfaces[i].name, &b = told.interfaces[i].name;
    if (a != b) differences.add("line '{}' is no '{}'", printable(a), printable(b));
  }
  std::map<std::uint32_t, std::string_view> points;
  for (const NamedPoint& point : told.points) points.emplace(point.vertex.value(), point.name);
  for (const NamedPoint& point : stored.points) {
    const auto name = points.find(point.vertex.value());
    if (name != points.end() && name->second != point.name)
      differences.add("point '{}' is no '{}'", printable(point.name), printable(name->second));
  }
  return differences.text();
}

}  // namespace cover
