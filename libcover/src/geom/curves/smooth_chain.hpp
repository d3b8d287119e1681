// Borders between pixels made smooth.
#pragma once

#include <vector>

#include <cover/point.hpp>

namespace cover {

/// A way along the sides of pixels: corners, each one unit from the next, to the left, right, up or
/// down.
struct PixelChain {
  std::vector<Point> corners;
  bool is_loop = false;  ///< without an end; the last corner is the first one then
};

/// No point of a smoothed chain is farther from the chain, and no corner of the chain farther from
/// the smoothed one, than this.
inline constexpr double kMostMoved = 0.7;

/// How much of what pixels make of a border is taken out.
enum class Smoothing {
  none,    ///< nothing: the corners where the chain turns
  least,   ///< corners are cut: through the middles of the pixels' sides
  little,  ///< steps of a few pixels
  much,    ///< waves of up to 40 pixels
};

/// A curve along a chain, with the same ends. Of a loop, all points may move, and its first point
/// is repeated last. Long straight pieces come out straight, and have few points. Corners between
/// two straight pieces of four sides of pixels and more stay, so that rectangles are what they are.
///
/// Source: least squares with a penalty on third differences (whittaker_1923_graduation), which
///         leaves quadratic curves as they are and so does not shrink circles
/// Cost:   O(n log n)
std::vector<Point> smooth_chain(const PixelChain& chain, Smoothing smoothing);

}  // namespace cover
