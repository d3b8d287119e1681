// Constructions are rounded, checks are exact. A trial that fails a check names the almonds at
// fault; these are made a little flatter (any nu between min(B, 60 degrees) and nu(A) keeps Theorem
// 1), then as flat as that allows, then replaced by the side's own triangle, then left out; and all
// is laid out anew. A region with no almonds left is its own remainder, which cannot fail, so this
// ends. (That remainder is not laid out: on a side of the hull that may be split, rounding would
// see vertices that are only next to it.)
#include "almond/almond_method.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <unordered_set>

#include <fmt/core.h>

#include "almond/almond_triangles.hpp"
#include "almond/arc_layer.hpp"
#include "almond/arc_walk.hpp"
#include "base/containers/order.hpp"
#include "base/faults/internal_fault.hpp"
#include "geom/predicates.hpp"

namespace cover {
namespace {

/// With k = 0.495 the almond triangles keep a little more than half of nu(A); so much may be given
/// away.
constexpr double kSlack = 0.005;
/// After so many trials all almonds are left out.
constexpr int kTrials = 40;
/// From this trial on points are united from as far apart as ever; only repairs change anything.
constexpr int kUnited = 4;
/// Fewer trials where each looks at so much, as in a region whose points are all nearly on a line:
/// there every almond reaches every triangle.
constexpr int kTrialsAtLeast = 8;
constexpr std::size_t kMostVisits = 10'000'000;
constexpr std::size_t kMostVisitsPerAlmond = 1'000;
/// From kUnited on so many crossings are repaired in a trial: one by one, hundreds of them would
/// use up all trials.
constexpr std::size_t kMostConflicts = 200;
/// After so many rounds of waking some almonds, all are woken.
constexpr int kRounds = 4;

class AlmondMethod {
 public:
  AlmondMethod(const AlmondInput& input, const CutRule& rule, const FillPlan& plan,
               const std::stop_token& stop)
      : input_(input),
        rule_(rule),
        plan_(plan),
        stop_(stop),
        almonds_(make_almonds(input.cdt, input.sides, input.segments, input.limit, input.origin,
                              input.team)),
        repairs_(almonds_.size(), 0) {
    const double b = std::min(input.limit.nu, std::numbers::pi / 3);
    least_nu_ = rule.paper ? b : (1 - kSlack) * b;
    find_isolated();
    for (const Almond& a : almonds_) {
      if (a.kind == AlmondKind::hull_side) hull_triangles_.insert(a.base.triangle);
    }
    flatten_below_resolution();
    for (const Almond& almond : almonds_) awake_kind_.push_back(almond.kind);
    asleep_.assign(almonds_.size(), false);
    if (input.sparing) {
      for (std::uint32_t k = 0; k < almonds_.size(); ++k) put_to_sleep(k);
    }
  }

  AlmondMesh run() {
    for (int trial = 0;; ++trial) {
      // Points that should have been one can be farther apart than a first guess says.
      const double unite = trial == 0 ? 1 : trial < kUnited ? 0x1p+10 : 0x1p+20;
      const std::vector<std::uint32_t> blamed =
          try_once(unite, trial < kUnited ? 1 : kMostConflicts);
      if (blamed.empty()) break;
      if (wake(blamed)) {
        --trial;
        all_left_out_ = false;
      } else if (all_left_out_) {
        throw InternalFault("almonds: a region without almonds fails", {input_.cdt.points.front()});
      } else if (trial < kTrials && !(trial >= kTrialsAtLeast && has_visited_enough()) &&
                 (repair(blamed, /*unite_first=*/trial == 0 && rule_.paper) || trial < kUnited)) {
        continue;
      } else {
        for (Almond& almond : almonds_) leave_out(almond);
        all_left_out_ = true;
      }
    }
    drop_unused();
    report_repairs();
    return std::move(mesh_);
  }

