// The legal values of options, for whoever asks people for them.
#pragma once

#include <limits>
#include <string>

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

/// Those of the members of Options, ReadOptions and WriteOptions; angles in degrees.
namespace ranges {
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();
inline constexpr Range kAll{-kNoLimit, kNoLimit};
inline constexpr Range kPieces{2, 1000};
inline constexpr Range kMaxAngle{60, 180, false, false};
inline constexpr Range kMinAngle{0, 60, true, false};
inline constexpr Range kSplitInterfaces{60, 180, true, false};
inline constexpr Range kGrowth{1, kNoLimit, false, false};
inline constexpr Range kWeld{0, 1, true, false};
inline constexpr Range kSize{0, kNoLimit, false, false};
inline constexpr Range kLayerGrowth{1, kNoLimit, true, false};
inline constexpr Range kLayerCount{0, 1000};
inline constexpr Range kThreads{0, 4096};
inline constexpr Range kScale{0, kNoLimit, false, false};
inline constexpr Range kChordError{0, kNoLimit, false, false};
inline constexpr Range kChordAngle{0, 120, false, true};
inline constexpr Range kOrder{1, 2};
inline constexpr Range kParts{1, 100000};
inline constexpr Range kSpeckle{0, 100000};
}  // namespace ranges

/// "above 60 and below 180", "at least 0 and below 1", "above 1".
std::string describe(const Range& range);

/// What Options::weld is with `auto`, relative to the size of the drawing: decimal rounding of
/// coordinates and of what programs compute from them misses by less.
inline constexpr double kAutoWeld = 0x1p-30;

/// The largest angle, in degrees, that Method::nonobtuse may leave where it snaps nearly touching
/// disks to contact.
inline constexpr double kLargestSnapped = 90.1;

}  // namespace cover
