// Formats of surfaces: .obj, .off and .ply. OpenMesh has writers for them, but they round every
// coordinate to a float.
// Tested by tests/unit/io/write_mesh/solver_formats/write_surface_test.cpp.
#include "io/files/text_writer.hpp"
#include "io/write_mesh/check_format.hpp"

#include <cover/mesh_view.hpp>

namespace cover {
namespace {

void write_nodes(std::span<const std::uint32_t> nodes, std::uint32_t first, TextWriter& out) {
  for (const std::uint32_t node : nodes) out << ' ' << node + first;
}

void write_points(const MeshView& view, std::string_view before, TextWriter& out) {
  for (const Point& p : view.points) out << before << p.x << ' ' << p.y << " 0\n";
}

}  // namespace

Status write_obj(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".obj", output, path, options); !status) return status;
  const MeshView view = view_of(output, {});
  return write_text(path, options.stop, [&](TextWriter& out) {
    write_points(view, "v ", out);
    const Group* current = nullptr;
    for (std::size_t t = 0; t < view.triangles.size(); ++t) {
      const Group& group = view.group_of_triangle(t);
      if (&group != current) out << "g " << group.name << '\n';
      current = &group;
      out << 'f';
      write_nodes(view.triangles[t], 1, out);
      out << '\n';
    }
    for (std::size_t l = 0; l < view.lines.size(); ++l) {
      const Group& group = view.group_of_line(l);
      if (&group != current) out << "g " << group.name << '\n';
      current = &group;
      out << 'l';
      write_nodes(view.lines[l], 1, out);
      out << '\n';
    }
  });
}

Status write_off(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".off", output, path, options); !status) return status;
  const MeshView view = view_of(output, {});
  return write_text(path, options.stop, [&](TextWriter& out) {
    out << "OFF\n" << view.points.size() << ' ' << view.triangles.size() << " 0\n";
    write_points(view, "", out);
    for (std::size_t t = 0; t < view.triangles.size(); ++t) {
      out << '3';
      write_nodes(view.triangles[t], 0, out);
      out << '\n';
    }
  });
}

Status write_ply(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".ply", output, path, options); !status) return status;
  const MeshView view = view_of(output, {});
  return write_text(path, options.stop, [&](TextWriter& out) {
    out << "ply\nformat ascii 1.0\nelement vertex " << view.points.size()
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
        << view.triangles.size()
        << "\nproperty list uchar int vertex_indices\nproperty int material\nproperty int region\n"
           "end_header\n";
    write_points(view, "", out);
    for (std::size_t t = 0; t < view.triangles.size(); ++t) {
      out << '3';
      write_nodes(view.triangles[t], 0, out);
      out << ' ' << view.material[t] << ' ' << view.region[t].value() << '\n';
    }
  });
}

}  // namespace cover
