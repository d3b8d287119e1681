// Inner edges flipped until all of them are locally Delaunay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/team.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// Makes `mesh` the constrained Delaunay triangulation of its vertices; returns how many flips that
/// took.
///
/// EXACT: yes, in the frame of the mesh
/// Cost:  O(triangles), and what each flip entails
std::size_t make_delaunay(MutableMesh& mesh, const Team& team = {});
/// The same where all edges but those of `triangles` are locally Delaunay already.
std::size_t make_delaunay(MutableMesh& mesh, std::span<const std::uint32_t> triangles);

}  // namespace cover
