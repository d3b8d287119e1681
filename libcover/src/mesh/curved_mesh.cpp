// Straight triangles are valid. Where one is not with the arc beside it, the nodes of edges around
// follow the arc: each by what the near segments do beside it (an arc bulges, a straight segment
// stays), the less the farther away. That is tried with patches and reaches of several sizes; where
// none will do, edges on arcs of what is not proven are made straight, and all is tried again,
// until everything is proven. Straightening alone ends with straight triangles, so there is an end.
// Last come the nodes of straight edges that rounding has moved too far (mesh/straight_nodes).
// Tested by tests/unit/mesh/curved_mesh_test.cpp.
#include <cover/curved_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <cover/mesh.hpp>

#include "base/containers/order.hpp"
#include "base/none.hpp"
#include "geom/curves/arc.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "mesh/straight_nodes.hpp"

namespace cover {
namespace {

constexpr std::array kRings{1, 2, 4, 8, 16};  ///< of triangles around what is not proven
/// How far an arc reaches, in lengths of its chord, and the share of it that is followed.
constexpr std::array<std::array<double, 2>, 8> kFollowed{
    {{0.5, 1}, {1, 1}, {2, 1}, {1e3, 1}, {1, 0.5}, {1e3, 0.5}, {0.5, 0.25}, {1e3, 1.5}}};
constexpr std::size_t kLargestPatch = 2000;  ///< triangles
constexpr int kRounds = 40;                  ///< after which arcs are straightened only

class Curving {
 public:
  explicit Curving(const Output& output)
      : output_(output),
        tri_(output.mesh.tri()),
        number_(tri_.n_edges(), kNone),
        is_segment_(tri_.n_edges(), false) {}

  CurvedMesh run() {
    find_edges();
    if (halfedges_.empty()) take_nodes_of_file();
    make_valid();
    take_straight_nodes();
    add_areas();
    for (const auto& [edge, middle] : moved_) curved_.moved.push_back(moved_node(edge, middle));
    return std::move(curved_);
  }

 private:
  using Halfedge = TriMesh::HalfedgeHandle;
  using Face = TriMesh::FaceHandle;

  /// A segment beside a patch, and by how much its middle is off its chord.
  struct Wall {
    Point a, b;
    Vector bulge{0, 0};
  };
  /// Triangles around what is not proven; the edges between them may be curved.
  struct Patch {
    std::vector<Face> faces;
    std::vector<Wall> walls;
    std::vector<std::size_t> free;  ///< edges
  };

  [[nodiscard]] Point at(TriMesh::VertexHandle v) const {
    const TriMesh::Point& p = tri_.point(v);
    return {p[0], p[1]};
  }

  void find_edges() {
    const Pslg& pslg = output_.pslg;
    if (pslg.circles.empty()) return;
    std::vector<TriMesh::VertexHandle> vertex(pslg.points.size());
    for (const auto v : tri_.vertices()) {
      const long point = output_.mesh.input_id(v);
      if (point >= 0) vertex[static_cast<std::size_t>(point)] = v;
    }
    for (const Segment& s : pslg.segments) {
      const auto a = vertex[s.a.index()], b = vertex[s.b.index()];
      if (!a.is_valid() || !b.is_valid()) continue;  // it touches no region
      const Halfedge h = tri_.find_halfedge(a, b);
      if (!h.is_valid()) continue;
      is_segment_[index_of(h)] = true;
      const ArcCircle* circle = circle_of(pslg, s);
      if (circle == nullptr) continue;
      number_[index_of(h)] = static_cast<std::uint32_t>(curved_.edges.size());
      halfedges_.push_back(h);
      curved_.edges.push_back({static_cast<std::uint32_t>(a.idx()),
                               static_cast<std::uint32_t>(b.idx()), s.circle - 1,
                               ArcOver(*circle, at(a), at(b)).middle(), false});
    }
  }

