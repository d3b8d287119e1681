// Groups first, from the tables alone, so that tags do not depend on what is left out; then cells.
// Tested by tests/unit/io/write_mesh/mesh_view_test.cpp.
#include <cover/mesh_view.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <cover/curved_mesh.hpp>
#include <cover/mesh.hpp>

#include "base/containers/order.hpp"
#include "base/none.hpp"
#include "base/run_all.hpp"
#include "base/words/safe_names.hpp"
#include "geom/vector.hpp"
#include "io/text/array_names.hpp"

namespace cover {
namespace {

using Edge = TriMesh::EdgeHandle;
using Halfedge = TriMesh::HalfedgeHandle;

/// Unique names of `groups` by `make`, which gets originals and names that are taken. Those of the
/// input come first: a solver is told them, while no one relies on one that is made up.
template <class Make>
std::vector<std::string> names_by(const std::vector<Group>& groups,
                                  const std::vector<std::string>& originals, const Make& make,
                                  std::set<std::string> taken = {}) {
  std::vector<std::string> names(groups.size());
  for (const bool made_up : {false, true}) {
    std::vector<std::string> some;
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (groups[g].is_made_up == made_up) some.push_back(originals[g]);
    some = make(some, taken);
    taken.insert(some.begin(), some.end());
    auto next = some.begin();
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (groups[g].is_made_up == made_up) names[g] = std::move(*next++);
  }
  return names;
}

using Names = std::vector<std::string>;
using NameSet = std::set<std::string>;

/// Groups in the order in which their keys come up.
template <class Key>
class Grouping {
 public:
  /// The group of `key`; a new one gets `name` and `material`.
  std::uint32_t find(const Key& key, const std::string& name, int material,
                     bool is_made_up = false) {
    const auto [at, is_new] = index_.emplace(key, static_cast<std::uint32_t>(groups_.size()));
    if (is_new) groups_.push_back({{}, {}, name, 0, material, is_made_up});
    return at->second;
  }

  /// The groups with their names made safe and the lowest tags that are not `taken`, from
  /// `first_tag` on.
  std::vector<Group> finish(int first_tag, const std::set<int>& taken = {}) {
    Names originals;
    for (const Group& group : groups_) originals.push_back(group.original);
    const Names labels = names_by(groups_, originals, [](const Names& some, const NameSet& used) {
      return unique_legible_names(some, used);
    });
    const Names names = names_by(groups_, originals, [](const Names& some, const NameSet& used) {
      return unique_safe_names(some, used);
    });
    for (std::size_t g = 0; g < groups_.size(); ++g, ++first_tag) {
      while (taken.contains(first_tag)) ++first_tag;
      groups_[g].name = names[g];
      groups_[g].label = labels[g];
      groups_[g].tag = first_tag;
    }
    return std::move(groups_);
  }

 private:
  std::map<Key, std::uint32_t> index_;
  std::vector<Group> groups_;
};

void group_regions(const RegionTable& table, const std::string& ids, MeshView& view) {
  const bool by_region = ids == "region", by_material = ids == "material";
  Grouping<std::tuple<std::string, std::uint32_t, int>> grouping;
  for (const Region& region : table.regions) {
    const std::string& name = by_material ? region.material_name : region.name;
    view.region_group.push_back(
        grouping.find({by_material ? std::string() : name, by_region ? region.id.value() : 0,
                       by_region ? 0 : region.material},
                      name, region.material));
  }
  view.region_groups = grouping.finish(1);  // by regions, these are their ids
  if (by_material) {
    for (Group& group : view.region_groups) group.tag = group.material;
  }
  view.has_ids = !ids.empty();
}

/// By group, interface, marker and edge.
bool is_before(const LineEdge& a, const LineEdge& b) {
  return std::tuple(a.group, a.interface, a.marker, a.order) <
         std::tuple(b.group, b.interface, b.marker, b.order);
}

/// Many lines are mostly one outline in its order.
void sort_lines(std::vector<LineEdge>& lines) {
  if (!std::is_sorted(lines.begin(), lines.end(), is_before))
    std::sort(lines.begin(), lines.end(), is_before);
}

/// Names the groups of lines and tells of each line to which it belongs.
class LineGroups {
 public:
  LineGroups(const RegionTable& table, const MeshView& view) : table_(table), view_(view) {}

