// Fewer bad triangles, by other vertices.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stop_token>

#include "mend/repairs.hpp"

namespace cover {

/// How many places are tried to mend bad triangles.
struct MendEffort {
  std::uint64_t places_per_bad = 0;  ///< for every bad triangle that there is at first
  std::uint64_t places_at_most = 0;
  std::stop_token stop{};

  [[nodiscard]] PlacesLeft places_for(std::size_t bad) const {
    return {std::min<std::uint64_t>(places_at_most, places_per_bad * bad), stop};
  }
};

/// What came of it.
struct BadTriangles {
  std::size_t before = 0;
  std::size_t after = 0;
};

/// Makes bad triangles fewer, one after another: by more vertices, by cuts from wall to wall, and
/// by others in place of some that are near, many times. Those that are worse than any may be come
/// first (mend_beyond_worst).
///
/// ENSURES: the same mesh for the same input, whatever the machine
/// Cost:    as `effort` says
/// Ref:     libcover/docs/cutting_segments.md, "Fewer vertices"
BadTriangles mend_what_is_left(MeshWithUndo& mesh, const MendEffort& effort);

/// Moves, adds and, where that does not help, takes away vertices until no triangle is gravely bad
/// (MeshWithUndo::grave), and then, if that can be, until none is by a vertex inside that could
/// lie elsewhere. No more triangles become bad in any way.
///
/// ENSURES: the same mesh for the same input, whatever the machine
/// Cost:    places_per_bad for each gravely bad triangle, `places_per_sign` for each other bad one,
///          whichever takes them; places_at_most in all
BadTriangles mend_mesh(MeshWithUndo& mesh, const MendEffort& effort, std::uint64_t places_per_sign);

/// Steps of mend_what_is_left() and thin_mesh(). Bad triangles, where more vertices help in so many
/// tries.
void mend_with_more_vertices(Repairs& repairs, std::size_t tries);
/// Triangles that are worse than any may be, for up to four more each that are only bad: there are
/// some where the mesh before was not Delaunay.
void mend_beyond_worst(Repairs& repairs);

}  // namespace cover
