// Between two stages of a run.
#pragma once

#include <string_view>

#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "base/faults/errors.hpp"

namespace cover {

/// Tells the caller that a stage begins, unless the run is to stop.
///
/// Errors: cancelled
inline Status begin_stage(std::string_view stage, const Callbacks& callbacks) {
  if (callbacks.stop.stop_requested()) return interrupted();
  if (callbacks.progress) callbacks.progress({stage, 0, 0});
  return ok();
}

}  // namespace cover
