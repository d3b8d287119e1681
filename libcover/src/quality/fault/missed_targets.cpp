// See missed_targets.hpp. Tested by tests/unit/quality/fault/missed_targets_test.cpp.
#include "quality/fault/missed_targets.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <cover/judged_angle.hpp>
#include <cover/text.hpp>

#include "cdt/cdt.hpp"
#include "geom/angle_rounding.hpp"

namespace cover {
namespace {

constexpr std::size_t kPlaces = 8;  ///< at most, per note
constexpr std::size_t kNamed = 3;   ///< of them in its text

Note missed(RegionId region, std::string message, std::vector<Point> where) {
  return {Note::Kind::target_missed, region, std::move(message), std::move(where)};
}

/// "N angles above 100 degrees remain", with the verb that N asks for.
std::string remaining(std::size_t count, std::string_view what, Angle limit) {
  return fmt::format("{} {} {:.6g} degrees {}", counted(count, "angle"), what, limit.in_degrees(),
                     count == 1 ? "remains" : "remain");
}

/// Segments whose own gamma_opt is above the target, worst first. A segment may be two sides.
void note_forced(const RegionBoundary& boundary, const AngleLimit& limit, Angle max,
                 std::vector<Note>& notes) {
  std::vector<std::size_t> forced;
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    if (!meets(Angle::radians(limit.side_nu[s]), max.supplement())) forced.push_back(s);
  }
  if (forced.empty()) return;
  std::stable_sort(forced.begin(), forced.end(), [&](std::size_t a, std::size_t b) {
    return limit.side_nu[a] < limit.side_nu[b];
  });
  std::set<SegmentId> segments;
  std::vector<Point> where;
  std::string ends;
  for (const std::size_t s : forced) {
    if (!segments.insert(boundary.segments[s]).second || segments.size() > kPlaces) continue;
    const Point a = boundary.points[boundary.sides[s][0]];
    const Point b = boundary.points[boundary.sides[s][1]];
    where.push_back(a);
    if (segments.size() > kNamed) continue;
    ends += fmt::format("{}from {} to {}", ends.empty() ? "" : ", ", describe(a), describe(b));
  }
  notes.push_back(missed(
      boundary.id,
      fmt::format(
          "region {}: the input forces an angle above {:.6g} degrees, up to {:.6g}, at {}: "
          "{}{}",
          boundary.id.value(), max.in_degrees(), Angle::radians(limit.nu).supplement().in_degrees(),
          counted(segments.size(), "segment"), ends, segments.size() > kNamed ? ", ..." : ""),
      std::move(where)));
}

/// In the plane, where rounding is that of the coordinates that are written.
bool is_obtuse(const MutableMesh& mesh, std::uint32_t t, Point origin) {
  const auto corner = [&](Corner i) {
    const Point p = mesh.corner(t, i);
    return Point{p.x + origin.x, p.y + origin.y};
  };
  return bluntness_of(corner(0), corner(1), corner(2)) == Blunt::yes;
}

/// Angles, and the first places where they are.
struct CountedAngles {
  std::size_t count = 0;
  std::vector<Point> where;

  void add(Point at) {
    ++count;
    if (where.size() < kPlaces) where.push_back(at);
  }
  void add(const CountedAngles& later) {
    count += later.count;
    const std::size_t more = std::min(later.where.size(), kPlaces - where.size());
    where.insert(where.end(), later.where.begin(),
                 later.where.begin() + static_cast<std::ptrdiff_t>(more));
  }
};

/// What some triangles miss.
struct MissedAngles {
  CountedAngles large, small;
  CountedAngles forced;  ///< small ones

  void look_at(const MutableMesh& mesh, std::uint32_t t, const Options& options,
               const MeshHistory& history) {
    const Point origin = history.origin;
    if (mesh.is_hole(t)) return;
    const Goal& goal = mesh.goal();
    const SideAllowances sides = mesh.allowances_beside(mesh.triangles[t].n);
    const double allowed = allowed_small(sides);
    if (mesh.excess[t] <= 0 && allowed == 0) return;
    const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    for (const Corner i : kCorners) {
      const Point in_frame = mesh.points[mesh.triangles[t].v[i]];
      const Point at{in_frame.x + origin.x, in_frame.y + origin.y};
      const double cot = k.dot[i] / k.cross;
      if (-cot > wanted_large(goal, sides[i]) + kSameCot &&
          (options.max_angle != Angle::degrees(90) || is_obtuse(mesh, t, origin)))
        large.add(at);
      if (goal.weight == 0 || t < history.layer_triangles || is_between_sides(sides, i) ||
          !is_sharper(cot, goal.small))
        continue;
      // Where sides force it, no triangle on that side is without such an angle.
      (allowed > 0 ? forced : small).add(at);
    }
  }
};

std::string reason_of(Unreached why) {
  switch (why) {
    case Unreached::unknown:
      break;
    case Unreached::budget:
      return ", not known to be forced (the budget of the region was used up)";
    case Unreached::couplings:
      return ", which couplings force: a vertex inside, wherever it is, makes that of a side "
             "negative "
             "(--couplings last puts angles first)";
  }
  return ", not known to be forced";
}

}  // namespace

std::vector<Note> missed_targets(const MutableMesh& mesh, const RegionBoundary& boundary,
                                 const Options& options, const MeshHistory& history,
                                 const Team& team) {
  std::vector<Note> notes;
  note_forced(boundary, history.limit, options.max_angle, notes);
  std::vector<MissedAngles> parts(Team::ranges(mesh.triangles.size(), kManyAtATime));
  team.each_range(mesh.triangles.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t)
      parts[first / kManyAtATime].look_at(mesh, static_cast<std::uint32_t>(t), options, history);
  });
  MissedAngles all;
  for (const MissedAngles& part : parts) {
    all.large.add(part.large);
    all.small.add(part.small);
    all.forced.add(part.forced);
  }
  const std::size_t large = all.large.count, small = all.small.count;
  const std::size_t forced_small = all.forced.count;
  const std::string why = reason_of(history.why);
  const std::string region = fmt::format("region {}: ", boundary.id.value());
  if (large > 0) {
    notes.push_back(missed(boundary.id, region + remaining(large, "above", options.max_angle) + why,
                           std::move(all.large.where)));
  }
  if (small > 0) {
    const std::string also = forced_small > 0
                                 ? fmt::format(", beside {} that sides force", forced_small)
                                 : std::string();
    notes.push_back(missed(boundary.id,
                           region + remaining(small, "below", options.min_angle) + why + also,
                           std::move(all.small.where)));
  } else if (forced_small > 0) {
    notes.push_back(
        missed(boundary.id,
               fmt::format("{}sides near each other force {} below {:.6g} degrees", region,
                           counted(forced_small, "angle"), options.min_angle.in_degrees()),
               std::move(all.forced.where)));
  }
  return notes;
}

}  // namespace cover