  /// As they are: what a file says is not mended.
  void take_nodes_of_file() {
    if (!output_.nodes) return;
    for (const MovedNode& node : *output_.nodes) {
      const Halfedge h = tri_.find_halfedge(TriMesh::VertexHandle(static_cast<int>(node.a)),
                                            TriMesh::VertexHandle(static_cast<int>(node.b)));
      if (h.is_valid()) moved_[index_of(h)] = node.middle;
    }
  }

  static std::size_t index_of(Halfedge h) {
    return static_cast<std::size_t>(TriMesh::s_edge_handle(h).idx());
  }
  static Halfedge first_half(std::size_t edge) {
    return TriMesh::s_halfedge_handle(TriMesh::EdgeHandle(static_cast<int>(edge)), 0);
  }

  [[nodiscard]] std::array<Halfedge, 3> halves_of(Face f) const {
    const Halfedge first = tri_.halfedge_handle(f), second = tri_.next_halfedge_handle(first);
    return {first, second, tri_.next_halfedge_handle(second)};
  }

  /// The node of an edge.
  [[nodiscard]] Point middle_of(Halfedge h) const {
    const std::uint32_t k = number_[index_of(h)];
    if (k != kNone) return curved_.edges[k].middle;
    const auto moved = moved_.find(index_of(h));
    return moved != moved_.end() ? moved->second : straight_middle(h);
  }

  /// As files have it: from the end of the edge's first half.
  [[nodiscard]] Point straight_middle(Halfedge h) const {
    const Halfedge first = first_half(index_of(h));
    return midpoint(at(tri_.from_vertex_handle(first)), at(tri_.to_vertex_handle(first)));
  }

  /// As it is written, and thus as the proof must have it.
  [[nodiscard]] bool is_proven(Face f) const {
    CurvedTriangle corners;
    const std::array halves = halves_of(f);
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = at(tri_.from_vertex_handle(halves[i]));
      corners[3 + i] = middle_of(halves[i]);
    }
    return has_positive_jacobian(corners);
  }

  void make_valid() {
    std::vector<Face> touched;
    for (const Halfedge h : halfedges_) add_faces(h, touched);
    for (int round = 0; !touched.empty(); ++round) {
      const std::vector<Face> bad = unproven(std::move(touched));
      touched.clear();
      if (round == kRounds) {
        for (const auto& [edge, middle] : moved_) add_faces(first_half(edge), touched);
        moved_.clear();
      }
      std::set<Face> done;
      for (const Face f : bad) {
        if (done.count(f) != 0) continue;
        if (round < kRounds) {
          mend(cluster_of(f, bad, done), touched);
        } else {
          straighten(f, touched);
        }
      }
    }
  }

  void add_faces(Halfedge h, std::vector<Face>& faces) const {
    for (const Halfedge side : {h, tri_.opposite_halfedge_handle(h)}) {
      if (tri_.face_handle(side).is_valid()) faces.push_back(tri_.face_handle(side));
    }
  }

  /// Each once, ascending.
  [[nodiscard]] std::vector<Face> unproven(std::vector<Face> faces) const {
    sort_unique(faces);
    std::erase_if(faces, [&](Face f) { return is_proven(f); });
    return faces;
  }

  /// The face beyond an edge that is no segment.
  [[nodiscard]] std::optional<Face> beyond(Halfedge h) const {
    const Face f = tri_.face_handle(tri_.opposite_halfedge_handle(h));
    if (is_segment_[index_of(h)] || !f.is_valid()) return std::nullopt;
    return f;
  }

  /// The unproven triangles that hang together with `f` over triangles between them; they are done.
  [[nodiscard]] std::vector<Face> cluster_of(Face f, const std::vector<Face>& bad,
                                             std::set<Face>& done) const {
    std::vector<Face> cluster{f};
    done.insert(f);
    for (std::size_t k = 0; k < cluster.size() && cluster.size() < kLargestPatch; ++k) {
      for (const Face near : around({cluster[k]}, 2)) {
        if (std::binary_search(bad.begin(), bad.end(), near) && done.insert(near).second)
          cluster.push_back(near);
      }
    }
    return cluster;
  }

