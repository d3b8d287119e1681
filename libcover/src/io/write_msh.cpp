// gmsh's .msh in text. Version 2.2 is what most solvers read, 4.1 what gmsh itself prefers; the
// elements are the same. Every face is an elementary surface and every interface an elementary
// curve of its own; names stand at the physical groups.
//
// Tested by tests/unit/io/write_msh_test.cpp and, in the solvers, by tests/solvers.
#include <algorithm>

#include "io/mesh_view.hpp"
#include "io/text_writer.hpp"

namespace cover {
namespace {

class MshWriter {
 public:
  MshWriter(const MeshView& view, std::size_t regions, std::size_t interfaces, TextWriter& out)
      : view_(view),
        out_(out),
        hull_(interfaces + 1),
        surfaces_(regions, view.triangles.size(),
                  [&](std::size_t t) { return view.region[t].index() - 1; }),
        curves_(interfaces + 1, view.lines.size(), [&](std::size_t l) { return curve(l) - 1; }) {}

  void write_2() {
    out_ << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    names();
    out_ << "$Nodes\n" << view_.points.size() << '\n';
    for (std::size_t p = 0; p < view_.points.size(); ++p) {
      out_ << p + 1 << ' ';
      coordinates(view_.points[p]);
    }
    out_ << "$EndNodes\n$Elements\n" << view_.lines.size() + view_.triangles.size() << '\n';
    for (std::size_t l = 0; l < view_.lines.size(); ++l)
      element_2(line_type(), view_.group_of_line(l).tag, curve(l), view_.lines[l]);
    for (std::size_t t = 0; t < view_.triangles.size(); ++t)
      element_2(triangle_type(), view_.group_of_triangle(t).tag, view_.region[t].index(),
                view_.triangles[t]);
    out_ << "$EndElements\n";
  }

  void write_4() {
    out_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    names();
    entities();
    const std::size_t points = view_.points.size();
    out_ << "$Nodes\n1 " << points << " 1 " << points << "\n2 " << first_surface() << " 0 "
         << points << '\n';
    for (std::size_t p = 0; p < points; ++p) out_ << p + 1 << '\n';
    for (const Point& p : view_.points) coordinates(p);
    out_ << "$EndNodes\n$Elements\n";
    const std::size_t elements = view_.lines.size() + view_.triangles.size();
    out_ << used(curves_) + used(surfaces_) << ' ' << elements << " 1 " << elements << '\n';
    blocks_4(1, line_type(), curves_, view_.lines);
    blocks_4(2, triangle_type(), surfaces_, view_.triangles);
    out_ << "$EndElements\n";
  }

 private:
  [[nodiscard]] int line_type() const { return view_.second_order() ? 8 : 1; }
  [[nodiscard]] int triangle_type() const { return view_.second_order() ? 9 : 2; }

  /// The elementary tag of a line: its InterfaceId, or the one after the last for the hull.
  [[nodiscard]] std::size_t curve(std::size_t line) const {
    return view_.interface[line] == kNoInterface ? hull_ : view_.interface[line].index();
  }

  static std::size_t used(const Buckets& entities) {
    std::size_t n = 0;
    for (std::size_t e = 0; e < entities.size(); ++e) n += entities[e].empty() ? 0 : 1;
    return n;
  }

  [[nodiscard]] std::size_t first_surface() const {
    std::size_t e = 0;
    while (e + 1 < surfaces_.size() && surfaces_[e].empty()) ++e;
    return e + 1;
  }

  void coordinates(const Point& p) { out_ << p.x << ' ' << p.y << " 0\n"; }

  /// Names of the groups that have elements.
  void names() {
    std::vector<std::uint8_t> has_lines(view_.line_groups.size());
    for (const std::uint32_t group : view_.line_group) has_lines[group] = 1;
    const auto lines = std::count(has_lines.begin(), has_lines.end(), 1);
    out_ << "$PhysicalNames\n"
         << static_cast<std::size_t>(lines) + view_.region_groups.size() << '\n';
    for (std::size_t g = 0; g < view_.line_groups.size(); ++g) {
      if (has_lines[g] != 0) name(1, view_.line_groups[g]);
    }
    for (const Group& group : view_.region_groups) name(2, group);
    out_ << "$EndPhysicalNames\n";
  }
  void name(int dimension, const Group& group) {
    out_ << dimension << ' ' << group.tag << " \"" << group.name << "\"\n";
  }

  void nodes(std::span<const std::uint32_t> nodes) {
    for (const std::uint32_t node : nodes) out_ << ' ' << node + 1;
    out_ << '\n';
  }

  void element_2(int type, int physical, std::size_t elementary,
                 std::span<const std::uint32_t> cell) {
    out_ << ++element_ << ' ' << type << " 2 " << physical << ' ' << elementary;
    nodes(cell);
  }

  void entities() {
    out_ << "$Entities\n0 " << used(curves_) << ' ' << used(surfaces_) << " 0\n";
    for (std::size_t e = 0; e < curves_.size(); ++e) {
      if (!curves_[e].empty())
        entity(e + 1, view_.group_of_line(curves_[e].front()).tag, curves_[e], view_.lines);
    }
    for (std::size_t e = 0; e < surfaces_.size(); ++e) {
      if (!surfaces_[e].empty())
        entity(e + 1, view_.group_of_triangle(surfaces_[e].front()).tag, surfaces_[e],
               view_.triangles);
    }
    out_ << "$EndEntities\n";
  }

  /// Tag, bounding box, physical group; what bounds it is not said.
  void entity(std::size_t tag, int physical, std::span<const std::size_t> members,
              const Cells& cells) {
    Point low = view_.points[cells[members.front()][0]], high = low;
    for (const std::size_t k : members) {
      for (const std::uint32_t node : cells[k]) {
        const Point& p = view_.points[node];
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    out_ << tag << ' ' << low.x << ' ' << low.y << " 0 " << high.x << ' ' << high.y << " 0 1 "
         << physical << " 0\n";
  }

  void blocks_4(int dimension, int type, const Buckets& entities, const Cells& cells) {
    for (std::size_t e = 0; e < entities.size(); ++e) {
      if (entities[e].empty()) continue;
      out_ << dimension << ' ' << e + 1 << ' ' << type << ' ' << entities[e].size() << '\n';
      for (const std::size_t k : entities[e]) {
        out_ << ++element_;
        nodes(cells[k]);
      }
    }
  }

  const MeshView& view_;
  TextWriter& out_;
  std::size_t element_ = 0;  ///< number of the last element written
  std::size_t hull_;         ///< elementary tag of lines without an interface
  Buckets surfaces_;         ///< triangles by RegionId - 1
  Buckets curves_;           ///< lines by curve() - 1
};

}  // namespace

Status write_msh(const Output& output, const std::string& path, const WriteOptions& options) {
  Result<TextWriter> out = TextWriter::create(path);
  if (!out) return std::move(out).error();
  const MeshView view = view_of(output, options);
  MshWriter writer(view, output.table.regions.size(), output.table.interfaces.size(), *out);
  if (options.msh == "4.1") {
    writer.write_4();
  } else {
    writer.write_2();
  }
  return out->commit();
}

}  // namespace cover
