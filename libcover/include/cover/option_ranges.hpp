// The legal values of options, for whoever asks people for them.
#pragma once

#include <limits>

namespace cover {

/// The values that an option may have.
struct Range {
  double low;
  double high;
  bool has_low = true;   ///< whether `low` is one of them
  bool has_high = true;  ///< and `high`

  /// False for what is no number.
  [[nodiscard]] constexpr bool holds(double x) const {
    return (x > low || (has_low && x == low)) && (x < high || (has_high && x == high));
  }
};

/// Those of the members of Options; angles in degrees.
namespace ranges {
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();
inline constexpr Range kPieces{2, 1000};
inline constexpr Range kMaxAngle{60, 180, false, false};
inline constexpr Range kMinAngle{0, 60, true, false};
inline constexpr Range kSplitInterfaces{60, 180, true, false};
inline constexpr Range kGrowth{1, kNoLimit, false, false};
inline constexpr Range kWeld{0, 1, true, false};
inline constexpr Range kSize{0, kNoLimit, false, false};
}  // namespace ranges

}  // namespace cover
