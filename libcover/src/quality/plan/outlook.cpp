// See outlook.hpp. Tested by tests/unit/quality/plan/outlook_test.cpp.
#include "quality/plan/outlook.hpp"

#include <vector>

#include "box/half_discs.hpp"
#include "geom/cotangent.hpp"
#include "limits/angles/limit_prover.hpp"
#include "quality/fault/extreme_angles.hpp"
#include "quality/plan/optimise.hpp"

namespace cover {

bool Outlook::is_near_limits(const Candidate& candidate) {
  const Merit& merit = candidate.merit;
  if (merit.large != last_asked_.large || merit.small != last_asked_.small)
    last_asked_ = {merit.large, merit.small, prove_near_limits(candidate)};
  return last_asked_.is_near;
}

bool Outlook::is_settled(const Candidate& candidate, const Goal& goal) {
  const Merit& merit = candidate.merit;
  // No mesh that misses the largest angle was ever found to be near its limits: 1,000 Voronoi
  // cells and 140 parcels were asked in vain, for 3 % of the instructions.
  if (is_smaller_cot(goal.large, merit.large) || goal.weight == 0) return false;
  if (extreme_angles(*candidate.mesh).least < angle_of_cot(merit.small) - kAngleSlack) return false;
  return is_near_limits(candidate);
}

bool Outlook::prove_near_limits(const Candidate& candidate) {
  if (boundary_.has_hull_sides()) return false;
  const MutableMesh& mesh = *candidate.mesh;
  std::vector<IndexTriple> triangles;
  for (const MeshTriangle& t : mesh.triangles) {
    if (t.v[0] != kNone) triangles.push_back(t.v);
  }
  LimitProver& prover = proof_->prover(team_);
  prover.compare_with(AnglesAround::of(mesh.points, triangles, boundary_.points.size()));
  return prover.is_near(
      {Angle::radians(angle_of_cot(candidate.merit.large)),
       Angle::radians(angle_of_cot(candidate.merit.small))},
      {options_.max_angle.supplement(), options_.min_angle},
      options_.effort == Effort::fast ? ProofEffort::brief() : ProofEffort::usual());
}

void Outlook::look_for_room(const SideLimits& limits) {
  if (boundary_.has_hull_sides()) return;
  std::vector<bool> is_free(limits.size());
  for (std::size_t s = 0; s < is_free.size(); ++s) is_free[s] = limits[s].least_cot > -kInverted;
  has_no_room_ = half_discs_cover(cdt().points, boundary_.sides, is_free);
}

}  // namespace cover
