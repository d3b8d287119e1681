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

/// One step of a run. While a step takes long, it is told again now and then.
struct Progress {
  std::string_view stage;  ///< "clean", "regions", "mesh", "cut", "thin", "stitch", ...
  std::size_t done = 0;    ///< of `total`, in units of the stage (regions by their weight)
  std::size_t total = 0;   ///< 0: the stage begins, and does not tell how far it is
};

/// How the caller follows a run. What `progress` or `packing` throws stops the run, as `stop` does,
/// and reaches the caller.
///
/// Threads: `progress` and `packing` are called one at a time, each time by any thread, with
///          Options::threads 1 as well; workers that have something to tell wait meanwhile. Neither
///          may wait for the thread that called the library, which waits for them: a graphical
///          program posts what it is told, and does not wait until that is shown.
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
