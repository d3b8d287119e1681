// Whole inputs for tests and benchmarks: many regions, any size, one seed each.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/input.hpp>

#include "support/inputs/shapes.hpp"

namespace cover::testing {

/// A checkerboard of cells x cells regions in the unit square. Every cell side is cut into `pieces`
/// and its inner points are moved off the line by up to 0.08 of the side; a seed per cell with
/// material 1 or 2. cells * cells * pieces * 4 sides.
Input checker(int cells, int pieces, std::uint64_t seed);

/// One smooth star-shaped region of n vertices: jittered angles, a random Fourier radius whose
/// slope has the same size at every scale.
Loop smooth_star(int n, std::uint64_t seed);

/// One loop as an input without seeds.
Input input_of(const Loop& loop);

/// Points and the segments with these ends, ids from 0, without seeds.
Input segments_between(const std::vector<Point>& points,
                       const std::vector<std::array<std::uint32_t, 2>>& ends);

/// A layer that pinches out in a wedge of a fifth of a degree within a taller one, with corners in
/// pairs, one above the other, as sections through the ground have them: walls are seen from the
/// other ones at hardly more than a right angle.
Input pinch_out();

/// A square cut `cuts` times in two, one convex piece at a time, by a random line; a seed per piece
/// with material 1 to 3. Corners of a piece lie in the middle of its neighbours' sides, which are
/// cut there and bent by rounding: angles next to 180 degrees.
Input random_cells(int cuts, std::uint64_t seed);

/// Star-shaped polygons inside each other, n corners each; a seed between any two.
Input nested_stars(int rings, int n, std::uint64_t seed);

/// Rectangles between random lines, some far thinner than others; some are void.
Input rectangles(int columns, int rows, std::uint64_t seed);

/// Some of the edges of a Delaunay triangulation of at most `n` points that lie awkwardly: on a
/// lattice, nearly on lines, in clusters, on scales from 1 to 1e-8, far from the origin. So there
/// are slits, loose edges, pinched vertices, isolated points, very thin regions and void.
Input planar_graph(int n, std::uint64_t seed);

/// A generator of devices with several regions each.
struct RandomInput {
  const char* name;
  Input (*make)(std::uint64_t seed);
};
inline constexpr RandomInput kRandomDevices[] = {
    {"cells", [](std::uint64_t seed) { return random_cells(24, seed); }},
    {"stars", [](std::uint64_t seed) { return nested_stars(4, 17, seed); }},
    {"rectangles", [](std::uint64_t seed) { return rectangles(6, 5, seed); }},
    {"checker", [](std::uint64_t seed) { return checker(4, 5, seed); }},
};

/// The same input with the order of points, segments and seeds shuffled and some segments reversed.
Input shuffled(const Input& input, std::uint64_t seed);

/// The same input with every coordinate multiplied by `factor`, then shifted.
Input transformed(const Input& input, double factor, Point shift = {0, 0});

}  // namespace cover::testing
