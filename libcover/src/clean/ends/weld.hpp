// Closing gaps and slivers where a drawing misses itself by the last bits.
#pragma once

#include <vector>

#include <cover/input.hpp>
#include <cover/report.hpp>

#include "clean/network.hpp"
#include "clean/node_edges.hpp"

namespace cover {

/// Cuts the strands of `network` as node_edges does, but first unites ends of lines that are nearer
/// to each other than the tolerance, and bends lines to ends that are nearer to them.
///
/// The tolerance at an end is `relative` times the size of the drawing, and never more than an
/// eighth of the shortest line that ends there. So a layer, however thin, whose drawing has an edge
/// across it stays: nothing at its corners moves by more than an eighth of that edge. An edge is
/// shrunk to a point only where it is no longer than the tolerance and rounding_of() all points.
/// With `keep_polygons`, a polygon that is wider than rounding does not vanish: where welding would
/// make all of its edges cancel each other, its corners are not welded to its own edges.
/// Every weld is appended to `changes`.
/// REQUIRES: one strand per raw line
/// Cost:     that of node_edges, a pass more for each generation of welds.
EdgeGraph weld_and_node(const Input& input, double relative, Network& network,
                        std::vector<Change>& changes, bool keep_polygons = false);

}  // namespace cover
