// Which segment lies close behind an edge of a triangulation.
#pragma once

#include <cstdint>
#include <optional>

#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// Goes on from point w across `edge`, which need not be locked, as long as edges are nearer to w
/// than `reach`, to the locked edge behind them. None where that takes too many steps.
std::optional<EdgeRef> wall_behind(const Triangulation& triangulation, std::uint32_t w,
                                   EdgeRef edge, double reach);

}  // namespace cover
