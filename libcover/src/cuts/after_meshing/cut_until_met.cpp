// Long segments beside short ones are what makes targets hard: no vertex may lie near the middle of
// a side that is to be seen at 90 degrees, and there the vertices for its neighbours are wanted. So
// a few triangles are worked on where they are (cut_and_improve); if some are left, the longest
// segments near each are halved, and the regions beside them are meshed anew.
// Tested by tests/unit/cuts/after_meshing/cut_until_met_test.cpp and cut_and_improve_test.cpp
// beside it.
#include "cuts/after_meshing/cut_until_met.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "cuts/after_meshing/cut_and_improve.hpp"
#include "cuts/after_meshing/mutable_joined_mesh.hpp"
#include "cuts/after_meshing/thin_cuts.hpp"
#include "cuts/before_meshing/split_interfaces.hpp"
#include "method/boundaries_with_wishes.hpp"
#include "options/intent.hpp"
#include "tasks/begin_stage.hpp"
#include "tasks/errors_as_values.hpp"

namespace cover {
namespace {

constexpr int kRounds = 6;
/// Rounds in a row that left no fewer triangles above a target below 90 degrees: more of them only
/// cut. Towards 90 degrees all rounds may be needed: flat layers get worse before they get better.
constexpr int kInVain = 2;
/// So many rounds in a row that left more and more triangles, in the end by half more than the best
/// one, are of no use for any target: where no double has room, each cut forces further ones. With
/// twice as many in place of that, parcels 1 mm apart take a third more time, for nothing.
constexpr int kInVainForAll = 2;
constexpr double kFarMore = 1.5;
/// Of so many points at first one such round is enough: each takes longer than all before it.
constexpr std::size_t kVeryMany = 10'000;
constexpr std::size_t kMostPoints = 4;  ///< times those at first: then there are no more rounds,
                                        ///< and one that makes more is given up
/// So many new points for each triangle that is left are too many as well. Drawings take one or
/// two; in a layer thousands of times as long as thick, each half cuts what faces it, all along.
constexpr std::size_t kMostCutForOne = 32;
constexpr std::size_t kFewPoints = 2'000;  ///< with less, rounds cost so little that all are made
/// With no more than one triangle left for so many points there are no more rounds, where other
/// vertices mend what is left (thin_cuts). Of 2,000 Voronoi cells (SEED 0, 1, 5) at 90 degrees 0,
/// 1 and 0 triangles stay obtuse; without this 1, 0 and 0, with 16, 14 and 10 % more new vertices
/// in a third more time; with 10 in place of 20 it is 0, 3 and 3.
constexpr std::size_t kFewToMend = 20;
/// So many triangles above the target for each point at first are those of a mesh that misses it
/// nearly everywhere: halves do not mend that.
constexpr std::size_t kEverywhere = 4;
/// The same is said by the share of all triangles, of targets below 90 degrees: the smaller ones
/// that halves make miss them as well.
constexpr double kNearlyAll = 2.0 / 3;
/// Evaluations of all searches together, by points at first: some seconds for some thousand points.
/// Each search has half of what the ones before it left. Above 90 degrees ten times as many mean a
/// third of the cuts in the same time (12,000 Voronoi cells); towards 90 degrees halves do more.
constexpr std::uint64_t kEvaluationsPerPoint = 20'000;
constexpr std::uint64_t kEvaluationsAtLeast = 3'000'000;
constexpr std::uint64_t kMostEvaluations = 20'000'000;
constexpr std::uint64_t kMostEvaluationsPerPoint = 10'000, kMostTowardsRightAngles = 1'000;
/// One triangle above the target for so many points is too many for a search, and for more rounds
/// after one in vain: of parcels 1 mm apart each further one leaves half as many again.
constexpr std::size_t kMany = 4;
/// A round that left no less than this part of so many is like one in vain, where other vertices
/// mend what is left: further rounds make no more than halves of it, and take longer than that.
/// Parcels 1 mm apart keep 0.87; Voronoi cells, grains and maps 0.05 to 0.56.
constexpr double kHardlyFewer = 0.75;

/// Work, and what is left above the target in its meshes.
struct JudgedWork {
  Work work;
  CutResult left{};
  std::shared_ptr<MutableJoinedMesh> joined{};  ///< of `work`, which takes long; null: to be made

