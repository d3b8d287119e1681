// A vertex moved to where its star is best.
// Mends: a small or a large angle of a triangle with a free corner.
#pragma once

#include "quality/moves/workplace.hpp"

namespace cover {

/// Moves a free corner of `t`: the first whose star gets better.
bool try_relocate(Workplace& work, std::uint32_t t);

}  // namespace cover
