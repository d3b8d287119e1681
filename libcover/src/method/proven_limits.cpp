// Hull sides may be split, so that nothing is known of meshes there. The almond method aims at the
// bound and at no target: limits beside one would take twice its time (`cover check` tells them of
// any mesh). With little effort little is asked.
// Tested by tests/unit/method/mesh_one_region_test.cpp.
#include "method/proven_limits.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <cover/judged_angle.hpp>

#include "limits/region_limits.hpp"
#include "options/intent.hpp"
#include "region/triangulation_of.hpp"

namespace cover {
namespace {

/// The sides with a negative coupling.
std::vector<IndexPair> negative_sides(const RegionBoundary& boundary,
                                      std::span<const NegativeCoupling> couplings) {
  using Edge = std::pair<Point, Point>;
  std::vector<Edge> edges;
  for (const NegativeCoupling& c : couplings) edges.emplace_back(c.a, c.b);
  std::sort(edges.begin(), edges.end());
  std::vector<IndexPair> negative;
  for (const IndexPair& side : boundary.sides) {
    const Edge edge{boundary.points[side[0]], boundary.points[side[1]]};
    if (std::binary_search(edges.begin(), edges.end(), edge)) negative.push_back(side);
  }
  return negative;
}

}  // namespace

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
  LimitProver& prover = proof->prover(team);
  const bool is_coupled = couplings_count(options) && mesh.report.box.negative_inside == 0;
  if (is_coupled && !mesh.report.couplings.empty())
    prover.exempt(negative_sides(boundary, mesh.report.couplings));
  return region_limits(prover, reached, wanted, effort, std::move(around),
                       is_coupled ? Meshes::coupled : Meshes::all);
}

}  // namespace cover
