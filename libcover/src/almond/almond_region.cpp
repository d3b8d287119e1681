// The stages of one region: its constrained Delaunay triangulation, which may do as it is; else
// the almond method, in coordinates relative to the region, checked in those of the input.
// Tested by tests/unit/almond/almond_region_test.cpp.
#include "almond/almond_region.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "almond/almond_method.hpp"
#include "almond/fill/fill_refine.hpp"
#include "cdt/region_cdt.hpp"
#include "disks/fill_disks.hpp"
#include "geom/predicates.hpp"
#include "target/angle_limit.hpp"
#include "target/local_frame.hpp"
#include "target/report/fill_report.hpp"

namespace cover {
namespace {

/// The fill asked for, then the other, then refinement with ten times the budget.
FillPlan make_plan(const Options& options) {
  FillPlan plan;
  plan.refine_first = options.fill == Fill::refine;
  plan.fillers.push_back(make_disk_filler({.removes_spare_vertices = !options.paper}));
  plan.names.emplace_back("disks");
  plan.fillers.push_back(make_refine_filler(10));
  plan.names.emplace_back("refine with ten times the budget");
  return plan;
}

class AlmondRegion {
 public:
  AlmondRegion(const RegionBoundary& boundary, const Options& options, std::stop_token stop,
               const Team& team)
      : boundary_(boundary),
        options_(options),
        stop_(std::move(stop)),
        team_(team),
        frame_(boundary.points) {}

  RegionMesh run() {
    triangulate();
    describe_limit();
    if (is_good_enough()) {
      keep_cdt();
      return std::move(mesh_);
    }
    mesh_.report.method = "almond";
    if (!cover() && frame_.is_shifted()) {
      // Rounding the shifted coordinates turned a triangle over: work where they are rounded.
      frame_.undo(boundary_.points);
      triangulate();
      cover();
    }
    return std::move(mesh_);
  }

 private:
  void triangulate() {
    cdt_ = triangulate_in_order(frame_.take_points(), boundary_.sides, boundary_.known_triangles(),
                                team_);
    limit_ = angle_limit(cdt_, boundary_.sides, boundary_.segments, team_);
  }

  void describe_limit() {
    mesh_.report.id = boundary_.id;
    set_bound(limit_, mesh_.report);
  }

  /// A region of one triangle is as good as it gets, if it may not be split; else the improvement
  /// over the paper: a triangulation that keeps the bound needs no Steiner vertex.
  [[nodiscard]] bool is_good_enough() const {
    if (cdt_.triangles.size() == 1 && !boundary_.has_hull_sides()) return true;
    if (options_.paper) return false;
    const double nu = limit_.promised_nu();
    return std::all_of(cdt_.triangles.begin(), cdt_.triangles.end(), [&](const Triangle& f) {
      const Point a = cdt_.points[f.v[0]], b = cdt_.points[f.v[1]], c = cdt_.points[f.v[2]];
      return std::min(
                 {accurate_nu_at(a, b, c), accurate_nu_at(b, c, a), accurate_nu_at(c, a, b)}) >= nu;
    });
  }

  void keep_cdt() {
    mesh_.report.method = "cdt";
    mesh_.triangles.reserve(cdt_.triangles.size());
    for (const Triangle& f : cdt_.triangles) mesh_.triangles.push_back(f.v);
  }

  /// The almond method; false if a triangle is not counter-clockwise in the region's coordinates.
  bool cover() {
    const CutRule rule{options_.paper, options_.pieces, limit_.promised_nu(), frame_.rounding()};
    // Disk packing puts vertices on every chord, so it needs almonds before every side.
    const bool sparing = !options_.paper && options_.fill == Fill::refine;
    AlmondMesh almonds = mesh_by_almonds(
        {cdt_, boundary_.sides, boundary_.segments, limit_, frame_.origin(), sparing, team_}, rule,
        make_plan(options_), stop_);
    const std::size_t inputs = boundary_.points.size();
    mesh_.steiner.clear();
    for (std::size_t v = inputs; v < almonds.points.size(); ++v) {
      mesh_.steiner.push_back(frame_.restore(almonds.points[v]));
    }
    mesh_.triangles = std::move(almonds.triangles);
    mesh_.report.notes.clear();
    for (const SideRemark& remark : almonds.remarks) add_note(remark);
    for (const auto& fallback : almonds.fallbacks) add_note(fallback);
    return !frame_.is_shifted() || is_counter_clockwise();
  }

  [[nodiscard]] Point point(std::uint32_t v) const {
    const std::size_t inputs = boundary_.points.size();
    return v < inputs ? boundary_.points[v] : mesh_.steiner[v - inputs];
  }

  [[nodiscard]] bool is_counter_clockwise() const {
    return std::all_of(mesh_.triangles.begin(), mesh_.triangles.end(), [&](const auto& t) {
      return orientation(point(t[0]), point(t[1]), point(t[2])) == Sign::positive;
    });
  }

  void add_note(const SideRemark& remark) {
    const auto& [u, v] = boundary_.sides[remark.side];
    const Point a = boundary_.points[u], b = boundary_.points[v];
    const Triangle& f = cdt_.triangles[limit_.at[remark.side].triangle];
    const Point apex = boundary_.points[f.v[limit_.at[remark.side].edge]];
    mesh_.report.notes.push_back(
        {remark.kind,
         boundary_.id,
         fmt::format(
             "region {}: the almond of the segment from ({}, {}) to ({}, {}), seen by ({}, {}), {}",
             boundary_.id.value(), a.x, a.y, b.x, b.y, apex.x, apex.y, remark.what),
         {a, b, apex}});
  }

  void add_note(const FilledRemainder::Fallback& fallback) {
    const Point at = frame_.restore(fallback.at);
    mesh_.report.notes.push_back(
        {Note::Kind::fallback,
         boundary_.id,
         fmt::format("region {}: the fill fell short near ({}, {}); \"{}\" was used instead{}",
                     boundary_.id.value(), at.x, at.y, fallback.filler,
                     fallback.held ? "" : " and fell short, too"),
         {at}});
  }

  const RegionBoundary& boundary_;
  const Options& options_;
  std::stop_token stop_;
  const Team& team_;
  LocalFrame frame_;
  Triangulation cdt_;
  AngleLimit limit_;
  RegionMesh mesh_;
};

}  // namespace

RegionMesh almond_region(const RegionBoundary& boundary, const Options& options,
                         std::stop_token stop, const Team& team) {
  return AlmondRegion(boundary, options, std::move(stop), team).run();
}

}  // namespace cover
