// How long is cut and searched once there are meshes, and when. What the rounds and searches of
// cut_until_met, cut_and_improve and thin_cuts may take stands at the head of these. Where no
// figures are told, a number was not measured by itself.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cover::effort::cuts {

/// Triangles around one above the target whose longest sides are halved: what it lacks room for may
/// be some triangles away.
inline constexpr std::size_t kHalvedAround = 24;
/// Sides there of so much of the squared length of the longest are halved, too. With this, 0.8 of
/// the length, a mesh ends without obtuse triangles at 1,745 vertices; with one size for all at
/// 2,376; from 0.5 of the length on it never ends (RESULTS.md, "Which choices of cutting segments
/// were measured?").
inline constexpr double kHalvedToo = 0.64;

/// Clefts are closed where half of all points are their corners, four to a cleft: with fewer, few
/// triangles would be mended by it.
inline constexpr std::size_t kCornersOfCleft = 4;
/// Places tried for an obtuse triangle of the mesh with closed clefts, and for all of them.
inline constexpr std::uint64_t kPlacesBesideClefts = 20'000, kMostPlacesBesideClefts = 3'000'000;

}  // namespace cover::effort::cuts
