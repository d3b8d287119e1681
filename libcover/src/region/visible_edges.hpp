// What painting leaves of the edges.
#pragma once

#include <cstdint>
#include <vector>

#include "region/network.hpp"
#include "region/node_edges.hpp"
#include "region/paint.hpp"

namespace cover {

/// An edge that separates owners, or that a segment or a line of the input asks for.
struct VisibleEdge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  EdgeOwners owners{kNoIndex, kNoIndex};  ///< left and right, from a to b
  std::vector<std::uint32_t> raws;        ///< the lines that it is a piece of, ascending
};

/// Drops what separates nothing and unites the pieces of a line that only dropped edges had cut.
///
/// ENSURES: points of the input stay; united pieces belong to the same lines
/// Cost:    O(n log n).
std::vector<VisibleEdge> visible_edges(const Network& network, const EdgeGraph& graph,
                                       const std::vector<EdgeOwners>& owners);

/// The network of the visible edges alone: each has one strand for every owner beside it, one for
/// every segment or line on it, and none of a hidden polygon.
Network network_of(const std::vector<VisibleEdge>& edges, const Network& network);

}  // namespace cover
