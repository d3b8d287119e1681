// Passes over the regions that changed: every side that its apex sees at too large an angle marks
// its segment (segment_wishes); then all marked segments are cut at once, each at the foot of its
// apex: the apex and the pieces then make right triangles, and where walls are parallel a
// structured grid comes of it. Half way instead, narrow strips with vertices that do not face each
// other take 10 to 200 times the points; and feet need no care at sharp corners, where they end
// with a fan of right triangles. What is to be seen at less than 90 degrees is cut half way.
// Segments longer than wished are cut before that, all at once; but where two face each other
// across a strip that is narrower than the edges wished (narrow_strips), the coarser one waits for
// the cuts of the other and gets their feet: steps of its own would face none of them, and each
// would need its foot on the other side. Cuts that broke something are taken back (broken_cuts).
// Tested by tests/unit/cuts/before_meshing/split_interfaces_test.cpp.
#include "cuts/before_meshing/split_interfaces.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/internal_fault.hpp"
#include "cuts/before_meshing/broken_cuts.hpp"
#include "cuts/before_meshing/least_pieces.hpp"
#include "cuts/before_meshing/onto_arcs.hpp"
#include "cuts/before_meshing/segment_wishes.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/look_budget.hpp"
#include "cuts/periodic/mirror_cuts.hpp"
#include "cuts/room_on_segment.hpp"
#include "cuts/whole_segments.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "sizes/sizes.hpp"

namespace cover {
namespace {

constexpr int kPasses = 64;
constexpr int kTrials = 8;  ///< single cuts are taken back so often, then all of a broken region
constexpr std::size_t kPlaces = 8;
/// Passes have looked at enough once they have seen so many points for each that there is now, and
/// so many at all, and so many more segments are stuck than are cut: more passes, each of which
/// cuts what the one before it left too long, leave the angle as far off.
constexpr std::size_t kLooksPerPoint = 12;
constexpr std::size_t kLooksAtLeast = 250'000;
constexpr std::size_t kFarMoreStuck = 16;

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();

/// A segment, maybe one of many that a segment was cut into.
struct Piece {
  double length = 0;         ///< when this began: of a piece, where it was cut before
  bool is_to_halve = false;  ///< if it is not cut otherwise
  bool is_rigid = false;     ///< rounded cuts on it broke something
  /// From there angles are forced on it though it cannot be cut. What a region said last holds
  /// until it is looked at again.
  SeenFrom stuck_from = SeenFrom::none;
};

class Splitter {
 public:
  Splitter(Pslg& pslg, RegionTable& table, const Options& options, std::size_t uncut_points)
      : pslg_(pslg),
        table_(table),
        options_(options),
        uncut_points_(uncut_points),
        first_cut_{pslg.points.size()},
        dirty_(table.regions.size(), 1) {
    for (const Segment& segment : pslg.segments) pieces_.push_back({length_of(segment)});
  }

