// Ends of lines that miss another end by next to nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/report.hpp>

#include "cdt/cdt.hpp"

namespace cover {

/// 4 units in the last place of the largest coordinate: places that are no farther apart may be one
/// that was computed twice.
double rounding_of(std::span<const Point> points);

/// An end of one line alone, and another end near it.
struct LooseGap {
  std::uint32_t loose = 0;
  std::uint32_t other = 0;
  double distance = 0;
};

/// The gaps of at most `reach` between an end of one segment alone and the end nearest to it, of a
/// segment that does not join the two; by `loose`.
///
/// Cost: O(n log n), unless many ends are near one.
std::vector<LooseGap> find_loose_gaps(std::span<const Point> points,
                                      std::span<const IndexPair> segments, double reach);

/// Gaps wider than this part of the drawing's size are not taken for errors of drawing.
inline constexpr double kSmallGap = 0x1p-19;

/// "--weld auto" or "--weld 3e-08": the option, with one digit, that closes gaps of at most
/// `widest`, as a part of the drawing's size.
std::string weld_closing(double widest);

/// The input with loose ends joined to ends that are within rounding_of() its points. Nothing if
/// there are none. Every one is appended to `changes`.
///
/// REQUIRES: indices in range, coordinates finite
std::optional<Input> join_loose_ends(const Input& input, std::vector<Change>& changes);

}  // namespace cover
