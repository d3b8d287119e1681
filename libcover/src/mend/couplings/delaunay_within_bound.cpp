// A triangulation without negative couplings on inner edges is the constrained Delaunay
// triangulation of its vertices, so vertices are all there is to choose.
// Tested by tests/unit/mend/couplings/delaunay_within_bound_test.cpp.
#include "mend/couplings/delaunay_within_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/containers/order.hpp"
#include "box/encroached_sides.hpp"
#include "cdt/cdt.hpp"
#include "geom/predicates.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "limits/couplings/half_disc_room.hpp"
#include "mend/couplings/fill_room.hpp"
#include "mend/effort.hpp"
#include "mend/mend_mesh.hpp"
#include "mend/mesh_with_undo.hpp"
#include "region/whole_mesh.hpp"
#include "target/report/fill_report.hpp"

namespace cover {
namespace {

constexpr double kSlack = 1 - 1e-9;                  ///< of the cotangent of the largest angle
constexpr std::uint32_t kOfRest = 0, kOfLayers = 1;  ///< in place of regions

JoinedMesh joined_mesh_of(const RegionBoundary& boundary, const RegionMesh& mesh) {
  JoinedMesh out;
  out.points = all_points(boundary, mesh);
  out.line.assign(boundary.points.size(), JoinedMesh::kFixed);
  out.line.resize(boundary.points.size() + mesh.layer_vertices, JoinedMesh::kMayGo);
  out.line.resize(out.points.size(), JoinedMesh::kInside);
  for (const auto& [a, b] : boundary.sides) out.pieces.push_back({a, b, 0});
  out.triangles = mesh.triangles;
  out.region.assign(mesh.layer_triangles, kOfLayers);
  out.region.resize(mesh.triangles.size(), kOfRest);
  return out;
}

bool is_sound(const RegionReport& report) {
  return report.bound_held && report.box.negative_inside == 0;
}

/// What is asked of angles; nothing where the bound is none for obtuse ones.
std::optional<std::vector<WantedAngles>> wanted_angles(const RegionMesh& mesh) {
  const double least_cot = -kSlack / std::tan(mesh.report.nu_bound.in_radians());
  if (!(least_cot < 0)) return {};
  std::vector<WantedAngles> wanted(2, {0, least_cot, false});
  wanted[kOfLayers].closed = true;
  return wanted;
}

/// What has become of `mesh`, if it is better: see mend_couplings_within_bound().
std::optional<RegionMesh> taken_if_better(const RegionBoundary& boundary, const RegionMesh& mesh,
                                          const JoinedMesh& before, const MeshWithUndo& mending) {
  RegionMesh out;
  const std::size_t own = boundary.points.size();
  for (std::size_t k = 0; k < mesh.layer_vertices; ++k)
    out.layer_vertices += mending.is_there(static_cast<std::uint32_t>(own + k)) ? 1 : 0;
  const JoinedMesh after = mending.result(before);
  out.report = mesh.report;
  out.steiner.assign(after.points.begin() + static_cast<std::ptrdiff_t>(own), after.points.end());
  for (const std::uint32_t part : {kOfLayers, kOfRest}) {
    for (std::size_t t = 0; t < after.triangles.size(); ++t) {
      if (after.region[t] == part) out.triangles.push_back(after.triangles[t]);
    }
    if (part == kOfLayers) out.layer_triangles = out.triangles.size();
  }
  if (find_flaw({after.points, out.triangles, boundary.sides, boundary.segments, own})) return {};
  fill_report(boundary, out);
  const std::size_t given_up = out.report.box.negative_given_up;
  if (!is_sound(out.report) ||
      (is_sound(mesh.report) && given_up >= mesh.report.box.negative_given_up))
    return {};
  return out;
}

/// How many places are tried at most. In a region that is as narrow as rounding makes one, exact
/// arithmetic decides every one of them.
std::uint64_t most_places(const RegionBoundary& boundary) {
  const Point origin = boundary.points.front();
  double doubled_area = 0, around = 0;
  for (const auto& [a, b] : boundary.sides) {
    const Point p = boundary.points[a], q = boundary.points[b];
    doubled_area += cross(p - origin, q - origin);
    around += length(q - p);
  }
  const double narrow = effort::mend::kNarrow * spacing_of(boundary.points);
  return doubled_area <= narrow * around ? effort::mend::kMostPlacesWhereNarrow
                                         : effort::mend::kMostPlaces;
}

/// Vertices moved, added and taken away near what is wrong.
std::optional<RegionMesh> mend_nearby(const RegionBoundary& boundary, const RegionMesh& mesh,
                                      const std::stop_token& stop, const CouplingEffort& effort) {
  std::optional<std::vector<WantedAngles>> wanted = wanted_angles(mesh);
  if (!wanted) return {};
  const JoinedMesh before = joined_mesh_of(boundary, mesh);
  MeshWithUndo mending(before, *std::move(wanted));
  const std::uint64_t for_sides =
      mesh.layer_triangles == 0 ? effort.places_per_side : effort.places_per_angle;
  mend_mesh(mending, {effort.places_per_angle, most_places(boundary), stop}, for_sides);
  if (mending.grave() > 0) return {};
  return taken_if_better(boundary, mesh, before, mending);
}

/// By side: whether no vertex of the boundary encroaches it.
std::vector<bool> free_sides_of(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  return free_sides(cdt, locate_sides(cdt, boundary.sides));
}

/// The vertices inside that see a free side at more than a right angle, as far as they are next to
/// it.
std::vector<std::uint32_t> encroaching(const MeshWithUndo& mesh, const RegionBoundary& boundary,
                                       const std::vector<bool>& is_free) {
  std::vector<std::uint32_t> found;
  for (const MeshWithUndo::Triangle& t : mesh.triangles()) {
    if (t.v[0] == kNone || t.cost == 0) continue;
    for (const Corner i : kCorners) {
      if (t.line[i] == JoinedMesh::kInside || !mesh.is_movable(t.v[i])) continue;
      const IndexPair edge{t.v[i.next()], t.v[i.previous()]};
      const auto side = std::lower_bound(boundary.sides.begin(), boundary.sides.end(), edge);
      const bool is_side = side != boundary.sides.end() && *side == edge;
      if (is_side && is_free[static_cast<std::size_t>(side - boundary.sides.begin())] &&
          compare_with_90_degrees(mesh.at(edge[0]), mesh.at(t.v[i]), mesh.at(edge[1])) ==
              Sign::positive)
        found.push_back(t.v[i]);
    }
  }
  sort_unique(found);
  return found;
}

/// Takes away what encroaches free sides, or all vertices inside, and puts others where that leaves
/// angles beyond the bound.
std::optional<RegionMesh> mend_with_room(const RegionBoundary& boundary, const RegionMesh& mesh,
                                         int most_circles, const std::stop_token& stop) {
  std::optional<std::vector<WantedAngles>> wanted = wanted_angles(mesh);
  if (!wanted || mesh.layer_vertices > 0 || boundary.sides.size() > effort::mend::kFewSides ||
      mesh.report.box.negative_given_up > effort::mend::kFewGivenUp)
    return {};
  const std::vector<bool> is_free = free_sides_of(boundary);
  const HalfDiscRoom room(boundary.points, boundary.sides, is_free);
  const JoinedMesh before = joined_mesh_of(boundary, mesh);
  const MeshWithUndo start(before, *std::move(wanted));
  for (const bool all : {false, true}) {
    if (all && boundary.points.size() > effort::mend::kSmallRegion) break;
    MeshWithUndo mending = start;
    std::vector<std::uint32_t> gone;
    if (all) {
      for (auto v = static_cast<std::uint32_t>(boundary.points.size()); v < before.points.size();
           ++v)
        gone.push_back(v);
    } else {
      gone = encroaching(mending, boundary, is_free);
    }
    bool went = true;
    while (!gone.empty() && went) {
      for (const std::uint32_t v : gone) went = went && mending.remove(v);
      gone = encroaching(mending, boundary, is_free);
    }
    if (!went || !fill_room(mending, room, 0, most_circles, stop)) continue;
    std::optional<RegionMesh> mended = taken_if_better(boundary, mesh, before, mending);
    if (mended) return mended;
  }
  return {};
}

}  // namespace

std::optional<RegionMesh> mend_couplings_within_bound(const RegionBoundary& boundary,
                                                      const RegionMesh& mesh,
                                                      const std::stop_token& stop,
                                                      const CouplingEffort& effort) {
  if (is_sound(mesh.report) && mesh.report.box.negative_given_up == 0) return {};
  if (boundary.has_hull_sides()) return {};
  std::optional<RegionMesh> mended;
  const auto now = [&]() -> const RegionMesh& { return mended ? *mended : mesh; };
  const auto is_done = [&] {
    return is_sound(now().report) && now().report.box.negative_given_up == 0;
  };
  const auto take = [&](std::optional<RegionMesh> more) {
    if (more) mended = std::move(more);
  };
  // Few places first, then room, which is looked for in order; many places are the last resort.
  const bool may_be_short = effort.circles_with_room > 0 && mesh.layer_vertices == 0;
  CouplingEffort first = effort;
  if (may_be_short)
    first.places_per_side = std::min(effort.places_per_side, CouplingEffort::kFewPlaces);
  take(mend_nearby(boundary, mesh, stop, first));
  if (is_done() || effort.circles_with_room == 0 || !is_sound(now().report)) return mended;
  take(mend_with_room(boundary, now(), effort.circles_with_room, stop));
  if (is_done() || first.places_per_side == effort.places_per_side) return mended;
  take(mend_nearby(boundary, now(), stop, effort));
  return mended;
}

}  // namespace cover
