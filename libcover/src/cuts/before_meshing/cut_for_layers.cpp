// Both regions beside a segment, and the lines at both of its ends, may ask for points; those too
// near to another one are left out, and there layers taper off.
// Tested by tests/unit/cuts/before_meshing/cut_for_layers_test.cpp.
#include "cuts/before_meshing/cut_for_layers.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "cdt/sides.hpp"
#include "cuts/before_meshing/onto_arcs.hpp"
#include "cuts/before_meshing/split_interfaces.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/look_budget.hpp"
#include "cuts/periodic/mirror_cuts.hpp"
#include "cuts/room_on_segment.hpp"
#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "layers/layer_rules.hpp"
#include "layers/layered_region.hpp"
#include "layers/wall_points.hpp"
#include "region/region_graph.hpp"
#include "region/triangulation_of.hpp"

namespace cover {
namespace {

/// Of a layer's thickness: no point is nearer to another one.
constexpr double kApart = 0.5;
/// Walls are cut anew at most so often for arcs that sizes cut; two are enough as a rule.
constexpr int kRoundsForArcs = 4;

/// What is asked of one segment.
struct WallWish {
  std::vector<layers::WallPoint> points;
  std::vector<Point> apexes;  ///< of the triangles on both sides
};

/// Points along a segment that starts at `a`; low ones come first.
std::vector<Point> along_segment(Point a, Point b, WallWish wish) {
  std::stable_sort(wish.points.begin(), wish.points.end(), [](const auto& p, const auto& q) {
    return p.height != q.height ? p.height < q.height : p.at < q.at;
  });
  std::vector<Point> taken;
  for (const layers::WallPoint& p : wish.points) {
    const bool is_free = std::all_of(taken.begin(), taken.end(), [&](const Point& q) {
      return length(q - p.at) >= kApart * p.layer;
    });
    if (is_free && has_room_on_segment(a, b, p.at, wish.apexes)) taken.push_back(p.at);
  }
  std::sort(taken.begin(), taken.end(), [&](const Point& p, const Point& q) {
    return squared_length(p - a) < squared_length(q - a);
  });
  return taken;
}

/// Takes what is asked of a segment with images to the first of its class, where all of it counts.
class Wishes {
 public:
  explicit Wishes(const Pslg& pslg) : classes_(pslg) {}

  void add(SegmentId segment, layers::WallPoint p) {
    const auto [first, at] = at_first(segment, p.at);
    p.at = at;
    by_segment_[first].points.push_back(p);
  }

  /// Heeds a triangle beside the segment, if anything is asked of it.
  void add_apex(SegmentId segment, Point apex) {
    const auto [first, at] = at_first(segment, apex);
    const auto wish = by_segment_.find(first);
    if (wish != by_segment_.end()) wish->second.apexes.push_back(at);
  }

  [[nodiscard]] bool empty() const { return by_segment_.empty(); }

  /// What can be had, on segments and their images.
  [[nodiscard]] std::vector<SegmentCut> cuts(const Pslg& pslg) const {
    std::vector<SegmentCut> cuts;
    for (const auto& [segment, wish] : by_segment_) {
      const Segment& s = pslg.segments[segment.index()];
      const SegmentCut cut{segment,
                           along_segment(pslg.points[s.a.index()], pslg.points[s.b.index()], wish)};
      if (cut.points.empty()) continue;
      for (SegmentCut& image : classes_.images(cut)) cuts.push_back(std::move(image));
    }
    std::sort(cuts.begin(), cuts.end(),
              [](const SegmentCut& x, const SegmentCut& y) { return x.segment < y.segment; });
    return cuts;
  }

 private:
  [[nodiscard]] std::pair<SegmentId, Point> at_first(SegmentId segment, Point p) const {
    if (!classes_.is_periodic(segment)) return {segment, p};
    const SegmentCut first = classes_.images({segment, {p}}).front();
    return {first.segment, first.points.front()};
  }

