// A question is settled by one side. The side that settled the last one is asked first: the
// questions of prove() differ in a degree or two.
// Tested by tests/unit/limits/angles/limit_prover_test.cpp.
#include "limits/angles/limit_prover.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <cover/judged_angle.hpp>

#include "base/numbers.hpp"
#include "geom/cotangent.hpp"
#include "geom/vector.hpp"
#include "limits/angles/apex_search.hpp"
#include "limits/angles/clear_zones.hpp"
#include "limits/angles/fan_growth.hpp"

namespace cover {
namespace {

constexpr double kSixty = std::numbers::pi / 3;
/// Questions are put at these distances beyond what was reached. A limit within the first is near,
/// within `kExactQuestion` it is no gap.
constexpr double kNearQuestion = kDegree, kExactQuestion = 1e-6 * kDegree,
                 kFarQuestion = 5 * kDegree;

/// Sides of a region in which all are asked about the largest angle.
constexpr std::size_t kFewSides = 64;

/// The effort for what is far, which is seen at once or not worth its time.
ProofEffort quick(ProofEffort effort) {
  effort.per_search = effort.at_first;
  return effort;
}

/// The effort for what is a hair's breadth away: corners see that, or the first boxes.
ProofEffort glance(ProofEffort effort) {
  constexpr std::uint64_t kFirstBoxes = 2;
  if (!effort.asks_far)
    effort.per_search = effort.at_first = std::min(effort.at_first, kFirstBoxes);
  return effort;
}

ProofEffort without_boxes(ProofEffort effort) {
  effort.per_search = effort.at_first = 0;
  return effort;
}

/// The effort for the largest angle: of 940 Voronoi cells that miss their target 5 are near by what
/// corners say, and 2 more by boxes, which are better spent on the smallest angle.
ProofEffort by_corners(ProofEffort effort) {
  return effort.asks_far ? effort : without_boxes(effort);
}

}  // namespace

LimitProver::LimitProver(const Triangulation& cdt, const Team& team)
    : view_(cdt), team_(team), nu_opt_(std::numbers::pi) {
  for (const RegionSide& side : view_.sides()) nu_opt_ = std::min(nu_opt_, side.nu_opt);
}

/// One question, put to one side after the other. A team asks sides ahead, as many as the budget
/// pays for in any case; what they say counts in the order of the sides, so that the outcome is the
/// same.
class LimitProver::Question {
 public:
  Question(const RegionView& view, const Team& team, const FanGrowth& growth, Meshes meshes,
           double smallest_box)
      : view_(view), team_(team), growth_(growth), meshes_(meshes), smallest_box_(smallest_box) {}

