// A vertex moved to where its star is best.
// Mends: a small or a large angle of a triangle with a free corner.
#pragma once

#include "quality/moves/piece.hpp"

namespace cover {

/// Moves a free corner of `t`: the first whose star gets better.
bool try_relocate(Piece& piece, std::uint32_t t);

}  // namespace cover