  /// Cuts `halved` in any case, where there is room. False if that takes more than `most` points,
  /// or looks: in each pass at all points, and at those of regions that changed.
  Result<bool> run(std::span<const SegmentId> halved = {}, std::size_t most = kAny,
                   LookBudget looks = LookBudget()) {
    looks_ = looks;
    for (const SegmentId s : halved) pieces_[s.index()].is_to_halve = true;
    for (int pass = 0; pass < kPasses;) {
      Result<std::vector<SegmentCut>> cuts = find_cuts();
      if (!cuts) return std::move(cuts).error();
      if (!broken_.empty()) {
        take_back();
        continue;
      }
      if (cuts->empty()) break;
      if (points_with(*cuts) > most || looks_.is_spent()) return false;
      ++pass;
      // Nobody would look at what the last cuts break.
      if (pass == kPasses || is_in_vain(cuts->size())) {
        left_long_ = cuts->size();
        break;
      }
      before_ = Before{pslg_, table_, pieces_, *std::move(cuts), 0};
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

  /// One cut for every segment that a region that changed wants shorter; or broken_ is not empty.
  Result<std::vector<SegmentCut>> find_cuts() {
    looks_.spend(pslg_.points.size());
    std::vector<RegionBoundary> boundaries = split_regions(pslg_, table_);
    if (Status status = resolve_sizes(pslg_, table_, options_, boundaries); !status) {
      return std::move(status).error();
    }
    share_sizes(pslg_, boundaries);
    SegmentWishes wishes(pslg_, options_, first_cut_);
    broken_.clear();
    for (std::size_t r = 0; r < boundaries.size(); ++r) {
      if (dirty_[r] != 0) look_at(boundaries[r], wishes);
    }
    if (before_ && broken_.empty() && may_break_void())
      broken_ = cuts_that_broke_void(pslg_, table_, first_of_last_cuts());
    std::fill(dirty_.begin(), dirty_.end(), std::uint8_t{0});
    const PeriodicClasses classes(pslg_);
    const WholeSegments whole(pslg_, uncut_points_);
    std::vector<SegmentCut> cuts;
    for (std::size_t s = 0; s < pieces_.size(); ++s) {
      std::vector<Point> places = places_on(s, wishes, classes.is_periodic(SegmentId{s}));
      for (Point& place : places) place = whole.on_whole(SegmentId{s}, place);
      if (!places.empty()) cuts.push_back({SegmentId{s}, std::move(places)});
    }
    note_stuck();
    return onto_arcs(pslg_, table_, classes.with_images(std::move(cuts)), looks_);
  }

  void look_at(RegionBoundary& boundary, SegmentWishes& wishes) {
    looked_at_ += boundary.points.size();
    looks_.spend(boundary.points.size());
    if (const auto flaw = wishes.add(boundary)) {
      if (!before_) throw InternalFault(flaw->what, flaw->where);
      const auto cuts =
          cuts_that_broke(boundary, *flaw, first_of_last_cuts(), before_->trials >= kTrials);
      broken_.insert(broken_.end(), cuts.begin(), cuts.end());
      return;
    }
    for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
      const SegmentId segment = boundary.segments[s];
      if (segment == kHullSide) continue;
      SeenFrom& stuck_from = pieces_[segment.index()].stuck_from;
      stuck_from = without(stuck_from, seen_from(boundary, s, pslg_.segments[segment.index()]));
    }
  }

  /// Where to cut a segment; where that is wanted and cannot be, it is stuck.
  std::vector<Point> places_on(std::size_t s, const SegmentWishes& wishes, bool is_periodic) {
    const SegmentWish& wish = wishes.of(s);
    Piece& piece = pieces_[s];
    std::vector<Point> places;
    if (piece.is_rigid) {
      piece.stuck_from = piece.stuck_from | wish.forced_from;
    } else if (wish.sizes && wish.sizes->is_long()) {
      if (!is_periodic) places = wishes.feet_on(s);
      if (places.empty() && !is_periodic && waits(s, wishes)) {
        mark_dirty(table_.sides[s]);
        return {};
      }
      if (places.empty()) places = wish.sizes->cuts();
    } else if (wish.forced_from != SeenFrom::none || piece.is_to_halve) {
      if (const auto place = place_on(pslg_.segments[s], wish, piece.length)) {
        places = {*place};
      } else {
        piece.stuck_from = piece.stuck_from | wish.forced_from;
      }
    }
    return places;
  }

  /// Whether segment `s` is to be cut later, at feet of what is cut across a narrow strip.
  [[nodiscard]] bool waits(std::size_t s, const SegmentWishes& wishes) const {
    const std::vector<SegmentId> finer = wishes.finer_across(s);
    return std::any_of(finer.begin(), finer.end(),
                       [&](SegmentId other) { return !pieces_[other.index()].is_rigid; });
  }

  /// `foot`, that of `apex`; or, where it is so near to a corner of the input that it would leave a
  /// needle, the place as far from there as the apex is from its foot: seen from there, the corner
  /// is at less than a right angle as well. Beside cuts that would make cascades of others.
  [[nodiscard]] Point place_for(const Segment& piece, Point foot, Point apex) const {
    const double height = length(apex - foot), whole = length(at(piece.b) - at(piece.a));
    for (const auto& [end, other] : {std::pair{piece.a, piece.b}, std::pair{piece.b, piece.a}}) {
      if (end.index() < uncut_points_ && length(foot - at(end)) < kNeedle * height)
        return at(end) + std::min(height / whole, 0.5) * (at(other) - at(end));
    }
    return foot;
  }

  /// Where to cut a piece of a segment that is `whole` long; nothing if pieces would be too short,
  /// or what lies beside them too thin for rounded points.
  [[nodiscard]] std::optional<Point> place_on(const Segment& piece, const SegmentWish& wish,
                                              double whole) const {
    const auto [a, b] = std::minmax({at(piece.a), at(piece.b)});  // the same from both ends
    if (wish.nu > std::numbers::pi / 2 - kNuRounding) {
      if (length_of(piece) < 2 * kLeastHalf * whole) return std::nullopt;
      return has_room_on_segment(a, b, midpoint(a, b), wish.apexes) ? std::optional(midpoint(a, b))
                                                                    : std::nullopt;
    }
    const Point foot = place_for(piece, foot_on(a, b, wish.apex), wish.apex);
    const double shorter = std::min(length(foot - a), length(foot - b));
    if (shorter <= kLeastBesideFoot * whole || !has_room_on_segment(a, b, foot, wish.apexes))
      return std::nullopt;
    return foot;
  }

  void note_stuck() {
    stuck_.clear();
    for (std::size_t s = 0; s < pieces_.size(); ++s) {
      const Segment& segment = pslg_.segments[s];
      if (pieces_[s].stuck_from != SeenFrom::none)
        stuck_.push_back(midpoint(at(segment.a), at(segment.b)));
    }
  }

  [[nodiscard]] VertexId first_of_last_cuts() const {
    return VertexId{before_->pslg.points.size()};
  }

  /// Whether what lies in the void, which belongs to no region, may be met by the last cuts; or
  /// cuts of two regions may meet through a void between them.
  [[nodiscard]] bool may_break_void() const {
    if (!table_.void_segments.empty() || !table_.void_points.empty()) return true;
    return std::any_of(before_->cuts.begin(), before_->cuts.end(), [&](const SegmentCut& cut) {
      const SegmentSides& sides = before_->table.sides[cut.segment.index()];
      return sides.left == kVoid || sides.right == kVoid;
    });
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
      before.pieces[s.index()].is_rigid = true;
      mark_dirty(before.table.sides[s.index()]);
    }
    std::erase_if(before.cuts, [&](const SegmentCut& cut) {
      return std::binary_search(rigid.begin(), rigid.end(), cut.segment);
    });
    pslg_ = before.pslg;
    table_ = before.table;
    pieces_ = before.pieces;
    ++before.trials;
    before_ = std::move(before);
    apply(before_->cuts);
  }

