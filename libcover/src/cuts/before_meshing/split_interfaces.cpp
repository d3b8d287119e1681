// Passes over the regions that changed: every side that its apex sees at too large an angle marks
// its segment; then all marked segments are cut at once, each at the foot of its apex: the apex and
// the pieces then make right triangles, and where walls are parallel a structured grid comes of it.
// Half way instead, thin layers with vertices that do not face each other take 10 to 200 times the
// points; and feet need no care at sharp corners, where they end with a fan of right triangles.
// What is to be seen at less than 90 degrees is cut half way. Segments longer than wished are cut
// before that, all at once; but where two face each other across a layer that is thinner than the
// edges wished, the coarser one waits for the cuts of the other and gets their feet: steps of its
// own would face none of them, and each would need its foot on the other side.
// Tested by tests/unit/cuts/before_meshing/split_interfaces_test.cpp.
#include "cuts/before_meshing/split_interfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/internal_fault.hpp"
#include "cdt/cdt.hpp"
#include "cdt/region_cdt.hpp"
#include "cuts/before_meshing/onto_arcs.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/periodic/mirror_cuts.hpp"
#include "cuts/room_on_segment.hpp"
#include "cuts/whole_segments.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/curves/arc.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "sizes/segment_sizes.hpp"
#include "sizes/size_field.hpp"
#include "sizes/sizes.hpp"
#include "target/angle_limit.hpp"

namespace cover {
namespace {

constexpr int kPasses = 64;
constexpr double kFloor = 0x1p-10;      ///< of its segment: the shortest half that is cut in two
constexpr double kFootFloor = 0x1p-40;  ///< of its segment: the shortest piece beside a foot
constexpr double kRounding = 1e-9;      ///< radians
constexpr int kTrials = 8;  ///< single cuts are taken back so often, then all of a broken region
constexpr std::size_t kPlaces = 8;
/// Passes have looked at enough once they have seen so many points for each that there is now, and
/// so many at all, and so many more segments are stuck than are cut: more passes, each of which
/// cuts what the one before it left too long, leave the angle as far off.
constexpr std::size_t kLooksPerPoint = 12;
constexpr std::size_t kLooksAtLeast = 250'000;
constexpr std::size_t kFarMoreStuck = 16;

/// What the regions on both sides of a segment want.
struct Wish {
  bool forced = false;           ///< an angle that is too large is forced on it
  std::uint8_t forced_from = 0;  ///< kLeft, kRight or both
  double nu = std::numbers::pi;  ///< of the worst one
  Point apex;                    ///< sees it at that angle
  std::vector<Point> apexes;     ///< of the triangles on both sides
  std::optional<SegmentSizes> sizes;
  std::vector<Point> across;        ///< vertices that may face it across a thin layer
  std::vector<SegmentId> opposite;  ///< segments at the apexes
};

/// A layer is thin if it is no thicker than this part of the edge length wished along it.
constexpr double kThin = 0.5;

constexpr std::uint8_t kLeft = 1, kRight = 2;  ///< of a segment

/// A segment before it was cut.
struct Whole {
  Point a, b;
  double length = 0;  ///< when this began: of a piece, where it was cut before
};

class Splitter {
 public:
  Splitter(Pslg& pslg, RegionTable& table, const Options& options, std::size_t uncut_points)
      : pslg_(pslg),
        table_(table),
        options_(options),
        first_cut_{static_cast<std::uint32_t>(pslg.points.size())},
        least_nu_(options.split_interfaces->supplement().in_radians() - kRounding),
        is_right_(*options.split_interfaces == Angle::degrees(90)),
        dirty_(table.regions.size(), 1) {
    const WholeSegments whole(pslg, uncut_points);
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      const auto [a, b] = whole.ends(SegmentId{s});
      whole_.push_back({a, b, length_of(pslg.segments[s])});
    }
    rigid_.assign(pslg.segments.size(), 0);
    stuck_from_.assign(pslg.segments.size(), 0);
  }

