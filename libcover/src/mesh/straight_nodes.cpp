// A node that is off the middle by d puts the control point of its edge off by 2 d. Across the edge
// that changes the Jacobian by as much as all that a sliver has; along the edge it changes nearly
// nothing. So the doubles around a middle are tried, and along long edges more of them: some lie
// nearer to the edge than the one next to its middle.
// Tested by tests/unit/mesh/straight_nodes_test.cpp.
#include "mesh/straight_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "base/numbers.hpp"
#include "geom/curves/arc.hpp"
#include "geom/double_double.hpp"
#include "geom/topology/corner.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

using Face = TriMesh::FaceHandle;
using Halfedge = TriMesh::HalfedgeHandle;

/// A triangle is valid with nodes next to the middles if its doubled area is more than so many
/// times its longest step times the spacing of doubles there: rounding moves control points by one
/// spacing at most, and thus each coefficient of the Jacobian by less than ten such products.
constexpr double kSurelyValid = 64;
constexpr double kLeastProduct = 0x1p-900;  ///< smaller ones may have lost digits
constexpr int kAlong = 16;                  ///< spacings on either side of a middle
constexpr double kShort = 64;               ///< times these: a shorter edge has no room for them
constexpr std::size_t kEachSide = 6;        ///< places of an edge, on the left and on the right
constexpr std::size_t kChoices = 1500;      ///< of places for a triangle
constexpr std::size_t kVisitsOfEach = 50;   ///< of each triangle that is not valid at first
constexpr std::size_t kPatience = 200;      ///< tries after which triangles should be fewer

/// How far p is on the left of the line from a to b, times the length of that.
double left_of_line(Point a, Point b, Point p) {
  const auto to = [](double x, double from) { return two_difference(x, from); };
  return (to(b.x, a.x) * to(p.y, a.y) - to(b.y, a.y) * to(p.x, a.x)).high;
}

/// Doubles near the middle of an edge; first `middle`, then by how much they are off.
std::vector<Point> places_near(Point a, Point b, Point middle) {
  const bool is_steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  const auto turned = [is_steep](Point p) { return is_steep ? Point{p.y, p.x} : p; };
  const Point from = turned(a), to = turned(b), m = turned(middle);
  const double spacing = spacing_at(m.x), along = to.x - from.x;
  const int reach = std::abs(along) > kShort * kAlong * spacing ? kAlong : 1;
  const double slope = along != 0 ? (to.y - from.y) / along : 0;
  std::array<std::vector<std::pair<double, Point>>, 2> sides;
  for (int k = -reach; k <= reach; ++k) {
    const double x = m.x + k * spacing;
    // Where the edge is there, up to two spacings.
    const double y = m.y + (x - m.x) * slope;
    double at = std::nextafter(std::nextafter(y, -kInfinity), -kInfinity);
    for (int i = 0; i < 5; ++i, at = std::nextafter(at, kInfinity)) {
      const Point p = turned({x, at});
      const double off = left_of_line(a, b, p) / length(b - a);
      if (!std::isfinite(off)) continue;  // of subnormal numbers
      sides[off < 0 ? 1 : 0].emplace_back(std::abs(off) + std::abs(x - m.x) / kShort, p);
    }
  }
  std::vector<std::pair<double, Point>> best;
  for (auto& side : sides) {
    std::sort(side.begin(), side.end());
    side.resize(std::min(side.size(), kEachSide));
    best.insert(best.end(), side.begin(), side.end());
  }
  std::sort(best.begin(), best.end());
  std::vector<Point> places{middle};
  for (const auto& [off, p] : best) {
    if (p != middle) places.push_back(p);
  }
  return places;
}

class Nodes {
 public:
  Nodes(const TriMesh& mesh, const std::function<Point(std::size_t)>& node_of,
        const std::function<bool(std::size_t)>& may_move)
      : mesh_(mesh), node_of_(node_of), may_move_(may_move) {}

  StraightNodes run() {
    for (const Face f : mesh_.faces()) {
      if (!is_surely_valid(f) && !is_valid(f)) bad_.insert(f);
    }
    Face last;
    std::size_t fewest = bad_.size(), in_vain = 0, left = kPatience + kVisitsOfEach * bad_.size();
    for (std::size_t waited = 0; !bad_.empty() && in_vain < bad_.size() && left > 0; ++waited) {
      --left;
      if (bad_.size() < fewest) fewest = bad_.size(), waited = 0;
      if (waited > kPatience + 2 * bad_.size()) break;
      const auto next = bad_.upper_bound(last);
      last = next != bad_.end() ? *next : *bad_.begin();
      in_vain = mend(last) ? 0 : in_vain + 1;
    }
    std::erase_if(chosen_, [&](const auto& node) { return node.second == node_of_(node.first); });
    return {std::move(chosen_), {bad_.begin(), bad_.end()}};
  }

