// Hull sides may be split, so that nothing is known of meshes there. The almond method aims at the
// bound and at no target: limits beside one would take twice its time (`cover check` tells them of
// any mesh). With little effort little is asked.
// Tested by tests/unit/method/mesh_one_region_test.cpp.
#include "method/proven_limits.hpp"

#include <utility>

#include <cover/judged_angle.hpp>

#include "limits/region_limits.hpp"
#include "region/triangulation_of.hpp"

namespace cover {

std::unique_ptr<RegionProof> proof_of(const RegionBoundary& boundary) {
  return std::make_unique<RegionProof>(triangulation_of(boundary));
}

RegionLimits proven_limits(const RegionBoundary& boundary, const RegionMesh& mesh,
                           const Options& options, const Team& team,
                           std::unique_ptr<RegionProof> proof) {
  const Quality& quality = mesh.report.quality;
  if (quality.triangles == 0 || options.method != Method::quality || boundary.has_hull_sides())
    return {};
  const ReachedAngles reached{judged_nu(quality), quality.smallest};
  const ReachedAngles wanted{options.max_angle.supplement(), options.min_angle};
  if (meets(reached, wanted)) return region_limits({}, reached, wanted);
  if (mesh.report.has_no_room && mesh.layer_triangles == 0)
    return limits_by_couplings(reached, wanted);
  const ProofEffort effort = options.effort == Effort::fast     ? ProofEffort::brief()
                             : options.effort == Effort::normal ? ProofEffort::usual()
                                                                : ProofEffort();
  AnglesAround around =
      AnglesAround::of(all_points(boundary, mesh), mesh.triangles, boundary.points.size());
  if (!proof) proof = proof_of(boundary);
  return region_limits(proof->prover(team), reached, wanted, effort, std::move(around));
}

}  // namespace cover
