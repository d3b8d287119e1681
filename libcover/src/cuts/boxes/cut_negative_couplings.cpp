// A mesh keeps a negative coupling on a side only where the bound or a target needs a vertex in its
// diametral disk. Cut at the foot of that vertex, the side has two smaller disks without it.
#include "cuts/boxes/cut_negative_couplings.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "cdt/cdt.hpp"
#include "cdt/couplings.hpp"
#include "cdt/region_cdt.hpp"
#include "cuts/before_meshing/onto_arcs.hpp"
#include "cuts/boxes/cut_encroached.hpp"
#include "cuts/boxes/cut_for_boxes.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/look_budget.hpp"
#include "cuts/periodic/mirror_cuts.hpp"
#include "cuts/room_on_segment.hpp"
#include "cuts/whole_segments.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "method/boundaries_with_wishes.hpp"
#include "quality/measure_again.hpp"
#include "region/region_graph.hpp"
#include "tasks/errors_as_values.hpp"

namespace cover {
namespace {

/// Rounds that cut and mesh again, each with the points that the one before it left; they end by
/// themselves where no side with a negative coupling has room for a cut.
constexpr int kCouplingRounds = 24;
/// Of a side: a cut nearer to its ends goes to the middle instead.
constexpr double kNearEnd = 0.1;
constexpr std::size_t kCouplingsTold = 8;

/// A side with a negative coupling.
struct NegativeSide {
  SegmentId segment;
  Point apex;
};

/// Cuts, and by segment the vertex that saw it at too large an angle.
struct ChosenCuts {
  std::vector<SegmentCut> cuts;
  std::map<SegmentId, Point> by;
};

/// What is cut and meshed, in step.
class CouplingRounds {
 public:
  CouplingRounds(Work& work, const Options& options, const Callbacks& callbacks)
      : work_(work), options_(options), callbacks_(callbacks) {}

  Status run() {
    for (std::size_t r = 0; r < work_.meshes.size(); ++r) flip(r);
    const std::size_t most = most_points_for_boxes(work_.pslg, work_.report.box_cuts);
    for (int round = 0; round < kCouplingRounds && work_.pslg.points.size() <= most; ++round) {
      const ChosenCuts chosen = choose();
      if (chosen.cuts.empty()) break;
      const Pslg pslg = work_.pslg;
      const RegionTable table = work_.table;
      const std::vector<BoxCut> box_cuts = work_.report.box_cuts;
      if (Status status = cut_and_mesh(chosen); !status) {
        if (status.error().code != ErrorCode::internal || !breaks_a_region()) return status;
        // What was before the cuts stays.
        work_.pslg = pslg;
        work_.table = table;
        work_.report.box_cuts = box_cuts;
        break;
      }
    }
    std::size_t left = 0;
    std::vector<Point> where;
    for (const RegionMesh& mesh : work_.meshes) {
      left += mesh.report.couplings.size();
      for (const NegativeCoupling& c : mesh.report.couplings) {
        if (where.size() < kCouplingsTold) where.push_back(midpoint(c.a, c.b));
      }
    }
    if (left > 0)
      work_.report.notes.push_back(
          {Note::Kind::warning, kVoid,
           fmt::format("box-method: {} left, the first at {}", counted(left, "negative coupling"),
                       describe(where[0])),
           where});
    return ok();
  }

 private:
  /// Makes the mesh of a region constrained Delaunay; the bound comes first.
  void flip(std::size_t r) {
    RegionMesh flipped = work_.meshes[r];
    if (make_delaunay(all_points(work_.boundaries[r], flipped), flipped.triangles,
                      work_.boundaries[r].sides) == 0)
      return;
    measure_again(work_.boundaries[r], options_, Unreached::unknown, flipped);
    flipped.limits_are_old = true;
    if (flipped.report.bound_held || !work_.meshes[r].report.bound_held)
      work_.meshes[r] = std::move(flipped);
  }

