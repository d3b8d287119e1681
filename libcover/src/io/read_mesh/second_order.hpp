// Second-order triangles, of which only the corners are taken.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/verify.hpp>

namespace cover {

/// Leaves out the points that are in `midpoints` and no corner; the others keep their order.
/// Returns the new number of each old point.
///
/// REQUIRES: all indices in range
std::vector<std::uint32_t> drop_midpoints(const std::vector<std::uint32_t>& midpoints,
                                          TriangleSoup& soup);

/// Leaves out the values of the points that drop_midpoints() left out.
/// REQUIRES: `renumbered` is what it returned, for a mesh that has `kept` points now
void drop_values(const std::vector<std::uint32_t>& renumbered, std::size_t kept,
                 std::vector<double>& values);

}  // namespace cover
