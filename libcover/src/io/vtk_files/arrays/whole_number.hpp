// What may stand in the cell arrays of a file that somebody else wrote, or that is broken.
#pragma once

#include <cmath>
#include <cstdint>

namespace cover {

/// The value as an integer; 0 if doubles do not count that far, or it is no number.
inline std::int64_t whole_number(double value) {
  constexpr double kLargest = 9007199254740992;  // 2^53
  return std::abs(value) <= kLargest ? static_cast<std::int64_t>(value) : 0;
}

}  // namespace cover