 private:
  /// One trial; returns the almonds at fault or to be woken, none if mesh_ is complete.
  std::vector<std::uint32_t> try_once(double unite, std::size_t most_conflicts) {
    ChordLayer layer =
        all_left_out_ ? chords_of_sides() : cut_chords(lay_out(unite), almonds_, rule_);
    if (!layer.blamed.empty()) return layer.blamed;
    const bool no_almonds =
        all_left_out_ || (std::none_of(almonds_.begin(), almonds_.end(),
                                       [](const Almond& a) { return a.has_arc(); }) &&
                          layer.chords.size() == almonds_.size());
    Remainder remainder =
        no_almonds ? whole_region(input_.cdt, layer, almonds_)
                   : find_remainder(layer, almonds_, isolated_off_arcs(layer), most_conflicts);
    if (!remainder.blamed.empty()) return remainder.blamed;

    mesh_.points = std::move(layer.points);
    mesh_.triangles.clear();
    SplitChords splits;
    splits.first.assign(layer.chords.size() + 1, 0);
    if (!remainder.chords.empty()) {
      std::vector<std::uint32_t> vertex = std::move(remainder.vertex);
      const std::vector<std::uint32_t> arc_chord = std::move(remainder.arc_chord);
      RemainderFill fill(std::move(remainder), plan_, memory_, rule_.nu, stop_, input_.team);
      std::vector<std::uint32_t> sleeping;
      for (const std::uint32_t c : fill.refine()) {
        const std::uint32_t k = layer.chords[arc_chord[c]].almond;
        if (asleep_[k]) sleeping.push_back(k);
      }
      if (!sleeping.empty()) return sleeping;
      add_fill(fill.finish(), std::move(vertex), arc_chord, splits);
    }
    std::vector<std::uint32_t> blamed =
        triangulate_almonds(almonds_, layer, splits, rule_, mesh_.points, mesh_.triangles);
    if (!blamed.empty()) return blamed;
    return almonds_over_lost_points();
  }

  ArcLayer lay_out(double unite) {
    ArcLayer layer = lay_arcs(input_.cdt, almonds_, unite, input_.team);
    visits_ += layer.visits;
    return layer;
  }

  [[nodiscard]] bool has_visited_enough() const {
    return visits_ > kMostVisits + kMostVisitsPerAlmond * almonds_.size();
  }

  /// The chords of a region without almonds: its sides, those of the hull to be split as needed.
  [[nodiscard]] ChordLayer chords_of_sides() const {
    ChordLayer layer;
    layer.points = input_.cdt.points;
    for (std::uint32_t k = 0; k < almonds_.size(); ++k) {
      const Almond& a = almonds_[k];
      const ChordKind kind =
          a.kind == AlmondKind::hull_side ? ChordKind::exterior : ChordKind::fixed;
      layer.first.push_back(k);
      layer.chords.push_back({a.u, a.v, k, kind, 0, 1});
    }
    layer.first.push_back(static_cast<std::uint32_t>(almonds_.size()));
    return layer;
  }

  void find_isolated() {
    std::vector<bool> on_side(input_.cdt.points.size(), false);
    for (const auto& [u, v] : input_.sides) on_side[u] = on_side[v] = true;
    for (std::uint32_t v = 0; v < on_side.size(); ++v) {
      if (!on_side[v]) isolated_.push_back(v);
    }
  }

  /// Isolated points that the fill has to take care of.
  [[nodiscard]] std::vector<std::uint32_t> isolated_off_arcs(const ChordLayer& layer) const {
    if (isolated_.empty()) return {};
    std::vector<bool> on_arc(input_.cdt.points.size(), false);
    for (const ArcChord& chord : layer.chords) {
      if (chord.a < on_arc.size()) on_arc[chord.a] = true;
    }
    std::vector<std::uint32_t> off;
    for (const std::uint32_t v : isolated_) {
      if (!on_arc[v]) off.push_back(v);
    }
    return off;
  }

