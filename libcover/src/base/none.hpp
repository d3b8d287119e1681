// "None", where a 32-bit number counts things.
#pragma once

#include <cstdint>

namespace cover {

/// In place of the number of a point, a triangle, an edge, a side, ...: there is none.
inline constexpr std::uint32_t kNone = 0xffffffffU;

}  // namespace cover
