// The legacy format. Version 3.0, text, triangles first and integers as SCALARS: each of these is
// what some reader insists on, and VTK's own writer can no longer write it. The ids of interior
// lines stand in ManifoldID because deal.II takes boundary ids on the boundary only.
//
// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtk_test.cpp and, in the solvers, by
// tests/solvers.
#include <cctype>
#include <map>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <cover/mesh_view.hpp>

#include "base/words/safe_names.hpp"
#include "io/files/text_writer.hpp"
#include "io/write_mesh/check_format.hpp"

namespace cover {
namespace {

constexpr std::size_t kLongestTitle = 255;  // of the format, without the end of the line

/// The names of the materials, as far as they go: the format has no other place for them.
std::string title_of(const RegionTable& table) {
  std::map<int, std::string> names;
  for (const Region& region : table.regions) names.emplace(region.material, region.material_name);
  std::string title = "materials";
  for (const auto& [number, name] : names) {
    const std::string next = fmt::format(" {}={}", number, safe_name(name));
    if (title.size() + next.size() > kLongestTitle) break;
    title += next;
  }
  return title;
}

/// Node counts and nodes.
void write_cells(const Cells& cells, TextWriter& out) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    out << cells.nodes_each;
    for (const std::uint32_t node : cells[k]) out << ' ' << node;
    out << '\n';
  }
}

void write_types(const Cells& cells, int type, TextWriter& out) {
  for (std::size_t k = 0; k < cells.size(); ++k) out << type << '\n';
}

/// An array with `of_triangle(t)` for each triangle, then `of_line(l)` for each of `lines` lines.
template <class OfTriangle, class OfLine>
void write_array(std::string_view name, const MeshView& view, std::size_t lines,
                 OfTriangle of_triangle, OfLine of_line, TextWriter& out) {
  out << "SCALARS " << name << " int 1\nLOOKUP_TABLE default\n";
  for (std::size_t t = 0; t < view.triangles.size(); ++t) out << of_triangle(t) << '\n';
  for (std::size_t l = 0; l < lines; ++l) out << of_line(l) << '\n';
}

/// The cell arrays, where `lines` is the number of line cells.
void write_arrays(const MeshView& view, std::size_t lines, TextWriter& out) {
  const auto material = [&](std::size_t t) { return view.material[t]; };
  const auto region = [&](std::size_t t) { return view.region[t].value(); };
  const auto number = [&](std::size_t l) { return view.group_of_line(l).tag; };
  const auto outer = [&](std::size_t l) { return view.inner[l] != 0 ? -1 : number(l); };
  const auto inner = [&](std::size_t l) { return view.inner[l] != 0 ? number(l) : -1; };
  const auto zero = [](std::size_t) { return 0; };
  const auto solver = [&](std::size_t t) { return view.number_of_triangle(t); };
  write_array("MaterialID", view, lines, solver, outer, out);
  if (lines > 0) {
    write_array(
        "ManifoldID", view, lines, [](std::size_t) { return -1; }, inner, out);
    write_array("LineID", view, lines, zero, number, out);
  } else {
    write_array("material", view, lines, material, zero, out);
    write_array("mat_id", view, lines, solver, zero, out);
  }
  write_array("RegionId", view, lines, region, zero, out);
  if (lines > 0 && view.has_ids) write_array("material", view, lines, material, zero, out);
}

/// A name as the format wants it, in which VTK finds it again.
std::string with_escapes(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = std::isalnum(byte) != 0 || c == '_' || c == '-' || c == '.';
    out += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return out;
}

void write_point_arrays(const MeshView& view, TextWriter& out) {
  if (view.periodic_node.empty() && view.fields.empty()) return;
  out << "POINT_DATA " << view.points.size() << '\n';
  if (!view.periodic_node.empty()) {
    out << "SCALARS PeriodicNode int 1\nLOOKUP_TABLE default\n";
    for (const std::uint32_t node : view.periodic_node) out << node << '\n';
  }
  for (const PlaneField::Array& field : view.fields) {
    out << "SCALARS " << with_escapes(field.name) << " double 1\nLOOKUP_TABLE default\n";
    for (const double value : field.values) out << value << '\n';
  }
}

}  // namespace

Status write_vtk(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".vtk", output, path, options); !status) return status;
  const MeshView view = view_of(output, options);
  return write_text(path, options.stop, [&](TextWriter& out) {
    const Cells none{view.lines.nodes_each, {}};
    const Cells& lines = options.lines ? view.lines : none;
    const std::size_t cells = view.triangles.size() + lines.size();

    out << "# vtk DataFile Version 3.0\n" << title_of(output.table);
    out << "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << view.points.size() << " double\n";
    for (const Point& p : view.points) out << p.x << ' ' << p.y << " 0\n";
    out << "CELLS " << cells << ' ' << cells + view.triangles.nodes.size() + lines.nodes.size()
        << '\n';
    write_cells(view.triangles, out);
    write_cells(lines, out);
    out << "CELL_TYPES " << cells << '\n';
    write_types(view.triangles, view.second_order() ? 22 : 5, out);
    write_types(lines, view.second_order() ? 21 : 3, out);
    out << "CELL_DATA " << cells << '\n';
    write_arrays(view, lines.size(), out);
    write_point_arrays(view, out);
  });
}

}  // namespace cover
