// gmsh's .msh in text. Version 2.2 is what most solvers read, 4.1 what gmsh itself prefers; the
// elements are the same. In 2.2 every face is an elementary surface, and every interface an
// elementary curve of its own, or several where boundary markers divide it into groups, because
// gmsh takes a curve for part of every group that one of its elements names, or where its periodic
// images lie on several, because gmsh takes a curve for the image of one other; in 4.1 there is one
// entity per physical group and its tag is that of the group, because getfem takes the one for the
// other.
//
// Tested by tests/unit/io/write_mesh/solver_formats/write_msh_test.cpp and, in the solvers, by
// tests/solvers.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <cover/mesh_view.hpp>

#include "base/containers/buckets.hpp"
#include "base/numbers.hpp"
#include "io/write_mesh/check_format.hpp"
#include "io/write_mesh/partition.hpp"
#include "io/write_mesh/solver_formats/msh_sections.hpp"
#include "io/write_mesh/solver_formats/msh_text.hpp"
#include "io/write_mesh/view_cells.hpp"

namespace cover {
namespace {

/// The file of a whole mesh.
class MshWriter : MshSections {
 public:
  using MshSections::MshSections;

  void write_2() {
    out_ << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    names();
    out_ << "$Nodes\n" << cells_.points() << '\n';
    std::size_t node = 0;
    cells_.each_point([&](Point p) {
      out_ << ++node << ' ';
      coordinates(p);
    });
    out_ << "$EndNodes\n$Elements\n"
         << view_.named.size() + view_.lines.size() + cells_.triangles() << '\n';
    const std::vector<std::size_t> curve = curves();
    for (std::size_t l = 0; l < view_.lines.size(); ++l) {
      element_2(line_type(), view_.group_of_line(l).tag, curve[l], view_.lines[l]);
      remember(region_of_line(l));
    }
    cells_.each_triangle([&](RegionId region, std::span<const std::uint32_t> nodes) {
      const Group& group = view_.region_groups[view_.region_group[place_of(region)]];
      element_2(triangle_type(), group.tag, region.index(), nodes);
      remember(region);
    });
    // Behind all others, which have the same numbers in parts of the mesh.
    for (std::size_t k = 0; k < view_.named.size(); ++k) {
      element_2(kPointType, view_.point_groups[view_.named_group[k]].tag, k + 1, named(k));
      remember(kVoid);
    }
    out_ << "$EndElements\n";
    periodic(false, [&](std::size_t l) { return curve[l]; });
    data();
  }

  void write_4() {
    const Buckets curves(view_.line_groups.size(), view_.lines.size(),
                         [&](std::size_t l) { return view_.line_group[l]; });
    head_4(curves);
    const std::size_t surfaces = used_surfaces();
    const std::size_t points = cells_.points();
    // All nodes in one block, as if they lay on the first surface.
    out_ << "$Nodes\n1 " << points << " 1 " << points << "\n2 1 0 " << points << '\n';
    for (std::size_t p = 0; p < points; ++p) out_ << p + 1 << '\n';
    cells_.each_point([&](Point p) { coordinates(p); });
    const std::size_t elements = view_.named.size() + view_.lines.size() + cells_.triangles();
    out_ << "$EndNodes\n$Elements\n"
         << view_.point_groups.size() + used(curves) + surfaces << ' ' << elements << " 1 "
         << elements << '\n';
    for (std::size_t g = 0; g < view_.line_groups.size(); ++g) {
      if (curves[g].empty()) continue;
      block(1, view_.line_groups[g].tag, line_type(), curves[g].size());
      for (const std::size_t l : curves[g]) element_4(region_of_line(l), view_.lines[l]);
    }
    for (std::size_t g = 0; g < view_.region_groups.size(); ++g) {
      if (cells_.triangles(g) == 0) continue;
      block(2, view_.region_groups[g].tag, triangle_type(), cells_.triangles(g));
      cells_.each_triangle(g, [&](RegionId region, std::span<const std::uint32_t> nodes) {
        element_4(region, nodes);
      });
    }
    const Buckets points_of(view_.point_groups.size(), view_.named.size(),
                            [&](std::size_t k) { return view_.named_group[k]; });
    for (std::size_t g = 0; g < view_.point_groups.size(); ++g) {
      block(0, view_.point_groups[g].tag, kPointType, points_of[g].size());
      for (const std::size_t k : points_of[g]) element_4(kVoid, named(k));
    }
    out_ << "$EndElements\n";
    periodic(true,
             [&](std::size_t l) { return static_cast<std::size_t>(view_.group_of_line(l).tag); });
    data();
  }

 private:
  /// The elementary tag of each line: its InterfaceId, or the one after the last for the hull, or
  /// one after that where the interface lies in another group or is divided, see curve_of_lines().
  [[nodiscard]] std::vector<std::size_t> curves() const {
    const std::size_t hull = table_.interfaces.size() + 1;
    std::size_t last = hull;
    std::vector<std::uint8_t> taken(hull + 1);
    const std::vector<std::size_t> curve = curve_of_lines();
    std::vector<std::size_t> tags(view_.lines.size()), tag_of_curve;
    for (std::size_t l = 0; l < tags.size(); ++l) {
      if (curve[l] == tag_of_curve.size()) {
        const std::size_t own =
            view_.interface[l] == kNoInterface ? hull : view_.interface[l].index();
        tag_of_curve.push_back(taken[own] == 0 ? own : ++last);
        taken[own] = 1;
      }
      tags[l] = tag_of_curve[curve[l]];
    }
    return tags;
  }

