// From every end of a wall, a segment seen from the void, we look for the nearest wall of another
// polygon in front of it. Where that is near, there is a station, and a second one at the foot on
// the other wall. A stretch of a wall between two stations that face the same polygon is a part of
// a gap.
#include "region/gaps/open_gaps.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

#include "base/containers/union_find.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "region/gaps/wall_behind.hpp"

namespace cover {
namespace {

/// A gap is narrow up to this part of the width of what is beside it. Slots and tracks are wider:
/// 5 m in fields of 1 km are 1 : 100, a slot of 0.2 mm between planes of 5 cm is 1 : 165.
constexpr double kNarrow = 1.0 / 200;

/// A gap is long from this part of the width of what is beside it on. Round things that nearly
/// touch are narrowly apart, as above, for 2 * sqrt(kNarrow) of it.
constexpr double kLong = 0.5;

/// Walls that meet at an angle with no more than this tangent make a gap from there on: as thin as
/// other voids that are told.
constexpr double kWedge = 0.064;

/// What is in front of a wall is within 45 degrees of its normal.
constexpr double kInFront = 0.7;

/// A segment seen from the void, which is on its left.
struct Wall {
  EdgeRef edge;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t face = 0;  ///< what is on its right
};

/// A place on a wall that is near another polygon.
struct Station {
  std::uint32_t wall = 0;
  double part = 0;  ///< of the wall, from a
  double width = 0;
  std::uint32_t point = 0;  ///< at one end of the shortest way across
  std::uint32_t other = 0;  ///< at the other end, if that is a point; else the same
  std::uint32_t face = 0;   ///< what is on the other side
  bool is_tip = false;      ///< the walls meet here

  friend bool operator<(const Station& s, const Station& t) {
    return std::tie(s.wall, s.part, s.width, s.point, s.other, s.face) <
           std::tie(t.wall, t.part, t.width, t.point, t.other, t.face);
  }
};

/// A part of a wall that faces another polygon nearby.
struct Stretch {
  std::uint32_t point = 0;  ///< of a station at its end
  double length = 0;
  double width = 0;
  double per_beside = 0;  ///< one by the mean width of the polygons
  Point where;
  std::uint32_t face = 0;  ///< the void
};

class OpenGaps {
 public:
  OpenGaps(const Faces& faces, const FacesBeside& beside)
      : faces_(faces), beside_(beside), points_(faces.triangulation.points) {}

  std::vector<OpenGap> find() {
    add_walls();
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
      if (owner(walls_[w].face) == 0) continue;
      look(w, true);
      look(w, false);
    }
    std::sort(stations_.begin(), stations_.end());
    UnionFind joined(points_.size());
    std::vector<Stretch> stretches;
    for (std::size_t k = 0; k + 1 < stations_.size(); ++k)
      add_stretch(stations_[k], stations_[k + 1], joined, stretches);
    return gaps(stretches, joined);
  }

 private:
  [[nodiscard]] Point at(std::uint32_t p) const { return points_[p]; }
  [[nodiscard]] std::uint32_t owner(std::uint32_t face) const { return beside_.owner[face]; }
  [[nodiscard]] const Triangle& triangle(std::uint32_t t) const {
    return faces_.triangulation.triangles[t];
  }
  /// One by the mean width of two faces, the harmonic one: the thinner counts.
  [[nodiscard]] double per_width(std::uint32_t f, std::uint32_t g) const {
    return (1 / beside_.width[f] + 1 / beside_.width[g]) / 2;
  }

  void add_walls() {
    polygons_at_.resize(points_.size());
    for (std::uint32_t t = 0; t < faces_.of_triangle.size(); ++t) {
      if (!beside_.is_looked_at[faces_.of_triangle[t]]) continue;
      const Triangle& f = triangle(t);
      for (const Corner i : kCorners) {
        if (!f.is_locked(i)) continue;
        const std::uint32_t behind = f.n[i] == kNone ? kOutside : faces_.of_triangle[f.n[i]];
        walls_.push_back({{t, i}, f.v[i.next()], f.v[i.previous()], behind});
        for (const std::uint32_t v : {f.v[i.next()], f.v[i.previous()]}) add_polygon(v, behind);
      }
    }
  }

  /// Remembers faces of two polygons at a point.
  void add_polygon(std::uint32_t v, std::uint32_t face) {
    if (owner(face) == 0) return;
    auto& [first, second] = polygons_at_[v];
    if (first == 0) {
      first = face;
    } else if (second == 0 && owner(first) != owner(face)) {
      second = face;
    }
  }

  [[nodiscard]] std::optional<std::uint32_t> wall_at(EdgeRef edge) const {
    const auto key = [](EdgeRef e) {
      return std::pair<std::uint32_t, std::uint32_t>(e.triangle, e.edge);
    };
    const auto found =
        std::lower_bound(walls_.begin(), walls_.end(), edge,
                         [&](const Wall& w, EdgeRef e) { return key(w.edge) < key(e); });
    if (found == walls_.end() || key(found->edge) != key(edge)) return std::nullopt;
    return static_cast<std::uint32_t>(found - walls_.begin());
  }

  /// Looks from an end of a wall, b or a, through the triangles of the void there.
  void look(std::uint32_t w, bool from_b) {
    const Wall& wall = walls_[w];
    const std::uint32_t q = from_b ? wall.b : wall.a;
    Station best{w, from_b ? 1.0 : 0.0, reach_of(wall.face), q, q, 0, false};
    std::optional<Station> foot;
    EdgeRef entered = wall.edge;
    for (;;) {
      const Triangle& f = triangle(entered.triangle);
      const Corner here = f.corner_of(q);
      look_across(wall, q, {entered.triangle, here}, best, foot);
      // The other edge at q: the third one.
      const Corner out = here.next() == entered.edge ? here.previous() : here.next();
      const std::uint32_t next = f.n[out];
      if (f.is_locked(out)) {
        if (is_tip(wall, q, {entered.triangle, out}, best)) foot.reset();
        break;
      }
      if (next == kNone) break;
      entered = {next, triangle(next).edge_to(entered.triangle)};
    }
    if (best.face == 0 || best.width * per_width(wall.face, best.face) > kNarrow) return;
    stations_.push_back(best);
    if (foot) stations_.push_back(*foot);
  }

