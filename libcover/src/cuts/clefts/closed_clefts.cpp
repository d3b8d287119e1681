// Tested by tests/unit/cuts/clefts/closed_clefts_test.cpp.
#include "cuts/clefts/closed_clefts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "cdt/cdt.hpp"
#include "cdt/region_cdt.hpp"
#include "cuts/cut_segments.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/topology/half_edges.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

/// An end of width w, slanted by f, allows the first cut between w f and w / f from it: nearer, its
/// foot lies beyond the other corner; farther off, the sharp corner does not reach to it.
constexpr double kOfFirstCut = 0.7;
constexpr double kMostOfWall = 0.3;  ///< a first cut; else none is needed
constexpr double kOfRoom = 0.25;     ///< length of a slit, and of the pieces beside an end
constexpr double kMostOfRoom = 1.4;  ///< of that: the last piece of those that double
constexpr double kNarrow = 500;      ///< room, in widths: nearer, an opened cleft moves too much
constexpr double kNear = 10;         ///< to a wall, in widths: what opens with it

Point point_of(const Pslg& pslg, VertexId v) { return pslg.points[v.index()]; }

/// Where a slit ends that begins at the middle of the end, at a right angle to it.
Point end_of_slit(const Pslg& pslg, const Cleft::End& end, bool is_first) {
  const Point a = point_of(pslg, end.corner[0]), b = point_of(pslg, end.corner[1]);
  const Vector out = (is_first ? -1 : 1) / length(b - a) * left_normal(b - a);
  return midpoint(a, b) + kOfRoom * end.room * out;
}

/// Of the first wall.
double wall_length(const Pslg& pslg, const Cleft& cleft) {
  return length(point_of(pslg, cleft.end[1].corner[0]) - point_of(pslg, cleft.end[0].corner[0]));
}

/// The cut nearest to an end, as a part of a wall that is so long.
double first_cut(const Pslg& pslg, const Cleft::End& end, double wall) {
  const double width = length(point_of(pslg, end.corner[1]) - point_of(pslg, end.corner[0]));
  return kOfFirstCut * width / (end.slant * wall);
}

/// The cuts of the first wall that its slanted ends ask for, as parts of it, in order.
std::vector<double> first_cuts(const Pslg& pslg, const Cleft& cleft) {
  const double wall = wall_length(pslg, cleft);
  std::vector<double> parts;
  for (const Cleft::End& end : cleft.end) {
    const double part = first_cut(pslg, end, wall);
    if (part < kMostOfWall) parts.push_back(&end == &cleft.end[0] ? part : 1 - part);
  }
  return parts;
}

