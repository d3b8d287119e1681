// It is rounding that makes both methods miss: the almond method in a region as flat as coordinates
// can be, the quality method where an improved triangle lies just inside the bound in the frame in
// which it was improved.
// Tested by tests/unit/method/mesh_one_region_test.cpp.
#include "method/method_with_fallback.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "almond/almond_region.hpp"
#include "almond/chords.hpp"
#include "base/faults/internal_fault.hpp"
#include "cdt/region_cdt.hpp"
#include "method/judged_attempt.hpp"
#include "region/triangulation_of.hpp"
#include "target/angle_limit.hpp"
#include "target/report/fill_report.hpp"

namespace cover {
namespace {

using RegionMethod = ProvenMesh (*)(const RegionBoundary&, const Options&, const std::stop_token&,
                                    const Team&);

Attempt attempt(RegionMethod method, const RegionBoundary& boundary, const Options& options,
                const std::stop_token& stop, const Team& team) {
  return judged(method(boundary, options, stop, team), boundary, stop, team);
}

ProvenMesh by_quality(const RegionBoundary& boundary, const Options& options,
                      const std::stop_token& stop, const Team& team) {
  return quality_region(boundary, options, stop, {team});
}

ProvenMesh by_almonds(const RegionBoundary& boundary, const Options& options,
                      const std::stop_token& stop, const Team& team) {
  return {almond_region(boundary, options, stop, team)};
}

/// The constrained Delaunay triangulation, which no rounding can break.
ProvenMesh plain_region(const RegionBoundary& boundary, const Options&, const std::stop_token&,
                        const Team& team) {
  const Triangulation cdt = triangulation_of(boundary, team);
  RegionMesh mesh;
  mesh.report.id = boundary.id;
  mesh.report.method = "cdt";
  set_bound(angle_limit(cdt, boundary.sides, boundary.segments), mesh.report);
  mesh.triangles.reserve(cdt.triangles.size());
  for (const Triangle& t : cdt.triangles) mesh.triangles.push_back(t.v);
  return {std::move(mesh)};
}

/// What became of a method that was not used.
Note note_of_fallback(const RegionBoundary& boundary, const Attempt& attempt, std::string_view from,
                      std::string_view to) {
  const RegionReport& report = attempt.mesh.report;
  std::string what = attempt.flaw
                         ? "broke the mesh (" + attempt.flaw->what + ")"
                         : fmt::format("put an angle of {:.12g} degrees beyond the bound",
                                       report.quality.largest_nu.supplement().in_degrees());
  return {Note::Kind::fallback, boundary.id,
          fmt::format("region {}: with the {} method, rounding {}; the {} was used instead",
                      boundary.id.value(), from, what, to),
          attempt.flaw ? attempt.flaw->where : std::vector<Point>{}};
}

}  // namespace

ProvenMesh method_with_fallback(const RegionBoundary& boundary, const Options& options,
                                const std::stop_token& stop, const Team& team) {
  const bool quality = options.method == Method::quality;
  const std::string_view asked = quality ? "quality" : "almond";
  const std::string_view second = quality ? "almond" : "quality";
  Attempt first = attempt(quality ? by_quality : by_almonds, boundary, options, stop, team);
  const bool promised = CutRule{options.paper, options.pieces}.promises_bound();
  const bool will_do =
      !first.flaw && (first.mesh.report.bound_held || !promised || boundary.is_rest);
  if (stop.stop_requested() || will_do) return first;
  const auto by_the_other = [&]() -> ProvenMesh {
    if (!quality) return quality_region(boundary, options, stop, {team}, first.mesh);
    if (first.almonds) return {*std::exchange(first.almonds, std::nullopt)};
    return by_almonds(boundary, options, stop, team);
  };
  Attempt other = judged(by_the_other(), boundary, stop, team);
  other.proof = std::move(first.proof);
  if (stop.stop_requested()) return other;
  if (first.flaw && other.flaw) {
    Attempt plain = attempt(plain_region, boundary, options, stop, team);
    if (plain.flaw) throw InternalFault(plain.flaw->what, std::move(plain.flaw->where));
    plain.mesh.report.notes.push_back(
        note_of_fallback(boundary, first, asked, "constrained Delaunay triangulation"));
    plain.mesh.report.notes.push_back(
        note_of_fallback(boundary, other, second, "constrained Delaunay triangulation"));
    plain.proof = std::move(other.proof);
    return plain;
  }
  if (!first.flaw && (other.flaw || other.mesh.report.quality.largest_nu <=
                                        first.mesh.report.quality.largest_nu)) {
    first.proof = std::move(other.proof);
    return first;
  }
  other.mesh.report.notes.push_back(
      note_of_fallback(boundary, first, asked, fmt::format("{} method", second)));
  return other;
}

}  // namespace cover
