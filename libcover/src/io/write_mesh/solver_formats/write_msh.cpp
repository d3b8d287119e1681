// gmsh's .msh in text. Version 2.2 is what most solvers read, 4.1 what gmsh itself prefers; the
// elements are the same. In 2.2 every face is an elementary surface, and every interface an
// elementary curve of its own, or several where boundary markers divide it into groups, because
// gmsh takes a curve for part of every group that one of its elements names; in 4.1 there is one
// entity per physical group and its tag is that of the group, because getfem takes the one for the
// other.
//
// Tested by tests/unit/io/write_mesh/solver_formats/write_msh_test.cpp and, in the solvers, by
// tests/solvers.
#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include <cover/mesh_view.hpp>

#include "base/containers/buckets.hpp"
#include "geom/topology/half_edges.hpp"
#include "io/write_mesh/partition.hpp"
#include "io/write_mesh/solver_formats/msh_text.hpp"

namespace cover {
namespace {

/// A mesh in parts, with the numbers that elements have in the file of the whole mesh.
struct MshParts {
  const MeshView& view;
  const Partition& partition;
  std::vector<std::vector<std::size_t>> lines;  ///< by part: beside its own triangles
  std::vector<std::size_t> line_number, triangle_number;
  std::vector<int> first_curve, first_surface;  ///< by part: tags; the last surface is for ghosts

  MshParts(const MeshView& mesh, const Partition& parts) : view(mesh), partition(parts) {
    number_elements();
    place_lines();
    number_entities();
  }

  [[nodiscard]] const std::vector<std::size_t>& own(std::uint32_t part) const {
    return partition.parts[part].own;
  }
  [[nodiscard]] std::uint32_t group(std::size_t t) const {
    return view.region_group[view.region[t].index() - 1];
  }

 private:
  void number_elements() {
    std::size_t next = 0;
    const auto number = [&](const Buckets& groups, std::vector<std::size_t>& numbers) {
      for (std::size_t g = 0; g < groups.size(); ++g)
        for (const std::size_t k : groups[g]) numbers[k] = ++next;
    };
    line_number.resize(view.lines.size());
    triangle_number.resize(view.triangles.size());
    number(Buckets(view.line_groups.size(), view.lines.size(),
                   [&](std::size_t l) { return view.line_group[l]; }),
           line_number);
    number(Buckets(view.region_groups.size(), view.triangles.size(),
                   [&](std::size_t t) { return group(t); }),
           triangle_number);
  }

  /// A line between two parts belongs to both.
  void place_lines() {
    std::vector<IndexTriple> corners;
    corners.reserve(view.triangles.size());
    for (std::size_t t = 0; t < view.triangles.size(); ++t) {
      const auto nodes = view.triangles[t];
      corners.push_back({nodes[0], nodes[1], nodes[2]});
    }
    const HalfEdges edges(view.points.size(), corners);
    lines.resize(partition.parts.size());
    for (std::size_t l = 0; l < view.lines.size(); ++l) {
      const auto ends = view.lines[l];
      std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
      for (const std::uint32_t h : {edges.find(ends[0], ends[1]), edges.find(ends[1], ends[0])}) {
        if (h == HalfEdges::kAbsent || partition.owner[h / 3] == first) continue;
        first = partition.owner[h / 3];
        lines[first].push_back(l);
      }
    }
  }

  /// Tags that no other part has, nor the whole mesh.
  void number_entities() {
    int next = 1;
    for (const auto* groups : {&view.line_groups, &view.region_groups})
      for (const Group& group : *groups) next = std::max(next, group.tag + 1);
    const auto count = [](const std::vector<std::size_t>& cells, auto group) {
      std::set<std::uint32_t> groups;
      for (const std::size_t cell : cells) groups.insert(group(cell));
      return static_cast<int>(groups.size());
    };
    int curve = next, surface = next;
    for (std::uint32_t part = 0; part < partition.parts.size(); ++part) {
      first_curve.push_back(curve);
      first_surface.push_back(surface);
      curve += count(lines[part], [&](std::size_t l) { return view.line_group[l]; });
      surface += count(own(part), [&](std::size_t t) { return group(t); }) + 1;
    }
  }
};

class MshWriter {
 public:
  MshWriter(const MeshView& view, const CellSource& cells, const RegionTable& table,
            TextWriter& out)
      : view_(view),
        cells_(cells),
        table_(table),
        interfaces_(table.interfaces.size()),
        out_(out) {}

