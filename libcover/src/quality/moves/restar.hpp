// A hole of a few triangles filled with a star around a new vertex.
// Mends: a small or a large angle at vertices that must stay, where no diagonal helps.
#pragma once

#include "quality/moves/workplace.hpp"

namespace cover {

/// Grows a hole from `t`, alone or with each of its neighbours, and puts a vertex into it, well
/// placed. The best hole is filled.
bool try_restar(Workplace& work, std::uint32_t t);

}  // namespace cover
