// From input as the user has it to a clean PSLG: the only step that may split an input segment.
#pragma once

#include <optional>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

#include "base/team.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// Makes a PSLG of `input`. Every change made to it is appended to `report.changes`; they are
/// summed up, and warnings given, in `report.notes`.
///
/// ENSURES: points are finite and all different; segments meet only at points; given points are
///          kept bit for bit unless they were welded.
/// Errors:  ErrorCode 100-199, with ids and coordinates.
/// Cost:    O((n + k) log n) for k crossings.
///
/// With `whole`: the triangulation of the convex hull, where one of the result was made on the way.
Result<Pslg> make_pslg(const Input& input, const Options& options, Report& report,
                       std::optional<Triangulation>* whole = nullptr, const Team& team = {});

}  // namespace cover
