// Files keep triangles, regions and the edges of interfaces; the rest follows: connectivity, the
// segments (an edge on an interface is one whole segment), which region lies on which side, voids.
// Tested by tests/unit/mesh/rebuild_test.cpp.
#include <cover/mesh.hpp>
#include <cover/stored_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/core.h>

#include "base/faults/out_of_memory.hpp"
#include "geom/predicates.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"
#include "mesh/find_edges.hpp"
#include "mesh/mesh_builder.hpp"
#include "mesh/voids.hpp"
#include "region/interfaces.hpp"
#include "target/report/measure_angles.hpp"

namespace cover {
namespace {

class Rebuilder {
 public:
  explicit Rebuilder(const StoredMesh& stored)
      : stored_(stored), soup_(stored.soup), builder_(soup_.points, soup_.triangles) {}

  Result<Output> run() {
    out_.mesh = builder_.build();
    out_.report.provenance = stored_.provenance;
    out_.report.unit = stored_.unit;
    out_.report.scale = stored_.scale;
    out_.table.regions = stored_.regions;
    if (stored_.regions.empty()) make_up_regions();
    set_faces();
    out_.table.void_seeds = places_in_voids(out_.mesh, out_.report.notes);
    out_.report.quality = measure_angles(soup_.points, soup_.triangles);
    if (std::optional<Error> error = add_named_points()) return *std::move(error);
    if (std::optional<Error> error = add_segments()) return *std::move(error);
    set_vertices();
    if (std::optional<Error> error = add_periodic()) return *std::move(error);
    if (std::optional<Error> error = add_arcs()) return *std::move(error);
    if (std::optional<Error> error = add_nodes()) return *std::move(error);
    if (std::optional<Error> error = add_arrays()) return *std::move(error);
    return std::move(out_);
  }

  /// What must hold before anything is built.
  static std::optional<Error> check(const StoredMesh& stored) {
    const TriangleSoup& soup = stored.soup;
    const std::size_t n = soup.triangles.size();
    if (soup.region.size() != n || soup.material.size() != n) {
      return wrong("the mesh has not one region and one material per triangle");
    }
    if (!std::all_of(soup.points.begin(), soup.points.end(),
                     [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); })) {
      return wrong("a coordinate is not finite");
    }
    if (stored.input_vertices > soup.points.size()) return wrong("more input points than points");
    if (stored.cut_vertices > soup.points.size())
      return wrong("more points put on segments than points");
    if (stored.names.empty() || !stored.names[0].empty())
      return wrong("the names of contacts do not begin with the empty one");
    if (std::optional<Error> error = check_tables(stored)) return error;
    for (const Interface& line : stored.interfaces) {
      if (std::max(line.left.index(), line.right.index()) > stored.regions.size())
        return wrong(fmt::format("interface {} has a side in region {}, which is not there",
                                 line.id.value(), std::max(line.left.value(), line.right.value())));
    }
    const std::size_t most = stored.regions.empty() ? n : stored.regions.size();
    for (std::size_t t = 0; t < n; ++t) {
      for (const std::uint32_t v : soup.triangles[t]) {
        if (v >= soup.points.size())
          return wrong(fmt::format("triangle {} has no vertex {}", t, v));
      }
      if (soup.region[t] < 1 || soup.region[t] > static_cast<std::int64_t>(most)) {
        return wrong(fmt::format("triangle {} has RegionId {}, but regions are 1 to {}", t,
                                 soup.region[t], most));
      }
      if (soup.material[t] != static_cast<std::int32_t>(soup.material[t]))
        return wrong(fmt::format("triangle {} has the material {}, which is no number of 32 bits",
                                 t, soup.material[t]));
    }
    if (!HalfEdges(soup.points.size(), soup.triangles).all_different())
      return wrong("triangles overlap: two of them share a directed edge");
    return std::nullopt;
  }

 private:
  /// Regions and interfaces are known by their places.
  static std::optional<Error> check_tables(const StoredMesh& stored) {
    for (std::size_t r = 0; r < stored.regions.size(); ++r) {
      if (stored.regions[r].id != RegionId(r + 1))
        return wrong(
            fmt::format("region {} has the number {}", r + 1, stored.regions[r].id.value()));
    }
    for (std::size_t k = 0; k < stored.interfaces.size(); ++k) {
      if (stored.interfaces[k].id != InterfaceId(k + 1))
        return wrong(
            fmt::format("interface {} has the number {}", k + 1, stored.interfaces[k].id.value()));
    }
    return std::nullopt;
  }

