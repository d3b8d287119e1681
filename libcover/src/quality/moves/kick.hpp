// Out of a local optimum: a step that makes a triangulation worse first. Mends: nothing by itself;
// what no step that only helps can reach, by the improvement that follows.
#pragma once

#include <array>
#include <cstdint>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

struct Kick {
  enum class What {
    vertex_inside,   ///< at the centroid
    vertex_on_edge,  ///< in the middle, from corner `at` to the next
    flip,            ///< of the edge opposite to corner `at`
    removal          ///< of corner `at`
  };
  What what;
  Corner at = 0;
};

/// All that there are, in the order in which they are tried.
inline constexpr std::array<Kick, 10> kKicks{{{Kick::What::vertex_inside},
                                              {Kick::What::vertex_on_edge, 0},
                                              {Kick::What::vertex_on_edge, 1},
                                              {Kick::What::vertex_on_edge, 2},
                                              {Kick::What::flip, 0},
                                              {Kick::What::flip, 1},
                                              {Kick::What::flip, 2},
                                              {Kick::What::removal, 0},
                                              {Kick::What::removal, 1},
                                              {Kick::What::removal, 2}}};

/// Changes `mesh` around triangle `t`, for better or worse. False, and nothing has changed, if that
/// kick does not apply.
bool do_kick(MutableMesh& mesh, std::uint32_t t, Kick kick);

}  // namespace cover
