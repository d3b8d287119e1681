// Triangulations without obtuse angles, with fewer vertices.
#pragma once

#include <cstdint>
#include <stop_token>

#include "thin/conforming_mesh.hpp"
#include "thin/mesh_with_undo.hpp"

namespace cover {

/// How long is searched: places tried for a vertex, some 0.5 us each.
struct ThinEffort {
  std::uint64_t places_per_vertex = 0;  ///< for every vertex that may go
  std::uint64_t places_at_most = 0;
  std::uint64_t places_per_bad = 0;  ///< for every bad triangle that there is at first, besides
  std::uint64_t places_to_mend_at_most = 0;
  std::stop_token stop;
};

/// What came of it.
struct Thinned {
  std::size_t bad_before = 0;  ///< triangles
  std::size_t bad = 0;
};

/// Takes vertices away, merges several into fewer and moves them, while no more triangles are bad
/// than before; adds some where that makes bad triangles fewer. Points of the input stay.
///
/// ENSURES: the same mesh for the same input, whatever the machine
/// Cost:    as `effort` says
/// Ref:     libcover/docs/box_method.md, "Fewer vertices"
Thinned thin_mesh(MeshWithUndo& mesh, const ThinEffort& effort);

/// Makes bad triangles fewer, one after another: by more vertices, and by others in place of some
/// that are near, many times. Nothing else is changed.
///
/// ENSURES: the same mesh for the same input, whatever the machine
/// Cost:    places_per_bad for each such triangle, places_to_mend_at_most in all
Thinned mend_what_is_left(MeshWithUndo& mesh, const ThinEffort& effort);

/// Moves, adds and, where that does not help, takes away vertices until no triangle is gravely bad
/// (MeshWithUndo::grave), and then, if that can be, until none is by a vertex inside that could
/// lie elsewhere. No more triangles become bad in any way.
///
/// ENSURES: the same mesh for the same input, whatever the machine
/// Cost:    places_per_bad for each gravely bad triangle, `places_per_sign` for each other bad one,
///          whichever takes them; places_to_mend_at_most in all
Thinned mend_mesh(MeshWithUndo& mesh, const ThinEffort& effort, std::uint64_t places_per_sign);

}  // namespace cover