  /// A contact by its name, a marked line by its marker as if that were the name of a contact, any
  /// other line by its name and the groups on its sides: what lies between groups of two names has
  /// one name, whichever of them is on the left.
  std::uint32_t of(InterfaceId id, int marker) {
    // A side of the hull that no segment prescribes.
    if (id == kNoInterface) return find({InterfaceKind::outline, 0, 0, "hull"});
    const Interface& line = table_.interface(id);
    if (line.kind == InterfaceKind::contact) return find({line.kind, 0, 0, line.name});
    if (marker != 0) return find({InterfaceKind::contact, 0, 0, std::to_string(marker)});
    std::uint32_t left = group_of(line.left), right = group_of(line.right);
    if (line.kind == InterfaceKind::interface && right < left) std::swap(left, right);
    return find({line.kind, left, right, line.name});
  }

  std::vector<Group> finish() {
    std::set<int> taken;
    for (const Group& group : view_.region_groups) taken.insert(group.tag);
    return grouping_.finish(static_cast<int>(taken.size()) + 1, taken);
  }

 private:
  /// Kind, groups on the left and on the right counted from 1 (the lower first, of an interface),
  /// name.
  using Key = std::tuple<InterfaceKind, std::uint32_t, std::uint32_t, std::string>;

  std::uint32_t find(const Key& key) {
    const bool is_made_up = std::get<InterfaceKind>(key) != InterfaceKind::contact;
    return grouping_.find(key, std::get<std::string>(key), 0, is_made_up);
  }
  [[nodiscard]] std::uint32_t group_of(RegionId region) const {
    return region == kVoid ? 0 : 1 + view_.region_group[place_of(region)];
  }

  const RegionTable& table_;
  const MeshView& view_;
  Grouping<Key> grouping_;
};

/// The half-edge along `edge` with the region on its left that should lie there.
Halfedge directed(const Mesh& mesh, const RegionTable& table, Edge edge) {
  const TriMesh& tri = mesh.tri();
  const Halfedge h = TriMesh::s_halfedge_handle(edge, 0),
                 back = TriMesh::s_halfedge_handle(edge, 1);
  if (tri.is_boundary(h)) return back;
  if (tri.is_boundary(back)) return h;
  const InterfaceId line = mesh.interface(edge);
  const RegionId left = table.interface(line).left;
  return mesh.region(tri.face_handle(h)) == left ? h : back;
}

/// `lines` in their order, and their groups; as WriteOptions::order asks, edge k has its middle at
/// node `corners` + k.
void add_lines(const RegionTable& table, std::vector<LineEdge> lines, const WriteOptions& options,
               MeshView& view) {
  // Groups are numbered in this order, whichever lines are left out then.
  sort_lines(lines);
  LineGroups groups(table, view);
  for (const bool hull : {false, true}) {
    for (LineEdge& line : lines) {
      if ((line.interface == kNoInterface) == hull)
        line.group = groups.of(line.interface, line.marker);
    }
  }
  view.line_groups = groups.finish();
  sort_lines(lines);
  if (!options.inner_lines)
    std::erase_if(lines, [](const LineEdge& line) { return line.is_inner; });
  const bool second_order = options.order == 2;
  view.lines.nodes_each = second_order ? 3 : 2;
  view.lines.nodes.reserve(view.lines.nodes_each * lines.size());
  view.interface.reserve(lines.size());
  view.line_group.reserve(lines.size());
  view.inner.reserve(lines.size());
  view.marker.reserve(lines.size());
  for (const LineEdge& line : lines) {
    view.lines.nodes.push_back(line.from);
    view.lines.nodes.push_back(line.to);
    if (second_order)
      view.lines.nodes.push_back(static_cast<std::uint32_t>(view.corners + line.order));
    view.interface.push_back(line.interface);
    view.line_group.push_back(line.group);
    view.inner.push_back(line.is_inner ? 1 : 0);
    view.marker.push_back(line.marker);
  }
}

/// `points` with their numbers in the mesh, and their groups.
void add_named(std::span<const NamedPoint> points, MeshView& view) {
  Grouping<std::string> grouping;
  std::vector<std::array<std::uint32_t, 2>> members;  // group, point
  for (const NamedPoint& point : points)
    members.push_back({grouping.find(point.name, point.name, 0), point.vertex.value()});
  sort_unique(members);
  for (const auto& [group, point] : members) {
    view.named.push_back(point);
    view.named_group.push_back(group);
  }
  std::set<int> taken;
  for (const auto* groups : {&view.region_groups, &view.line_groups})
    for (const Group& group : *groups) taken.insert(group.tag);
  view.point_groups = grouping.finish(static_cast<int>(taken.size()) + 1, taken);
}

class Viewer {
 public:
  Viewer(const Output& output, const WriteOptions& options, const Team& team)
      : team_(team),
        output_(output),
        mesh_(output.mesh),
        tri_(output.mesh.tri()),
        table_(output.table),
        periodic_(output.periodic),
        options_(options) {}