  /// The triangles within so many steps over edges that are no segments.
  [[nodiscard]] std::vector<Face> around(std::vector<Face> faces, int rings) const {
    std::set<Face> seen(faces.begin(), faces.end());
    std::size_t first = 0;
    for (int ring = 0; ring < rings; ++ring) {
      const std::size_t last = faces.size();
      for (; first < last; ++first) {
        for (const Halfedge h : halves_of(faces[first])) {
          const auto next = beyond(h);
          if (next && seen.insert(*next).second) faces.push_back(*next);
        }
      }
    }
    return faces;
  }

  [[nodiscard]] Patch patch_of(const std::vector<Face>& cluster, int rings) const {
    Patch patch;
    patch.faces = around(cluster, rings);
    std::vector<std::size_t> inner;
    for (const Face f : patch.faces) {
      for (const Halfedge h : halves_of(f)) {
        if (is_segment_[index_of(h)]) {
          const std::uint32_t k = number_[index_of(h)];
          Wall wall{at(tri_.from_vertex_handle(h)), at(tri_.to_vertex_handle(h))};
          if (k != kNone && !curved_.edges[k].is_straight)
            wall.bulge = curved_.edges[k].middle - midpoint(wall.a, wall.b);
          patch.walls.push_back(wall);
        } else {
          inner.push_back(index_of(h));
        }
      }
    }
    std::sort(inner.begin(), inner.end());
    for (std::size_t k = 1; k < inner.size(); ++k) {
      if (inner[k - 1] == inner[k]) patch.free.push_back(inner[k]);
    }
    return patch;
  }

  /// How far a place follows the walls around it, each of which reaches so many of its lengths.
  [[nodiscard]] static Vector followed(const std::vector<Wall>& walls, Point p, double reach) {
    Vector sum{0, 0};
    double weights = 0;
    for (const Wall& wall : walls) {
      const Vector chord = wall.b - wall.a;
      const double share = part_on_segment(wall.a, wall.b, p);
      const double away = length(p - (wall.a + share * chord));
      if (away == 0) return {0, 0};  // an end of it: a short edge there stays
      const double weight = 1 / (away * away);
      const double fading = std::max(0.0, 1 - away / (reach * length(chord)));
      sum = sum + (4 * share * (1 - share) * fading * weight) * wall.bulge;
      weights += weight;
    }
    return weights > 0 ? (1 / weights) * sum : Vector{0, 0};
  }

  /// Moves the nodes between triangles of a patch by this share of what they follow.
  void move_nodes(const Patch& patch, double reach, double share) {
    for (const std::size_t edge : patch.free) {
      const Halfedge h = first_half(edge);
      const Point middle = straight_middle(h);
      const Point a = at(tri_.from_vertex_handle(h)), b = at(tri_.to_vertex_handle(h));
      const auto of = [&](Point p) { return followed(patch.walls, p, reach); };
      const Vector by = share * (of(middle) - 0.5 * (of(a) + of(b)));  // vertices stay
      moved_.erase(edge);
      if (const Point p = middle + by; p != middle) moved_[edge] = p;
    }
  }

  /// Moves nodes around a cluster until it is proven; else makes arcs straight where it is not.
  void mend(const std::vector<Face>& cluster, std::vector<Face>& touched) {
    std::vector<Face> fewest = cluster;
    for (const int rings : kRings) {
      const Patch patch = patch_of(cluster, rings);
      if (patch.faces.size() > kLargestPatch) break;
      std::vector<std::pair<std::size_t, Point>> before;
      for (const std::size_t edge : patch.free) {
        const auto moved = moved_.find(edge);
        if (moved != moved_.end()) before.emplace_back(*moved);
      }
      for (const auto& [reach, share] : kFollowed) {
        move_nodes(patch, reach, share);
        std::vector<Face> bad = unproven(patch.faces);
        if (bad.empty()) return;
        if (bad.size() < fewest.size()) fewest = std::move(bad);
      }
      for (const std::size_t edge : patch.free) moved_.erase(edge);
      moved_.insert(before.begin(), before.end());
    }
    const std::size_t count = touched.size();
    for (const Face f : fewest) straighten(f, touched);
    if (touched.size() == count) {
      for (const Face f : cluster) straighten(f, touched);
    }
    touched.insert(touched.end(), cluster.begin(), cluster.end());
  }

