// Several threads judge a large mesh: one looks for flaws while others measure it, and make what
// its limits will need.
// Tested by tests/unit/method/mesh_one_region_test.cpp.
#include "method/judged_attempt.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "method/proven_limits.hpp"
#include "target/report/fill_report.hpp"

namespace cover {
namespace {

/// From so many on, several threads judge a mesh: some tenths of a second of work.
constexpr std::size_t kManyToJudge = 100'000;

}  // namespace

Attempt judged(ProvenMesh made, const RegionBoundary& boundary, const std::stop_token& stop,
               const Team& team) {
  Attempt out{std::move(made)};
  if (stop.stop_requested()) return out;
  RegionMesh& mesh = out.mesh;
  const std::vector<Point> points = all_points(boundary, mesh);
  // What the limits will need, meanwhile: it takes no longer than that by itself.
  const auto& notes = mesh.report.notes;
  const bool looks_ahead =
      !out.proof && team.workers() > 1 && mesh.triangles.size() >= kManyToJudge &&
      std::any_of(notes.begin(), notes.end(),
                  [](const Note& note) { return note.kind == Note::Kind::target_missed; });
  // Large meshes are measured meanwhile, too, and once more if they are flawed.
  const bool measures_ahead = team.workers() > 1 && mesh.triangles.size() >= kManyToJudge;
  std::vector<std::uint32_t> across;
  const RegionReport unmeasured = measures_ahead ? mesh.report : RegionReport();
  team.each(looks_ahead      ? 3
            : measures_ahead ? 2
                             : 1,
            [&](std::size_t k) {
              if (k == 2) {
                out.proof = proof_of(boundary);
              } else if (k == 1) {
                fill_report(boundary, mesh, team);
              } else {
                out.flaw = find_flaw({points, mesh.triangles, boundary.sides, boundary.segments,
                                      boundary.points.size()},
                                     team, measures_ahead ? nullptr : &across);
              }
            });
  if (out.flaw) {
    mesh.steiner.clear();
    mesh.triangles.clear();
    across.clear();
    if (measures_ahead) mesh.report = unmeasured;
  }
  if (out.flaw || !measures_ahead) fill_report(boundary, mesh, team, std::move(across));
  return out;
}

}  // namespace cover