  MeshView make(bool with_lines) {
    group_regions(table_, options_.ids, view_);
    add_points();
    add_triangles();
    // Nodes on periodic sides are found by their lines.
    if (with_lines || !periodic_.empty()) add_lines(table_, all_lines(), options_, view_);
    if (with_lines) add_named(named_points_of(output_), view_);
    if (!periodic_.empty()) add_periodic();
    add_arrays();
    return std::move(view_);
  }

 private:
  [[nodiscard]] Point at(int v) const {
    const TriMesh::Point& p = tri_.point(TriMesh::VertexHandle(v));
    return {p[0], p[1]};
  }

  /// The point in the middle of an edge.
  [[nodiscard]] std::uint32_t midpoint_of(Halfedge h) const {
    return static_cast<std::uint32_t>(view_.corners) +
           static_cast<std::uint32_t>(TriMesh::s_edge_handle(h).idx());
  }

  void add_points() {
    view_.corners = tri_.n_vertices();
    view_.points.reserve(tri_.n_vertices() + (options_.order == 2 ? tri_.n_edges() : 0));
    view_.points.resize(tri_.n_vertices());
    team_.each_range(tri_.n_vertices(), kItemsAtATime, [this](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) view_.points[v] = at(static_cast<int>(v));
    });
    if (options_.order != 2) return;
    for (const Edge e : tri_.edges()) {
      const Halfedge h = TriMesh::s_halfedge_handle(e, 0);
      view_.points.push_back(
          midpoint(at(tri_.from_vertex_handle(h).idx()), at(tri_.to_vertex_handle(h).idx())));
    }
    const CurvedMesh curved = curved_mesh(output_);
    for (const CurvedEdge& edge : curved.edges)
      view_.points[midpoint_of(between(edge.a, edge.b))] = edge.middle;
    for (const auto* nodes : {&curved.moved, &curved.rounded}) {
      for (const MovedNode& node : *nodes)
        view_.points[midpoint_of(between(node.a, node.b))] = node.middle;
    }
  }

  void add_triangles() {
    view_.triangles.nodes_each = options_.order == 2 ? 6 : 3;
    view_.triangles.nodes.resize(view_.triangles.nodes_each * tri_.n_faces());
    view_.region.resize(tri_.n_faces());
    view_.material.resize(tri_.n_faces());
    team_.each_range(tri_.n_faces(), kItemsAtATime, [this](std::size_t first, std::size_t last) {
      for (std::size_t f = first; f < last; ++f) add_triangle(f);
    });
  }

  void add_triangle(std::size_t f) {
    const TriMesh::FaceHandle face(static_cast<int>(f));
    const Halfedge first = tri_.halfedge_handle(face);
    const Halfedge second = tri_.next_halfedge_handle(first);
    const Halfedge third = tri_.next_halfedge_handle(second);
    std::size_t next = view_.triangles.nodes_each * f;
    for (const Halfedge h : {first, second, third})
      view_.triangles.nodes[next++] = static_cast<std::uint32_t>(tri_.from_vertex_handle(h).idx());
    if (options_.order == 2) {
      for (const Halfedge h : {first, second, third})
        view_.triangles.nodes[next++] = midpoint_of(h);
    }
    view_.region[f] = mesh_.region(face);
    view_.material[f] = mesh_.material(face);
  }