  [[nodiscard]] std::size_t triangles() const {
    std::size_t sum = 0;
    for (const RegionMesh& mesh : work.meshes) sum += mesh.triangles.size();
    return sum;
  }
};

class Rounds {
 public:
  Rounds(const Options& options, const Callbacks& callbacks, std::uint64_t points)
      : options_(options),
        callbacks_(callbacks),
        goal_(Goal::of(options.max_angle, options.min_angle)),
        budget_{
            evaluations(points, options.max_angle <= Angle::degrees(90) ? kMostTowardsRightAngles
                                                                        : kMostEvaluationsPerPoint),
            callbacks.stop},
        to_spare_(budget_.left - evaluations(points, kMostTowardsRightAngles)) {}

  /// Halves segments beside the triangles that are left and meshes again. False if that takes more
  /// than `most` points.
  Result<bool> halve(JudgedWork& judged, std::size_t most) const {
    std::vector<RegionBoundary> boundaries;
    Result<bool> cut =
        errors_as_values("cut segments", [&] { return cut_further(judged, boundaries, most); });
    if (!cut || !*cut) return cut;
    const auto meshed = mesh_changed(judged.work, std::move(boundaries), options_, callbacks_);
    if (!meshed) return meshed.error();
    return true;
  }

  /// Works on the triangles above the target if they are few; counts them.
  Status improve(JudgedWork& judged) {
    if (Status status = begin_stage("cut", callbacks_); !status) return status;
    return errors_as_values("cut and improve", [&]() -> Status {
      judged.joined = joined(judged.work);
      judged.left = {judged.joined->triangles_above().size()};
      if (judged.left.above > 0 && kMany * judged.left.above <= judged.work.pslg.points.size()) {
        Budget part = budget_.share(2);
        const Result<CutResult> left = cut_and_improve(judged.work, *judged.joined, options_, part);
        if (!left) return left.error();
        judged.left = *left;
        if (judged.joined->has_changed()) judged.joined.reset();
        budget_.take_back(part);
        // What is there for searches that mend is not there for others.
        if (judged.left.was_in_vain) budget_.spend(std::exchange(to_spare_, 0));
      }
      return ok();
    });
  }

 private:
  static std::uint64_t evaluations(std::uint64_t points, std::uint64_t per_point) {
    return kEvaluationsAtLeast +
           std::min(kEvaluationsPerPoint * points, kMostEvaluations + per_point * points);
  }

  [[nodiscard]] std::shared_ptr<MutableJoinedMesh> joined(const Work& work) const {
    return std::make_shared<MutableJoinedMesh>(work.pslg, work.boundaries, work.meshes, goal_);
  }

  Result<bool> cut_further(JudgedWork& judged, std::vector<RegionBoundary>& boundaries,
                           std::size_t most) const {
    Work& work = judged.work;
    if (judged.joined == nullptr) judged.joined = joined(work);
    const std::vector<SegmentId> halved = judged.joined->segments_to_halve();
    judged.joined.reset();  // of the work as it was
    Result<bool> cut =
        halve_segments(work.pslg, work.table, options_, work.report.input_points, halved, most);
    if (!cut || !*cut) return cut;
    Result<std::vector<RegionBoundary>> made =
        boundaries_with_wishes(work.pslg, work.table, options_);
    if (!made) return std::move(made).error();
    boundaries = *std::move(made);
    return true;
  }

  const Options& options_;
  const Callbacks& callbacks_;
  Goal goal_;
  Budget budget_;
  std::uint64_t to_spare_;  ///< of it, what is taken away when a search was in vain
};

/// Whether another round may be of use.
class Prospects {
 public:
  Prospects(const Options& options, const Work& work, CutUntil until)
      : points_(work.pslg.points.size()),
        is_acute_(options.max_angle < Angle::degrees(90)),
        is_mended_after_(until == CutUntil::few_are_left &&
                         wants_thinning(work, work.boundaries, options)) {}