  PeriodicClasses classes_;
  std::map<SegmentId, WallWish> by_segment_;
};

/// Those of rows that are counted: nothing else tells where they come to lie.
bool is_settled(const LayerRule& rule) { return rule.count > 0; }

/// Whether a line with layers is an arc anywhere: where that is cut, its ends turn.
bool has_layers_on_arcs(const Pslg& pslg, std::span<const RegionBoundary> boundaries) {
  return std::any_of(boundaries.begin(), boundaries.end(), [&](const RegionBoundary& boundary) {
    for (std::size_t s = 0; s < boundary.layers.size(); ++s) {
      const SegmentId segment = boundary.segments[s];
      if (boundary.layers[s] != 0 && segment != kHullSide &&
          circle_of(pslg, pslg.segments[segment.index()]) != nullptr)
        return true;
    }
    return false;
  });
}

/// What sizes cut segments to where these were cut at `walls` before, found out on a copy.
std::vector<layers::NextToEnds> pieces_for_sizes(const Prepared& prepared,
                                                 const std::vector<SegmentCut>& walls,
                                                 const Options& options) {
  Pslg cut = prepared.pslg;
  RegionTable table = prepared.table;
  std::vector<Note> notes;
  cut_segments(cut, table, walls);
  if (!split_interfaces(cut, table, options, notes)) return {};  // which will be told
  std::vector<layers::NextToEnds> next;
  std::size_t piece = 0;
  for (const Segment& s : prepared.pslg.segments) {
    const VertexId after_a = cut.segments[piece].b;
    while (cut.segments[piece].b != s.b) ++piece;
    const VertexId before_b = cut.segments[piece].a;
    next.push_back({cut.points[after_a.index()], cut.points[before_b.index()]});
    ++piece;
  }
  return next;
}

std::size_t count_straightened(const Pslg& pslg) {
  return static_cast<std::size_t>(
      std::count_if(pslg.segments.begin(), pslg.segments.end(),
                    [](const Segment& s) { return (s.circle & kStraightened) != 0; }));
}

/// The cuts of walls for layers.
struct WallCuts {
  std::vector<SegmentCut> cuts;
  bool for_arcs = false;  ///< see has_layers_on_arcs()
};

bool are_same(const std::vector<SegmentCut>& one, const std::vector<SegmentCut>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const SegmentCut& x, const SegmentCut& y) {
                      return x.segment == y.segment && x.points == y.points;
                    });
}

Result<WallCuts> find_wall_cuts(Prepared& prepared, const Options& options, bool settled_only,
                                const std::vector<layers::NextToEnds>& pieces) {
  auto& [pslg, table, report] = prepared;
  std::vector<RegionBoundary> boundaries = split_regions(pslg, table);
  if (Status status = resolve_layers(pslg, table, options, boundaries); !status)
    return std::move(status).error();
  Wishes wishes(pslg);
  for (const RegionBoundary& boundary : boundaries) {
    if (!has_layers(boundary)) continue;
    for (const layers::WallPoint& p : layers::wall_points(pslg, boundary, options.layers, pieces)) {
      const SegmentId segment = boundary.segments[p.side];
      if (settled_only && !is_settled(options.layers[p.rule])) continue;
      wishes.add(segment, p);
    }
  }
  for (const RegionBoundary& boundary : boundaries) {
    if (wishes.empty()) break;
    const Triangulation cdt = triangulation_of(boundary);
    const std::vector<EdgeRef> at = locate_sides(cdt, boundary.sides);
    for (std::size_t s = 0; s < at.size(); ++s) {
      wishes.add_apex(boundary.segments[s],
                      cdt.points[cdt.triangles[at[s].triangle].v[at[s].edge]]);
    }
  }
  const std::size_t straight = count_straightened(pslg);
  LookBudget looks;
  WallCuts found{onto_arcs(pslg, table, wishes.cuts(pslg), looks),
                 has_layers_on_arcs(pslg, boundaries)};
  // On a chord that has to stay straight, other points have the heights.
  if (count_straightened(pslg) > straight)
    return find_wall_cuts(prepared, options, settled_only, pieces);
  return found;
}

Status cut_walls(Prepared& prepared, const Options& options, bool settled_only) {
  if (options.layers.empty() || (!options.split_interfaces && !options.box_method)) return ok();
  Result<WallCuts> found = find_wall_cuts(prepared, options, settled_only, {});
  if (!found) return std::move(found).error();
  // Cuts of walls make edges beside them shorter, and these turn the ends of arcs.
  for (int round = 0; round < kRoundsForArcs && settled_only && found->for_arcs; ++round) {
    const std::vector<SegmentCut> before = std::move(found->cuts);
    found = find_wall_cuts(prepared, options, settled_only,
                           pieces_for_sizes(prepared, before, options));
    if (!found) return std::move(found).error();
    if (are_same(found->cuts, before)) break;
  }
  const std::vector<SegmentCut>& cuts = found->cuts;
  if (cuts.empty()) return ok();
  std::vector<Point> where;
  for (const SegmentCut& cut : cuts)
    where.insert(where.end(), cut.points.begin(), cut.points.end());
  cut_segments(prepared.pslg, prepared.table, cuts);
  prepared.report.notes.push_back(
      {Note::Kind::cut, kVoid,
       fmt::format("{} added on segments where layers end, the first at {}",
                   counted(where.size(), "point"), describe(where.front())),
       std::move(where)});
  return ok();
}

}  // namespace

Status cut_before_sizes(Prepared& prepared, const Options& options) {
  return options.sizes.empty() ? ok() : cut_walls(prepared, options, true);
}

Status cut_for_layers(Prepared& prepared, const Options& options) {
  return cut_walls(prepared, options, false);
}

}  // namespace cover
