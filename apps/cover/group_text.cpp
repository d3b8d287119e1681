#include "group_text.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <fmt/core.h>

#include "console.hpp"
#include "io/write_mesh/mesh_view.hpp"
#include "text_table.hpp"

namespace cover::app {
namespace {

constexpr std::size_t kRows = 20;

bool has_numbers(const std::string& file) {
  constexpr std::array<std::string_view, 5> kFormats{".msh", ".mesh", ".xdmf", ".vtk", ".ele"};
  const std::string extension = std::filesystem::path(file).extension();
  return std::find(kFormats.begin(), kFormats.end(), extension) != kFormats.end();
}

std::string row_of_dots(std::size_t rows, std::size_t shown) {
  return shown == rows ? std::string()
                       : fmt::format("  and {} more: -v, or the manifest (-o NAME.json)\n",
                                     grouped(rows - shown));
}

}  // namespace

std::string group_text(const Output& output, const std::vector<std::string>& files, bool all) {
  if (std::none_of(files.begin(), files.end(), has_numbers)) return {};
  const MeshView view = view_of(output, {});
  using Align = TextTable::Align;
  TextTable regions({{"group"}, {"material"}, {"region", Align::left}});
  TextTable lines({{"group"}, {"line", Align::left}});
  const auto shown = [&](std::size_t rows) { return all ? rows : std::min(rows, kRows); };
  const std::size_t region_rows = shown(view.region_groups.size());
  const std::size_t line_rows = shown(view.line_groups.size());
  for (std::size_t g = 0; g < region_rows; ++g) {
    const Group& group = view.region_groups[g];
    regions.add({fmt::format("{}", group.tag), fmt::format("{}", group.material), group.original});
  }
  // Contacts and markers are what boundary conditions are for: they come first.
  std::vector<std::size_t> order(view.line_groups.size());
  for (std::size_t g = 0; g < order.size(); ++g) order[g] = g;
  const auto is_made_up = [&](std::size_t g) {
    return std::any_of(
        output.table.interfaces.begin(), output.table.interfaces.end(), [&](const Interface& line) {
          return line.kind != InterfaceKind::contact && line.name == view.line_groups[g].original;
        });
  };
  std::stable_partition(order.begin(), order.end(), [&](std::size_t g) { return !is_made_up(g); });
  for (std::size_t k = 0; k < line_rows; ++k) {
    const Group& group = view.line_groups[order[k]];
    const bool marker = !group.original.empty() &&
                        group.original.find_first_not_of("-0123456789") == std::string::npos;
    lines.add({fmt::format("{}", group.tag), (marker ? "marker " : "") + group.original});
  }
  return "Numbers in the files: of regions the group in .msh, elsewhere the material; of lines the "
         "group\n" +
         regions.text() + row_of_dots(view.region_groups.size(), region_rows) + lines.text() +
         row_of_dots(view.line_groups.size(), line_rows);
}

}  // namespace cover::app
