// Tested by tests/unit/region/region_graph_test.cpp.
#include "region/gaps/near_misses.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include <cover/text.hpp>

#include "base/containers/union_find.hpp"
#include "clean/ends/loose_ends.hpp"
#include "geom/box.hpp"
#include "geom/vector.hpp"
#include "region/gaps/wall_behind.hpp"

namespace cover {
namespace {

/// What is nearer than this, compared with the edges beside it, is worth a warning. Rounded decimal
/// drawings miss by 1e-16 to 1e-7 of their size; the thinnest layers that are meant (1.2 nm on 1
/// mm) lie above.
constexpr double kNear = 1e-6;
constexpr std::size_t kMostWarnings = 50;

/// An end of one line alone is no corner of a layer: it is told up to this part of its line, as
/// long as welding reaches it, which is held back by short segments.
constexpr double kUndershoot = 1e-3;
constexpr double kOfLastSegment = 1.0 / 16;

/// A dangling end of a line.
struct DanglingEnd {
  std::uint32_t point = 0;
  std::uint32_t joined = 0;  ///< the other end of its segment
  double reach = 0;          ///< what is nearer may be meant to meet it
};

/// The dangling ends beside which a region is, by point.
///
/// Cost: O(n)
std::vector<DanglingEnd> dangling_ends(const Pslg& pslg, const Faces& faces,
                                       const std::vector<bool>& is_void) {
  std::vector<std::uint8_t> degree(pslg.points.size(), 0);  // 3: and more
  for (const Segment& s : pslg.segments) {
    for (const VertexId v : {s.a, s.b})
      degree[v.index()] = static_cast<std::uint8_t>(std::min(degree[v.index()] + 1, 3));
  }
  if (std::find(degree.begin(), degree.end(), 1) == degree.end()) return {};
  // The lines between points where not just two segments meet.
  UnionFind line(pslg.points.size());
  const auto is_inner = [&](VertexId v) { return degree[v.index()] == 2; };
  for (const Segment& s : pslg.segments) {
    if (is_inner(s.a) && is_inner(s.b)) line.unite(s.a.value(), s.b.value());
  }
  const auto line_of = [&](const Segment& s) {
    return line.find((is_inner(s.a) ? s.a : s.b).value());
  };
  const auto length_of = [&](const Segment& s) {
    return length(pslg.points[s.b.index()] - pslg.points[s.a.index()]);
  };
  std::vector<double> lengths(pslg.points.size(), 0);
  for (const Segment& s : pslg.segments) {
    if (is_inner(s.a) || is_inner(s.b)) lengths[line_of(s)] += length_of(s);
  }
  std::vector<DanglingEnd> ends;
  for (std::size_t k = 0; k < pslg.segments.size(); ++k) {
    const Segment& s = pslg.segments[k];
    if (is_void[faces.of_segment[k][0]] && is_void[faces.of_segment[k][1]]) continue;
    for (const auto& [end, joined] : {std::pair(s.a, s.b), std::pair(s.b, s.a)}) {
      if (degree[end.index()] != 1) continue;
      const double segment = length_of(s);
      const double whole = is_inner(joined) ? lengths[line_of(s)] : segment;
      ends.push_back(
          {end.value(), joined.value(), std::min(kUndershoot * whole, kOfLastSegment * segment)});
    }
  }
  std::sort(ends.begin(), ends.end(),
            [](const DanglingEnd& e, const DanglingEnd& f) { return e.point < f.point; });
  return ends;
}

class NearMisses {
 public:
  NearMisses(const Pslg& pslg, const Triangulation& triangulation, std::vector<Note>& notes)
      : pslg_(pslg), triangulation_(triangulation), notes_(notes) {}

  /// A corner of a triangle, to which something is near.
  struct CornerOfTriangle {
    std::uint32_t triangle;
    Corner i;
  };

  /// Adds the corners of triangle t that are near to the edge opposite, or whose edge opposite is
  /// short.
  void collect(std::uint32_t t, std::vector<CornerOfTriangle>& found) const {
    const Triangle& f = triangulation_.triangles[t];
    std::array<double, 3> opposite{};  // the lengths of the edges
    for (const Corner i : kCorners) opposite[i] = length(at(f.v[i.previous()]) - at(f.v[i.next()]));
    for (const Corner i : kCorners) {
      const double beside = std::min(opposite[i.next()], opposite[i.previous()]);
      if (opposite[i] < kNear * beside) {
        if (!f.is_locked(i)) found.push_back({t, i});
      } else if (!f.is_locked(i.next()) && !f.is_locked(i.previous()) &&
                 is_near_edge(f, i, beside)) {
        found.push_back({t, i});
      }
    }
  }