  /// On interfaces, and on the hull.
  [[nodiscard]] std::vector<LineEdge> all_lines() const {
    std::vector<std::vector<LineEdge>> parts(Team::ranges(tri_.n_edges(), kItemsAtATime));
    team_.each_range(tri_.n_edges(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      parts[first / kItemsAtATime] = lines_among(static_cast<int>(first), static_cast<int>(last));
    });
    std::size_t count = 0;
    for (const std::vector<LineEdge>& part : parts) count += part.size();
    std::vector<LineEdge> lines;
    lines.reserve(count);
    for (const std::vector<LineEdge>& part : parts)
      lines.insert(lines.end(), part.begin(), part.end());
    return lines;
  }

  [[nodiscard]] std::vector<LineEdge> lines_among(int first, int last) const {
    std::vector<LineEdge> lines;
    for (int e = first; e < last; ++e) {
      const Edge edge(e);
      const InterfaceId interface = mesh_.interface(edge);
      const bool is_outer = tri_.is_boundary(edge);
      if (interface == kNoInterface && !is_outer) continue;
      const Halfedge h = directed(mesh_, table_, edge);
      lines.push_back({static_cast<std::uint64_t>(e), 0, interface, mesh_.marker(edge),
                       static_cast<std::uint32_t>(tri_.from_vertex_handle(h).idx()),
                       static_cast<std::uint32_t>(tri_.to_vertex_handle(h).idx()), !is_outer});
    }
    return lines;
  }

  /// The edge between two vertices, which is there.
  [[nodiscard]] Halfedge between(std::uint32_t u, std::uint32_t v) const {
    return tri_.find_halfedge(TriMesh::VertexHandle(static_cast<int>(u)),
                              TriMesh::VertexHandle(static_cast<int>(v)));
  }

  void add_periodic() {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> line_of;
    for (std::uint32_t l = 0; l < view_.lines.size(); ++l) {
      const auto ends = view_.lines[l];
      line_of.emplace(std::array{ends[0], ends[1]}, l);
      line_of.emplace(std::array{ends[1], ends[0]}, l);
    }
    std::vector<PeriodicNodes> all = periodic_;
    for (PeriodicNodes& nodes : all) {
      PeriodicLines lines{nodes.map, {}, {}};
      for (const auto& [a, b, a2, b2] : nodes.edges) {
        const auto from = line_of.find({a, b}), to = line_of.find({a2, b2});
        if (from != line_of.end() && to != line_of.end()) {
          lines.lines.push_back({from->second, to->second});
          lines.corners.push_back({{{a, a2}, {b, b2}}});
        }
        if (options_.order == 2)
          nodes.vertices.push_back({midpoint_of(between(a, b)), midpoint_of(between(a2, b2))});
      }
      view_.periodic.push_back(std::move(lines));
    }
    view_.periodic_node = periodic_classes(all, view_.points.size());
  }

  void add_arrays() {
    view_.attributes = table_.attributes;
    view_.fields = output_.fields;
    std::vector<std::string> names;
    for (const Attribute& attribute : view_.attributes) names.push_back(attribute.name);
    for (const PlaneField::Array& field : view_.fields) names.push_back(field.name);
    names = array_names(std::move(names));
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::size_t n = view_.attributes.size();
      (k < n ? view_.attributes[k].name : view_.fields[k - n].name) = names[k];
    }
    view_.region_values = output_.region_values;
    if (options_.order != 2) return;
    for (std::size_t k = 0; k < view_.fields.size(); ++k) {
      PlaneField::Array& field = view_.fields[k];
      for (const Edge e : tri_.edges()) {
        const Halfedge h = TriMesh::s_halfedge_handle(e, 0);
        const auto value = [&](TriMesh::VertexHandle v) {
          return field.values[static_cast<std::size_t>(v.idx())];
        };
        add_values_of_regions(h, k);
        field.values.push_back(value(tri_.from_vertex_handle(h)) / 2 +
                               value(tri_.to_vertex_handle(h)) / 2);
      }
    }
  }

