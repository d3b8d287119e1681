// Periodic sides: lines that are made images of each other before regions are meshed.
#pragma once

#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

namespace cover {

/// Makes the lines that `rules` name images of each other and fills Pslg::periodic and
/// Pslg::isometries. Points match within 2^-30 of the size of both lines, or as far as
/// Options::weld takes ends for one. Points that only one line has are put on the other; then the
/// points of each class are moved to the rounded images of one of them, the first. Both are changes
/// that the report tells, but moves by a few units in the last place.
///
/// ENSURES: segments meet only at points, by exact predicates; `table` is that of `pslg`
/// Errors:  those of match_sides(); bad_option, with places, where lines do not match;
///          changed_input, with Options::strict
/// Cost:    O(n log n)
Status join_periodic_sides(Pslg& pslg, RegionTable& table, const std::vector<PeriodicRule>& rules,
                           const Options& options, Report& report);

}  // namespace cover