  /// Tells of what was collected.
  void look(const CornerOfTriangle& corner) {
    const auto& [t, i] = corner;
    const Triangle& f = triangulation_.triangles[t];
    const std::uint32_t w = f.v[i], u = f.v[i.next()], v = f.v[i.previous()];
    const double uv = length(at(v) - at(u));
    const double beside = std::min(length(at(w) - at(v)), length(at(u) - at(w)));
    if (uv < kNear * beside) {
      points(u, v, uv);
    } else {
      look_across(w, t, i, kNear * beside);
    }
  }

  /// Tells of what is nearest to dangling ends, where it is near.
  void look_at_ends(const std::vector<DanglingEnd>& ends) {
    if (ends.empty()) return;
    std::vector<Nearest> nearest;
    std::vector<bool> is_end(pslg_.points.size(), false);
    for (const DanglingEnd& end : ends) {
      nearest.push_back({end.reach, kNone, kNone});
      is_end[end.point] = true;
    }
    for (std::uint32_t t = 0; t < triangulation_.triangles.size(); ++t) {
      for (const Corner i : kCorners) {
        const std::uint32_t w = triangulation_.triangles[t].v[i];
        if (!is_end[w]) continue;
        const auto end = std::lower_bound(
            ends.begin(), ends.end(), w,
            [](const DanglingEnd& e, std::uint32_t point) { return e.point < point; });
        look_from_end(*end, {t, i}, nearest[static_cast<std::size_t>(end - ends.begin())]);
      }
    }
    const std::size_t before = notes_.size();
    double widest = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const auto& [distance, u, v] = nearest[k];
      if (u == kNone) continue;
      widest = std::max(widest, distance);
      if (u == v) {
        points(ends[k].point, u, distance);
      } else {
        point_and_segment(ends[k].point, u, v, distance);
      }
    }
    if (notes_.size() == before) return;
    notes_[before].message += fmt::format(": a line ends there ({} closes such gaps)",
                                          weld_closing(widest / box_of(pslg_.points).extent()));
  }

  /// Says how many more there are than were listed.
  void finish() {
    if (seen_.size() <= kMostWarnings) return;
    warn(fmt::format("{} more places where points or segments nearly touch",
                     seen_.size() - kMostWarnings),
         {});
  }

 private:
  /// The segment between two points, or one point twice, that is nearest to another.
  struct Nearest {
    double distance = 0;
    std::uint32_t u = kNone;
    std::uint32_t v = kNone;
  };

  void look_from_end(const DanglingEnd& end, EdgeRef opposite, Nearest& nearest) const {
    const Triangle& f = triangulation_.triangles[opposite.triangle];
    const std::uint32_t w = end.point;
    const auto corners = {f.v[opposite.edge.next()], f.v[opposite.edge.previous()]};
    for (const std::uint32_t p : corners) {
      const double away = length(at(p) - at(w));
      if (p != end.joined && away < nearest.distance) nearest = {away, p, p};
    }
    const auto wall = wall_behind(triangulation_, w, opposite, nearest.distance);
    if (!wall) return;
    const Triangle& g = triangulation_.triangles[wall->triangle];
    const std::uint32_t u = g.v[wall->edge.next()], v = g.v[wall->edge.previous()];
    if (!is_beside(w, u, v) || distance(w, u, v) >= nearest.distance) return;
    nearest = {distance(w, u, v), u, v};
  }

  [[nodiscard]] bool is_near_edge(const Triangle& f, Corner i, double beside) const {
    const std::uint32_t w = f.v[i], u = f.v[i.next()], v = f.v[i.previous()];
    return is_beside(w, u, v) && distance(w, u, v) < kNear * beside;
  }

  [[nodiscard]] std::string name(std::uint32_t p) const {
    const long id = pslg_.point_ids[p];
    return id < 0 ? fmt::format("the point at {}", describe(pslg_.points[p]))
                  : fmt::format("point {} at {}", id, describe(pslg_.points[p]));
  }

