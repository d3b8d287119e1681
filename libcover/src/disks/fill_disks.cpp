// The stages in order, in coordinates of the component's own: translated to the corner of its
// bounding box and scaled into the unit square by a power of two, which is exact. What rounding
// broke is found at the end, on the final coordinates: exact orientation, area, edges, angles. An
// attempt that fails is repeated with other corner disks and another tolerance, both from a fixed
// list; the best valid attempt is returned.
// Tested by tests/unit/disks/fill_disks_test.cpp.
#include "disks/fill_disks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <cover/angle.hpp>
#include <cover/option_ranges.hpp>

#include "cdt/cdt.hpp"
#include "disks/gaps/gap.hpp"
#include "disks/packing/boundary_disks.hpp"
#include "disks/packing/connect_holes.hpp"
#include "disks/packing/corner_disks.hpp"
#include "disks/packing/reduce_cycles.hpp"
#include "disks/remove_spare_vertices.hpp"
#include "disks/unit_frame.hpp"
#include "geom/predicates.hpp"
#include "geom/triangle.hpp"

namespace cover {
namespace {

using disks::Index;
using disks::Packing;

/// One way to run the stages.
struct Attempt {
  double tolerance;  ///< relative gap below which disks count as touching
  double fraction;   ///< of a corner's clearance that its disks take
};
constexpr std::array<Attempt, 4> kAttempts{
    {{1e-3, 0.46}, {1e-5, 0.47}, {1e-3, 0.42}, {1e-2, 0.45}}};

/// With more chords than that, what rounding broke twice is given up: in so many places, another
/// tolerance mends one and breaks the next.
constexpr std::size_t kManyChords = 1'000;
constexpr int kBrokenTwice = 2;

/// A right angle, with room for rounding.
constexpr double kRight = std::numbers::pi / 2 + 1e-6;

/// A filling with what its checks found.
struct Checked {
  Filling filling;
  std::string flaw;          ///< empty: valid
  double largest_angle = 0;  ///< radians
  PackingRecord record;
};

double largest_angle_in(Point a, Point b, Point c) {
  return std::max({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
}

/// Runs the attempts on one task.
class TaskRun {
 public:
  /// `radii`: of disks centred on the boundary; empty: disks into the corners.
  TaskRun(const FillTask& task, const Triangulation& cdt, std::span<const double> radii,
          const DiskFillOptions& options)
      : task_(task), cdt_(cdt), frame_(task.points), options_(options) {
    for (const double r : radii) radii_.push_back(frame_.inward(r));
  }

  [[nodiscard]] Checked attempt(const Attempt& attempt) const {
    Checked result;
    Packing packing;
    for (const Point p : task_.points) packing.draft.points.push_back(frame_.inward(p));
    const auto pairs = radii_.empty()
                           ? place_corner_disks(packing, cdt_, task_.chords, attempt.fraction)
                           : place_boundary_disks(packing, cdt_, task_.chords, radii_);
    const std::size_t corner_disks = packing.elements.size();
    if (!connect_holes(packing, pairs, attempt.tolerance)) {
      result.flaw = "a hole could not be connected";
      return result;
    }
    const std::size_t connected = packing.elements.size();
    if (!reduce_cycles(packing, attempt.tolerance)) {
      result.flaw = "a cycle could not be split";
      return result;
    }
    if (options_.record != nullptr) {
      note_disks(packing, corner_disks, connected, result.record);
      note_gaps(packing, result.record);
    }
    fill_gaps(packing, attempt.tolerance, result.record);
    if (options_.removes_spare_vertices)
      remove_spare_vertices(packing.draft, static_cast<Index>(task_.points.size()), kRight);
    hand_over(packing, result.filling);
    check(result);
    if (options_.record != nullptr && result.flaw.empty()) note_result(result);
    return result;
  }

 private:
  void note_disks(const Packing& packing, std::size_t corner_disks, std::size_t connected,
                  PackingRecord& record) const {
    for (std::size_t k = 0; k < packing.elements.size(); ++k) {
      const disks::Element& e = packing.elements[k];
      if (e.is_line()) continue;
      record.disks.push_back({frame_.outward(e.c), frame_.outward(e.r),
                              k < corner_disks ? PackingRecord::Purpose::corner
                              : k < connected  ? PackingRecord::Purpose::connection
                                               : PackingRecord::Purpose::reduction});
    }
  }

  void note_result(Checked& result) const {
    for (const auto& t : result.filling.triangles) {
      result.record.triangles.push_back(
          {point(result.filling, t[0]), point(result.filling, t[1]), point(result.filling, t[2])});
    }
    for (const Chord& c : task_.chords) {
      result.record.outline.push_back({task_.points[c.a], task_.points[c.b]});
    }
  }

  [[nodiscard]] static disks::Gap gap_in(const Packing& packing, const disks::Cycle& cycle) {
    disks::Gap gap;
    gap.size = static_cast<int>(cycle.size);
    Index s = cycle.side;
    for (std::size_t k = 0; k < cycle.size; ++k, s = packing.sides[s].next) {
      gap.e[k] = packing.element_of(s);
      gap.t[k] = packing.sides[s].end;
    }
    return gap;
  }

  void note_gaps(const Packing& packing, PackingRecord& record) const {
    for (const disks::Cycle& cycle : packing.cycles) {
      record.gaps.emplace_back();
      for (const Index v : cell_of(gap_in(packing, cycle))) {
        record.gaps.back().polygon.push_back(frame_.outward(packing.point(v)));
      }
    }
  }

  void fill_gaps(Packing& packing, double tolerance, PackingRecord& record) const {
    for (std::size_t k = 0; k < packing.cycles.size(); ++k) {
      const GapKind kind = fill_gap(packing.draft, gap_in(packing, packing.cycles[k]), tolerance);
      ++record.kinds[static_cast<std::size_t>(kind)];
      if (k < record.gaps.size()) record.gaps[k].kind = kind;
    }
  }

  void hand_over(const Packing& packing, Filling& filling) const {
    const auto& draft = packing.draft;
    for (std::size_t k = task_.points.size(); k < draft.points.size(); ++k) {
      filling.added.push_back(frame_.outward(draft.points[k]));
    }
    filling.triangles = draft.triangles;
    struct Placed {
      Index chord;
      double at;
      Index vertex;
    };
    std::vector<Placed> placed;
    for (const auto& [chord, vertex] : draft.on_chord) {
      const disks::Element& line = packing.elements[chord];
      placed.push_back({chord, dot(line.d, draft.points[vertex] - line.c), vertex});
    }
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
      if (a.chord != b.chord) return a.chord < b.chord;
      return a.at != b.at ? a.at < b.at : a.vertex < b.vertex;
    });
    for (const Placed& p : placed) {
      if (filling.splits.empty() || filling.splits.back().chord != p.chord) {
        filling.splits.push_back({p.chord, {}});
      }
      filling.splits.back().vertices.push_back(p.vertex);
    }
  }

  [[nodiscard]] Point point(const Filling& filling, Index v) const {
    return v < task_.points.size() ? task_.points[v] : filling.added[v - task_.points.size()];
  }

  /// The pieces of all chords, with the outside on their left; without slits, whose two sides
  /// belong to each other.
  [[nodiscard]] std::vector<IndexPair> outer_edges(const Filling& filling) const {
    std::vector<IndexPair> pieces, outer;
    auto split = filling.splits.begin();
    for (Index c = 0; c < task_.chords.size(); ++c) {
      Index last = task_.chords[c].a;
      if (split != filling.splits.end() && split->chord == c) {
        for (const Index v : (split++)->vertices) pieces.push_back({v, last}), last = v;
      }
      pieces.push_back({task_.chords[c].b, last});
    }
    std::sort(pieces.begin(), pieces.end());
    for (const IndexPair e : pieces) {
      if (!std::binary_search(pieces.begin(), pieces.end(), IndexPair{e[1], e[0]})) {
        outer.push_back(e);
      }
    }
    return outer;
  }

  /// Every directed edge has its opposite and occurs once.
  [[nodiscard]] bool edges_match(const Filling& filling) const {
    std::vector<IndexPair> edges = outer_edges(filling);
    edges.reserve(edges.size() + 3 * filling.triangles.size());
    for (const auto& t : filling.triangles) {
      for (const Corner k : kCorners) edges.push_back({t[k], t[k.next()]});
    }
    std::vector<IndexPair> opposite;
    opposite.reserve(edges.size());
    for (const IndexPair e : edges) opposite.push_back({e[1], e[0]});
    std::sort(edges.begin(), edges.end());
    std::sort(opposite.begin(), opposite.end());
    return edges == opposite && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  }

  void check(Checked& result) const {
    double area = 0, wanted = 0;
    const Point o = task_.points[0];
    for (const auto& t : result.filling.triangles) {
      const Point a = point(result.filling, t[0]), b = point(result.filling, t[1]),
                  c = point(result.filling, t[2]);
      if (orientation(a, b, c) != Sign::positive) result.flaw = "a triangle was turned over";
      area += doubled_area(a, b, c);
      result.largest_angle = std::max(result.largest_angle, largest_angle_in(a, b, c));
    }
    for (const Chord& c : task_.chords)
      wanted += doubled_area(o, task_.points[c.a], task_.points[c.b]);
    constexpr double kAreaError = 1e-10;
    if (!(std::abs(area - wanted) <= kAreaError * wanted)) result.flaw = "the area is wrong";
    if (!edges_match(result.filling)) result.flaw = "edges do not match";
  }

  const FillTask& task_;
  const Triangulation& cdt_;
  disks::UnitFrame frame_;
  std::vector<double> radii_;  ///< in the frame
  const DiskFillOptions& options_;
};

/// The constrained Delaunay triangulation as a filling.
Filling plain(const Triangulation& cdt, std::string remark) {
  Filling filling;
  for (const Triangle& t : cdt.triangles) filling.triangles.push_back(t.v);
  filling.target_reached = false;
  filling.remark = std::move(remark);
  return filling;
}

/// Why corner disks cannot be used at all; empty if they can.
std::string obstacle(const FillTask& task) {
  std::vector<IndexPair> ends;
  for (const Chord& c : task.chords) {
    if (c.locked) return "disk packing splits every chord, but some are locked";
    ends.push_back({std::min(c.a, c.b), std::max(c.a, c.b)});
  }
  std::sort(ends.begin(), ends.end());
  if (std::adjacent_find(ends.begin(), ends.end()) != ends.end()) {
    return "disk packing puts different points on the two sides of a slit";
  }
  return {};
}

/// Whether the triangulation ends somewhere without a chord.
bool has_open_rim(const Triangulation& cdt) {
  return std::any_of(cdt.triangles.begin(), cdt.triangles.end(), [](const Triangle& t) {
    return (t.n[0] == kNone && !t.is_locked(0)) || (t.n[1] == kNone && !t.is_locked(1)) ||
           (t.n[2] == kNone && !t.is_locked(2));
  });
}

/// Triangulates `task`; see make_disk_filler() and fill_between_disks().
Filling run_attempts(const FillTask& task, std::span<const double> radii,
                     const std::stop_token& stop, const DiskFillOptions& options) {
  std::vector<IndexPair> sides;
  for (const Chord& c : task.chords) sides.push_back({c.a, c.b});
  const CdtResult cdt = triangulate_domain(task.points, sides);
  if (!cdt.conflicts.empty() || cdt.triangulation.triangles.empty() ||
      has_open_rim(cdt.triangulation)) {
    Filling none;
    none.target_reached = false;
    none.remark = "the chords bound no domain";
    return none;
  }
  if (radii.empty()) {
    if (std::string why = obstacle(task); !why.empty()) return plain(cdt.triangulation, why);
  }
  const TaskRun run(task, cdt.triangulation, radii, options);
  constexpr double kAim = Angle::degrees(kLargestSnapped).in_radians();
  std::optional<Checked> best;
  std::string flaw = "stopped";
  int attempts = 0;
  for (const Attempt& a : kAttempts) {
    if (stop.stop_requested() || (best && best->largest_angle <= kAim)) break;
    if (!best && attempts == kBrokenTwice && task.chords.size() > kManyChords) break;
    Checked result = run.attempt(a);
    if (!result.flaw.empty() && ++attempts == 1) flaw = result.flaw;
    if (!result.flaw.empty()) continue;
    ++attempts;
    if (!best || result.largest_angle < best->largest_angle) best = std::move(result);
  }
  if (!best) return plain(cdt.triangulation, "rounding defeated the disk packing: " + flaw);
  if (best->largest_angle > kAim) {
    best->filling.target_reached = false;
    best->filling.remark = "rounding of tiny features left an angle of " +
                           std::to_string(Angle::radians(best->largest_angle).in_degrees()) +
                           " degrees";
  }
  if (options.record != nullptr) {
    *options.record = std::move(best->record);
    options.record->attempts = attempts;
  }
  return std::move(best->filling);
}

class DiskFiller final : public Filler {
 public:
  explicit DiskFiller(const DiskFillOptions& options) : options_(options) {}
  [[nodiscard]] Filling fill(const FillTask& task, std::stop_token stop) const override {
    return run_attempts(task, {}, stop, options_);
  }

 private:
  DiskFillOptions options_;
};

}  // namespace

std::unique_ptr<Filler> make_disk_filler(const DiskFillOptions& options) {
  return std::make_unique<DiskFiller>(options);
}

Filling fill_between_disks(const FillTask& task, std::span<const double> radii,
                           const std::stop_token& stop, const DiskFillOptions& options) {
  return run_attempts(task, radii, stop, options);
}

}  // namespace cover