  /// In the middle of the edge of `h`, which is the next point, where they differ from the mean.
  void add_values_of_regions(Halfedge h, std::size_t k) {
    if (k >= view_.region_values.size() || view_.region_values[k].empty()) return;
    const std::vector<double>& values = view_.fields[k].values;
    const auto a = static_cast<std::uint32_t>(tri_.from_vertex_handle(h).idx());
    const auto b = static_cast<std::uint32_t>(tri_.to_vertex_handle(h).idx());
    const double mean = values[a] / 2 + values[b] / 2;
    std::set<RegionId> regions;
    for (const Halfedge side : {h, tri_.opposite_halfedge_handle(h)})
      if (const auto face = tri_.face_handle(side); face.is_valid())
        regions.insert(mesh_.region(face));
    for (const RegionId region : regions) {
      const double value = value_in(view_.fields, view_.region_values, k, a, region) / 2 +
                           value_in(view_.fields, view_.region_values, k, b, region) / 2;
      if (value != mean && !(std::isnan(value) && std::isnan(mean)))
        view_.region_values[k].push_back(
            {static_cast<std::uint32_t>(values.size()), region, value});
    }
  }

  const Team& team_;
  const Output& output_;
  const Mesh& mesh_;
  const TriMesh& tri_;
  const RegionTable& table_;
  const std::vector<PeriodicNodes>& periodic_;
  const WriteOptions& options_;
  MeshView view_;
};

MeshView make_view(const Output& output, const WriteOptions& options, bool with_lines) {
  MeshView view;
  with_team(output.report.threads,
            [&](const Team& team) { view = Viewer(output, options, team).make(with_lines); });
  const std::size_t uncut = output.report.input_points;
  if (uncut > 0 && output.pslg.points.size() > uncut)
    view.cut_vertices = output.pslg.points.size() - uncut;
  return view;
}

}  // namespace

std::vector<NamedPoint> named_points_of(const Output& output) {
  const Pslg& pslg = output.pslg;
  if (pslg.named_points.empty()) return {};
  std::vector<std::uint32_t> number(pslg.points.size(), kNone);
  for (const auto v : output.mesh.tri().vertices()) {
    const long point = output.mesh.input_id(v);
    if (point >= 0) number[static_cast<std::size_t>(point)] = static_cast<std::uint32_t>(v.idx());
  }
  std::vector<NamedPoint> named;
  for (const NamedPoint& point : pslg.named_points) {
    const std::uint32_t v = number[point.vertex.index()];
    if (v != kNone) named.push_back({VertexId(v), point.name});
  }
  return named;
}

MeshView view_of(const Output& output, const WriteOptions& options) {
  return make_view(output, options, true);
}

MeshView view_of_triangles(const Output& output, const WriteOptions& options) {
  return make_view(output, options, false);
}

std::array<Angle, 3> angles_of(const MeshView& view, std::size_t t) {
  const auto nodes = view.triangles[t];
  const Point a = view.points[nodes[0]], b = view.points[nodes[1]], c = view.points[nodes[2]];
  return {Angle::radians(angle_at(b, a, c)), Angle::radians(angle_at(c, b, a)),
          Angle::radians(angle_at(a, c, b))};
}

MeshView view_of_lines(const RegionTable& table, std::vector<LineEdge> lines,
                       const WriteOptions& options, std::span<const NamedPoint> named) {
  MeshView view;
  group_regions(table, options.ids, view);
  add_lines(table, std::move(lines), options, view);
  add_named(named, view);
  return view;
}

std::vector<Group> node_sets(const MeshView& view) {
  std::vector<Group> sets = view.line_groups;
  sets.insert(sets.end(), view.point_groups.begin(), view.point_groups.end());
  return sets;
}

std::vector<std::string> abaqus_names(const std::vector<Group>& groups) {
  constexpr std::size_t kLongest = 80;  // what Abaqus and CalculiX read
  std::vector<std::string> names;
  for (const Group& group : groups) {
    std::string name = group.name;
    for (char& c : name) {
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
      if (c == '.') c = '_';
    }
    if (name[0] < 'A' || name[0] > 'Z') name.insert(name.begin(), 'X');
    names.push_back(std::move(name));
  }
  const auto make = [&](const Names& some, const NameSet& taken) {
    return unique_safe_names(some, taken, kLongest);
  };
  return names_by(groups, names, make, {kAllNodes});
}

}  // namespace cover