  [[nodiscard]] ChosenCuts choose() const {
    const Pslg& pslg = work_.pslg;
    std::map<SegmentId, Point> apexes;
    for (std::size_t r = 0; r < work_.boundaries.size(); ++r) {
      for (const NegativeSide& side : negative_sides(work_.boundaries[r], work_.meshes[r])) {
        // Of both sides the same one, however regions are numbered.
        const auto [at, is_new] = apexes.emplace(side.segment, side.apex);
        if (!is_new) at->second = std::min(at->second, side.apex);
      }
    }
    const WholeSegments whole(pslg, work_.report.input_points);
    const PeriodicClasses classes(pslg);
    std::vector<SegmentCut> cuts;
    ChosenCuts chosen;
    for (const auto& [segment, apex] : apexes) {
      const Segment& s = pslg.segments[segment.index()];
      const auto [a, b] =
          std::minmax({pslg.points[s.a.index()], pslg.points[s.b.index()]});  // as from both ends
      const double share = part_on_line(a, b, apex);
      const Point foot = whole.on_whole(
          segment, share > kNearEnd && share < 1 - kNearEnd ? foot_on(a, b, apex) : midpoint(a, b));
      if (!has_room_on_segment(a, b, foot, std::vector<Point>{apex})) continue;
      cuts.push_back({segment, {foot}});
      for (const SegmentCut& image : classes.images(cuts.back()))
        chosen.by.emplace(image.segment, apex);
    }
    LookBudget looks;
    chosen.cuts = onto_arcs(work_.pslg, work_.table, classes.with_images(std::move(cuts)), looks);
    return chosen;
  }

  static std::vector<NegativeSide> negative_sides(const RegionBoundary& boundary,
                                                  const RegionMesh& mesh) {
    std::map<std::pair<Point, Point>, Point> apexes;
    for (const NegativeCoupling& c : mesh.report.couplings) {
      if (c.kind != NegativeCoupling::Kind::inside) apexes[{c.a, c.b}] = c.apex;
    }
    std::vector<NegativeSide> found;
    if (apexes.empty()) return found;
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      const auto at = apexes.find(
          {boundary.points[boundary.sides[s][0]], boundary.points[boundary.sides[s][1]]});
      if (at != apexes.end() && boundary.segments[s] != kHullSide)
        found.push_back({boundary.segments[s], at->second});
    }
    return found;
  }

  Status cut_and_mesh(const ChosenCuts& chosen) {
    std::vector<BoxCut>& box_cuts = work_.report.box_cuts;
    Result<std::vector<RegionBoundary>> boundaries = errors_as_values("cut segments", [&] {
      for (const SegmentCut& cut : chosen.cuts) {
        for (const Point p : cut.points)
          box_cuts.push_back({p, BoxCut::Reason::given_up, chosen.by.at(cut.segment)});
      }
      cut_segments(work_.pslg, work_.table, chosen.cuts);
      cut_encroached(work_, VertexId{0U});
      return boundaries_with_wishes(work_.pslg, work_.table, options_);
    });
    if (!boundaries) return std::move(boundaries).error();
    const auto changed = mesh_changed(work_, *std::move(boundaries), options_, callbacks_);
    if (!changed) return changed.error();
    for (const std::size_t r : *changed) flip(r);
    return ok();
  }

  /// Whether cuts, rounded, crossed something nearly straight.
  [[nodiscard]] bool breaks_a_region() const {
    const std::vector<RegionBoundary> boundaries = split_regions(work_.pslg, work_.table);
    return std::any_of(boundaries.begin(), boundaries.end(), [](const RegionBoundary& boundary) {
      const CdtResult cdt = triangulate_domain(boundary.points, boundary.sides);
      return find_flaw(cdt, boundary.points, boundary.sides).has_value();
    });
  }

  Work& work_;
  const Options& options_;
  const Callbacks& callbacks_;
};

}  // namespace

Status cut_negative_couplings(Work& work, const Options& options, const Callbacks& callbacks) {
  if (!options.box_method) return ok();
  Status status = CouplingRounds(work, options, callbacks).run();
  if (!status) return status;
  tell_box_cuts(work.report);
  return ok();
}

}  // namespace cover
