// The parts of a run: those who hold regions on the disk, or mesh some of them again, do the second
// one otherwise.
#pragma once

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "base/stage_clock.hpp"
#include "cuts/work.hpp"
#include "sizes/expected_triangles.hpp"

namespace cover {

/// Input made clean, and its regions as pieces of work, with the sizes and layers that the options
/// ask for; no meshes yet. An input that may be moved from is gone as soon as it is clean.
///
/// Errors: those of prepare_regions(), sizes and layers; out_of_memory where what is
///         `held` of the mesh would take more than there is
Result<Work> begin_work(Input&& input, const Options& options, Held held,
                        const Callbacks& callbacks, StageClock& clock);
Result<Work> begin_work(const Input& input, const Options& options, Held held,
                        const Callbacks& callbacks, StageClock& clock);

/// Meshes, cuts again where that is asked for, stitches.
///
/// REQUIRES: work.meshes is empty
Result<Output> finish_work(Work work, const Options& options, const Callbacks& callbacks,
                           StageClock& clock);

/// What finish_work() ends with: the meshes of all regions as one, by vertex id, and what they
/// report as one report.
Result<Output> stitch_regions(Work work, const Callbacks& callbacks, StageClock& clock);

}  // namespace cover
