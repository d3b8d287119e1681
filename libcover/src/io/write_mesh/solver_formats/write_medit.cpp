// Medit's .mesh, as FreeFem++, mmg and gmsh read it. The format has no names.
// Tested by tests/unit/io/write_mesh/solver_formats/write_medit_test.cpp and, in FreeFem++, by
// tests/solvers.
#include "io/files/text_writer.hpp"
#include "io/write_mesh/check_format.hpp"

#include <cover/mesh_view.hpp>

namespace cover {
namespace {

/// A keyword, the number of cells, and each cell with its reference.
template <class Reference>
void write_cells(std::string_view keyword, const Cells& cells, Reference reference,
                 TextWriter& out) {
  out << '\n' << keyword << '\n' << cells.size() << '\n';
  for (std::size_t k = 0; k < cells.size(); ++k) {
    for (const std::uint32_t node : cells[k]) out << node + 1 << ' ';
    out << reference(k) << '\n';
  }
}

}  // namespace

Status write_medit(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".mesh", output, path, options); !status) return status;
  const MeshView view = view_of(output, options);
  return write_text(path, options.stop, [&](TextWriter& out) {
    out << "MeshVersionFormatted 2\nDimension 2\n\nVertices\n" << view.points.size() << '\n';
    std::vector<int> reference(view.points.size());
    for (std::size_t k = 0; k < view.named.size(); ++k)
      reference[view.named[k]] = view.point_groups[view.named_group[k]].tag;
    for (std::size_t p = 0; p < view.points.size(); ++p)
      out << view.points[p].x << ' ' << view.points[p].y << ' ' << reference[p] << '\n';
    write_cells(
        view.second_order() ? "EdgesP2" : "Edges", view.lines,
        [&](std::size_t l) { return view.group_of_line(l).tag; }, out);
    write_cells(
        view.second_order() ? "TrianglesP2" : "Triangles", view.triangles,
        [&](std::size_t t) { return view.number_of_triangle(t); }, out);
    out << "\nEnd\n";
  });
}

}  // namespace cover
