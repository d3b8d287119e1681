// Points of the input that are on no line of their own.
#pragma once

#include "region/network.hpp"
#include "region/node_edges.hpp"

namespace cover {

/// Cuts edges at the lone points that lie on them. True if there are any: then the graph must be
/// made anew.
///
/// EXACT: yes
/// Cost:  O(points * sqrt(n)) typically.
bool cut_at_lone_points(Network& network, const EdgeGraph& graph);

}  // namespace cover