  /// Asks `sides` for `most_boxes` each, but the first one for `of_first`. Those that need more are
  /// left in `sides`.
  ///
  /// ENSURES: the side that settles it, if there is one
  std::optional<std::uint32_t> put(std::vector<std::uint32_t>& sides, std::uint64_t most_boxes,
                                   std::uint64_t of_first, std::uint64_t& budget) {
    std::size_t left = 0, asked = 0;
    for (std::size_t k = 0; k < sides.size() && budget > 0; ++k) {
      const std::uint64_t most = k == 0 ? of_first : most_boxes;
      const std::uint64_t given = std::min(budget, most);
      if (k >= asked && k > 0) {
        asked = k + std::min<std::uint64_t>({sides.size() - k, budget / most_boxes, kMostAhead});
        asked = team_.workers() > 1 && asked - k >= 2 * kAtATime ? asked : k;
        ask_ahead(std::span(sides).subspan(k, asked - k), most_boxes);
        first_ = k;
      }
      const Answer answer = k < asked ? answers_[k - first_] : ask(sides[k], given);
      budget -= answer.boxes;
      if (answer.is_settled) return sides[k];
      if (answer.boxes == given) sides[left++] = sides[k];
    }
    sides.resize(left);
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kAtATime = 64;  ///< sides that one thread asks
  /// More might be asked in vain after one that settles it.
  static constexpr std::size_t kMostAhead = 1 << 17;
  static constexpr std::size_t kParts = 64;  ///< that a team divides its sides into, at most

  /// What a side says, and after how many boxes.
  struct Answer {
    std::uint64_t boxes = 0;
    bool is_settled = false;
  };
  /// For one thread at a time. What it remembers changes no answer.
  struct Asker {
    Asker(const RegionView& view, const FanGrowth& growth, Meshes meshes, double smallest_box)
        : zones(view, growth.range().most, meshes), search(view, zones, growth, smallest_box) {}
    ClearZones zones;
    ApexSearch search;
  };

  Answer ask(std::uint32_t side, std::uint64_t given) {
    if (askers_.empty()) askers_.push_back(new_asker());
    return ask(*askers_.front(), side, given);
  }
  static Answer ask(Asker& asker, std::uint32_t side, std::uint64_t given) {
    std::uint64_t share = given;
    const bool is_settled = asker.search.has_none(side, share);
    return {given - share, is_settled};
  }

  void ask_ahead(std::span<const std::uint32_t> sides, std::uint64_t most_boxes) {
    if (sides.empty()) return;
    answers_.resize(sides.size());
    const std::size_t size = std::max(kAtATime, sides.size() / kParts);
    team_.each_range(sides.size(), size, [&](std::size_t first, std::size_t last) {
      std::unique_ptr<Asker> asker = take_asker();
      for (std::size_t k = first; k < last; ++k) answers_[k] = ask(*asker, sides[k], most_boxes);
      give_back(std::move(asker));
    });
  }
  [[nodiscard]] std::unique_ptr<Asker> new_asker() const {
    return std::make_unique<Asker>(view_, growth_, meshes_, smallest_box_);
  }
  std::unique_ptr<Asker> take_asker() {
    {
      const std::lock_guard lock(mutex_);
      if (!askers_.empty()) {
        std::unique_ptr<Asker> asker = std::move(askers_.back());
        askers_.pop_back();
        return asker;
      }
    }
    return new_asker();
  }
  void give_back(std::unique_ptr<Asker> asker) {
    const std::lock_guard lock(mutex_);
    askers_.push_back(std::move(asker));
  }

  const RegionView& view_;
  const Team& team_;
  const FanGrowth& growth_;
  Meshes meshes_;
  double smallest_box_;
  std::vector<Answer> answers_;  ///< of the sides from first_ on
  std::size_t first_ = 0;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Asker>> askers_;  ///< that nobody uses
};

void LimitProver::exempt(std::span<const IndexPair> sides) {
  view_.exempt(sides);
  coupled_ = {};
}

bool LimitProver::refutes(AngleRange range, std::uint64_t& budget, const ProofEffort& effort,
                          Meshes meshes) {
  return refutes(range, budget, effort, meshes, Asked::all);
}

bool LimitProver::refutes(AngleRange range, std::uint64_t& budget, const ProofEffort& effort,
                          Meshes meshes, Asked asked) {
  const double lemma_1 = std::numbers::pi - nu_opt_;
  if (range.most < std::max(lemma_1, kSixty) - kAngleSlack) return true;
  if (range.least > std::min(nu_opt_ / 2, kSixty) + kAngleSlack) return true;
  range.most = std::max(range.most, lemma_1) + kAngleSlack;
  if (range.most >= std::numbers::pi) return false;
  if (is_known_to_refute(range, meshes)) return true;
  if (is_known_as_open(range, effort, meshes)) return false;
  range.least = std::min(range.least, kSixty);
  const FanGrowth growth(range);
  Known& known = meshes == Meshes::all ? all_ : coupled_;
  if (corners_refute(growth, meshes) || ask_sides(growth, budget, effort, meshes, asked)) {
    known.refuted.push_back({range, 0});
    return true;
  }
  if (asked == Asked::all) known.open.push_back({range, effort.per_search});
  return false;
}

/// Which meshes are proven not to keep to the range: all, or some of them.
std::optional<Meshes> LimitProver::kept_out(const AngleRange& range, std::uint64_t& budget,
                                            const ProofEffort& effort, Meshes meshes, Asked asked) {
  if (meshes == Meshes::all) {
    if (refutes(range, budget, effort, Meshes::all, asked)) return Meshes::all;
    return std::nullopt;
  }
  if (refutes(range, budget, without_boxes(effort), Meshes::all, asked)) return Meshes::all;
  if (!refutes(range, budget, effort, meshes, asked)) return std::nullopt;
  const Asked again = effort.asks_far ? Asked::all : Asked::last;
  return refutes(range, budget, effort, Meshes::all, again) ? Meshes::all : meshes;
}

/// A range within one that no mesh keeps to; what is said of all is said of the coupled ones.
bool LimitProver::is_known_to_refute(const AngleRange& range, Meshes meshes) const {
  const auto is_within = [&](const Answer& known) {
    return range.most <= known.range.most && range.least >= known.range.least;
  };
  return std::any_of(all_.refuted.begin(), all_.refuted.end(), is_within) ||
         (meshes == Meshes::coupled &&
          std::any_of(coupled_.refuted.begin(), coupled_.refuted.end(), is_within));
}

/// A range that holds the angles of some mesh, or around one that was asked about in vain, with as
/// much effort. What is not proven of the coupled ones is not proven of all.
bool LimitProver::is_known_as_open(const AngleRange& range, const ProofEffort& effort,
                                   Meshes meshes) const {
  const auto is_kept = [&](const AngleRange& mesh) {
    return mesh.most <= range.most && mesh.least >= range.least;
  };
  const auto is_around = [&](const Answer& known) {
    return range.most >= known.range.most && range.least <= known.range.least &&
           effort.per_search <= known.per_search;
  };
  const auto says_so = [&](const Known& known) {
    return std::any_of(known.open.begin(), known.open.end(), is_around);
  };
  return says_so(coupled_) || (meshes == Meshes::all &&
                               (says_so(all_) || std::any_of(seen_.begin(), seen_.end(), is_kept)));
}

/// Whether a corner's sides differ too much in length for the triangles that fill it: what settles
/// most questions about lots of land, before any place is looked at.
bool LimitProver::corners_refute(const FanGrowth& growth, Meshes meshes) {
  const auto sides = view_.sides();
  const auto refuter = std::find_if(sides.begin(), sides.end(), [&](const RegionSide& side) {
    const RegionCorner& corner = view_.corner(side.start);
    const double before =
        length(view_.point(view_.seen_from(corner).back().vertex) - view_.point(side.a));
    const double after = length(view_.point(side.b) - view_.point(side.a));
    const double ratio = std::max(before / after, after / before);
    const double low = corner.angle - kAngleSlack, high = corner.angle + kAngleSlack;
    if (!growth.may_lead(low, high, ratio)) return true;
    if (meshes == Meshes::all || growth.range().least == 0) return false;
    const auto may_end = [&](const RegionSide& last, double times) {
      FanGrowth::Ending ending{apex_range(last, growth.range(), meshes)};
      return growth.may_end(low, high, times, times, ending);
    };
    return !may_end(sides[corner.before], before / after) || !may_end(side, after / before);
  });
  if (refuter == sides.end()) return false;
  if (meshes == Meshes::coupled) {  // which all are asked about next
    last_refuter_ = static_cast<std::uint32_t>(refuter - sides.begin());
    has_refuter_ = true;
  }
  return true;
}

bool LimitProver::ask_sides(const FanGrowth& growth, std::uint64_t& budget,
                            const ProofEffort& effort, Meshes meshes, Asked asked) {
  if (effort.per_search == 0 || (asked == Asked::last && !has_refuter_)) return false;
  const AngleRange range = growth.range();
  Question question(view_, team_, growth, meshes, effort.smallest_box);
  const auto sides = static_cast<std::uint32_t>(view_.sides().size());
  undecided_.clear();
  if (asked == Asked::last) undecided_.push_back(last_refuter_);
  for (std::uint32_t k = 0; k < sides && asked == Asked::all; ++k) {
    const std::uint32_t side = (last_refuter_ + k) % sides;
    if (is_worth_asking(view_.sides()[side], range)) undecided_.push_back(side);
  }
  if (!has_refuter_ && range.least > 0) ask_worst_first();
  // The side that settled the last question, or else the one with the smallest angles, settles
  // most: it is asked in full at once.
  const bool is_first_likely = (has_refuter_ || range.least > 0) && asked == Asked::all;
  const std::uint32_t first = undecided_.empty() ? kNone : undecided_.front();
  // Most sides are done after a few boxes; only then is it worth while to ask the others for more.
  for (const std::uint64_t most_boxes : {effort.at_first, effort.per_search}) {
    const bool is_first_round = most_boxes == effort.at_first;
    if (!is_first_round && is_first_likely && !undecided_.empty() && undecided_.front() == first)
      undecided_.erase(undecided_.begin());
    const std::uint64_t of_first =
        is_first_round && is_first_likely ? effort.per_search : most_boxes;
    if (const auto settled = question.put(undecided_, most_boxes, of_first, budget)) {
      last_refuter_ = *settled;
      has_refuter_ = true;
      return true;
    }
    if (budget == 0 || most_boxes >= effort.per_search) return false;
  }
  return false;
}

/// Whether the mesh does not show that the side settles nothing. With the largest angle of the mesh
/// in the range all that forbids an apex looks at the triangles at the ends of the side, but for
/// what only larger angles than that could bring about. Else, which is asked about the largest
/// angle alone, zones and wedges reach farther: then this is a guess that saves time in large
/// regions, where few sides are near the angle in question.
bool LimitProver::is_worth_asking(const RegionSide& side, const AngleRange& range) const {
  if (mesh_.least_cot.empty()) return true;
  if (range.least > 0)
    return std::max(mesh_.most_cot[side.a], mesh_.most_cot[side.b]) > cot_of(range.least);
  return view_.sides().size() <= kFewSides ||
         std::min(mesh_.least_near[side.a], mesh_.least_near[side.b]) < cot_of(range.most);
}

/// Sides with the smallest angles of the mesh at both ends settle most questions.
void LimitProver::ask_worst_first() {
  if (mesh_.most_cot.empty()) return;
  const auto worst = [this](std::uint32_t s) {
    const RegionSide& side = view_.sides()[s];
    return std::min(mesh_.most_cot[side.a], mesh_.most_cot[side.b]);
  };
  std::stable_sort(undecided_.begin(), undecided_.end(),
                   [&](std::uint32_t s, std::uint32_t t) { return worst(s) > worst(t); });
}

bool LimitProver::is_near(const ReachedAngles& reached, const ReachedAngles& wanted,
                          const ProofEffort& effort) {
  const double lowest = std::max(std::numbers::pi - nu_opt_, kSixty);
  std::uint64_t budget = effort.per_region + effort.per_side * view_.sides().size();
  if (!meets(reached.largest_nu, wanted.largest_nu)) {
    const double most = std::numbers::pi - reached.largest_nu.in_radians() - kNearQuestion;
    if (most > lowest && !refutes({most, 0}, budget, effort)) return false;
  }
  if (meets(reached.smallest, wanted.smallest)) return true;
  const double least = reached.smallest.in_radians() + kNearQuestion;
  if (least >= std::min((std::numbers::pi - lowest) / 2, kSixty)) return true;
  const double most =
      std::numbers::pi - std::min(reached.largest_nu, wanted.largest_nu).in_radians();
  return refutes({most, least}, budget, effort);
}

ProvenLimits LimitProver::prove(const ReachedAngles& reached, const ReachedAngles& wanted,
                                const ProofEffort& effort, Meshes meshes) {
  const double lowest = std::max(std::numbers::pi - nu_opt_, kSixty);
  const double largest = std::numbers::pi - reached.largest_nu.in_radians();
  const double smallest = reached.smallest.in_radians();
  std::uint64_t budget = effort.per_region + effort.per_side * view_.sides().size();

  // With all effort everybody is asked how near the limit is: what that says does not depend on the
  // order of the sides, as the side that settled the question before does.
  const Asked exact = effort.asks_far ? Asked::all : Asked::last;
  ProvenLimits limits;
  double largest_limit = lowest;
  if (reached.largest_nu < wanted.largest_nu) {
    const auto ask = [&](double gap, Meshes of, Asked asked) {
      if (largest - gap <= largest_limit) return true;
      const ProofEffort for_this = by_corners(gap == kNearQuestion ? effort : quick(effort));
      const auto kept = kept_out({largest - gap, 0}, budget, for_this, of, asked);
      if (!kept) return false;
      largest_limit = largest - gap;
      limits.of_largest = *kept;
      return true;
    };
    // What is open by a degree is hardly ever closed by five.
    if (ask(kNearQuestion, meshes, Asked::all)) ask(kExactQuestion, limits.of_largest, exact);
  }

  const double most =
      std::numbers::pi - std::min(reached.largest_nu, wanted.largest_nu).in_radians();
  double smallest_limit = std::min((std::numbers::pi - lowest) / 2, kSixty);
  if (reached.smallest < wanted.smallest) {
    // In large regions most sides have angles just above what is wanted, and would all be asked.
    const double beyond = view_.sides().size() <= kFewSides
                              ? kNearQuestion
                              : std::min(kNearQuestion, wanted.smallest.in_radians() - smallest);
    const auto ask = [&](double gap, const ProofEffort& for_this, Meshes of, Asked asked) {
      if (smallest + gap >= smallest_limit) return true;
      const auto kept = kept_out({most, smallest + gap}, budget, for_this, of, asked);
      if (!kept) return false;
      smallest_limit = smallest + gap;
      limits.of_smallest = *kept;
      return true;
    };
    if (ask(beyond, effort, meshes, Asked::all)) {
      ask(kExactQuestion, glance(quick(effort)), limits.of_smallest, exact);
    } else if (effort.asks_far && view_.sides().size() <= kFewSides) {
      ask(kFarQuestion, quick(effort), Meshes::all, Asked::all);
    }
  }
  // Rounding of the mesh's own coordinates must not make it better than its limit.
  limits.largest_nu = Angle::radians(std::numbers::pi - std::min(largest_limit, largest));
  limits.smallest = Angle::radians(std::max(smallest_limit, smallest));
  limits.under = Angle::radians(std::numbers::pi - most);
  return limits;
}

}  // namespace cover
