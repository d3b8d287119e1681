// A vertex moved to where its star is best.
#pragma once

#include "quality/moves/piece.hpp"

namespace cover {

/// Moves a free corner of `t`: the first whose star gets better.
bool try_relocate(Piece& piece, std::uint32_t t);

}  // namespace cover
