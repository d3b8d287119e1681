// Watching and stopping a long run.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string_view>

#include <cover/ids.hpp>
#include <cover/packing.hpp>
#include <cover/share_out.hpp>

namespace cover {

/// One step of a run. While a region takes long, its step is told again now and then.
struct Progress {
  std::string_view stage;  ///< "clean", "regions", "mesh", "stitch", ...
  std::size_t done = 0;    ///< of `total`, in units of the stage (regions by their weight)
  std::size_t total = 0;   ///< 0: the stage begins, and does not tell how far it is
};

/// How the caller follows a run. Each is called from one thread at a time; what `progress` throws
/// ends the run and reaches the caller.
struct Callbacks {
  std::function<void(const Progress&)> progress;
  /// Method nonobtuse: the packing of every region, in region order.
  std::function<void(RegionId, const PackingRecord&)> packing;
  std::stop_token stop;
  /// Has regions meshed in other processes as well; empty: all are meshed here. Methods quality and
  /// almond.
  ShareOut share_out;
  /// Has parts of files written by the processes that keep meshes, see StreamOptions::may_stay.
  WriteElsewhere write_elsewhere;
};

}  // namespace cover
