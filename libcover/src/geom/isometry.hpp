// Translations, rotations and reflections whose images of points are rounded once.
#pragma once

#include <cover/angle.hpp>
#include <cover/periodic.hpp>
#include <cover/point.hpp>

#include "geom/double_double.hpp"
#include "geom/vector.hpp"

namespace cover {

/// The image of a point, computed with twice the digits of a double and rounded once.
Point image_of(const Isometry& map, Point p);

/// The map that takes images back.
Isometry inverse_of(const Isometry& map);

/// `map` with another shift (x0, y0).
Isometry with_shift(Isometry map, DoubleDouble x0, DoubleDouble y0);

Isometry translation_by(Vector by);

/// Counter-clockwise. Angles that are multiples of 30 or 90 degrees have the cosines and sines
/// that they should, up to 2^-64.
Isometry rotation_about(Point centre, Angle angle);

/// The reflection that takes `p` to `q`. Exact in its linear part where the axis is parallel to a
/// coordinate axis or a diagonal up to 2^-36.
///
/// REQUIRES: p differs from q
Isometry reflection_between(Point p, Point q);

}  // namespace cover