  /// Takes over the triangles of the remainder, whose vertices and chords have the numbers given,
  /// and what was put on its chords.
  void add_fill(FilledRemainder filled, std::vector<std::uint32_t> vertex,
                std::span<const std::uint32_t> arc_chord, SplitChords& splits) {
    mesh_.points.reserve(mesh_.points.size() + filled.points.size() - vertex.size());
    for (std::size_t v = vertex.size(); v < filled.points.size(); ++v) {
      vertex.push_back(static_cast<std::uint32_t>(mesh_.points.size()));
      mesh_.points.push_back(filled.points[v]);
    }
    // An empty almond has one chord, and no triangle; others have a triangle per piece of chord,
    // and sometimes one more.
    const std::size_t inner = splits.first.size() - 1 - almonds_.size();
    mesh_.triangles.reserve(filled.triangles.size() + 3 * inner + filled.splits.size());
    for (const auto& t : filled.triangles) {
      mesh_.triangles.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
    }
    mesh_.fallbacks = std::move(filled.fallbacks);
    // Chords of the remainder are in the order of the chord layer.
    for (const ChordSplit& split : filled.splits) {
      splits.first[arc_chord[split.chord] + 1] = static_cast<std::uint32_t>(split.vertices.size());
      for (const std::uint32_t v : split.vertices) splits.vertices.push_back(vertex[v]);
    }
    for (std::size_t c = 1; c < splits.first.size(); ++c) splits.first[c] += splits.first[c - 1];
  }

  /// Almonds that cover a point which has no triangle.
  [[nodiscard]] std::vector<std::uint32_t> almonds_over_lost_points() const {
    if (isolated_.empty()) return {};
    std::vector<bool> used(input_.cdt.points.size(), false);
    for (const auto& t : mesh_.triangles) {
      for (const std::uint32_t v : t) {
        if (v < used.size()) used[v] = true;
      }
    }
    std::vector<std::uint32_t> blamed;
    for (const std::uint32_t v : isolated_) {
      if (used[v]) continue;
      const Point p = input_.cdt.points[v];
      for (std::uint32_t k = 0; k < almonds_.size(); ++k) {
        const Almond& a = almonds_[k];
        if (a.has_arc() && a.power(p) < 0x1p-20 * a.length * a.length && a.on_the_arc(p)) {
          blamed.push_back(k);
        }
      }
    }
    return blamed;
  }

  void flatten_below_resolution() {
    for (std::uint32_t k = 0; k < almonds_.size(); ++k) {
      Almond& a = almonds_[k];
      if (a.kind != AlmondKind::whole || a.height() >= kFlatArc * a.resolution) continue;
      replace_by_triangle(a);
      mesh_.remarks.push_back(
          {Note::Kind::below_resolution, k,
           fmt::format("is too flat for double coordinates (height {:.3g}, spacing {:.3g})",
                       a.height(), a.resolution)});
    }
  }

  void put_to_sleep(std::uint32_t k) {
    if (almonds_[k].kind == AlmondKind::hull_side) return;
    almonds_[k].kind = AlmondKind::none;
    asleep_[k] = true;
  }

  /// Wakes those of `almonds` that sleep, and with them the sides that pass through an almond
  /// awake: only their own almonds keep its arc from running on behind them. False if none slept.
  bool wake(const std::vector<std::uint32_t>& almonds) {
    std::vector<std::uint32_t> stack;
    const auto wake_one = [&](std::uint32_t k) {
      if (k == kNone || !asleep_[k]) return;
      asleep_[k] = false;
      almonds_[k].kind = awake_kind_[k];
      stack.push_back(k);
    };
    for (const std::uint32_t k : almonds) wake_one(k);
    if (stack.empty()) return false;
    if (++rounds_ >= kRounds) {
      for (std::uint32_t k = 0; k < almonds_.size(); ++k) wake_one(k);
      return true;
    }
    find_cuts();
    while (!stack.empty()) {
      const std::uint32_t k = stack.back();
      stack.pop_back();
      auto cut = std::lower_bound(cuts_.begin(), cuts_.end(), Cut{k, 0});
      for (; cut != cuts_.end() && (*cut)[0] == k; ++cut) wake_one((*cut)[1]);
    }
    return true;
  }

  /// Which sides pass through which almonds, all of them being awake.
  void find_cuts() {
    if (rounds_ > 1) return;
    std::vector<Almond> all = almonds_;
    for (std::uint32_t k = 0; k < all.size(); ++k) all[k].kind = awake_kind_[k];
    cuts_ = walk_almonds(input_.cdt, all).cuts;
    std::sort(cuts_.begin(), cuts_.end());
  }

  static void leave_out(Almond& a) {
    if (a.kind != AlmondKind::hull_side) a.kind = AlmondKind::none;
  }

  /// A side of the hull may be split, the side's triangle not: none where the two share an edge.
  void replace_by_triangle(Almond& a) const {
    const bool fits = a.apex_limits && !hull_triangles_.contains(a.base.triangle);
    a.kind = fits ? AlmondKind::triangle : AlmondKind::none;
  }

