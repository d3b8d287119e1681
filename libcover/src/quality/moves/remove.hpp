// A vertex taken away. Mends: large angles around a free vertex of three or four triangles.
// Elsewhere it saves triangles.
#pragma once

#include "quality/moves/workplace.hpp"

namespace cover {

/// Takes away a free corner of `t` and triangulates its star anew, where that is no worse: fewer
/// triangles are a gain.
bool try_remove(Workplace& work, std::uint32_t t);

}  // namespace cover
