// Whether anything better than a candidate is to be had, as far as it is proven.
#pragma once

#include <memory>
#include <utility>

#include <cover/options.hpp>

#include "base/team.hpp"
#include "limits/region_proof.hpp"
#include "quality/plan/candidate.hpp"
#include "region/region_boundary.hpp"
#include "target/goal.hpp"

namespace cover {

/// What is proven about the meshes that a region can have, from the first question on.
class Outlook {
 public:
  /// REQUIRES: `boundary` and `options` outlive this object; the triangulation is that of the
  ///           region in its frame, constrained Delaunay
  Outlook(const RegionBoundary& boundary, const Options& options, Triangulation triangulation,
          const Team& team)
      : boundary_(boundary),
        options_(options),
        team_(team),
        proof_(std::make_unique<RegionProof>(std::move(triangulation))) {}

  /// The constrained Delaunay triangulation.
  [[nodiscard]] const Triangulation& cdt() const { return proof_->cdt(); }
  /// As LimitProver::has_seen().
  void has_seen(const AngleRange& angles) { proof_->has_seen(angles); }

  /// No mesh of the region is better than `candidate` by more than a degree, in what it misses:
  /// this is proven, and a search would be in vain.
  [[nodiscard]] bool is_near_limits(const Candidate& candidate);
  /// The same, and nothing else that could be better by `goal` hides behind angles that are forced:
  /// what is near its limits are the worst angles of the mesh.
  [[nodiscard]] bool is_settled(const Candidate& candidate, const Goal& goal);

  /// Finds out whether the constrained Delaunay triangulation is the only mesh without a negative
  /// coupling on a side that counts by `limits`, or inside: then nothing else is to be tried.
  ///
  /// REQUIRES: it has none
  void look_for_room(const SideLimits& limits);
  /// The last answer: there is none for a vertex. False before the question.
  [[nodiscard]] bool has_no_room() const { return has_no_room_; }
  void forget_room() { has_no_room_ = false; }

  /// What was proven, handed over: nothing else is asked from then on.
  [[nodiscard]] std::unique_ptr<RegionProof> take_proof() { return std::move(proof_); }

 private:
  [[nodiscard]] bool prove_near_limits(const Candidate& candidate);

  const RegionBoundary& boundary_;
  const Options& options_;
  Team team_;
  std::unique_ptr<RegionProof> proof_;
  bool has_no_room_ = false;
  /// The last answer of is_near_limits(): several steps ask the same.
  struct {
    double large = kInverted, small = kInverted;
    bool is_near = false;
  } last_asked_;
};

}  // namespace cover
