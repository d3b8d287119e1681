#include "words/group_text.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/mesh_view.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include "terminal/console.hpp"
#include "words/text_table.hpp"

namespace cover::app {
namespace {

constexpr std::size_t kGroupRows = 20;

bool is_any_of(const std::string& file, std::initializer_list<std::string_view> formats) {
  const std::string extension = extension_of(file);
  return std::find(formats.begin(), formats.end(), extension) != formats.end();
}

bool has_numbers(const std::string& file) {
  const std::vector<std::string> formats = number_formats();
  return std::find(formats.begin(), formats.end(), extension_of(file)) != formats.end();
}

/// Whether points have groups in it, whose numbers solvers find them by.
bool has_numbers_of_points(const std::string& file, const WriteOptions& options) {
  const std::vector<std::string> formats = point_formats(options);
  return has_numbers(file) &&
         std::find(formats.begin(), formats.end(), extension_of(file)) != formats.end();
}

std::string row_of_dots(std::size_t rows, std::size_t shown) {
  return shown == rows ? std::string()
                       : fmt::format("  and {} more: -v, or the manifest (-o NAME.json)\n",
                                     grouped(rows - shown));
}

/// What the input calls it, or what people read where the input does not name it.
const std::string& name_of_group(const Group& group) {
  return group.is_made_up ? group.label : group.original;
}

/// Whether its format bears names, and some in another form only.
bool may_rename(const std::string& file) { return is_any_of(file, {".msh", ".inp", ".obj"}); }

/// Names that formats bear in another form only; the rest are not listed.
std::string renamed_text(const MeshView& view, const std::vector<std::string>& files,
                         const WriteOptions& options, bool all) {
  const auto writes = [&](std::string_view extension) {
    return std::any_of(files.begin(), files.end(),
                       [&](const std::string& file) { return is_any_of(file, {extension}); });
  };
  std::string text;
  const auto list = [&](std::string_view extension, const std::vector<Group>& groups,
                        const std::vector<std::string>& names) {
    TextTable table({{fmt::format("in {}", extension), TextTable::Align::left},
                     {"stands for", TextTable::Align::left}});
    std::size_t rows = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (lower(names[g]) == lower(groups[g].original)) continue;
      if (++rows <= kGroupRows || all) table.add({names[g], name_of_group(groups[g])});
    }
    if (rows > 0) text += table.text() + row_of_dots(rows, all ? rows : std::min(rows, kGroupRows));
  };
  const auto safe = [](const std::vector<Group>& groups) {
    std::vector<std::string> names;
    for (const Group& group : groups) names.push_back(group.name);
    return names;
  };
  // .msh keeps all but quotes, control characters, and a second use of a name.
  const auto list_labels = [&](const std::vector<Group>& groups) {
    TextTable table({{"in .msh", TextTable::Align::left}, {"stands for", TextTable::Align::left}});
    std::size_t rows = 0;
    for (const Group& group : groups) {
      if (group.is_made_up || group.label == group.original) continue;
      if (++rows <= kGroupRows || all) table.add({group.label, group.original});
    }
    if (rows > 0) text += table.text() + row_of_dots(rows, all ? rows : std::min(rows, kGroupRows));
  };
  const std::vector<Group> others = node_sets(view);
  for (const auto* groups : {&view.region_groups, &others}) {
    // An .obj holds no points, nor does a .msh in parts.
    const std::vector<Group>& without_points = groups == &others ? view.line_groups : *groups;
    if (writes(".msh")) list_labels(options.parts == 1 ? *groups : without_points);
    if (writes(".inp")) list(".inp", *groups, abaqus_names(*groups));
    if (writes(".obj")) list(".obj", without_points, safe(without_points));
  }
  return text;
}

}  // namespace

std::string group_text(const StreamedOutput& streamed, const std::vector<std::string>& files,
                       const WriteOptions& options, bool all) {
  const auto tells = [](const std::string& file) { return has_numbers(file) || may_rename(file); };
  if (std::none_of(files.begin(), files.end(), tells)) return {};
  const Output& output = streamed.output;
  WriteOptions numbers;
  numbers.ids = options.ids;
  const MeshView view =
      streamed.is_streamed() ? view_of_lines(streamed, numbers) : view_of(output, numbers);
  std::string renamed = renamed_text(view, files, options, all);
  if (std::none_of(files.begin(), files.end(), has_numbers)) return renamed;
  using Align = TextTable::Align;
  TextTable regions({{"group"}, {"material"}, {"region", Align::left}});
  TextTable lines({{"group"}, {"line", Align::left}});
  const auto shown = [&](std::size_t rows) { return all ? rows : std::min(rows, kGroupRows); };
  const std::size_t region_rows = shown(view.region_groups.size());
  const std::size_t line_rows = shown(view.line_groups.size());
  for (std::size_t g = 0; g < region_rows; ++g) {
    const Group& group = view.region_groups[g];
    regions.add({fmt::format("{}", group.tag), fmt::format("{}", group.material), group.original});
  }
  // Contacts and markers are what boundary conditions are for: they come first.
  std::vector<std::size_t> order(view.line_groups.size());
  for (std::size_t g = 0; g < order.size(); ++g) order[g] = g;
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t g) { return !view.line_groups[g].is_made_up; });
  for (std::size_t k = 0; k < line_rows; ++k) {
    const Group& group = view.line_groups[order[k]];
    const std::string& name = name_of_group(group);
    const bool marker = !name.empty() && name.find_first_not_of("-0123456789") == std::string::npos;
    lines.add({fmt::format("{}", group.tag), (marker ? "marker " : "") + name});
  }
  TextTable points({{"group"}, {"point", Align::left}});
  const bool has_points = std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    return has_numbers_of_points(file, options);
  });
  const std::size_t points_in_files = has_points ? view.point_groups.size() : 0;
  const std::size_t point_rows = shown(points_in_files);
  for (std::size_t g = 0; g < point_rows; ++g) {
    const Group& group = view.point_groups[g];
    points.add({fmt::format("{}", group.tag), group.original});
  }
  return (view.has_ids
              ? fmt::format("Numbers in the files, by {}: the groups of regions and of lines\n",
                            options.ids)
              : "Numbers in the files: of regions the group in .msh, elsewhere the material; of "
                "lines the group\n") +
         regions.text() + row_of_dots(view.region_groups.size(), region_rows) + lines.text() +
         row_of_dots(view.line_groups.size(), line_rows) +
         (point_rows > 0 ? points.text() : std::string()) +
         row_of_dots(points_in_files, point_rows) + renamed;
}

std::string renamed_text(const Output& output, const std::vector<std::string>& files,
                         const WriteOptions& options, bool all) {
  if (std::none_of(files.begin(), files.end(), may_rename)) return {};
  WriteOptions numbers;
  numbers.ids = options.ids;
  return renamed_text(view_of(output, numbers), files, options, all);
}

}  // namespace cover::app
