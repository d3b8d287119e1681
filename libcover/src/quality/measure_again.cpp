// See measure_again.hpp. Tested by tests/unit/quality/measure_again_test.cpp.
#include "quality/measure_again.hpp"

#include <algorithm>
#include <vector>

#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"
#include "quality/fault/missed_targets.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "region/triangulation_of.hpp"
#include "target/angle_limit.hpp"
#include "target/goal.hpp"
#include "target/report/fill_report.hpp"
#include "target/side_limit.hpp"

namespace cover {

void report_again(const RegionBoundary& boundary, const Options& options, Unreached why,
                  RegionMesh& mesh) {
  const Triangulation cdt = triangulation_of(boundary);
  const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
  const Triangulation all = with_neighbours(all_points(boundary, mesh), mesh.triangles);
  MutableMesh mutable_mesh(all, static_cast<std::uint32_t>(boundary.points.size()),
                           locate_sides(all, boundary.sides), side_limits(cdt, limit.at));
  mutable_mesh.set_goal(Goal::of(options.max_angle, options.min_angle));
  set_bound(limit, mesh.report);
  std::vector<Note>& notes = mesh.report.notes;
  std::erase_if(notes, [](const Note& note) { return note.kind == Note::Kind::target_missed; });
  const auto missed =
      missed_targets(mutable_mesh, boundary, options, {limit, why, {}, mesh.layer_triangles});
  notes.insert(notes.end(), missed.begin(), missed.end());
}

void measure_again(const RegionBoundary& boundary, const Options& options, Unreached why,
                   RegionMesh& mesh) {
  report_again(boundary, options, why, mesh);
  fill_report(boundary, mesh);
}

}  // namespace cover
