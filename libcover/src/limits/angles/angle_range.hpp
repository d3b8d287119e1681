// Which angles a mesh may have: what a limit is asked about.
#pragma once

namespace cover {

/// All angles are at most `most` and at least `least`, in radians.
struct AngleRange {
  double most = 0;   ///< in [60 degrees, pi)
  double least = 0;  ///< in [0, 60 degrees]; 0: any
};

/// Which covering meshes a question is about.
enum class Meshes {
  all,
  coupled,  ///< without a negative coupling but those of sides that are encroached or exempt
};

/// Every comparison of angles in a proof leaves this much room, in radians: far more than rounding
/// can do to the figures compared, far less than anybody can see.
inline constexpr double kAngleSlack = 1e-9;

}  // namespace cover