  void points(std::uint32_t u, std::uint32_t v, double distance) {
    if (!is_new({std::min(u, v), std::max(u, v), std::max(u, v)})) return;
    warn(fmt::format("{} and {} are only {} apart", name(u), name(v), describe_roughly(distance)),
         {pslg_.points[u], pslg_.points[v]});
  }

  [[nodiscard]] Point at(std::uint32_t p) const { return pslg_.points[p]; }

  /// Whether the point of the line through u and v that is nearest to w lies between them.
  [[nodiscard]] bool is_beside(std::uint32_t w, std::uint32_t u, std::uint32_t v) const {
    return dot(at(v) - at(u), at(w) - at(u)) > 0 && dot(at(u) - at(v), at(w) - at(v)) > 0;
  }

  /// The distance of w from the line through u and v.
  [[nodiscard]] double distance(std::uint32_t w, std::uint32_t u, std::uint32_t v) const {
    return std::abs(cross(at(v) - at(u), at(w) - at(u))) / length(at(v) - at(u));
  }

  /// Tells of the segment that is nearer to point w than `reach` behind edge i of triangle t.
  void look_across(std::uint32_t w, std::uint32_t t, Corner i, double reach) {
    const std::optional<EdgeRef> wall = wall_behind(triangulation_, w, {t, i}, reach);
    if (!wall) return;
    const Triangle& f = triangulation_.triangles[wall->triangle];
    const std::uint32_t u = f.v[wall->edge.next()], v = f.v[wall->edge.previous()];
    if (is_beside(w, u, v)) point_and_segment(w, u, v, distance(w, u, v));
  }

  void point_and_segment(std::uint32_t w, std::uint32_t u, std::uint32_t v, double distance) {
    if (!is_new({w, std::min(u, v), std::max(u, v)})) return;
    const std::string apart = distance > 0 ? fmt::format("only {} away", describe_roughly(distance))
                                           : std::string("less than doubles can tell away");
    warn(fmt::format("{} is {} from the segment between {} and {}", name(w), apart, name(u),
                     name(v)),
         {pslg_.points[w]});
  }

  bool is_new(std::array<std::uint32_t, 3> place) {
    return seen_.insert(place).second && seen_.size() <= kMostWarnings;
  }

  void warn(std::string message, std::vector<Point> where) {
    notes_.push_back({Note::Kind::warning, kVoid, std::move(message), std::move(where)});
  }

  const Pslg& pslg_;
  const Triangulation& triangulation_;
  std::vector<Note>& notes_;
  std::set<std::array<std::uint32_t, 3>> seen_;
};

constexpr const char* kRemedy = " (--weld closes such gaps)";

std::vector<Note> find_near_misses(const Pslg& pslg, const Triangulation& triangulation,
                                   const std::vector<DanglingEnd>& ends, const char* remedy,
                                   const Team& team) {
  const std::size_t triangles = triangulation.triangles.size();
  std::vector<Note> notes;
  NearMisses misses(pslg, triangulation, notes);
  std::vector<std::vector<NearMisses::CornerOfTriangle>> found(
      Team::ranges(triangles, kItemsAtATime));
  team.each_range(triangles, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (auto t = static_cast<std::uint32_t>(first); t < last; ++t)
      misses.collect(t, found[first / kItemsAtATime]);
  });
  for (const auto& some : found) {
    for (const NearMisses::CornerOfTriangle& corner : some) misses.look(corner);
  }
  if (!notes.empty()) notes[0].message += remedy;
  misses.look_at_ends(ends);
  misses.finish();
  return notes;
}

}  // namespace

void warn_of_near_misses(const Pslg& pslg, const Faces& faces, const std::vector<bool>& is_void,
                         const Team& team, std::vector<Note>& notes) {
  std::vector<Note> misses = find_near_misses(pslg, faces.triangulation,
                                              dangling_ends(pslg, faces, is_void), kRemedy, team);
  std::move(misses.begin(), misses.end(), std::back_inserter(notes));
}

std::string near_misses_behind(const Pslg& pslg, const Triangulation& triangulation) {
  const std::vector<Note> misses = find_near_misses(pslg, triangulation, {}, "", Team());
  if (misses.empty()) return {};
  std::string out = "; " + misses[0].message;
  if (misses.size() > 1) {
    out += fmt::format(", and so at {}", counted(misses.size() - 1, "more place"));
  }
  return out + kRemedy;
}

}  // namespace cover
