// See fill_report.hpp.
#include "target/report/fill_report.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "geom/topology/half_edges.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "target/report/flat_on_hull.hpp"
#include "target/report/holds_bound.hpp"
#include "target/report/measure_angles.hpp"
#include "target/report/measure_boxes.hpp"
#include "target/report/sorted_corners.hpp"
#include "target/report/tell_couplings.hpp"

namespace cover {
namespace {

/// Spacings of doubles: a triangle that is no higher than that cannot be divided.
constexpr double kNoRoom = 64;

/// The triangle with the largest angle.
IndexTriple worst_triangle(std::span<const Point> points, std::span<const IndexTriple> triangles) {
  const auto nu = [&](const IndexTriple& t) {
    return largest_nu_of(points[t[0]], points[t[1]], points[t[2]]);
  };
  return *std::min_element(triangles.begin(), triangles.end(),
                           [&](const auto& s, const auto& t) { return nu(s) < nu(t); });
}

Note bound_missed(const RegionReport& report, std::span<const Point> points, IndexTriple worst) {
  const Point a = points[worst[0]], b = points[worst[1]], c = points[worst[2]];
  const SortedCorners s = sort_corners(a, b, c);
  const double height = std::abs(cross(s.p - s.apex, s.q - s.apex)) / length(s.q - s.p);
  const double spacing = spacing_at(largest_coordinate(points));
  std::string why;
  if (height < kNoRoom * spacing) {
    why = fmt::format(
        ": it is {:.2g} high where doubles are {:.2g} apart, which leaves no room for a vertex "
        "beside it (--weld joins points so near to each other)",
        height, spacing);
  }
  return {Note::Kind::bound_missed,
          report.id,
          fmt::format("region {}: the triangle ({}, {}), ({}, {}), ({}, {}) has an angle of {:.9g} "
                      "degrees; the bound is {:.9g}{}",
                      report.id.value(), a.x, a.y, b.x, b.y, c.x, c.y,
                      report.quality.largest_nu.supplement().in_degrees(),
                      report.nu_bound.supplement().in_degrees(), why),
          {a, b, c}};
}

}  // namespace

void set_bound(const AngleLimit& limit, RegionReport& report) {
  report.nu_opt = Angle::radians(limit.nu);
  report.nu_bound = Angle::radians(limit.promised_nu());
  report.forced_above_120 = limit.above_120;
  report.forced_above_150 = limit.above_150;
}

void fill_report(const RegionBoundary& boundary, RegionMesh& mesh, const Team& team,
                 std::vector<std::uint32_t> across) {
  const std::vector<Point> points = all_points(boundary, mesh);
  RegionReport& report = mesh.report;
  team.each(2, [&](std::size_t k) {
    if (k == 1) {
      report.quality = measure_angles(points, mesh.triangles, team);
      return;
    }
    const Opposites opposites =
        opposites_of(points, mesh.triangles, boundary.sides, team, std::move(across));
    report.box = measure_boxes(points, mesh.triangles, opposites, team);
    report.couplings = tell_couplings(boundary, mesh, points, opposites, team, report.box);
  });
  report.input_vertices = boundary.points.size();
  report.steiner_vertices = mesh.steiner.size();
  report.bound_held =
      !mesh.triangles.empty() && (report.quality.largest_nu >= report.nu_bound ||
                                  holds_bound(points, mesh.triangles, report.nu_bound));
  // What was missed before something was mended is missed no more.
  std::erase_if(report.notes, [](const Note& n) { return n.kind == Note::Kind::bound_missed; });
  if (!report.bound_held && !mesh.triangles.empty()) {
    Note note = bound_missed(report, points, worst_triangle(points, mesh.triangles));
    const auto others = without_flat_on_hull(boundary, points, mesh.triangles);
    if (others.size() < mesh.triangles.size() && holds_bound(points, others, report.nu_bound))
      note.kind = Note::Kind::below_resolution;
    report.notes.push_back(std::move(note));
  }
}

}  // namespace cover
