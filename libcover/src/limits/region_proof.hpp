// What is known of a region's limits, handed from one stage to the next.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "cdt/triangulation.hpp"
#include "limits/angles/limit_prover.hpp"

namespace cover {

/// The constrained Delaunay triangulation of a region and, once it has been asked, the prover of
/// its limits, which remembers what it was asked. Not to be moved: the prover refers to the
/// triangulation.
class RegionProof {
 public:
  explicit RegionProof(Triangulation triangulation) : cdt_(std::move(triangulation)) {}
  RegionProof(const RegionProof&) = delete;
  RegionProof& operator=(const RegionProof&) = delete;

  [[nodiscard]] const Triangulation& cdt() const { return cdt_; }
  /// The team counts at the first call.
  LimitProver& prover(const Team& team = {}) {
    if (!prover_) {
      prover_.emplace(cdt_, team);
      for (const AngleRange& angles : seen_) prover_->has_seen(angles);
    }
    return *prover_;
  }
  /// As LimitProver::has_seen().
  void has_seen(const AngleRange& angles) {
    if (prover_) {
      prover_->has_seen(angles);
    } else {
      seen_.push_back(angles);
    }
  }

 private:
  Triangulation cdt_;
  std::optional<LimitProver> prover_;
  std::vector<AngleRange> seen_;  ///< before there was a prover
};

}  // namespace cover
