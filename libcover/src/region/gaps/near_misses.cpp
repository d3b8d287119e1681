// Tested by tests/unit/region/region_graph_test.cpp.
#include "region/gaps/near_misses.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

#include <cover/text.hpp>

#include "geom/vector.hpp"
#include "region/gaps/wall_behind.hpp"

namespace cover {
namespace {

/// What is nearer than this, compared with the edges beside it, is worth a warning. Rounded decimal
/// drawings miss by 1e-16 to 1e-7 of their size; the thinnest layers that are meant (1.2 nm on 1
/// mm) lie above.
constexpr double kNear = 1e-6;
constexpr std::size_t kMostWarnings = 50;

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

  /// Says how many more there are than were listed.
  void finish() {
    if (seen_.size() <= kMostWarnings) return;
    warn(fmt::format("{} more places where points or segments nearly touch",
                     seen_.size() - kMostWarnings),
         {});
  }

 private:
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
  misses.finish();
  return notes;
}

}  // namespace

void warn_of_near_misses(const Pslg& pslg, const Triangulation& triangulation, const Team& team,
                         std::vector<Note>& notes) {
  std::vector<Note> misses = find_near_misses(pslg, triangulation, team);
  if (!misses.empty()) misses[0].message += kRemedy;
  std::move(misses.begin(), misses.end(), std::back_inserter(notes));
}

std::string near_misses_behind(const Pslg& pslg, const Triangulation& triangulation) {
  const std::vector<Note> misses = find_near_misses(pslg, triangulation, Team());
  if (misses.empty()) return {};
  std::string out = "; " + misses[0].message;
  if (misses.size() > 1) {
    out += fmt::format(", and so at {}", counted(misses.size() - 1, "more place"));
  }
  return out + kRemedy;
}

}  // namespace cover
