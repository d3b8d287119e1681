// What painting leaves of the edges.
#pragma once

#include <cstdint>
#include <vector>

#include "base/none.hpp"
#include "clean/network.hpp"
#include "clean/node_edges.hpp"
#include "clean/paint/paint.hpp"

namespace cover {

/// An edge that separates owners, or that a segment or a line of the input asks for.
struct VisibleEdge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  EdgeOwners owners{kNone, kNone};  ///< left and right, from a to b: first of their region
  std::vector<std::uint32_t> raws;  ///< the lines that show in it, ascending: rings of its owners
                                    ///< and all segments and lines
};

struct VisibleEdges {
  std::vector<VisibleEdge> edges;  ///< in the order of the graph's; some from b to a
  bool any_united = false;         ///< else they are all edges of the graph
};

/// Drops what separates nothing and unites pieces that only hidden edges had cut.
///
/// ENSURES: points of the input and corners that show stay
/// Cost:    O(n log n).
VisibleEdges visible_edges(const Network& network, const EdgeGraph& graph,
                           const Painting& painting);

/// The network of the visible edges alone: each has one strand for every owner beside it, one for
/// every segment or line on it, and none of a hidden polygon.
Network network_of(const std::vector<VisibleEdge>& edges, const Network& network);

}  // namespace cover
