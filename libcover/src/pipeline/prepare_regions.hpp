// What every run starts with: input made clean, and its regions.
#pragma once

#include <vector>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "base/stage_clock.hpp"
#include "region/region_graph.hpp"
#include "sizes/expected_triangles.hpp"

namespace cover {

/// What is prepared, and what was found on the way.
struct PreparedRegions {
  Prepared prepared;
  std::vector<TriangulatedRegion> triangulated;
};

/// Input made clean and its regions, with segments cut as the options ask; no lower bounds yet.
///
/// Errors: ErrorCode 100-199, bad_option, cancelled; out_of_memory where what is `held` of
///         the sizes asked for takes more than there is
Result<PreparedRegions> prepare_regions(const Input& input, const Options& options,
                                        const Callbacks& callbacks, StageClock& clock, Held held);
/// The same; `input` is gone as soon as it is clean.
Result<PreparedRegions> prepare_regions(Input&& input, const Options& options,
                                        const Callbacks& callbacks, StageClock& clock, Held held);

}  // namespace cover
