// Layers that fill a film: the last of them is what the others leave of it.
#pragma once

#include <span>
#include <vector>

#include <cover/options.hpp>

#include "layers/front/layer_front.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Of the sides in `sides` that have room for all layers but one: makes those complete beside which
/// the mesh has a row as thick as the last one up to the boundary opposite, to a thousandth.
///
/// Cost: O(triangles), and O(n log n) in the number of these sides
void complete_filled_films(const RegionBoundary& boundary, std::span<const LayerRule> rules,
                           const layers::LayerFront& front, const RegionMesh& mesh,
                           std::vector<layers::SideLayers>& sides);

}  // namespace cover