  /// Cuts `halved` in any case, where there is room. False if that takes more than `most` points.
  Result<bool> run(std::span<const SegmentId> halved = {},
                   std::size_t most = std::numeric_limits<std::size_t>::max()) {
    for (int pass = 0; pass < kPasses;) {
      halved_.assign(pslg_.segments.size(), 0);
      if (pass == 0) {
        for (const SegmentId s : halved) halved_[s.index()] = 1;
      }
      Result<std::vector<SegmentCut>> cuts = find_cuts();
      if (!cuts) return std::move(cuts).error();
      if (!broken_.empty()) {
        take_back();
        continue;
      }
      if (cuts->empty()) break;
      if (points_with(*cuts) > most) return false;
      ++pass;
      // Nobody would look at what the last cuts break.
      if (pass == kPasses || is_in_vain(cuts->size())) {
        left_long_ = cuts->size();
        break;
      }
      before_ = Before{pslg_, table_, whole_, rigid_, stuck_from_, *std::move(cuts), 0};
      apply(before_->cuts);
    }
    return true;
  }

  /// What was cut since there were `before` points, and what was not.
  void tell(std::size_t before, std::vector<Note>& notes) const {
    const auto degrees = options_.split_interfaces->in_degrees();
    if (pslg_.points.size() > before) {
      std::vector<Point> where(pslg_.points.begin() + static_cast<std::ptrdiff_t>(before),
                               pslg_.points.end());
      notes.push_back({Note::Kind::cut, kVoid,
                       fmt::format("{} added on segments for --split-interfaces {:.6g}, the "
                                   "first at {}",
                                   counted(pslg_.points.size() - before, "point"), degrees,
                                   describe(where.front())),
                       std::move(where)});
    }
    if (left_long_ > 0 && stuck_.empty())
      notes.push_back({Note::Kind::warning,
                       kVoid,
                       fmt::format("{} would have to be cut further to force no angle above {:.6g} "
                                   "degrees",
                                   counted(left_long_, "segment"), degrees),
                       {}});
    if (stuck_.empty()) return;
    std::vector<Point> where = stuck_;
    where.resize(std::min(where.size(), kPlaces));
    std::string text = fmt::format(
        "{} would have to be cut too short to force no angle above {:.6g} degrees, the first near "
        "{}",
        counted(stuck_.size(), "segment"), degrees, describe(where[0]));
    if (left_long_ > 0) text += fmt::format("; {} more would have to be cut further", left_long_);
    notes.push_back({Note::Kind::warning, kVoid, std::move(text), std::move(where)});
  }

 private:
  [[nodiscard]] Point at(VertexId v) const { return pslg_.points[v.index()]; }
  [[nodiscard]] double length_of(const Segment& s) const { return length(at(s.b) - at(s.a)); }

  [[nodiscard]] std::size_t points_with(std::span<const SegmentCut> cuts) const {
    std::size_t points = pslg_.points.size();
    for (const SegmentCut& cut : cuts) points += cut.points.size();
    return points;
  }

  /// Whether so many cuts, of another pass, would leave the angle as far off.
  [[nodiscard]] bool is_in_vain(std::size_t cuts) const {
    return looked_at_ > std::max(kLooksAtLeast, kLooksPerPoint * pslg_.points.size()) &&
           stuck_.size() > kFarMoreStuck * cuts;
  }

  /// One cut for every segment that a region that changed wants shorter.
  Result<std::vector<SegmentCut>> find_cuts() {
    const PeriodicClasses classes(pslg_);
    std::vector<RegionBoundary> boundaries = split_regions(pslg_, table_);
    if (Status status = resolve_sizes(pslg_, table_, options_, boundaries); !status) {
      return std::move(status).error();
    }
    share_sizes(pslg_, boundaries);
    wishes_.assign(pslg_.segments.size(), {});
    broken_.clear();
    for (std::size_t r = 0; r < boundaries.size(); ++r) {
      if (dirty_[r] != 0) wish(boundaries[r]);
    }
    if (before_ && broken_.empty()) look_at_void();
    std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{0});
    std::vector<SegmentCut> cuts;
    for (std::size_t s = 0; s < wishes_.size(); ++s) {
      const Segment& segment = pslg_.segments[s];
      const Wish& wish = wishes_[s];
      if (rigid_[s] != 0) {
        stuck_from_[s] |= wish.forced_from;
      } else if (wish.sizes && wish.sizes->is_long()) {
        const bool is_periodic = classes.is_periodic(SegmentId{s});
        std::vector<Point> places;
        if (!is_periodic) places = feet_across(segment, wish);
        if (places.empty() && !is_periodic && waits(s)) {
          mark_dirty(table_.sides[s]);
          continue;
        }
        if (places.empty()) places = wish.sizes->cuts();
        for (Point& place : places) place = on_whole(s, place);
        cuts.push_back({SegmentId{s}, std::move(places)});
      } else if (wish.forced || halved_[s] != 0) {
        const auto place = place_on(segment, wish, whole_[s].length);
        if (place) {
          cuts.push_back({SegmentId{s}, {on_whole(s, *place)}});
        } else {
          stuck_from_[s] |= wish.forced_from;
        }
      }
    }
    stuck_.clear();
    for (std::size_t s = 0; s < stuck_from_.size(); ++s) {
      const Segment& segment = pslg_.segments[s];
      if (stuck_from_[s] != 0) stuck_.push_back(midpoint(at(segment.a), at(segment.b)));
    }
    return onto_arcs(pslg_, table_, classes.with_images(std::move(cuts)));
  }