  /// A round that left `now` of `before` triangles.
  void note_round(std::size_t before, std::size_t now, bool is_better) {
    in_vain_ = is_better ? 0 : in_vain_ + 1;
    has_helped_ = static_cast<double>(now) < kHardlyFewer * static_cast<double>(before);
  }

  /// After a round that left `now`, of which the best left `best`.
  [[nodiscard]] bool are_there(const JudgedWork& now, const CutResult& best) const {
    const std::size_t points = now.work.pslg.points.size();
    if (best.above == 0 || points >= kMostPoints * points_) return false;
    if (is_mended_after_ && kFewToMend * now.left.above <= points) return false;
    if (in_vain_ >= (is_acute_ ? kInVain : kRounds)) return false;
    if (points < kFewPoints) return true;
    const bool was_of_use = is_mended_after_ ? has_helped_ : in_vain_ == 0;
    if (!was_of_use && kMany * now.left.above > points) return false;
    const auto above = static_cast<double>(now.left.above);
    if (is_acute_ && above > kNearlyAll * static_cast<double>(now.triangles())) return false;
    const int most_worse = points_ < kVeryMany ? kInVainForAll : 1;
    return now.left.above <= kEverywhere * points_ &&
           (in_vain_ < most_worse || above <= kFarMore * static_cast<double>(best.above));
  }

  /// The points that the next round may lead to.
  [[nodiscard]] std::size_t most_points(const JudgedWork& now) const {
    const std::size_t for_all = now.work.pslg.points.size() + kMostCutForOne * now.left.above;
    return std::max(std::min(kMostPoints * points_, for_all), kFewPoints);
  }

 private:
  std::size_t points_;  ///< at first
  bool is_acute_;       ///< less than 90 degrees are asked for
  bool is_mended_after_;
  int in_vain_ = 0;         ///< rounds since the last one that left fewer triangles
  bool has_helped_ = true;  ///< the last one left far fewer than the one before it
};

/// Halves segments and improves in turn, as long as that may be of use. Keeps in `best` what leaves
/// the fewest triangles above the target.
Status halve_in_rounds(JudgedWork& best, Rounds& rounds, Prospects prospects) {
  Status status = rounds.improve(best);
  JudgedWork now = best;
  best.joined.reset();
  for (int k = 0; k < kRounds && status && prospects.are_there(now, best.left); ++k) {
    const Result<bool> halved = rounds.halve(now, prospects.most_points(now));
    if (!halved) return halved.error();
    if (!*halved) break;
    const std::size_t before = now.left.above;
    status = rounds.improve(now);
    const bool is_better = status && now.left.above < best.left.above;
    prospects.note_round(before, now.left.above, is_better);
    if (!is_better) continue;
    best = now;
    best.joined.reset();  // only what is worked on needs it
  }
  return status;
}

/// What was cut since there were `before` points.
Note note_of_cuts(const Pslg& pslg, std::size_t before, const Options& options) {
  std::vector<Point> where(pslg.points.begin() + static_cast<std::ptrdiff_t>(before),
                           pslg.points.end());
  return {Note::Kind::cut, kVoid,
          fmt::format("{} added on segments where triangles were left above {:.6g} degrees, the "
                      "first at {}",
                      counted(pslg.points.size() - before, "point"), options.max_angle.in_degrees(),
                      describe(where.front())),
          std::move(where)};
}

}  // namespace

Status cut_until_met(Work& work, const Options& options, const Callbacks& callbacks,
                     CutUntil until) {
  if (!is_cut_until_met(options) || !work.table.hull_sides.empty()) return ok();
  const std::size_t points = work.pslg.points.size();
  Rounds rounds(options, callbacks, points);
  const Prospects prospects(options, work, until);
  JudgedWork best{std::move(work)};
  Status status = halve_in_rounds(best, rounds, prospects);
  if (!status) return status;
  work = std::move(best.work);
  return errors_as_values("measure", [&] {
    measure_again(work, options, best.left.budget_used_up ? Unreached::budget : Unreached::unknown);
    if (work.pslg.points.size() > points)
      work.report.notes.push_back(note_of_cuts(work.pslg, points, options));
    return ok();
  });
}

}  // namespace cover
