// Cutting off what lies outside a window.
#pragma once

#include <vector>

#include <cover/point.hpp>
#include <cover/read_options.hpp>

namespace cover {

/// The part of a polygon inside a window, after Sutherland and Hodgman (1974): where it falls into
/// pieces, they are joined along the window's sides by lines that lie twice there, which paints
/// the same by even-odd. Empty if nothing is inside.
///
/// Points inside stay bit for bit; new ones lie on the window's sides.
std::vector<Point> clip_polygon(std::vector<Point> polygon, const Window& window);

/// The parts of a polyline inside a window.
std::vector<std::vector<Point>> clip_line(const std::vector<Point>& line, const Window& window);

}  // namespace cover