  /// The lines of one interface in one group, as numbers in the order in which they first come;
  /// divided where their images or originals lie on several of these: gmsh knows a curve as the
  /// image of one other.
  [[nodiscard]] std::vector<std::size_t> curve_of_lines() const {
    const std::size_t n = view_.lines.size();
    // By rule, 0 for an original and 1 for an image, and the curve of the other.
    using Partners = std::vector<std::array<std::size_t, 3>>;
    std::vector<std::size_t> curve(n);
    for (std::size_t before = 0;;) {
      std::vector<Partners> partners(n);
      for (std::size_t r = 0; before > 0 && r < view_.periodic.size(); ++r) {
        for (const auto& [from, to] : view_.periodic[r].lines) {
          partners[from].push_back({r, 0, curve[to]});
          partners[to].push_back({r, 1, curve[from]});
        }
      }
      std::map<std::tuple<std::size_t, std::uint32_t, InterfaceId, Partners>, std::size_t> numbers;
      for (std::size_t l = 0; l < n; ++l) {
        std::sort(partners[l].begin(), partners[l].end());
        curve[l] = numbers
                       .try_emplace({curve[l], view_.line_group[l], view_.interface[l],
                                     std::move(partners[l])},
                                    numbers.size())
                       .first->second;
      }
      if (numbers.size() == before || view_.periodic.empty()) return curve;
      before = numbers.size();
    }
  }

  /// The node of a point's element.
  [[nodiscard]] std::span<const std::uint32_t> named(std::size_t k) const {
    return std::span(view_.named).subspan(k, 1);
  }

  void element_2(int type, int physical, std::size_t elementary,
                 std::span<const std::uint32_t> cell) {
    out_ << ++element_ << ' ' << type << " 2 " << physical << ' ' << elementary;
    nodes(cell);
  }

  void element_4(RegionId region, std::span<const std::uint32_t> cell) {
    out_ << ++element_;
    nodes(cell);
    remember(region);
  }

  /// The region of the element written last, for data().
  void remember(RegionId region) {
    if (!view_.attributes.empty()) region_of_element_.push_back(region);
  }

  /// Attributes and fields. Every element has a value, lines those of the region on their left and
  /// points none, since meshio cannot read data of some elements alone.
  void data() {
    for (const Attribute& attribute : view_.attributes) {
      begin_data("Element", attribute.name, region_of_element_.size());
      for (std::size_t e = 0; e < region_of_element_.size(); ++e) {
        const RegionId region = region_of_element_[e];
        out_ << e + 1 << ' ' << (region == kVoid ? kNoNumber : attribute.values[place_of(region)])
             << '\n';
      }
      out_ << "$EndElementData\n";
    }
    for (const PlaneField::Array& field : view_.fields) {
      begin_data("Node", field.name, field.values.size());
      for (std::size_t p = 0; p < field.values.size(); ++p)
        out_ << p + 1 << ' ' << field.values[p] << '\n';
      out_ << "$EndNodeData\n";
    }
  }

  /// A curve that is the image of another one, with pairs of nodes: its own and that of the other.
  struct Link {
    Isometry map;
    std::set<std::array<std::uint32_t, 2>> nodes;
  };

  /// Pairs of curves; `tag(l)` is the elementary tag of line l. Nodes that are their own images are
  /// left out: they ask for nothing, and some readers would follow them for ever.
  template <class Tag>
  void periodic(bool is_version_4, Tag tag) {
    std::map<std::array<std::size_t, 3>, Link> links;  // by rule, image and original
    for (std::size_t r = 0; r < view_.periodic.size(); ++r) {
      const PeriodicLines& rule = view_.periodic[r];
      for (std::size_t k = 0; k < rule.lines.size(); ++k) {
        const auto [from, to] = rule.lines[k];
        Link& link = links[{r, tag(to), tag(from)}];
        link.map = rule.map;
        for (const auto& [original, image] : rule.corners[k]) {
          if (original != image) link.nodes.insert({image, original});
        }
        if (second_order()) link.nodes.insert({view_.lines[to][2], view_.lines[from][2]});
      }
    }
    if (links.empty()) return;
    out_ << "$Periodic\n" << links.size() << '\n';
    for (const auto& [key, link] : links) {
      out_ << "1 " << key[1] << ' ' << key[2] << '\n' << (is_version_4 ? "16" : "Affine");
      const Isometry& m = link.map;
      for (const double c : {m.xx[0], m.xy[0], 0.0, m.x0[0], m.yx[0], m.yy[0], 0.0, m.y0[0], 0.0,
                             0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0})
        out_ << ' ' << (c == 0 ? 0.0 : c);  // no -0
      out_ << '\n' << link.nodes.size() << '\n';
      for (const auto& [image, original] : link.nodes)
        out_ << image + 1 << ' ' << original + 1 << '\n';
    }
    out_ << "$EndPeriodic\n";
  }

  std::size_t element_ = 0;                  ///< number of the last element written
  std::vector<RegionId> region_of_element_;  ///< where there are attributes
};

}  // namespace

void write_msh_text(const MeshView& view, const CellSource& cells, const RegionTable& table,
                    const std::string& version, TextWriter& out) {
  MshWriter writer(view, cells, table, out);
  if (version == "4.1") {
    writer.write_4();
  } else {
    writer.write_2();
  }
}

Status write_msh(const Output& output, const std::string& path, const WriteOptions& options) {
  if (Status status = check_format(".msh", output, path, options); !status) return status;
  MeshView view = view_of(output, options);
  if (options.parts != 1) {
    if (!view.periodic.empty()) return periodic_in_parts(path);
    view.named.clear();
    view.named_group.clear();
    view.point_groups.clear();
    return write_msh_parts(view, output.table, path, options);
  }
  return write_text(path, options.stop, [&](TextWriter& out) {
    const ViewCells cells(view, options.msh == "4.1");
    write_msh_text(view, cells, output.table, options.msh, out);
  });
}

}  // namespace cover
