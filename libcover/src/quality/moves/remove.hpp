// A vertex taken away. Mends: large angles around a free vertex of three or four triangles.
// Elsewhere it saves triangles.
#pragma once

#include "quality/moves/piece.hpp"

namespace cover {

/// Takes away a free corner of `t` and triangulates its star anew, where that is no worse: fewer
/// triangles are a gain.
bool try_remove(Piece& piece, std::uint32_t t);

}  // namespace cover