  static Error wrong(std::string what) { return {ErrorCode::syntax, std::move(what), {}, {}}; }

  [[nodiscard]] RegionId region_of(std::size_t triangle) const {
    return RegionId(static_cast<std::uint32_t>(soup_.region[triangle]));
  }

  void make_up_regions() {
    std::int64_t last = 0;
    for (const std::int64_t r : soup_.region) last = std::max(last, r);
    out_.table.regions.resize(static_cast<std::size_t>(last));
    for (std::size_t r = 0; r < out_.table.regions.size(); ++r) {
      out_.table.regions[r].id = RegionId(r + 1);
    }
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      Region& region = out_.table.region(region_of(t));
      if (!region.name.empty()) continue;
      region.material = static_cast<int>(soup_.material[t]);
      region.name = region.material_name = fmt::format("material_{}", region.material);
    }
  }

  void set_faces() {
    for (Region& region : out_.table.regions) region.area = 0;
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      const TriMesh::FaceHandle face(static_cast<int>(t));
      out_.mesh.set_region(face, region_of(t));
      out_.mesh.set_material(face, static_cast<int>(soup_.material[t]));
      const auto [i, j, k] = soup_.triangles[t];
      const Point a = soup_.points[i], b = soup_.points[j], c = soup_.points[k];
      Region& region = out_.table.region(region_of(t));
      const Point middle = centroid(a, b, c);
      if (!region.inside && is_strictly_inside(a, b, c, middle)) region.inside = middle;
      region.area += doubled_area(a, b, c) / 2;
    }
  }

  /// Regions on the left and on the right of the edge from a to b.
  [[nodiscard]] SegmentSides sides_of(TriMesh::HalfedgeHandle h) const {
    const TriMesh& tri = out_.mesh.tri();
    const auto region = [&](TriMesh::HalfedgeHandle side) {
      const auto face = tri.face_handle(side);
      return face.is_valid() ? out_.mesh.region(face) : kVoid;
    };
    return {region(h), region(tri.opposite_halfedge_handle(h)), kNoInterface};
  }

  std::optional<Error> add_named_points() {
    for (const NamedPoint& point : stored_.points) {
      if (point.vertex.index() >= soup_.points.size())
        return wrong(fmt::format("the point '{}' is vertex {}, which is not there", point.name,
                                 point.vertex.value()));
      input_vertices_ = std::max(input_vertices_, point.vertex.index() + 1);
    }
    out_.pslg.named_points = stored_.points;
    return std::nullopt;
  }

  std::optional<Error> add_segments() {
    out_.table.interfaces = stored_.interfaces;
    for (Interface& line : out_.table.interfaces) {
      line.length = 0;
      line.segments.clear();
    }
    out_.pslg.names = stored_.names;
    const bool make_up = stored_.interfaces.empty();
    std::vector<std::array<std::uint32_t, 2>> ends;
    for (const StoredEdge& edge : stored_.edges) ends.push_back({edge.a, edge.b});
    const std::vector<std::uint32_t> half_edges =
        find_edges(soup_.points.size(), soup_.triangles, ends);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const StoredEdge& edge = stored_.edges[k];
      if (half_edges[k] == kNone) {
        return wrong(fmt::format("the line from vertex {} to vertex {} is no edge of the mesh",
                                 edge.a, edge.b));
      }
      if (make_up ? edge.interface != kNoInterface || edge.name >= stored_.names.size()
                  : edge.interface == kNoInterface ||
                        edge.interface.index() > stored_.interfaces.size()) {
        return wrong(fmt::format("there is no interface {}", edge.interface.value()));
      }
      add_segment(builder_.edge_of(half_edges[k]), edge.marker,
                  make_up ? kNoInterface : edge.interface, edge.name);
    }
    if (make_up) make_up_interfaces();
    return std::nullopt;
  }

  [[nodiscard]] bool is_edge(std::uint32_t a, std::uint32_t b) const {
    const std::size_t n = soup_.points.size();
    return a < n && b < n &&
           out_.mesh.tri()
               .find_halfedge(TriMesh::VertexHandle(static_cast<int>(a)),
                              TriMesh::VertexHandle(static_cast<int>(b)))
               .is_valid();
  }

  std::optional<Error> add_periodic() {
    for (const PeriodicNodes& nodes : stored_.periodic) {
      for (const auto& [a, b, a2, b2] : nodes.edges) {
        if (!is_edge(a, b) || !is_edge(a2, b2))
          return wrong(
              fmt::format("the periodic edges from vertex {} to {} and from {} to {} are "
                          "no edges of the mesh",
                          a, b, a2, b2));
      }
      for (const auto& pair : nodes.vertices) {
        if (std::max(pair[0], pair[1]) >= soup_.points.size())
          return wrong(fmt::format("the periodic vertices {} and {} are not both in the mesh",
                                   pair[0], pair[1]));
      }
    }
    out_.periodic = stored_.periodic;
    return std::nullopt;
  }

  std::optional<Error> add_arcs() {
    if (stored_.arcs.empty()) return std::nullopt;
    std::map<std::array<std::uint32_t, 2>, std::size_t> segment_of;
    for (std::size_t s = 0; s < out_.pslg.segments.size(); ++s) {
      const Segment& segment = out_.pslg.segments[s];
      const std::uint32_t a = segment.a.value(), b = segment.b.value();
      segment_of.emplace(std::array{std::min(a, b), std::max(a, b)}, s);
    }
    for (const StoredArc& arc : stored_.arcs) {
      const Point c = arc.circle.centre;
      if (!(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(arc.circle.radius) &&
            arc.circle.radius > 0))
        return wrong("an arc has no circle");
      out_.pslg.circles.push_back(arc.circle);
      for (const auto& [a, b] : arc.edges) {
        const auto found = segment_of.find({std::min(a, b), std::max(a, b)});
        if (found == segment_of.end())
          return wrong(fmt::format("the arc from vertex {} to vertex {} is on no line", a, b));
        out_.pslg.segments[found->second].circle =
            static_cast<std::uint32_t>(out_.pslg.circles.size());
      }
    }
    return std::nullopt;
  }

  std::optional<Error> add_nodes() {
    if (!stored_.second_order) return std::nullopt;
    for (const auto& [a, b, middle] : stored_.nodes) {
      if (!is_edge(a, b))
        return wrong(fmt::format("the node between vertices {} and {} is on no edge", a, b));
      if (!std::isfinite(middle.x) || !std::isfinite(middle.y))
        return wrong(fmt::format("the node between vertices {} and {} is nowhere", a, b));
    }
    out_.nodes = stored_.nodes;
    return std::nullopt;
  }

  std::optional<Error> add_arrays() {
    for (const Attribute& attribute : stored_.attributes) {
      const auto words = static_cast<double>(attribute.words.size());
      if (attribute.values.size() != out_.table.regions.size())
        return wrong(
            fmt::format("the attribute '{}' has not one value per region", attribute.name));
      if (attribute.is_text &&
          !std::all_of(attribute.values.begin(), attribute.values.end(), [&](double value) {
            return value >= 0 && value <= words && value == std::floor(value);
          }))
        return wrong(fmt::format("the attribute '{}' has a word too few", attribute.name));
    }
    for (const PlaneField::Array& field : stored_.fields) {
      if (field.values.size() != soup_.points.size())
        return wrong(fmt::format("the field '{}' has not one value per point", field.name));
    }
    if (std::optional<Error> error = check_region_values()) return error;
    out_.table.attributes = stored_.attributes;
    out_.fields = stored_.fields;
    out_.region_values = stored_.region_values;
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Error> check_region_values() const {
    const auto is_there = [&](const RegionValue& one) {
      return one.vertex < soup_.points.size() && one.region != kVoid &&
             one.region.index() <= out_.table.regions.size();
    };
    const auto is_not_before = [](const RegionValue& a, const RegionValue& b) {
      return !(a.place() < b.place());
    };
    if (stored_.region_values.size() > stored_.fields.size())
      return wrong("regions have values of fields that are not there");
    for (const std::vector<RegionValue>& values : stored_.region_values) {
      if (!std::all_of(values.begin(), values.end(), is_there) ||
          std::adjacent_find(values.begin(), values.end(), is_not_before) != values.end())
        return wrong("values of regions at vertices are in no order, or not in the mesh");
    }
    return std::nullopt;
  }

  void make_up_interfaces() {
    std::vector<bool> known(out_.mesh.tri().n_edges());
    for (const auto edge : segment_edge_) known[static_cast<std::size_t>(edge.idx())] = true;
    for (const auto edge : out_.mesh.tri().edges()) {
      const SegmentSides sides = sides_of(out_.mesh.tri().halfedge_handle(edge, 0));
      if (sides.left != sides.right && !known[static_cast<std::size_t>(edge.idx())])
        add_segment(edge, 0, kNoInterface, 0);
    }
    take_points();
    build_interfaces(out_.pslg, out_.table);
    for (std::size_t s = 0; s < segment_edge_.size(); ++s) {
      out_.mesh.set_interface(segment_edge_[s], out_.table.sides[s].interface);
    }
  }

  void add_segment(TriMesh::EdgeHandle edge, int marker, InterfaceId interface,
                   std::uint32_t name) {
    const TriMesh& tri = out_.mesh.tri();
    const auto h = tri.halfedge_handle(edge, 0);
    const VertexId a(tri.from_vertex_handle(h).idx()), b(tri.to_vertex_handle(h).idx());
    input_vertices_ = std::max({input_vertices_, a.index() + 1, b.index() + 1});
    segment_edge_.push_back(edge);
    out_.mesh.set_marker(edge, marker);
    out_.mesh.set_interface(edge, interface);
    SegmentSides sides = sides_of(h);
    sides.interface = interface;
    out_.table.sides.push_back(sides);
    if (interface != kNoInterface) {
      Interface& line = out_.table.interface(interface);
      line.segments.emplace_back(out_.pslg.segments.size());
      line.length += length(soup_.points[b.index()] - soup_.points[a.index()]);
      if (line.kind == InterfaceKind::contact) name = name_index(line.name);
    }
    out_.pslg.segments.push_back({a, b, marker, name});
  }

  std::uint32_t name_index(const std::string& name) {
    auto& names = out_.pslg.names;
    const auto known = std::find(names.begin() + 1, names.end(), name);
    const auto index = static_cast<std::uint32_t>(known - names.begin());
    if (known == names.end()) names.push_back(name);
    return index;
  }

  /// The points of the PSLG: the first vertices, up to the last one that a segment needs.
  void take_points() {
    const auto n = static_cast<std::ptrdiff_t>(std::max(input_vertices_, stored_.input_vertices));
    out_.pslg.points.assign(soup_.points.begin(), soup_.points.begin() + n);
    out_.pslg.point_markers.assign(out_.pslg.points.size(), 0);
    // The last of these were put on segments.
    const auto cuts = static_cast<std::ptrdiff_t>(stored_.cut_vertices);
    for (std::ptrdiff_t v = 0; v < n; ++v)
      out_.pslg.point_ids.push_back(v < n - cuts ? static_cast<long>(v) : -1);
  }

  void set_vertices() {
    if (out_.pslg.points.empty()) take_points();
    const std::size_t n = out_.pslg.points.size();
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      out_.mesh.set_input_id(TriMesh::VertexHandle(static_cast<int>(v)),
                             v < n ? static_cast<long>(v) : -1);
    }
    const std::size_t segments = out_.pslg.segments.size();
    out_.report.input_points = n - std::min(stored_.cut_vertices, n);
    out_.report.input_segments = segments - std::min(stored_.cut_vertices, segments);
    out_.report.steiner_vertices = soup_.points.size() - n;
  }

  const StoredMesh& stored_;
  const TriangleSoup& soup_;
  MeshBuilder builder_;
  std::size_t input_vertices_ = 0;                 ///< at least so many
  std::vector<TriMesh::EdgeHandle> segment_edge_;  ///< by SegmentId
  Output out_;
};

}  // namespace

Result<Output> rebuild(const StoredMesh& stored) {
  return memory_as_value("rebuild", [&]() -> Result<Output> {
    if (std::optional<Error> error = Rebuilder::check(stored)) return *std::move(error);
    return Rebuilder(stored).run();
  });
}

}  // namespace cover
