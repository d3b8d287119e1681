// A region with layers: the layers, and the rest meshed by whatever method.
#pragma once

#include <functional>
#include <span>
#include <stop_token>

#include <cover/options.hpp>

#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Meshes a region.
using RegionMesher = std::function<RegionMesh(const RegionBoundary&, const Options&)>;

/// Whether the region has any side with layers.
bool has_layers(const RegionBoundary& boundary);

/// Lays layers on the sides that are to have some, has `mesh_rest` mesh what is left, and puts both
/// together. Where the rest would break the bound of the whole region, or does not become a region,
/// layers are withdrawn, near such places first. Where negative couplings stay inside, all is done
/// again with a rest that is meshed with little effort, and the better one is kept.
///
/// ENSURES: RegionMesh::report has the bound, the figures and the layers of the whole region, and
///          those notes on the rest that are not about targets
/// Cost:    that of `mesh_rest`, a few times where layers are withdrawn or couplings stay
RegionMesh mesh_with_layers(const RegionBoundary& boundary, const Options& options,
                            const RegionMesher& mesh_rest, std::stop_token stop);

}  // namespace cover
