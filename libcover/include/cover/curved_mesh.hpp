// A mesh with nodes on its edges, on arcs where there are any: triangles of second order whose
// Jacobians are positive.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cover/output.hpp>
#include <cover/point.hpp>

namespace cover {

/// An edge between two vertices of an arc.
struct CurvedEdge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t circle = 0;  ///< index into Pslg::circles
  Point middle;              ///< its node: on the arc, or where is_straight the middle of the chord
  bool is_straight = false;  ///< on the arc, a triangle beside it would not be proven valid
};

/// What Output::mesh is with triangles of second order.
struct CurvedMesh {
  std::vector<CurvedEdge> edges;  ///< in the order of the segments of Output::pslg
  /// Of edges inside regions that give way to arcs beside them, in the order of the mesh's edges;
  /// where there are no arcs, Output::nodes.
  std::vector<MovedNode> moved;
  /// Of other edges of slivers a few units in the last place wide: with the double next to the
  /// middle a triangle beside them would not be valid.
  std::vector<MovedNode> rounded;
  /// Triangles whose Jacobian is not positive everywhere, ascending: between their corners there
  /// are no doubles, or none were found, with which it is.
  std::vector<std::uint32_t> not_valid;
  std::vector<double> areas;  ///< by RegionId - 1: inside edges through the nodes

  /// How many edges are straight, or a triangle beside them would not be proven valid.
  [[nodiscard]] std::size_t straight_edges() const {
    return static_cast<std::size_t>(std::count_if(
        edges.begin(), edges.end(), [](const CurvedEdge& edge) { return edge.is_straight; }));
  }
};

/// Puts the middle nodes of edges on arcs where segments are chords of arcs, and where none is, to
/// the places of Output::nodes.
///
/// ENSURES: the Jacobian of every triangle but those in `not_valid` is positive everywhere, by the
///          exact signs of the coefficients of Bernstein's form; where it would not be proven,
///          nodes of edges inside the region move with the arc, and where that does not do, edges
///          on arcs are straight. Nodes on segments that are no chords stay in the middle, but for
///          rounding
/// Cost:    O(n), and what patches around places that need it take: O(their triangles x segments)
CurvedMesh curved_mesh(const Output& output);

}  // namespace cover
