// Tested by tests/unit/limits/region_limits_test.cpp.
#include "limits/region_limits.hpp"

#include <algorithm>
#include <utility>

#include <cover/judged_angle.hpp>

namespace cover {
namespace {

constexpr double kNothing = 1e-5;  ///< degrees: no gap
constexpr double kNear = 1 + kNothing;

Standing standing_of(bool met, Angle reached, Angle limit) {
  if (met) return Standing::met;
  const double gap = limit.in_degrees() - reached.in_degrees();
  return gap <= kNothing ? Standing::optimal : gap <= kNear ? Standing::near : Standing::open;
}

}  // namespace

const char* describe(Standing standing) {
  switch (standing) {
    case Standing::met:
      return "met";
    case Standing::optimal:
      return "optimal";
    case Standing::near:
      return "near";
    case Standing::open:
      return "open";
    case Standing::coupled:
      return "coupled";
    case Standing::unknown:
      break;
  }
  return "unknown";
}

bool meets(const ReachedAngles& reached, const ReachedAngles& wanted) {
  return meets(reached.largest_nu, wanted.largest_nu) && meets(reached.smallest, wanted.smallest);
}

RegionLimits limits_by_couplings(const ReachedAngles& reached, const ReachedAngles& wanted) {
  RegionLimits limits;
  const auto standing = [](bool is_met) { return is_met ? Standing::met : Standing::coupled; };
  limits.largest_nu = reached.largest_nu;
  limits.smallest = reached.smallest;
  limits.under = std::min(reached.largest_nu, wanted.largest_nu);
  limits.of_largest = standing(meets(reached.largest_nu, wanted.largest_nu));
  limits.of_smallest = standing(meets(reached.smallest, wanted.smallest));
  return limits;
}

RegionLimits region_limits(const Triangulation& cdt, const ReachedAngles& reached,
                           const ReachedAngles& wanted, const Team& team, const ProofEffort& effort,
                           AnglesAround around) {
  if (!meets(reached, wanted)) {
    LimitProver prover(cdt, team);
    return region_limits(prover, reached, wanted, effort, std::move(around), Meshes::all);
  }
  RegionLimits limits;
  limits.of_largest = limits.of_smallest = Standing::met;
  return limits;
}

RegionLimits region_limits(LimitProver& prover, const ReachedAngles& reached,
                           const ReachedAngles& wanted, const ProofEffort& effort,
                           AnglesAround around, Meshes meshes) {
  prover.compare_with(std::move(around));
  const ProvenLimits proven = prover.prove(reached, wanted, effort, meshes);
  const auto standing = [](Angle angle, Angle target, Angle limit, Meshes of) {
    const Standing among_them = standing_of(meets(angle, target), angle, limit);
    const bool is_proven = among_them == Standing::optimal || among_them == Standing::near;
    return is_proven && of == Meshes::coupled ? Standing::coupled : among_them;
  };
  RegionLimits limits;
  limits.largest_nu = proven.largest_nu;
  limits.smallest = proven.smallest;
  limits.under = proven.under;
  limits.of_largest =
      standing(reached.largest_nu, wanted.largest_nu, proven.largest_nu, proven.of_largest);
  limits.of_smallest =
      standing(reached.smallest, wanted.smallest, proven.smallest, proven.of_smallest);
  return limits;
}

}  // namespace cover