  /// What is farther away is in no narrow gap, however wide the other polygon is.
  [[nodiscard]] double reach_of(std::uint32_t face) const {
    return 2 * kNarrow * beside_.width[face];
  }

  /// Looks from q across the edge opposite to it.
  void look_across(const Wall& wall, std::uint32_t q, EdgeRef edge, Station& best,
                   std::optional<Station>& foot) const {
    const Triangle& f = triangle(edge.triangle);
    if (!f.is_locked(edge.edge)) {
      const std::uint32_t u = f.v[edge.edge.next()], v = f.v[edge.edge.previous()];
      for (const std::uint32_t end : {u, v}) {
        for (const std::uint32_t face : polygons_at_[end])
          if (take(wall, at(end), face, end, best)) foot.reset();
      }
      if (distance_to_line(at(q), at(u), at(v)) >= best.width) return;
    }
    const std::optional<EdgeRef> behind = wall_behind(faces_.triangulation, q, edge, best.width);
    const std::optional<std::uint32_t> g = behind ? wall_at(*behind) : std::nullopt;
    if (!g) return;
    const Wall& across = walls_[*g];
    const double part = part_on_segment(at(across.a), at(across.b), at(q));
    const Point nearest = nearest_on_segment(at(across.a), at(across.b), at(q));
    const std::uint32_t other = part == 0 ? across.a : part == 1 ? across.b : q;
    if (!take(wall, nearest, across.face, other, best)) return;
    foot.reset();
    if (other == q) foot = Station{*g, part, best.width, q, q, wall.face, false};
  }

  /// Whether a place of a polygon is in front and nearer than the best.
  bool take(const Wall& wall, Point place, std::uint32_t face, std::uint32_t other,
            Station& best) const {
    if (owner(face) == 0 || owner(face) == owner(wall.face)) return false;
    const Vector way = place - at(best.point), along = at(wall.b) - at(wall.a);
    const double width = length(way);
    if (!(width < best.width) || cross(along, way) < kInFront * width * length(along)) return false;
    best.width = width;
    best.face = face;
    best.other = other;
    return true;
  }

  /// Whether the wall and the next one, of another polygon, close a wedge in q.
  bool is_tip(const Wall& wall, std::uint32_t q, EdgeRef edge, Station& best) const {
    const std::optional<std::uint32_t> g = wall_at(edge);
    if (!g) return false;
    const Wall& next = walls_[*g];
    if (owner(next.face) == 0 || owner(next.face) == owner(wall.face)) return false;
    const Vector back = at(wall.a == q ? wall.b : wall.a) - at(q);
    const Vector on = at(next.a == q ? next.b : next.a) - at(q);
    const double turn = wall.a == q ? cross(back, on) : cross(on, back);
    if (turn <= 0 || turn > kWedge * dot(back, on)) return false;
    best.width = 0;
    best.face = next.face;
    best.other = q;
    best.is_tip = true;
    return true;
  }

  void add_stretch(const Station& from, const Station& to, UnionFind& joined,
                   std::vector<Stretch>& stretches) const {
    if (from.wall != to.wall || owner(from.face) != owner(to.face)) return;
    if (from.is_tip && to.is_tip) return;
    const Wall& wall = walls_[from.wall];
    const Vector along = at(wall.b) - at(wall.a);
    const double part = to.part - from.part, width = (from.width + to.width) / 2;
    for (const Station& s : {from, to}) {
      joined.unite(from.point, s.point);
      joined.unite(from.point, s.other);
    }
    const Point middle = at_part(at(wall.a), at(wall.b), from.part + part / 2);
    stretches.push_back({from.point, part * length(along), width, per_width(wall.face, from.face),
                         middle + width / 2 / length(along) * left_normal(along),
                         faces_.of_triangle[wall.edge.triangle]});
  }

  static std::vector<OpenGap> gaps(const std::vector<Stretch>& stretches, UnionFind& joined) {
    struct Sum {
      OpenGap gap;
      double longest = 0;
      double per_beside = 0;  ///< times the length
    };
    std::map<std::uint32_t, Sum> sums;
    for (const Stretch& s : stretches) {
      Sum& sum = sums[joined.find(s.point)];
      sum.gap.area += s.length * s.width / 2;  // it is also measured from the other side
      sum.gap.length += s.length;
      sum.per_beside += s.length * s.per_beside;
      if (s.length <= sum.longest) continue;
      sum.longest = s.length;
      sum.gap.where = s.where;
      sum.gap.face = s.face;
    }
    std::vector<OpenGap> found;
    for (const auto& [point, sum] : sums) {
      // The length of one wall in widths of what is beside it.
      if (sum.per_beside / 2 >= kLong) found.push_back(sum.gap);
    }
    return found;
  }

  const Faces& faces_;
  const FacesBeside& beside_;
  const std::vector<Point>& points_;
  std::vector<Wall> walls_;                                ///< by triangle and edge
  std::vector<std::array<std::uint32_t, 2>> polygons_at_;  ///< by point: faces; 0: none
  std::vector<Station> stations_;
};

}  // namespace

std::vector<OpenGap> open_gaps(const Faces& faces, const FacesBeside& beside) {
  return OpenGaps(faces, beside).find();
}

}  // namespace cover