 private:
  static std::size_t edge_of(Halfedge h) {
    return static_cast<std::size_t>(TriMesh::s_edge_handle(h).idx());
  }
  [[nodiscard]] Point at(TriMesh::VertexHandle v) const {
    return {mesh_.point(v)[0], mesh_.point(v)[1]};
  }
  [[nodiscard]] std::array<Halfedge, 3> halves_of(Face f) const {
    const Halfedge first = mesh_.halfedge_handle(f), second = mesh_.next_halfedge_handle(first);
    return {first, second, mesh_.next_halfedge_handle(second)};
  }
  [[nodiscard]] Point node(std::size_t edge) const {
    const auto chosen = chosen_.find(edge);
    return chosen != chosen_.end() ? chosen->second : node_of_(edge);
  }

  [[nodiscard]] bool is_surely_valid(Face f) const {
    std::array<Point, 3> corner;
    const std::array halves = halves_of(f);
    for (const Corner i : kCorners) {
      if (!may_move_(edge_of(halves[i]))) return false;
      corner[i] = at(mesh_.from_vertex_handle(halves[i]));
    }
    const Vector u = corner[1] - corner[0], v = corner[2] - corner[0];
    const double step = std::max({std::abs(u.x), std::abs(u.y), std::abs(v.x), std::abs(v.y)});
    return cross(u, v) > kSurelyValid * spacing_of(corner) * step + kLeastProduct;
  }

  [[nodiscard]] bool is_valid(Face f) const {
    CurvedTriangle triangle;
    const std::array halves = halves_of(f);
    for (const Corner i : kCorners) {
      triangle[i] = at(mesh_.from_vertex_handle(halves[i]));
      triangle[3 + i] = node(edge_of(halves[i]));
    }
    return has_positive_jacobian(triangle);
  }

  /// Places for the nodes of a triangle, by what they are off in all; indices into `places`.
  static std::vector<std::array<std::size_t, 3>> choices_of(
      const std::array<std::vector<Point>, 3>& places) {
    std::vector<std::array<std::size_t, 3>> choices;
    for (std::size_t i = 0; i < places[0].size(); ++i) {
      for (std::size_t j = 0; j < places[1].size(); ++j) {
        for (std::size_t k = 0; k < places[2].size(); ++k) choices.push_back({i, j, k});
      }
    }
    std::stable_sort(choices.begin(), choices.end(), [](const auto& a, const auto& b) {
      return a[0] + a[1] + a[2] < b[0] + b[1] + b[2];
    });
    choices.resize(std::min(choices.size(), kChoices));
    return choices;
  }

  /// Makes a triangle valid. Another one beside it may become invalid in its place if there is no
  /// other way: the one that has been looked at least often.
  bool mend(Face f) {
    const std::array halves = halves_of(f);
    std::array<std::vector<Point>, 3> places;
    std::array<Point, 3> before;
    std::array<Face, 3> beside;
    for (const Corner i : kCorners) {
      const std::size_t edge = edge_of(halves[i]);
      before[i] = node(edge);
      beside[i] = mesh_.face_handle(mesh_.opposite_halfedge_handle(halves[i]));
      places[i] = may_move_(edge)
                      ? places_near(at(mesh_.from_vertex_handle(halves[i])),
                                    at(mesh_.to_vertex_handle(halves[i])), node_of_(edge))
                      : std::vector{before[i]};
    }
    const auto take = [&](const std::array<Point, 3>& nodes) {
      for (const Corner i : kCorners) {
        if (nodes[i] != node(edge_of(halves[i]))) chosen_[edge_of(halves[i])] = nodes[i];
      }
    };
    ++visits_[f];
    std::optional<std::array<Point, 3>> second_best;
    std::size_t least = 0;
    for (const auto& choice : choices_of(places)) {
      take({places[0][choice[0]], places[1][choice[1]], places[2][choice[2]]});
      if (!is_valid(f)) continue;
      std::vector<Face> worse;
      for (const Face g : beside) {
        if (g.is_valid() && bad_.count(g) == 0 && !is_valid(g)) worse.push_back(g);
      }
      if (worse.empty()) return settle(f, beside);
      if (worse.size() == 1 && (!second_best || visits_[worse[0]] < least)) {
        second_best = {places[0][choice[0]], places[1][choice[1]], places[2][choice[2]]};
        least = visits_[worse[0]];
      }
    }
    take(second_best.value_or(before));
    return second_best && settle(f, beside);
  }

  /// After nodes of `f` have moved.
  bool settle(Face f, const std::array<Face, 3>& beside) {
    bad_.erase(f);
    for (const Face g : beside) {
      if (!g.is_valid()) continue;
      if (is_valid(g)) {
        bad_.erase(g);
      } else {
        bad_.insert(g);
      }
    }
    return true;
  }

  const TriMesh& mesh_;
  const std::function<Point(std::size_t)>& node_of_;
  const std::function<bool(std::size_t)>& may_move_;
  std::set<Face> bad_;  ///< triangles that are not valid
  std::map<std::size_t, Point> chosen_;
  std::map<Face, std::size_t> visits_;
};

}  // namespace

StraightNodes valid_straight_nodes(const TriMesh& mesh,
                                   const std::function<Point(std::size_t)>& node_of,
                                   const std::function<bool(std::size_t)>& may_move) {
  return Nodes(mesh, node_of, may_move).run();
}

}  // namespace cover
