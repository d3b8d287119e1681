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

/// Whether segments are cut, once there are meshes, where triangles are above the target: no mesh
/// of a region is the last one then. Layers stay as they are, and so do couplings that are to come
/// first.
inline bool is_cut_until_met(const Options& options) {
  const bool keeps_couplings = options.couplings == Couplings::first && !options.box_method;
  return options.split_interfaces && options.method == Method::quality && !options.hull &&
         options.layers.empty() && !keeps_couplings;
}

}  // namespace cover