  /// Notes what a region wants of its sides: sizes as its mesh will have them, graded from all of
  /// its boundary, so that no long side is left beside short edges.
  void wish(RegionBoundary& boundary) {
    looked_at_ += boundary.points.size();
    CdtResult result = triangulate_domain(boundary.points, boundary.sides);
    if (const auto fault = find_fault(result, boundary.points, boundary.sides)) {
      note_broken(boundary, *fault);
      return;
    }
    const Triangulation cdt = std::move(result.triangulation);
    const SizeField field(boundary, cdt, options_.growth, background_of(boundary, options_),
                          first_cut_);
    if (field.is_active()) {
      boundary.size_at.resize(boundary.points.size());
      for (std::uint32_t v = 0; v < boundary.points.size(); ++v) boundary.size_at[v] = field.at(v);
    }
    const std::vector<std::vector<std::uint32_t>> sides_at =
        field.is_active() ? sides_by_vertex(boundary) : std::vector<std::vector<std::uint32_t>>();
    if (field.is_active()) look_across(boundary, cdt, sides_at);
    const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      if (boundary.segments[s] == kHullSide) continue;
      const Segment& segment = pslg_.segments[boundary.segments[s].index()];
      const std::uint8_t from = side_of(boundary, s, segment);
      stuck_from_[boundary.segments[s].index()] &= static_cast<std::uint8_t>(~from);
      Wish& wish = wishes_[boundary.segments[s].index()];
      if (!wish.sizes) wish.sizes.emplace(at(segment.a), at(segment.b), options_);
      wish.sizes->add(boundary, s);
      const EdgeRef& edge = limit.at[s];
      const Point apex = cdt.points[cdt.triangles[edge.triangle].v[edge.edge]];
      wish.apexes.push_back(apex);
      if (field.is_active()) {
        for (const std::uint32_t other : sides_at[cdt.triangles[edge.triangle].v[edge.edge]])
          wish.opposite.push_back(boundary.segments[other]);
      }
      if (limit.side_nu[s] >= least_nu_) continue;
      // A foot of an earlier pass is rounded, and sees what it was made for so.
      if (is_right_ && bluntness(at(segment.a), apex, at(segment.b)) != Blunt::yes) continue;
      wish.forced_from |= from;
      if (limit.side_nu[s] > wish.nu) continue;
      if (limit.side_nu[s] == wish.nu && wish.apex < apex) continue;
      wish.forced = true;
      wish.nu = limit.side_nu[s];
      wish.apex = apex;
    }
  }

  /// None at vertices where very many meet: what lies between those is a wedge and no layer.
  static std::vector<std::vector<std::uint32_t>> sides_by_vertex(const RegionBoundary& boundary) {
    constexpr std::size_t kMost = 8;
    std::vector<std::vector<std::uint32_t>> sides(boundary.points.size());
    for (std::uint32_t s = 0; s < boundary.sides.size(); ++s) {
      if (boundary.segments[s] == kHullSide) continue;
      for (const std::uint32_t v : boundary.sides[s]) sides[v].push_back(s);
    }
    for (std::vector<std::uint32_t>& at_vertex : sides)
      if (at_vertex.size() > kMost) at_vertex.clear();
    return sides;
  }

  /// Notes which vertices may face a side across a thin layer: neighbours of its ends in the
  /// constrained Delaunay triangulation, as a chain of vertices along a long side is.
  void look_across(const RegionBoundary& boundary, const Triangulation& cdt,
                   const std::vector<std::vector<std::uint32_t>>& sides_at) {
    for (const Triangle& t : cdt.triangles) {
      for (const Corner i : kCorners) {
        const Point p = cdt.points[t.v[i.next()]];
        for (const std::uint32_t s : sides_at[t.v[i]]) {
          const auto [a, b] = boundary.sides[s];
          const Vector along = boundary.points[b] - boundary.points[a];
          const double part = dot(p - boundary.points[a], along) / squared_length(along);
          if (part > 0 && part < 1 &&
              length(p - at_part(boundary.points[a], boundary.points[b], part)) <
                  kThin * length(along))
            wishes_[boundary.segments[s].index()].across.push_back(p);
        }
      }
    }
  }

  /// The feet of vertices that face `piece` across a layer thinner than the edges wished there, in
  /// their order.
  [[nodiscard]] std::vector<Point> feet_across(const Segment& piece, const Wish& wish) const {
    const auto [a, b] = std::minmax({at(piece.a), at(piece.b)});
    const Vector along = b - a;
    std::vector<std::pair<double, Point>> feet;
    for (const Point& p : wish.across) {
      const double part = dot(p - a, along) / squared_length(along);
      if (!(part > kFootFloor && part < 1 - kFootFloor)) continue;
      const Point foot = foot_on(a, b, p);
      if (length(p - foot) <= kThin * wish.sizes->wished_at(part) &&
          has_room_on_segment(a, b, foot, wish.apexes))
        feet.emplace_back(part, foot);
    }
    std::sort(feet.begin(), feet.end());
    std::vector<Point> places;
    double last = 0;
    for (const auto& [part, foot] : feet) {
      if (part - last > kFloor && 1 - part > kFloor) places.push_back(foot), last = part;
    }
    if (at(piece.b) < at(piece.a)) std::reverse(places.begin(), places.end());
    return places;
  }

  /// Whether a segment across a thin layer is to have shorter edges than segment `s`, and is still
  /// to be cut.
  [[nodiscard]] bool waits(std::size_t s) const {
    const auto length_in_the_middle = [](const Wish& wish) { return wish.sizes->wished_at(0.5); };
    const Wish& wish = wishes_[s];
    const double own = length_in_the_middle(wish);
    return std::any_of(wish.opposite.begin(), wish.opposite.end(), [&](SegmentId other) {
      const Wish& its = wishes_[other.index()];
      if (other.index() == s || rigid_[other.index()] != 0 || !its.sizes || !its.sizes->is_long() ||
          !(length_in_the_middle(its) < own))
        return false;
      const Segment& facing = pslg_.segments[other.index()];
      const Segment& segment = pslg_.segments[s];
      const Point a = at(segment.a), b = at(segment.b);
      const auto is_near = [&](Point p) {
        return std::abs(cross(b - a, p - a)) <= kThin * own * length(b - a);
      };
      return is_near(at(facing.a)) && is_near(at(facing.b));
    });
  }

  /// From which side of `segment` its region sees side `s`.
  static std::uint8_t side_of(const RegionBoundary& boundary, std::size_t s,
                              const Segment& segment) {
    return boundary.vertices[boundary.sides[s][0]] == segment.a ? kLeft : kRight;
  }

  /// Where to cut a piece of a segment that is `whole` long; nothing if pieces would be too short,
  /// or what lies beside them too thin for rounded points.
  [[nodiscard]] std::optional<Point> place_on(const Segment& piece, const Wish& wish,
                                              double whole) const {
    const auto [a, b] = std::minmax({at(piece.a), at(piece.b)});  // the same from both ends
    if (wish.nu > std::numbers::pi / 2 - kRounding) {
      if (length_of(piece) < 2 * kFloor * whole) return std::nullopt;
      return has_room_on_segment(a, b, midpoint(a, b), wish.apexes) ? std::optional(midpoint(a, b))
                                                                    : std::nullopt;
    }
    const Point foot = foot_on(a, b, wish.apex);
    const double shorter = std::min(length(foot - a), length(foot - b));
    if (shorter <= kFootFloor * whole || !has_room_on_segment(a, b, foot, wish.apexes))
      return std::nullopt;
    return foot;
  }

  /// WholeSegments::on_whole().
  [[nodiscard]] Point on_whole(std::size_t s, Point p) const {
    if (circle_of(pslg_, pslg_.segments[s]) != nullptr) return p;
    return back_on_line(whole_[s].a, whole_[s].b, p);
  }

  /// Whether a cut of the last pass lies beside the void.
  [[nodiscard]] bool has_cut_void() const {
    return std::any_of(before_->cuts.begin(), before_->cuts.end(), [&](const SegmentCut& cut) {
      const SegmentSides& sides = before_->table.sides[cut.segment.index()];
      return sides.left == kVoid || sides.right == kVoid;
    });
  }

  /// What lies in the void belongs to no region, and cuts must not meet it either; nor may cuts of
  /// two regions meet through a void between them that rounding closes.
  void look_at_void() {
    if (table_.void_segments.empty() && table_.void_points.empty() && !has_cut_void()) return;
    const CdtResult whole = triangulate_whole(pslg_);
    if (whole.conflicts.empty()) {
      if (!table_.hull_sides.empty()) look_at_hull(whole.triangulation);
      look_at_passed(whole.triangulation);
      return;
    }
    for (const CdtConflict& conflict : whole.conflicts) {
      const bool first_is_point = conflict.kind != CdtConflict::Kind::crossing;
      const bool second_is_point = conflict.kind == CdtConflict::Kind::duplicate_point;
      const auto note = [&](std::uint32_t k, bool is_point) {
        const IndexPair ends =
            is_point ? IndexPair{k, k}
                     : IndexPair{pslg_.segments[k].a.value(), pslg_.segments[k].b.value()};
        for (const std::uint32_t v : ends) {
          if (v >= before_->pslg.points.size()) broken_.emplace_back(v);
        }
      };
      note(conflict.first, first_is_point);
      note(conflict.second, second_is_point);
      if (broken_.empty()) {  // where cuts moved a segment, what it meets may be as it was
        for (std::size_t v = before_->pslg.points.size(); v < pslg_.points.size(); ++v)
          broken_.emplace_back(v);
      }
      if (broken_.empty()) throw InternalFault("segments meet in the void", {});
    }
  }

  /// A cut may pass what hangs in the void beside it, and cross nothing.
  void look_at_passed(const Triangulation& whole) {
    const std::vector<VertexId> passed = void_in_regions(pslg_, table_, whole);
    if (passed.empty()) return;
    const std::size_t old = before_->pslg.points.size(), known = broken_.size();
    for (const Triangle& t : whole.triangles) {
      if (std::none_of(t.v.begin(), t.v.end(), [&](std::uint32_t v) {
            return std::binary_search(passed.begin(), passed.end(), VertexId{v});
          }))
        continue;
      for (const std::uint32_t v : t.v) {
        if (v >= old) broken_.emplace_back(v);
      }
    }
    if (broken_.size() > known) return;
    for (std::size_t v = old; v < pslg_.points.size(); ++v) broken_.emplace_back(v);
  }

  /// A cut beside a side of the hull that is in line with it may lie outside by rounding; the hull
  /// would have another side then.
  void look_at_hull(const Triangulation& whole) {
    std::vector<std::array<VertexId, 2>> sides;
    for (const HullSide& side : table_.hull_sides) sides.push_back({side.a, side.b});
    std::sort(sides.begin(), sides.end());
    for (const Triangle& t : whole.triangles) {
      for (const Corner i : kCorners) {
        if (t.n[i] != kNone || t.is_locked(i)) continue;
        const std::array<VertexId, 2> ends{VertexId{t.v[i.next()]}, VertexId{t.v[i.previous()]}};
        if (std::binary_search(sides.begin(), sides.end(), ends)) continue;
        for (const VertexId v : ends) {
          if (v.index() >= before_->pslg.points.size()) broken_.push_back(v);
        }
      }
    }
  }

  /// Notes the points whose cuts made `boundary` bound nothing.
  void note_broken(const RegionBoundary& boundary, const BoundaryFault& fault) {
    if (!before_) throw InternalFault(fault.what, fault.where);
    const std::size_t old = before_->pslg.points.size();
    const std::size_t known = broken_.size();
    if (before_->trials < kTrials) {
      for (const std::uint32_t v : fault.points) {
        if (boundary.vertices[v].index() >= old) broken_.push_back(boundary.vertices[v]);
      }
    }
    if (broken_.size() > known) return;
    for (const VertexId v : boundary.vertices) {  // all that is new in this region
      if (v.index() >= old) broken_.push_back(v);
    }
    if (broken_.size() == known) throw InternalFault(fault.what, fault.where);
  }

  /// Makes the last cuts anew without those that broke something; what they are on is cut no more.
  void take_back() {
    std::sort(broken_.begin(), broken_.end());
    Before before = *std::exchange(before_, std::nullopt);
    std::vector<SegmentId> rigid;
    std::size_t next = before.pslg.points.size();
    for (const SegmentCut& cut : before.cuts) {
      const VertexId first{next};
      next += cut.points.size();
      const auto broken = std::lower_bound(broken_.begin(), broken_.end(), first);
      if (broken != broken_.end() && broken->index() < next) rigid.push_back(cut.segment);
    }
    rigid = PeriodicClasses(before.pslg).with_classes(std::move(rigid));
    for (const SegmentId s : rigid) {
      before.rigid[s.index()] = 1;
      mark_dirty(before.table.sides[s.index()]);
    }
    std::vector<SegmentCut> cuts = std::move(before.cuts);
    std::erase_if(cuts, [&](const SegmentCut& cut) {
      return std::binary_search(rigid.begin(), rigid.end(), cut.segment);
    });
    pslg_ = before.pslg;
    table_ = before.table;
    whole_ = before.whole;
    rigid_ = before.rigid;
    stuck_from_ = before.stuck_from;
    before.cuts = std::move(cuts);
    ++before.trials;
    before_ = std::move(before);
    apply(before_->cuts);
  }

  void mark_dirty(const SegmentSides& sides) {
    for (const RegionId r : {sides.left, sides.right}) {
      if (r != kVoid) dirty_[r.index() - 1] = 1;
    }
  }

  void apply(const std::vector<SegmentCut>& cuts) {
    std::vector<Whole> whole;
    std::vector<std::uint8_t> rigid, stuck_from;
    auto cut = cuts.begin();
    for (std::size_t s = 0; s < whole_.size(); ++s) {
      whole.push_back(whole_[s]);
      rigid.push_back(rigid_[s]);
      stuck_from.push_back(stuck_from_[s]);
      if (cut == cuts.end() || cut->segment.index() != s) continue;
      whole.insert(whole.end(), cut->points.size(), whole_[s]);
      rigid.insert(rigid.end(), cut->points.size(), rigid_[s]);
      stuck_from.insert(stuck_from.end(), cut->points.size(), 0);
      mark_dirty(table_.sides[s]);
      ++cut;
    }
    whole_ = std::move(whole);
    rigid_ = std::move(rigid);
    stuck_from_ = std::move(stuck_from);
    cut_segments(pslg_, table_, cuts);
  }

  /// What was before the last cuts, and these.
  struct Before {
    Pslg pslg;
    RegionTable table;
    std::vector<Whole> whole;
    std::vector<std::uint8_t> rigid;
    std::vector<std::uint8_t> stuck_from;
    std::vector<SegmentCut> cuts;
    int trials = 0;  ///< so many of them were taken back
  };

  Pslg& pslg_;
  RegionTable& table_;
  const Options& options_;
  /// Feet of what lies on both sides of a thin layer may be near each other; lengths of pieces
  /// between them are no wish, or finer pieces would follow from them, and so on.
  VertexId first_cut_;
  double least_nu_;
  bool is_right_;                     ///< right angles are asked for
  std::vector<Wish> wishes_;          ///< by segment
  std::vector<std::uint8_t> dirty_;   ///< by region
  std::vector<std::uint8_t> halved_;  ///< by segment: to be cut half way if it is not otherwise
  std::vector<Whole> whole_;          ///< by segment: what it is a piece of
  std::vector<std::uint8_t> rigid_;   ///< by segment: rounded cuts on it broke something
  /// By segment: from which sides angles are forced on it though it cannot be cut. What a region
  /// said last holds until it is looked at again.
  std::vector<std::uint8_t> stuck_from_;
  std::vector<Point> stuck_;   ///< the middles of these segments
  std::size_t looked_at_ = 0;  ///< points of regions, in all passes
  std::size_t left_long_ = 0;  ///< segments that were to be cut when no more passes were made
  std::optional<Before> before_;
  std::vector<VertexId> broken_;  ///< cuts that broke something
};

}  // namespace

Status split_interfaces(Pslg& pslg, RegionTable& table, const Options& options,
                        std::vector<Note>& notes) {
  if (!options.split_interfaces) return ok();
  const std::size_t before = pslg.points.size();
  Splitter splitter(pslg, table, options, before);
  if (Result<bool> run = splitter.run(); !run) return std::move(run).error();
  splitter.tell(before, notes);
  return ok();
}

Result<bool> halve_segments(Pslg& pslg, RegionTable& table, const Options& options,
                            std::size_t uncut_points, std::span<const SegmentId> segments,
                            std::size_t most_points) {
  return Splitter(pslg, table, options, uncut_points).run(segments, most_points);
}

}  // namespace cover