/// The same, and from each end ever longer pieces up to what there is room for.
std::vector<double> cuts_by_shells(const Pslg& pslg, const Cleft& cleft) {
  const double wall = wall_length(pslg, cleft);
  std::vector<double> parts;
  for (const Cleft::End& end : cleft.end) {
    const double most = kOfRoom * end.room / wall;
    for (double part = std::min(first_cut(pslg, end, wall), most);
         part < kMostOfRoom * most && part < kMostOfWall; part *= 2)
      parts.push_back(&end == &cleft.end[0] ? part : 1 - part);
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// Whether the corner of the first wall at that end is obtuse: the end is filled from it, and the
/// cut beside it must be at a right angle then, where the walls are not quite parallel.
bool is_blunt_at_first(const Pslg& pslg, const Cleft& cleft, std::size_t end) {
  const Point corner = point_of(pslg, cleft.end[end].corner[0]);
  return dot(point_of(pslg, cleft.end[end].corner[1]) - corner,
             point_of(pslg, cleft.end[1 - end].corner[0]) - corner) < 0;
}

/// The same for cut `k` of `count`.
bool is_right_at_first(const Pslg& pslg, const Cleft& cleft, std::size_t k, std::size_t count) {
  return (k == 0 && is_blunt_at_first(pslg, cleft, 0)) ||
         (k + 1 == count && is_blunt_at_first(pslg, cleft, 1));
}

/// Straight across from points along the first wall; nothing if they are not in that order, or
/// beyond the other.
std::optional<std::vector<Point>> cuts_across(const Pslg& pslg, const Cleft& cleft,
                                              const std::vector<Point>& points) {
  const Point a = point_of(pslg, cleft.end[0].corner[0]),
              b = point_of(pslg, cleft.end[1].corner[0]),
              c = point_of(pslg, cleft.end[0].corner[1]),
              d = point_of(pslg, cleft.end[1].corner[1]);
  std::vector<Point> across;
  double before = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector along = is_right_at_first(pslg, cleft, k, points.size()) ? b - a : d - c;
    across.push_back(straight_across(points[k], along, c, d));
    const double part = part_on_line(c, d, across.back());
    if (!(part > before) || !(part < 1)) return std::nullopt;
    before = part;
  }
  return across;
}

class Closer {
 public:
  Closer(const Prepared& whole, std::span<const Cleft> clefts) : whole_(whole) {
    for (const Cleft& cleft : clefts) (is_narrow(cleft) ? closed_.clefts : wide_).push_back(cleft);
    take_over_segments();
    for (const Cleft& cleft : closed_.clefts) add_slits(cleft);
    drop_unused();
    Pslg& pslg = closed_.work.pslg;
    pslg.point_ids.resize(pslg.points.size(), -1);
    pslg.point_markers.resize(pslg.points.size(), 0);
    cut();
    closed_.work.report.input_points = pslg.points.size();
  }

  std::optional<ClosedClefts> closed() && {
    for (const RegionBoundary& boundary : split_regions(closed_.work.pslg, closed_.work.table)) {
      if (boundary.sides.empty() || find_flaw(triangulate_domain(boundary.points, boundary.sides),
                                              boundary.points, boundary.sides))
        return std::nullopt;
    }
    return std::move(closed_);
  }

 private:
  [[nodiscard]] bool is_narrow(const Cleft& cleft) const {
    return std::all_of(cleft.end.begin(), cleft.end.end(), [&](const Cleft::End& end) {
      return end.room > kNarrow * length(point_of(whole_.pslg, end.corner[1]) -
                                         point_of(whole_.pslg, end.corner[0]));
    });
  }

  /// All segments but second walls and ends. What ended at a corner of these ends at that of the
  /// first wall, which has behind it what was behind the second.
  void take_over_segments() {
    const Pslg& pslg = whole_.pslg;
    std::vector<std::uint32_t> to(pslg.points.size());  // by point: which one it becomes
    std::iota(to.begin(), to.end(), 0U);
    std::vector<std::uint32_t> cleft_of(pslg.segments.size(), kNone);
    std::vector<bool> goes(pslg.segments.size(), false);
    for (std::uint32_t k = 0; k < closed_.clefts.size(); ++k) {
      const Cleft& cleft = closed_.clefts[k];
      for (const Cleft::End& end : cleft.end) {
        to[end.corner[1].index()] = end.corner[0].value();
        if (end.segment) goes[end.segment->index()] = true;
      }
      goes[cleft.wall[1].index()] = true;
      cleft_of[cleft.wall[0].index()] = k;
    }
    closed_.wall.resize(closed_.clefts.size());
    Work& work = closed_.work;
    work.pslg.points = pslg.points;
    work.pslg.names = pslg.names;
    work.table.regions = whole_.table.regions;
    work.table.isolated_points = whole_.table.isolated_points;
    for (std::uint32_t s = 0; s < goes.size(); ++s) {
      SegmentSides sides = whole_.table.sides[s];
      if (goes[s] || (sides.left == kVoid && sides.right == kVoid)) continue;
      const Segment& segment = pslg.segments[s];
      if (const std::uint32_t k = cleft_of[s]; k != kNone) {
        closed_.wall[k] = static_cast<std::uint32_t>(work.pslg.segments.size());
        const Cleft& cleft = closed_.clefts[k];
        (segment.a == cleft.end[0].corner[0] ? sides.right : sides.left) = cleft.behind[1];
      }
      add(to[segment.a.index()], to[segment.b.index()], sides, s);
    }
  }

  void add(std::uint32_t a, std::uint32_t b, SegmentSides sides, std::uint32_t was) {
    Segment segment;
    segment.a = VertexId{a}, segment.b = VertexId{b};
    sides.interface = kNoInterface;
    closed_.work.pslg.segments.push_back(segment);
    closed_.segments.push_back(segment);
    closed_.work.table.sides.push_back(sides);
    closed_.segment_before.push_back(was);
  }

  void add_slits(const Cleft& cleft) {
    closed_.slit.push_back({kNone, kNone});
    for (std::size_t e = 0; e < 2; ++e) {
      const Cleft::End& end = cleft.end[e];
      if (end.beyond == kVoid) continue;
      Pslg& pslg = closed_.work.pslg;
      closed_.slit.back()[e] = static_cast<std::uint32_t>(pslg.segments.size());
      const auto last = static_cast<std::uint32_t>(pslg.points.size());
      pslg.points.push_back(end_of_slit(whole_.pslg, end, e == 0));
      add(end.corner[0].value(), last, {end.beyond, end.beyond, kNoInterface}, kNone);
    }
  }

  /// Points of no segment: they may lie on others.
  void drop_unused() {
    Pslg& pslg = closed_.work.pslg;
    std::vector<IsolatedPoint>& isolated = closed_.work.table.isolated_points;
    std::vector<bool> is_used(pslg.points.size(), false);
    for (const Segment& s : pslg.segments) is_used[s.a.index()] = is_used[s.b.index()] = true;
    for (const IsolatedPoint& p : isolated) is_used[p.vertex.index()] = true;
    std::vector<VertexId> number(pslg.points.size());
    std::vector<Point> points;
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      if (!is_used[v]) continue;
      number[v] = VertexId{points.size()};
      points.push_back(pslg.points[v]);
      closed_.point_before.push_back(v);
    }
    pslg.points = std::move(points);
    for (Segment& s : pslg.segments) s.a = number[s.a.index()], s.b = number[s.b.index()];
    for (IsolatedPoint& p : isolated) p.vertex = number[p.vertex.index()];
  }

  void cut() {
    Pslg& pslg = closed_.work.pslg;
    std::vector<SegmentCut> cuts;
    const auto add = [&](std::uint32_t segment, const Cleft& cleft, std::vector<Point> points) {
      if (points.empty()) return;
      if (closed_.segments[segment].a != cleft.end[0].corner[0] &&
          closed_.segments[segment].a != cleft.end[0].corner[1])
        std::reverse(points.begin(), points.end());
      cuts.push_back({SegmentId{segment}, std::move(points)});
    };
    const auto along = [&](const Cleft& cleft, const std::vector<double>& parts) {
      const Point a = point_of(whole_.pslg, cleft.end[0].corner[0]),
                  b = point_of(whole_.pslg, cleft.end[1].corner[0]);
      std::vector<Point> points;
      for (const double part : parts)
        points.push_back(part < 0.5 ? a + part * (b - a) : b + (1 - part) * (a - b));
      return points;
    };
    for (std::size_t k = 0; k < closed_.clefts.size(); ++k) {
      const Cleft& cleft = closed_.clefts[k];
      add(closed_.wall[k], cleft, along(cleft, first_cuts(whole_.pslg, cleft)));
    }
    std::vector<std::uint32_t> now(whole_.pslg.segments.size(), kNone);
    for (std::uint32_t s = 0; s < closed_.segment_before.size(); ++s) {
      if (closed_.segment_before[s] != kNone) now[closed_.segment_before[s]] = s;
    }
    for (const Cleft& cleft : wide_) {
      const std::vector<Point> points = along(cleft, cuts_by_shells(whole_.pslg, cleft));
      const std::optional<std::vector<Point>> across = cuts_across(whole_.pslg, cleft, points);
      if (!across) continue;
      add(now[cleft.wall[0].index()], cleft, points);
      add(now[cleft.wall[1].index()], cleft, *across);
    }
    std::sort(cuts.begin(), cuts.end(),
              [](const SegmentCut& x, const SegmentCut& y) { return x.segment < y.segment; });
    cut_segments(pslg, closed_.work.table, cuts);
  }

  const Prepared& whole_;
  ClosedClefts closed_;
  std::vector<Cleft> wide_;  ///< these stay open
};

