// What options ask for that is not said by one of them alone.
#pragma once

#include <cover/options.hpp>

namespace cover {

/// What is preferred: Options::prefer, but the largest angle where less than 95 degrees is asked
/// for.
inline Prefer preferred(const Options& options) {
  return options.max_angle < Angle::degrees(95) ? Prefer::largest : options.prefer;
}

/// Whether couplings come before targets.
inline bool couplings_count(const Options& options) { return options.couplings != Couplings::last; }

}  // namespace cover
