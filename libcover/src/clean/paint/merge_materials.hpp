// `--merge-materials` for a PSLG.
#pragma once

#include <vector>

#include <cover/pslg.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

namespace cover {

/// Leaves out the segments without a name that have the same material on both sides, so that the
/// faces beside them become one region. Those with one, as borders between layers of a drawing are,
/// stay, which is told.
///
/// Errors: those of apply_seeds.
/// Cost:   O(n log n).
Result<Pslg> merge_materials(Pslg pslg, Report& report);

}  // namespace cover