  /// False if that changed nothing: the next trial would end as this one did.
  bool repair(std::vector<std::uint32_t> blamed, bool unite_first) {
    sort_unique(blamed);
    bool is_changed = false;
    for (const std::uint32_t k : blamed) {
      if (unite_first) {
        is_changed = is_changed || repairs_[k] == 0;
        repairs_[k] = std::max(repairs_[k], 1);
      } else {
        is_changed = weaken(k) || is_changed;
      }
    }
    return is_changed;
  }

  /// False if it is as weak as can be.
  bool weaken(std::uint32_t k) {
    Almond& a = almonds_[k];
    ++repairs_[k];
    if (a.kind == AlmondKind::hull_side || a.kind == AlmondKind::none) return false;
    if (!a.has_arc()) {
      leave_out(a);
      return true;
    }
    if (a.nu <= least_nu_) {
      a.set_nu(full_nu(k));
      replace_by_triangle(a);
      return true;
    }
    const double factor = repairs_[k] <= 1 ? 0.97 : repairs_[k] == 2 ? 0.8 : 0;
    a.kind = AlmondKind::shrunk;
    a.set_nu(std::max(least_nu_, factor * full_nu(k)));
    return true;
  }

  [[nodiscard]] double full_nu(std::uint32_t k) const {
    return std::min(input_.limit.side_nu[k], std::numbers::pi / 3);
  }

  /// Removes meetings that were united, and the like.
  void drop_unused() {
    const std::size_t inputs = input_.cdt.points.size();
    std::vector<std::uint32_t> number(mesh_.points.size(), kNone);
    for (const auto& t : mesh_.triangles) {
      for (const std::uint32_t v : t) number[v] = 0;
    }
    std::size_t next = inputs;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (v < inputs) {
        number[v] = static_cast<std::uint32_t>(v);
      } else if (number[v] != kNone) {
        mesh_.points[next] = mesh_.points[v];
        number[v] = static_cast<std::uint32_t>(next++);
      }
    }
    mesh_.points.resize(next);
    for (auto& t : mesh_.triangles) {
      for (std::uint32_t& v : t) v = number[v];
    }
  }

  void report_repairs() {
    for (std::uint32_t k = 0; k < almonds_.size(); ++k) {
      if (repairs_[k] == 0 || asleep_[k]) continue;
      const Almond& a = almonds_[k];
      std::string what;
      if (a.kind == AlmondKind::none) {
        what = "was left out";
      } else if (a.kind == AlmondKind::triangle) {
        what = "was replaced by the side's own triangle";
      } else if (a.kind == AlmondKind::shrunk) {
        what = fmt::format("was made flatter, to {:.4g} of its angle", a.nu / full_nu(k));
      } else {
        what = "had vertices united with near ones";
      }
      mesh_.remarks.push_back({Note::Kind::repair, k, what + " because of rounding"});
    }
  }

  const AlmondInput& input_;
  const CutRule& rule_;
  const FillPlan& plan_;
  FillMemory memory_;
  const std::stop_token& stop_;
  std::vector<Almond> almonds_;
  using Cut = std::array<std::uint32_t, 2>;
  std::vector<AlmondKind> awake_kind_;                ///< by almond
  std::vector<bool> asleep_;                          ///< by almond: not needed so far
  int rounds_ = 0;                                    ///< of waking
  std::size_t visits_ = 0;                            ///< in all trials
  bool all_left_out_ = false;                         ///< after kTrials trials
  std::vector<Cut> cuts_;                             ///< (almond, side through it), in order
  std::vector<int> repairs_;                          ///< by almond
  std::unordered_set<std::uint32_t> hull_triangles_;  ///< with a side of the hull
  double least_nu_ = 0;                               ///< almonds may be made as flat as this
  std::vector<std::uint32_t> isolated_;
  AlmondMesh mesh_;
};

}  // namespace

AlmondMesh mesh_by_almonds(const AlmondInput& input, const CutRule& rule, const FillPlan& plan,
                           const std::stop_token& stop) {
  return AlmondMethod(input, rule, plan, stop).run();
}

}  // namespace cover