/// The same mesh with all points of the plane before, which have their numbers again.
JoinedMesh with_numbers_before(const JoinedMesh& mesh, const ClosedClefts& closed,
                               const std::vector<Point>& before) {
  const std::vector<std::uint32_t>& was = closed.point_before;
  const std::size_t old = std::max<std::size_t>(before.size(), was.back() + 1);
  const auto number = [&](std::uint32_t v) {
    return v < was.size() ? was[v] : static_cast<std::uint32_t>(v - was.size() + old);
  };
  JoinedMesh out = mesh;
  out.points = before;
  out.points.resize(old + mesh.points.size() - was.size());
  out.line.assign(out.points.size(), JoinedMesh::kFixed);
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    out.points[number(v)] = mesh.points[v];
    out.line[number(v)] = mesh.line[v];
  }
  for (JoinedMesh::Piece& piece : out.pieces) piece.a = number(piece.a), piece.b = number(piece.b);
  for (IndexTriple& t : out.triangles) {
    for (std::uint32_t& v : t) v = number(v);
  }
  return out;
}

class Opener {
 public:
  Opener(JoinedMesh mesh, const ClosedClefts& closed, const Prepared& whole)
      : mesh_(std::move(mesh)),
        closed_(closed),
        whole_(whole),
        edges_(mesh_.points.size(), mesh_.triangles),
        on_(closed.segment_before.size()) {
    for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) {
      if (mesh_.line[v] < on_.size()) on_[mesh_.line[v]].push_back(v);
    }
    take_over();
  }

  std::optional<OpenedClefts> opened() && {
    for (std::size_t k = 0; k < closed_.clefts.size(); ++k) {
      if (!open(k)) return std::nullopt;
    }
    if (!is_sound()) return std::nullopt;
    return OpenedClefts{std::move(out_), std::move(pairs_)};
  }

 private:
  /// What is as it was.
  void take_over() {
    const Pslg& pslg = whole_.pslg;
    out_.points = mesh_.points;
    out_.triangles = mesh_.triangles;
    out_.region = mesh_.region;
    for (const Segment& s : pslg.segments)
      out_.lines.push_back({point_of(pslg, s.a), point_of(pslg, s.b)});
    for (std::uint32_t v = 0; v < mesh_.points.size(); ++v) {
      std::uint32_t line = mesh_.line[v];
      if (v < pslg.points.size()) {
        line = JoinedMesh::kFixed;
      } else if (line < closed_.segment_before.size() && closed_.segment_before[line] != kNone) {
        line = closed_.segment_before[line];
      } else {
        line = JoinedMesh::kInside;
      }
      out_.line.push_back(line);
    }
    for (const JoinedMesh::Piece& piece : mesh_.pieces) {
      const std::uint32_t was = closed_.segment_before[piece.line];
      if (was == kNone) continue;
      const Segment &before = pslg.segments[was], &now = closed_.segments[piece.line];
      const auto corner = [&](std::uint32_t v) {
        return v == now.a.value() ? before.a.value() : v == now.b.value() ? before.b.value() : v;
      };
      out_.pieces.push_back({corner(piece.a), corner(piece.b), was});
    }
  }

  [[nodiscard]] bool is_sound() const {
    return HalfEdges(out_.points.size(), out_.triangles).all_different() &&
           std::all_of(out_.triangles.begin(), out_.triangles.end(), [&](const IndexTriple& t) {
             return orientation(out_.points[t[0]], out_.points[t[1]], out_.points[t[2]]) ==
                    Sign::positive;
           });
  }

  bool open(std::size_t k) {
    const Cleft& cleft = closed_.clefts[k];
    const Pslg& pslg = whole_.pslg;
    const Point a = point_of(pslg, cleft.end[0].corner[0]),
                b = point_of(pslg, cleft.end[1].corner[0]);
    // Along the first wall, and what they become on the other.
    std::vector<std::uint32_t> first = on_[closed_.wall[k]], other;
    std::sort(first.begin(), first.end(), [&](std::uint32_t x, std::uint32_t y) {
      return dot(mesh_.points[x] - a, b - a) < dot(mesh_.points[y] - a, b - a);
    });
    if (!cut_across(cleft, first, other)) return false;
    first.insert(first.begin(), cleft.end[0].corner[0].value());
    first.push_back(cleft.end[1].corner[0].value());
    other.insert(other.begin(), cleft.end[0].corner[1].value());
    other.push_back(cleft.end[1].corner[1].value());

    const std::array<std::uint32_t, 2> next{next_on_slit(k, 0), next_on_slit(k, 1)};
    for (std::size_t i = 0; i < first.size(); ++i) {
      const std::uint32_t from = i + 1 < first.size() ? first[i + 1] : next[1];
      const std::uint32_t to = i > 0 ? first[i - 1] : next[0];
      turn_over(cleft, first[i], from, to, other[i]);
    }
    end_at(cleft, next);
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
      out_.pieces.push_back({other[i], other[i + 1], cleft.wall[1].value()});
      fill(first[i], other[i], other[i + 1], first[i + 1], cleft.region);
    }
    return true;
  }

  /// Cuts the other wall across from each cut of the first one; `other` gets the new vertices.
  /// False if there is no room for them.
  bool cut_across(const Cleft& cleft, const std::vector<std::uint32_t>& first,
                  std::vector<std::uint32_t>& other) {
    std::vector<Point> points;
    for (const std::uint32_t v : first) points.push_back(mesh_.points[v]);
    const std::optional<std::vector<Point>> across = cuts_across(whole_.pslg, cleft, points);
    if (!across) return false;
    for (const Point p : *across) {
      other.push_back(static_cast<std::uint32_t>(out_.points.size()));
      out_.points.push_back(p);
      out_.line.push_back(cleft.wall[1].value());
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
      pairs_.push_back(
          {first[i], other[i], is_right_at_first(whole_.pslg, cleft, i, first.size())});
    }
    return true;
  }

  /// The segments at both ends, and the triangles over them; `next` are the first vertices beyond.
  void end_at(const Cleft& cleft, std::array<std::uint32_t, 2> next) {
    for (std::size_t e = 0; e < 2; ++e) {
      const Cleft::End& end = cleft.end[e];
      const std::uint32_t p = end.corner[0].value(), q = end.corner[1].value();
      if (end.segment) out_.pieces.push_back({p, q, end.segment->value()});
      if (next[e] == kNone) continue;
      out_.triangles.push_back(e == 0 ? IndexTriple{q, p, next[e]} : IndexTriple{p, q, next[e]});
      out_.region.push_back(end.beyond.value() - 1);
    }
  }

  /// The vertex beside the end on its slit; kNone without one.
  [[nodiscard]] std::uint32_t next_on_slit(std::size_t k, std::size_t e) const {
    const std::uint32_t slit = closed_.slit[k][e];
    if (slit == kNone) return kNone;
    const Point from = mesh_.points[closed_.clefts[k].end[e].corner[0].index()];
    std::uint32_t nearest = closed_.segments[slit].b.value();
    for (const std::uint32_t v : on_[slit]) {
      if (squared_length(mesh_.points[v] - from) < squared_length(mesh_.points[nearest] - from))
        nearest = v;
    }
    return nearest;
  }

  /// Triangles around `v`, clockwise from its edge to `from` up to that to `to`, get `other` in its
  /// place. Where there is no triangle, they end.
  void turn_over(const Cleft& cleft, std::uint32_t v, std::uint32_t from, std::uint32_t to,
                 std::uint32_t other) {
    // Without a slit on one side they begin, or end, at the void.
    std::uint32_t h = from == kNone ? kNone : edges_.find(from, v);
    if (from == kNone) h = first_clockwise(v, to);
    while (h != kNone) {
      IndexTriple& triangle = out_.triangles[h / 3];
      std::replace(triangle.begin(), triangle.end(), v, other);
      for (const std::uint32_t u : triangle)
        move_near(u, cleft, out_.points[other] - mesh_.points[v]);
      const std::uint32_t after = edges_.target(HalfEdges::next(h));
      if (after == to) return;
      h = edges_.find(after, v);
    }
  }

  [[nodiscard]] bool is_on_slit(std::uint32_t v) const {
    return mesh_.line[v] == JoinedMesh::kFixed || (mesh_.line[v] < closed_.segment_before.size() &&
                                                   closed_.segment_before[mesh_.line[v]] == kNone);
  }

  /// What lies nearly as near to the first wall as the other one will go on before that.
  void move_near(std::uint32_t u, const Cleft& cleft, Vector by) {
    if (u >= mesh_.points.size() || is_on_slit(u) || out_.line[u] == JoinedMesh::kFixed ||
        out_.line[u] == cleft.wall[0].value() || out_.points[u] != mesh_.points[u])
      return;
    const Point a = point_of(whole_.pslg, cleft.end[0].corner[0]),
                b = point_of(whole_.pslg, cleft.end[1].corner[0]);
    if (std::abs(cross(b - a, mesh_.points[u] - a)) > kNear * length(by) * length(b - a)) return;
    out_.points[u] = mesh_.points[u] + by;
    if (out_.line[u] == JoinedMesh::kInside) return;
    const auto [c, d] = out_.lines[out_.line[u]];
    out_.points[u] = c + part_on_line(c, d, out_.points[u]) * (d - c);
  }

  /// The half-edge to `v` from where the void is, from `to` back against the clock.
  [[nodiscard]] std::uint32_t first_clockwise(std::uint32_t v, std::uint32_t to) const {
    std::uint32_t h = edges_.find(v, to), found = kNone;
    while (h != kNone) {
      found = HalfEdges::previous(h);
      h = edges_.find(v, edges_.source(found));
    }
    return found;
  }

  /// Two triangles between (a, b) and (d, c), a before d and b before c on their walls.
  void fill(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, RegionId region) {
    const auto blunt = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      return -dot(out_.points[p] - out_.points[q], out_.points[r] - out_.points[q]);
    };
    const double from_a = std::max({blunt(a, b, c), blunt(c, d, a), blunt(b, a, c)}),
                 from_b = std::max({blunt(d, a, b), blunt(b, c, d), blunt(a, b, d)});
    if (from_a < from_b) {
      out_.triangles.push_back({a, b, c});
      out_.triangles.push_back({a, c, d});
    } else {
      out_.triangles.push_back({a, b, d});
      out_.triangles.push_back({b, c, d});
    }
    out_.region.resize(out_.triangles.size(), region.value() - 1);
  }

  JoinedMesh mesh_;
  const ClosedClefts& closed_;
  const Prepared& whole_;
  HalfEdges edges_;
  std::vector<std::vector<std::uint32_t>> on_;  ///< by whole segment: vertices that cut it
  JoinedMesh out_;
  std::vector<FollowedVertex> pairs_;
};

}  // namespace

std::optional<ClosedClefts> close_clefts(const Prepared& whole, std::span<const Cleft> clefts) {
  return Closer(whole, clefts).closed();
}

std::optional<OpenedClefts> open_clefts(const JoinedMesh& mesh, const ClosedClefts& closed,
                                        const Prepared& whole) {
  return Opener(with_numbers_before(mesh, closed, whole.pslg.points), closed, whole).opened();
}

}  // namespace cover
