// Nodes in the middle of straight edges, where rounding has to be looked at.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include <cover/mesh.hpp>
#include <cover/point.hpp>

namespace cover {

/// Nodes that are not the doubles next to the middles of their edges.
struct StraightNodes {
  std::map<std::size_t, Point> nodes;           ///< by edge
  std::vector<TriMesh::FaceHandle> not_mended;  ///< ascending
};

/// Looks for triangles of second order whose Jacobian is not positive, although their corners are
/// counter-clockwise: edges of slivers a few units in the last place wide have no double in their
/// middle. It takes another one near the middle there: the nearest choice with which no triangle
/// around has such a Jacobian, found by tries around each triangle in turn.
///
/// `node_of` tells the node of an edge and `may_move` whether it may be another one.
/// Cost: O(triangles), and some thousand tries for each triangle that is not valid, up to some ten
///       thousand where others beside it become invalid in its place
StraightNodes valid_straight_nodes(const TriMesh& mesh,
                                   const std::function<Point(std::size_t edge)>& node_of,
                                   const std::function<bool(std::size_t edge)>& may_move);

}  // namespace cover
