// Rational B-splines as points.
#pragma once

#include <optional>
#include <vector>

#include <cover/point.hpp>

#include "dxf/drawing.hpp"

namespace cover {

/// Points along a spline, so close that a chord spans a turn of at most `step` degrees and leaves
/// the curve by about `chord_error` at most, if that is given. A spline that has fit points only
/// gives these. Nothing if knots, degree and points do not belong together.
///
/// Cost: O(degree^2) per point, of which there are 2^12 per span between knots at most
std::optional<std::vector<Point>> spline_points(const DxfSpline& spline, double step,
                                                std::optional<double> chord_error);

}  // namespace cover
