// See missed_targets.hpp. Tested by tests/unit/quality/missed_targets_test.cpp.
#include "quality/missed_targets.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/describe.hpp"
#include "cdt/cdt.hpp"
#include "covering/measure.hpp"
#include "quality/with_neighbours.hpp"

namespace cover {
namespace {

constexpr std::size_t kPlaces = 8;  ///< at most, per note
constexpr double kRounding = 1e-9;  ///< in cotangents, and in radians

Note missed(RegionId region, std::string message, std::vector<Point> where) {
  return {Note::Kind::target_missed, region, std::move(message), std::move(where)};
}

/// Sides whose own gamma_opt is above the target.
void note_forced(const RegionBoundary& boundary, const AngleLimit& limit, Angle max,
                 std::vector<Note>& notes) {
  const double nu = max.supplement().in_radians() - kRounding;
  std::vector<std::size_t> forced;
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    if (limit.side_nu[s] < nu) forced.push_back(s);
  }
  if (forced.empty()) return;
  std::vector<Point> where;
  std::string segments;
  for (std::size_t k = 0; k < std::min(forced.size(), kPlaces); ++k) {
    where.push_back(boundary.points[boundary.sides[forced[k]][0]]);
    segments += fmt::format("{}{}", k == 0 ? "" : ", ", boundary.segments[forced[k]].value());
  }
  notes.push_back(missed(
      boundary.id,
      fmt::format(
          "region {}: the input forces an angle above {:.6g} degrees, up to {:.6g}, at {}: "
          "{}{}",
          boundary.id.value(), max.in_degrees(), Angle::radians(limit.nu).supplement().in_degrees(),
          counted(forced.size(), "segment"), segments, forced.size() > kPlaces ? ", ..." : ""),
      std::move(where)));
}

}  // namespace

std::vector<Note> missed_targets(const MutableMesh& mesh, const RegionBoundary& boundary,
                                 const AngleLimit& limit, const Options& options,
                                 bool budget_used_up, Point origin) {
  std::vector<Note> notes;
  note_forced(boundary, limit, options.max_angle, notes);
  std::size_t large = 0, small = 0;
  std::vector<Point> where_large, where_small;
  const Goal& goal = mesh.goal();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.is_hole(t)) continue;
    const auto& n = mesh.triangles[t].n;
    const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    for (std::size_t i = 0; i < 3; ++i) {
      const Point in_frame = mesh.points[mesh.triangles[t].v[i]];
      const Point at{in_frame.x + origin.x, in_frame.y + origin.y};
      const double cot = k.dot[i] / k.cross;
      const Allowance* side = mesh.allowance(n[i]);
      if (-cot > goal.large + (side != nullptr ? side->large : 0) + kRounding) {
        ++large;
        if (where_large.size() < kPlaces) where_large.push_back(at);
      }
      const bool of_the_input = is_side(n[(i + 1) % 3]) && is_side(n[(i + 2) % 3]);
      if (goal.weight > 0 && !of_the_input && cot > goal.small * (1 + kRounding)) {
        ++small;
        if (where_small.size() < kPlaces) where_small.push_back(at);
      }
    }
  }
  const std::string why = budget_used_up ? " (the budget of the region was used up)" : "";
  if (large > 0) {
    notes.push_back(
        missed(boundary.id,
               fmt::format("region {}: {} above {:.6g} degrees, not known to be forced, "
                           "remain{}",
                           boundary.id.value(), counted(large, "angle"),
                           options.max_angle.in_degrees(), why),
               std::move(where_large)));
  }
  if (small > 0) {
    notes.push_back(
        missed(boundary.id,
               fmt::format("region {}: {} below {:.6g} degrees remain{}", boundary.id.value(),
                           counted(small, "angle"), options.min_angle.in_degrees(), why),
               std::move(where_small)));
  }
  return notes;
}

void report_again(const RegionBoundary& boundary, const Options& options, bool budget_used_up,
                  RegionMesh& mesh) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
  const Triangulation all = with_neighbours(all_points(boundary, mesh), mesh.triangles);
  MutableMesh mutable_mesh(all, static_cast<std::uint32_t>(boundary.points.size()),
                           locate_sides(all, boundary.sides), side_limits(cdt, limit.at));
  mutable_mesh.set_goal(Goal::of(options.max_angle, options.min_angle));
  set_limits(limit, mesh.report);
  std::vector<Note>& notes = mesh.report.notes;
  std::erase_if(notes, [](const Note& note) { return note.kind == Note::Kind::target_missed; });
  const auto missed = missed_targets(mutable_mesh, boundary, limit, options, budget_used_up);
  notes.insert(notes.end(), missed.begin(), missed.end());
}

}  // namespace cover
