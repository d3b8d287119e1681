// The quality method: the best of several candidates for a region, improved.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include <cover/options.hpp>

#include "limits/region_proof.hpp"
#include "quality/parts/work_in_parts.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// A region's mesh, and its constrained Delaunay triangulation with what was proven by it on the
/// way.
struct ProvenMesh {
  RegionMesh mesh;
  std::unique_ptr<RegionProof> proof{};  ///< none: the region is large, or nobody made one
  std::optional<RegionMesh> almonds{};   ///< what almond_region() made of it, if that was asked
};

/// Triangulates one region without putting a vertex on its boundary, with its largest angle near
/// the optimum.
///
/// ENSURES: promise 3 at least, but for rounding, which mesh_one_region() looks after, and not for
///          the rest beside layers. Without sizes, by Order no worse than the constrained Delaunay
///          triangulation and than all that the steps of the plan which ran compared with it.
///          RegionMesh::report::notes says which targets were missed, where and why.
/// `almonds` is what almond_region() made of the region, where it was asked already.
/// Threads: pure function of its arguments, but for the team, on which nothing depends.
ProvenMesh quality_region(const RegionBoundary& boundary, const Options& options,
                          const std::stop_token& stop, const Sharing& sharing = {},
                          std::optional<RegionMesh> almonds = {});

}  // namespace cover