  /// Makes the edges of a triangle straight.
  void straighten(Face f, std::vector<Face>& touched) {
    for (const Halfedge h : halves_of(f)) {
      const std::uint32_t edge = number_[index_of(h)];
      if (edge == kNone) {
        if (moved_.erase(index_of(h)) > 0) add_faces(h, touched);
      } else if (!curved_.edges[edge].is_straight) {
        curved_.edges[edge].is_straight = true;
        curved_.edges[edge].middle = straight_middle(h);
        add_faces(h, touched);
      }
    }
  }

  [[nodiscard]] MovedNode moved_node(std::size_t edge, Point middle) const {
    const Halfedge h = first_half(edge);
    return {static_cast<std::uint32_t>(tri_.from_vertex_handle(h).idx()),
            static_cast<std::uint32_t>(tri_.to_vertex_handle(h).idx()), middle};
  }

  /// What follows no arc may still be rounded to where a triangle is not valid.
  void take_straight_nodes() {
    const auto may_move = [this](std::size_t edge) {
      const std::uint32_t k = number_[edge];
      return k != kNone ? curved_.edges[k].is_straight : moved_.count(edge) == 0;
    };
    const StraightNodes straight = valid_straight_nodes(
        tri_, [this](std::size_t edge) { return middle_of(first_half(edge)); }, may_move);
    for (const auto& [edge, node] : straight.nodes) {
      if (number_[edge] != kNone) {
        curved_.edges[number_[edge]].middle = node;
      } else {
        curved_.rounded.push_back(moved_node(edge, node));
      }
    }
    for (const Face f : straight.not_mended)
      curved_.not_valid.push_back(static_cast<std::uint32_t>(f.idx()));
  }

  void add_areas() {
    for (const Region& region : output_.table.regions) curved_.areas.push_back(region.area);
    for (std::size_t k = 0; k < halfedges_.size(); ++k) {
      if (!curved_.edges[k].is_straight) add_areas_beside(halfedges_[k], curved_.edges[k].middle);
    }
    for (const auto& [edge, middle] : moved_) {
      const Halfedge h = first_half(edge);
      if (region_beside(h) != region_beside(tri_.opposite_halfedge_handle(h)))
        add_areas_beside(h, middle);
    }
  }

  [[nodiscard]] RegionId region_beside(Halfedge h) const {
    const Face f = tri_.face_handle(h);
    return f.is_valid() ? output_.mesh.region(f) : kVoid;
  }

  void add_areas_beside(Halfedge edge, Point middle) {
    for (const Halfedge h : {edge, tri_.opposite_halfedge_handle(edge)}) {
      if (region_beside(h) == kVoid) continue;
      curved_.areas[place_of(region_beside(h))] +=
          area_beside_chord(at(tri_.from_vertex_handle(h)), at(tri_.to_vertex_handle(h)), middle);
    }
  }

  const Output& output_;
  const TriMesh& tri_;
  std::vector<std::uint32_t> number_;   ///< by edge of the mesh: in curved_.edges, or kNone
  std::vector<bool> is_segment_;        ///< by edge of the mesh
  std::vector<Halfedge> halfedges_;     ///< by curved edge, from a to b
  std::map<std::size_t, Point> moved_;  ///< nodes, by edge of the mesh
  CurvedMesh curved_;
};

}  // namespace

CurvedMesh curved_mesh(const Output& output) { return Curving(output).run(); }

}  // namespace cover