  void write_2() {
    out_ << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    names();
    out_ << "$Nodes\n" << cells_.points() << '\n';
    std::size_t node = 0;
    cells_.each_point([&](Point p) {
      out_ << ++node << ' ';
      coordinates(p);
    });
    out_ << "$EndNodes\n$Elements\n" << view_.lines.size() + cells_.triangles() << '\n';
    const std::vector<std::size_t> curve = curves();
    for (std::size_t l = 0; l < view_.lines.size(); ++l) {
      element_2(line_type(), view_.group_of_line(l).tag, curve[l], view_.lines[l]);
      remember(region_of_line(l));
    }
    cells_.each_triangle([&](RegionId region, std::span<const std::uint32_t> nodes) {
      const Group& group = view_.region_groups[view_.region_group[region.index() - 1]];
      element_2(triangle_type(), group.tag, region.index(), nodes);
      remember(region);
    });
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
    const std::size_t elements = view_.lines.size() + cells_.triangles();
    out_ << "$EndNodes\n$Elements\n"
         << used(curves) + surfaces << ' ' << elements << " 1 " << elements << '\n';
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
    out_ << "$EndElements\n";
    periodic(true,
             [&](std::size_t l) { return static_cast<std::size_t>(view_.group_of_line(l).tag); });
    data();
  }

