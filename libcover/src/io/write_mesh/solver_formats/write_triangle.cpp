// Triangle's files .node, .ele and .edge, numbered from 1. No file of them tells that it belongs to
// the others, so all three are whole on the disk before the first is renamed: nothing but a kill
// or a crash of the system between these three renames can mix two meshes.
// Tested by tests/unit/io/write_mesh/solver_formats/write_triangle_test.cpp.
#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <cover/mesh_view.hpp>

#include "io/files/text_writer.hpp"
#include "io/write_mesh/check_format.hpp"

namespace cover {
namespace {

/// The points of the input that have markers, sorted.
std::vector<std::pair<Point, int>> marked_points(const Pslg& pslg) {
  std::vector<std::pair<Point, int>> marked;
  for (std::size_t p = 0; p < pslg.point_markers.size(); ++p)
    if (pslg.point_markers[p] != 0) marked.emplace_back(pslg.points[p], pslg.point_markers[p]);
  std::sort(marked.begin(), marked.end());
  return marked;
}

void write_nodes(const MeshView& view, const Pslg& pslg, TextWriter& out) {
  const std::vector<std::pair<Point, int>> marked = marked_points(pslg);
  out << view.points.size() << " 2 0 " << (marked.empty() ? 0 : 1) << '\n';
  for (std::size_t p = 0; p < view.points.size(); ++p) {
    const Point at = view.points[p];
    out << p + 1 << ' ' << at.x << ' ' << at.y;
    if (!marked.empty()) {
      const auto found = std::partition_point(marked.begin(), marked.end(),
                                              [&](const auto& entry) { return entry.first < at; });
      out << ' ' << (found != marked.end() && found->first == at ? found->second : 0);
    }
    out << '\n';
  }
}

void write_elements(const MeshView& view, TextWriter& out) {
  out << view.triangles.size() << ' ' << view.triangles.nodes_each
      << (view.has_ids ? " 3\n" : " 2\n");
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const auto nodes = view.triangles[t];
    out << t + 1;
    for (const std::uint32_t node : nodes.first(3)) out << ' ' << node + 1;
    // Triangle names the midpoint opposite the first corner first.
    if (nodes.size() == 6) out << ' ' << nodes[4] + 1 << ' ' << nodes[5] + 1 << ' ' << nodes[3] + 1;
    out << ' ' << view.number_of_triangle(t) << ' ' << view.region[t].value();
    if (view.has_ids) out << ' ' << view.material[t];
    out << '\n';
  }
}

void write_edges(const MeshView& view, TextWriter& out) {
  const bool marked = std::any_of(view.marker.begin(), view.marker.end(), [](int m) { return m; });
  out << view.lines.size() << " 1\n";
  for (std::size_t l = 0; l < view.lines.size(); ++l) {
    out << l + 1 << ' ' << view.lines[l][0] + 1 << ' ' << view.lines[l][1] + 1 << ' '
        << (marked ? view.marker[l] : view.group_of_line(l).tag) << '\n';
  }
}

}  // namespace

Status write_triangle(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".ele", output, path, options); !status) return status;
  const MeshView view = view_of(output, options);
  std::vector<TextWriter> files;
  const std::filesystem::path elements(path);
  for (const std::filesystem::path& name :
       {std::filesystem::path(path).replace_extension(".node"), elements,
        std::filesystem::path(path).replace_extension(".edge")}) {
    Result<TextWriter> file = TextWriter::create(name.string(), options.stop);
    if (!file) return std::move(file).error();
    files.push_back(std::move(*file));
  }
  write_nodes(view, output.pslg, files[0]);
  write_elements(view, files[1]);
  write_edges(view, files[2]);
  std::vector<AtomicFile*> prepared;
  for (TextWriter& file : files) {
    if (Status status = file.prepare(); !status) return status;
    prepared.push_back(&file.file());
  }
  return commit_together(prepared);
}

}  // namespace cover
