// A question is settled by one side. The side that settled the last one is asked first: the
// questions of prove() differ in a degree or two. Tested by
// tests/unit/limits/limit_prover_test.cpp.
#include "limits/limit_prover.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limits/apex_search.hpp"
#include "limits/clear_zones.hpp"
#include "limits/fan_growth.hpp"

namespace cover {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSixty = std::numbers::pi / 3;
/// Questions are put at these distances beyond what was reached. A limit within the first is near,
/// within `kExactQuestion` it is no gap.
constexpr double kNearQuestion = kDegree, kExactQuestion = 1e-6 * kDegree,
                 kFarQuestion = 5 * kDegree;

/// The effort for what is exact, which is mostly seen at once.
ProofEffort quick(ProofEffort effort) {
  effort.per_search = effort.at_first;
  return effort;
}

}  // namespace

LimitProver::LimitProver(const Triangulation& cdt) : view_(cdt), nu_opt_(std::numbers::pi) {
  for (const RegionSide& side : view_.sides()) nu_opt_ = std::min(nu_opt_, side.nu_opt);
}

bool LimitProver::refutes(AngleRange range, std::uint64_t& budget, const ProofEffort& effort) {
  const double lemma_1 = std::numbers::pi - nu_opt_;
  if (range.most < std::max(lemma_1, kSixty) - kAngleSlack) return true;
  if (range.least > std::min(nu_opt_ / 2, kSixty) + kAngleSlack) return true;
  range.most = std::max(range.most, lemma_1) + kAngleSlack;
  if (range.most >= std::numbers::pi) return false;
  const FanGrowth growth(range);
  ClearZones zones(view_, range.most);
  ApexSearch search(view_, zones, growth);
  const auto sides = static_cast<std::uint32_t>(view_.sides().size());
  undecided_.resize(sides);
  for (std::uint32_t k = 0; k < sides; ++k) undecided_[k] = (last_refuter_ + k) % sides;
  // Most sides are done after a few boxes; only then is it worth while to ask the others for more.
  for (const std::uint64_t most_boxes : {effort.at_first, effort.per_search}) {
    std::size_t left = 0;
    for (const std::uint32_t s : undecided_) {
      if (budget == 0) return false;
      std::uint64_t share = std::min(budget, most_boxes);
      const std::uint64_t given = share;
      const bool settled = search.has_none(s, share);
      budget -= given - share;
      if (settled) {
        last_refuter_ = s;
        return true;
      }
      if (share == 0) undecided_[left++] = s;
    }
    if (most_boxes >= effort.per_search) return false;
    undecided_.resize(left);
  }
  return false;
}

bool LimitProver::is_near(const ReachedAngles& reached, const ReachedAngles& wanted,
                          const ProofEffort& effort) {
  const double lowest = std::max(std::numbers::pi - nu_opt_, kSixty);
  std::uint64_t budget = effort.per_region + effort.per_side * view_.sides().size();
  const auto misses = [](Angle angle, Angle target) {
    return angle.in_radians() < target.in_radians() - kAngleSlack;
  };
  if (misses(reached.largest_nu, wanted.largest_nu)) {
    const double most = std::numbers::pi - reached.largest_nu.in_radians() - kNearQuestion;
    if (most > lowest && !refutes({most, 0}, budget, effort)) return false;
  }
  if (!misses(reached.smallest, wanted.smallest)) return true;
  const double least = reached.smallest.in_radians() + kNearQuestion;
  if (least >= std::min((std::numbers::pi - lowest) / 2, kSixty)) return true;
  const double most =
      std::numbers::pi - std::min(reached.largest_nu, wanted.largest_nu).in_radians();
  return refutes({most, least}, budget, effort);
}

ProvenLimits LimitProver::prove(const ReachedAngles& reached, const ReachedAngles& wanted,
                                const ProofEffort& effort) {
  const double lowest = std::max(std::numbers::pi - nu_opt_, kSixty);
  const double largest = std::numbers::pi - reached.largest_nu.in_radians();
  const double smallest = reached.smallest.in_radians();
  std::uint64_t budget = effort.per_region + effort.per_side * view_.sides().size();

  double largest_limit = lowest;
  if (reached.largest_nu < wanted.largest_nu) {
    const auto ask = [&](double gap, const ProofEffort& for_this) {
      if (largest - gap <= largest_limit) return true;
      if (!refutes({largest - gap, 0}, budget, for_this)) return false;
      largest_limit = largest - gap;
      return true;
    };
    // What is open by a degree is hardly ever closed by five.
    if (ask(kNearQuestion, effort)) ask(kExactQuestion, quick(effort));
  }

  const double most =
      std::numbers::pi - std::min(reached.largest_nu, wanted.largest_nu).in_radians();
  double smallest_limit = std::min((std::numbers::pi - lowest) / 2, kSixty);
  if (reached.smallest < wanted.smallest) {
    const auto ask = [&](double gap, const ProofEffort& for_this) {
      if (smallest + gap >= smallest_limit) return true;
      if (!refutes({most, smallest + gap}, budget, for_this)) return false;
      smallest_limit = smallest + gap;
      return true;
    };
    if (ask(kNearQuestion, effort)) {
      ask(kExactQuestion, quick(effort));
    } else {
      ask(kFarQuestion, effort);
    }
  }
  // Rounding of the mesh's own coordinates must not make it better than its limit.
  return {Angle::radians(std::numbers::pi - std::min(largest_limit, largest)),
          Angle::radians(std::max(smallest_limit, smallest)),
          Angle::radians(std::numbers::pi - most)};
}

}  // namespace cover
