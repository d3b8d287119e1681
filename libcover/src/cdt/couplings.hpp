// Negative couplings of the box method: exactly, on the mesh of any region.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "cdt/cdt.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// The opposite of every half-edge, numbered as in HalfEdges; kNone for `sides`, the directed
/// sides of the triangles' region, which may be slits.
std::vector<std::uint32_t> across_edges(std::size_t points, std::span<const IndexTriple> triangles,
                                        std::span<const IndexPair> sides, const Team& team = {});

/// An edge whose form factor, half the sum of the cotangents of the angles opposite to it in one
/// region, is negative.
struct NegativeEdge {
  IndexPair edge{};        ///< as the first of its triangles has it
  std::uint32_t apex = 0;  ///< the corner opposite to it in that triangle
  bool is_side = false;    ///< on the region's boundary: only one triangle counts
};

/// The edges with negative coupling of the triangles of one region; `sides` are its directed sides.
///
/// An inner edge has a negative coupling just where it is not locally Delaunay, a side just where
/// the angle opposite to it is above 90 degrees.
/// EXACT: the signs, for the coordinates as they are
/// Cost:  O(n log n)
/// Ref:   docs/box_method.md
std::vector<NegativeEdge> negative_edges(std::span<const Point> points,
                                         std::span<const IndexTriple> triangles,
                                         std::span<const IndexPair> sides);

/// The same, from what is known: `across` is across_edges(), `cots` the cotangents of the angles
/// opposite to all half-edges, in doubles. Exact arithmetic is asked where these do not tell.
std::vector<NegativeEdge> negative_edges(std::span<const Point> points,
                                         std::span<const IndexTriple> triangles,
                                         std::span<const std::uint32_t> across,
                                         std::span<const double> cots, const Team& team = {});

/// Flips inner edges until all of them are locally Delaunay, and none has a negative coupling;
/// returns how many. Triangles keep their places in the list, two by two. Edges whose flip would
/// make triangles for one of which `is_allowed` is false stay.
///
/// REQUIRES: triangles counter-clockwise, exactly
/// ENSURES:  if all is allowed, they are the constrained Delaunay triangulation of their corners
/// EXACT:    yes
/// Cost:     O(n), and what each flip entails: few for a mesh with good angles
std::size_t make_delaunay(std::span<const Point> points, std::vector<IndexTriple>& triangles,
                          std::span<const IndexPair> sides,
                          const std::function<bool(const IndexTriple&)>& is_allowed = {});

}  // namespace cover