  void mark_dirty(const SegmentSides& sides) {
    for (const RegionId r : {sides.left, sides.right}) {
      if (r != kVoid) dirty_[place_of(r)] = 1;
    }
  }

  void apply(const std::vector<SegmentCut>& cuts) {
    std::vector<Piece> pieces;
    auto cut = cuts.begin();
    for (std::size_t s = 0; s < pieces_.size(); ++s) {
      Piece piece = pieces_[s];
      piece.is_to_halve = false;
      pieces.push_back(piece);
      if (cut == cuts.end() || cut->segment.index() != s) continue;
      piece.stuck_from = SeenFrom::none;
      pieces.insert(pieces.end(), cut->points.size(), piece);
      mark_dirty(table_.sides[s]);
      ++cut;
    }
    pieces_ = std::move(pieces);
    cut_segments(pslg_, table_, cuts);
  }

  /// What was before the last cuts, and these.
  struct Before {
    Pslg pslg;
    RegionTable table;
    std::vector<Piece> pieces;
    std::vector<SegmentCut> cuts;
    int trials = 0;  ///< so many of them were taken back
  };

  Pslg& pslg_;
  RegionTable& table_;
  const Options& options_;
  std::size_t uncut_points_;
  /// Feet of what lies on both sides of a narrow strip may be near each other; lengths of pieces
  /// between them are no wish, or finer pieces would follow from them, and so on.
  VertexId first_cut_;
  std::vector<Piece> pieces_;        ///< by segment
  std::vector<std::uint8_t> dirty_;  ///< by region
  std::vector<Point> stuck_;         ///< the middles of segments that are
  std::size_t looked_at_ = 0;        ///< points of regions, in all passes
  LookBudget looks_;
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

Result<std::optional<std::size_t>> count_interface_cuts(Pslg pslg, RegionTable table,
                                                        const Options& options,
                                                        std::size_t most_looks) {
  const std::size_t before = pslg.points.size();
  Result<bool> is_done =
      Splitter(pslg, table, options, before).run({}, kAny, LookBudget(most_looks));
  if (!is_done) return std::move(is_done).error();
  return *is_done ? std::optional(pslg.points.size() - before) : std::nullopt;
}

Result<bool> halve_segments(Pslg& pslg, RegionTable& table, const Options& options,
                            std::size_t uncut_points, std::span<const SegmentId> segments,
                            std::size_t most_points) {
  return Splitter(pslg, table, options, uncut_points).run(segments, most_points);
}

}  // namespace cover
