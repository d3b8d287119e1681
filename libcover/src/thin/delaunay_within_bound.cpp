// A triangulation without negative couplings on inner edges is the constrained Delaunay
// triangulation of its vertices, so vertices are all there is to choose.
// Tested by tests/unit/thin/delaunay_within_bound_test.cpp.
#include "thin/delaunay_within_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "target/measure.hpp"
#include "target/whole_mesh.hpp"
#include "thin/fewer_vertices.hpp"
#include "thin/mesh_with_undo.hpp"

namespace cover {
namespace {

constexpr double kSlack = 1 - 1e-9;  ///< of the cotangent of the largest angle
constexpr std::uint64_t kMostPlaces = 3'000'000;
constexpr std::uint32_t kOfRest = 0, kOfLayers = 1;  ///< in place of regions

ConformingMesh mutable_mesh(const RegionBoundary& boundary, const RegionMesh& mesh) {
  ConformingMesh out;
  out.points = all_points(boundary, mesh);
  out.line.assign(boundary.points.size(), ConformingMesh::kFixed);
  out.line.resize(boundary.points.size() + mesh.layer_vertices, ConformingMesh::kMayGo);
  out.line.resize(out.points.size(), ConformingMesh::kInside);
  for (const auto& [a, b] : boundary.sides) out.pieces.push_back({a, b, 0});
  out.triangles = mesh.triangles;
  out.region.assign(mesh.layer_triangles, kOfLayers);
  out.region.resize(mesh.triangles.size(), kOfRest);
  return out;
}

bool is_sound(const RegionReport& report) {
  return report.bound_held && report.box.negative_inside == 0;
}

}  // namespace

std::optional<MendedMesh> mend_couplings_within_bound(const RegionBoundary& boundary,
                                                      const RegionMesh& mesh, std::stop_token stop,
                                                      std::uint64_t for_sides) {
  if (is_sound(mesh.report) && mesh.report.box.negative_given_up == 0) return {};
  const auto& segments = boundary.segments;
  if (std::find(segments.begin(), segments.end(), kHullSide) != segments.end()) return {};
  const ConformingMesh before = mutable_mesh(boundary, mesh);
  const double least_cot = -kSlack / std::tan(mesh.report.nu_bound.in_radians());
  if (!(least_cot < 0)) return {};
  std::vector<WantedAngles> wanted(2, {0, least_cot, false});
  wanted[kOfLayers].closed = true;
  MeshWithUndo mending(before, std::move(wanted));
  const bool only_sides = is_sound(mesh.report) && mesh.layer_triangles == 0;
  mend_mesh(mending, {0, 0, only_sides ? for_sides : kPlacesToMend, kMostPlaces, std::move(stop)});
  if (mending.grave() > 0) return {};
  MendedMesh out;
  const std::size_t own = boundary.points.size();
  for (std::size_t k = 0; k < mesh.layer_vertices; ++k) {
    if (!mending.is_there(static_cast<std::uint32_t>(own + k)))
      out.gone.push_back(static_cast<std::uint32_t>(k));
  }
  const ConformingMesh after = mending.result(before);
  out.mesh.report = mesh.report;
  out.mesh.layer_vertices = mesh.layer_vertices - out.gone.size();
  out.mesh.steiner.assign(after.points.begin() + static_cast<std::ptrdiff_t>(own),
                          after.points.end());
  for (const std::uint32_t part : {kOfLayers, kOfRest}) {
    for (std::size_t t = 0; t < after.triangles.size(); ++t) {
      if (after.region[t] == part) out.mesh.triangles.push_back(after.triangles[t]);
    }
    if (part == kOfLayers) out.mesh.layer_triangles = out.mesh.triangles.size();
  }
  if (find_fault({after.points, out.mesh.triangles, boundary.sides, segments, own})) return {};
  measure(boundary, out.mesh);
  const std::size_t given_up = out.mesh.report.box.negative_given_up;
  if (!is_sound(out.mesh.report) ||
      (is_sound(mesh.report) && given_up >= mesh.report.box.negative_given_up))
    return {};
  return out;
}

}  // namespace cover