  /// The file of one process: its own triangles, the lines beside them, and ghosts. Entities of the
  /// whole mesh have one of the part each, as gmsh does it.
  void write_part(const MshParts& parts, std::uint32_t part) {
    head_4(Buckets(view_.line_groups.size(), view_.lines.size(),
                   [&](std::size_t l) { return view_.line_group[l]; }));
    const PartOfGroups curves(parts.lines[part], parts.first_curve[part],
                              [&](std::size_t l) { return view_.line_group[l]; });
    const PartOfGroups surfaces(parts.own(part), parts.first_surface[part],
                                [&](std::size_t t) { return parts.group(t); });
    const std::vector<std::size_t>& ghosts = parts.partition.parts[part].ghosts;
    const int ghost_tag = surfaces.tag(surfaces.groups.size());
    out_ << "$PartitionedEntities\n"
         << parts.partition.parts.size() << "\n1\n"
         << ghost_tag << ' ' << part + 1 << "\n0 " << curves.groups.size() << ' '
         << surfaces.groups.size() << " 0\n";
    std::vector<std::uint32_t> nodes;
    const auto entities = [&](int dimension, const PartOfGroups& all, const Cells& cells,
                              const std::vector<Group>& groups) {
      for (std::size_t k = 0; k < all.groups.size(); ++k) {
        Box box;
        for (const std::size_t c : all.items[k]) {
          for (const std::uint32_t node : cells[c]) box.add(view_.points[node]);
          nodes.insert(nodes.end(), cells[c].begin(), cells[c].end());
        }
        const int parent = groups[all.groups[k]].tag;
        out_ << all.tag(k) << ' ' << dimension << ' ' << parent << " 1 " << part + 1;
        corners(box);
        out_ << " 1 " << parent << " 0\n";
      }
    };
    entities(1, curves, view_.lines, view_.line_groups);
    entities(2, surfaces, view_.triangles, view_.region_groups);
    out_ << "$EndPartitionedEntities\n";
    for (const std::size_t t : ghosts)
      nodes.insert(nodes.end(), view_.triangles[t].begin(), view_.triangles[t].end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    part_nodes(nodes, surfaces);
    part_elements(parts, curves, surfaces, ghosts, ghost_tag);
    out_ << "$GhostElements\n" << ghosts.size() << '\n';
    for (const std::size_t t : ghosts)
      out_ << parts.triangle_number[t] << ' ' << parts.partition.owner[t] + 1 << " 1 " << part + 1
           << '\n';
    out_ << "$EndGhostElements\n";
    part_data(parts, curves, surfaces, ghosts, nodes);
  }

 private:
  /// The cells of a part by the groups that they are of, each an entity.
  struct PartOfGroups {
    std::vector<std::uint32_t> groups;
    std::vector<std::vector<std::size_t>> items;
    int first = 0;  ///< tag

    template <class Group>
    PartOfGroups(std::vector<std::size_t> cells, int first_tag, Group group) : first(first_tag) {
      std::stable_sort(cells.begin(), cells.end(),
                       [&](std::size_t a, std::size_t b) { return group(a) < group(b); });
      for (const std::size_t cell : cells) {
        if (groups.empty() || groups.back() != group(cell)) {
          groups.push_back(group(cell));
          items.emplace_back();
        }
        items.back().push_back(cell);
      }
    }
    [[nodiscard]] int tag(std::size_t k) const { return first + static_cast<int>(k); }
    [[nodiscard]] std::size_t size() const {
      std::size_t n = 0;
      for (const auto& some : items) n += some.size();
      return n;
    }
  };

  void part_nodes(std::span<const std::uint32_t> nodes, const PartOfGroups& surfaces) {
    out_ << "$Nodes\n";
    if (nodes.empty()) {
      out_ << "0 0 0 0\n$EndNodes\n";
      return;
    }
    out_ << "1 " << nodes.size() << ' ' << nodes.front() + 1 << ' ' << nodes.back() + 1 << "\n2 "
         << surfaces.tag(0) << " 0 " << nodes.size() << '\n';
    for (const std::uint32_t node : nodes) out_ << node + 1 << '\n';
    for (const std::uint32_t node : nodes) coordinates(view_.points[node]);
    out_ << "$EndNodes\n";
  }

  void part_elements(const MshParts& parts, const PartOfGroups& curves,
                     const PartOfGroups& surfaces, std::span<const std::size_t> ghosts,
                     int ghost_tag) {
    std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;
    const auto note = [&](std::size_t number) {
      least = std::min(least, number);
      most = std::max(most, number);
    };
    for (const auto& some : curves.items)
      for (const std::size_t l : some) note(parts.line_number[l]);
    for (const auto& some : surfaces.items)
      for (const std::size_t t : some) note(parts.triangle_number[t]);
    for (const std::size_t t : ghosts) note(parts.triangle_number[t]);
    out_ << "$Elements\n"
         << curves.groups.size() + surfaces.groups.size() + (ghosts.empty() ? 0 : 1) << ' '
         << curves.size() + surfaces.size() + ghosts.size() << ' ' << std::min(least, most) << ' '
         << most << '\n';
    const auto elements = [&](std::span<const std::size_t> cells, const Cells& of,
                              const std::vector<std::size_t>& numbers) {
      for (const std::size_t c : cells) {
        out_ << numbers[c];
        nodes(of[c]);
      }
    };
    for (std::size_t k = 0; k < curves.groups.size(); ++k) {
      block(1, curves.tag(k), line_type(), curves.items[k].size());
      elements(curves.items[k], view_.lines, parts.line_number);
    }
    for (std::size_t k = 0; k < surfaces.groups.size(); ++k) {
      block(2, surfaces.tag(k), triangle_type(), surfaces.items[k].size());
      elements(surfaces.items[k], view_.triangles, parts.triangle_number);
    }
    if (!ghosts.empty()) {
      block(2, ghost_tag, triangle_type(), ghosts.size());
      elements(ghosts, view_.triangles, parts.triangle_number);
    }
    out_ << "$EndElements\n";
  }

  /// As data(), of what is in the part.
  void part_data(const MshParts& parts, const PartOfGroups& curves, const PartOfGroups& surfaces,
                 std::span<const std::size_t> ghosts, std::span<const std::uint32_t> nodes) {
    constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
    for (const Attribute& attribute : view_.attributes) {
      begin_data("Element", attribute.name, curves.size() + surfaces.size() + ghosts.size());
      const auto value = [&](std::size_t number, RegionId region) {
        out_ << number << ' ' << (region == kVoid ? kNoValue : attribute.values[region.index() - 1])
             << '\n';
      };
      for (const auto& some : curves.items)
        for (const std::size_t l : some) value(parts.line_number[l], region_of_line(l));
      for (const auto& some : surfaces.items)
        for (const std::size_t t : some) value(parts.triangle_number[t], view_.region[t]);
      for (const std::size_t t : ghosts) value(parts.triangle_number[t], view_.region[t]);
      out_ << "$EndElementData\n";
    }
    for (const PlaneField::Array& field : view_.fields) {
      begin_data("Node", field.name, nodes.size());
      for (const std::uint32_t p : nodes) out_ << p + 1 << ' ' << field.values[p] << '\n';
      out_ << "$EndNodeData\n";
    }
  }

  /// Format, names and entities of 4.1.
  void head_4(const Buckets& curves) {
    out_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    names();
    out_ << "$Entities\n0 " << used(curves) << ' ' << used_surfaces() << " 0\n";
    curve_entities(curves);
    for (std::size_t g = 0; g < view_.region_groups.size(); ++g)
      if (cells_.triangles(g) > 0) entity(view_.region_groups[g].tag, cells_.box(g));
    out_ << "$EndEntities\n";
  }

  [[nodiscard]] bool second_order() const { return view_.lines.nodes_each == 3; }
  [[nodiscard]] int line_type() const { return second_order() ? 8 : 1; }
  [[nodiscard]] int triangle_type() const { return second_order() ? 9 : 2; }

  /// The elementary tag of each line: its InterfaceId, or the one after the last for the hull, or
  /// one after that where the interface lies in another group too.
  [[nodiscard]] std::vector<std::size_t> curves() const {
    const std::size_t hull = interfaces_ + 1;
    std::size_t last = hull;
    std::vector<std::uint8_t> taken(hull + 1);
    std::vector<std::size_t> tags(view_.lines.size());
    for (std::size_t l = 0; l < tags.size(); ++l) {
      const auto same = [&](const auto& of) { return l > 0 && of[l] == of[l - 1]; };
      if (same(view_.line_group) && same(view_.interface)) {
        tags[l] = tags[l - 1];
        continue;
      }
      const std::size_t own =
          view_.interface[l] == kNoInterface ? hull : view_.interface[l].index();
      tags[l] = taken[own] == 0 ? own : ++last;
      taken[own] = 1;
    }
    return tags;
  }

  static std::size_t used(const Buckets& entities) {
    std::size_t n = 0;
    for (std::size_t e = 0; e < entities.size(); ++e) n += entities[e].empty() ? 0 : 1;
    return n;
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
    out_ << dimension << ' ' << group.tag << " \"" << group.label << "\"\n";
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

  void element_4(RegionId region, std::span<const std::uint32_t> cell) {
    out_ << ++element_;
    nodes(cell);
    remember(region);
  }

  /// The region of the element written last, for data().
  void remember(RegionId region) {
    if (!view_.attributes.empty()) region_of_element_.push_back(region);
  }

  /// Tag, bounding box, physical group; not what bounds it.
  void entity(int tag, const Box& box) {
    out_ << tag;
    corners(box);
    out_ << " 1 " << tag << " 0\n";
  }
  void corners(const Box& box) {
    out_ << ' ' << box.low.x << ' ' << box.low.y << " 0 " << box.high.x << ' ' << box.high.y
         << " 0";
  }

  void curve_entities(const Buckets& members) {
    for (std::size_t g = 0; g < view_.line_groups.size(); ++g) {
      if (members[g].empty()) continue;
      Box box;
      for (const std::size_t l : members[g]) {
        for (const std::uint32_t node : view_.lines[l]) box.add(cells_.line_point(node));
      }
      entity(view_.line_groups[g].tag, box);
    }
  }

  [[nodiscard]] std::size_t used_surfaces() const {
    std::size_t n = 0;
    for (std::size_t g = 0; g < view_.region_groups.size(); ++g)
      n += cells_.triangles(g) > 0 ? 1 : 0;
    return n;
  }

  void block(int dimension, int tag, int type, std::size_t cells) {
    out_ << dimension << ' ' << tag << ' ' << type << ' ' << cells << '\n';
  }

  /// The one on its left; kVoid for a side of the hull.
  [[nodiscard]] RegionId region_of_line(std::size_t l) const {
    const InterfaceId interface = view_.interface[l];
    return interface == kNoInterface ? kVoid : table_.interfaces[interface.index() - 1].left;
  }

  /// Attributes and fields. Every element has a value, lines those of the region on their left,
  /// since meshio cannot read data of some elements alone.
  void data() {
    constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
    for (const Attribute& attribute : view_.attributes) {
      begin_data("Element", attribute.name, region_of_element_.size());
      for (std::size_t e = 0; e < region_of_element_.size(); ++e) {
        const RegionId region = region_of_element_[e];
        out_ << e + 1 << ' ' << (region == kVoid ? kNoValue : attribute.values[region.index() - 1])
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

  /// The time 0, the step 0, one number for each.
  void begin_data(std::string_view of, const std::string& name, std::size_t count) {
    out_ << '$' << of << "Data\n1\n\"" << name << "\"\n1\n0\n3\n0\n1\n" << count << '\n';
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

  const MeshView& view_;
  const CellSource& cells_;
  const RegionTable& table_;
  std::size_t interfaces_;
  TextWriter& out_;
  std::size_t element_ = 0;                  ///< number of the last element written
  std::vector<RegionId> region_of_element_;  ///< where there are attributes
};

/// A mesh in memory.
class ViewCells final : public CellSource {
 public:
  /// Groups are asked for only `by_group`.
  ViewCells(const MeshView& view, bool by_group)
      : view_(view),
        groups_(view.region_groups.size(), by_group ? view.triangles.size() : 0,
                [&](std::size_t t) { return view.region_group[view.region[t].index() - 1]; }) {}

  [[nodiscard]] std::size_t points() const override { return view_.points.size(); }
  [[nodiscard]] std::size_t triangles() const override { return view_.triangles.size(); }
  [[nodiscard]] std::size_t triangles(std::size_t group) const override {
    return groups_[group].size();
  }
  void each_point(const std::function<void(Point)>& use) const override {
    for (const Point& p : view_.points) use(p);
  }
  void each_triangle(const Use& use) const override {
    for (std::size_t t = 0; t < view_.triangles.size(); ++t)
      use(view_.region[t], view_.triangles[t]);
  }
  void each_triangle(std::size_t group, const Use& use) const override {
    for (const std::size_t t : groups_[group]) use(view_.region[t], view_.triangles[t]);
  }
  [[nodiscard]] Point line_point(std::uint32_t node) const override { return view_.points[node]; }
  [[nodiscard]] Box box(std::size_t group) const override {
    Box box;
    for (const std::size_t t : groups_[group]) {
      for (const std::uint32_t node : view_.triangles[t]) box.add(view_.points[node]);
    }
    return box;
  }

 private:
  const MeshView& view_;
  Buckets groups_;
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

namespace {

/// X_1.msh, X_2.msh, ..., which are all on the disk before the first of them appears.
Status write_msh_parts(const MeshView& view, const RegionTable& table, const std::string& path,
                       const WriteOptions& options) {
  const auto count = static_cast<std::uint32_t>(options.parts);
  const Partition partition = partition_of(view, count);
  const MshParts parts(view, partition);
  const ViewCells cells(view, true);
  std::filesystem::path stem(path);
  stem.replace_extension();
  std::vector<TextWriter> files;
  for (std::uint32_t part = 0; part < count; ++part) {
    Result<TextWriter> file =
        TextWriter::create(stem.string() + "_" + std::to_string(part + 1) + ".msh", options.stop);
    if (!file) return std::move(file).error();
    MshWriter(view, cells, table, *file).write_part(parts, part);
    if (Status status = file->prepare(); !status) return status;
    files.push_back(*std::move(file));
  }
  Status all = ok();
  for (TextWriter& file : files) {  // a folder that cannot be synced is no reason to mix meshes
    if (Status status = file.commit(); !status && all) all = std::move(status);
  }
  return all;
}

}  // namespace

Status write_msh(const Output& output, const std::string& path, const WriteOptions& options) {
  const MeshView view = view_of(output, options);
  if (options.parts != 1) {
    if (!view.periodic.empty())
      return Error{ErrorCode::bad_option,
                   "cannot write '" + path + "' in parts: periodic sides have no place in them",
                   {},
                   {}};
    return write_msh_parts(view, output.table, path, options);
  }
  return write_text(path, options.stop, [&](TextWriter& out) {
    const ViewCells cells(view, options.msh == "4.1");
    write_msh_text(view, cells, output.table, options.msh, out);
  });
}

}  // namespace cover
