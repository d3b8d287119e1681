// A gap is the difference of two lengths that are nearly equal, of which one is a root: d - s. It
// is taken as (d^2 - s^2) / (d + s), whose difference has twice the digits of a double. So it is
// right to a part in 2^50 or so of itself, or of 2^-100 of the lengths.
// Tested by tests/unit/geom/curves/touch_test.cpp.
#include "geom/curves/touch.hpp"

#include <algorithm>
#include <cmath>

#include "geom/double_double.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// The largest power of two by which lengths are divided, so that squares of what is left neither
/// over- nor underflow where it counts.
int octave_of(double largest) { return largest > 0 ? std::ilogb(largest) : 0; }

DoubleDouble square(DoubleDouble x) { return x * x; }

/// q - p, exactly, divided by the power of two.
struct LongStep {
  DoubleDouble x, y;
  LongStep(Point p, Point q, int octave)
      : x(two_difference(std::ldexp(q.x, -octave), std::ldexp(p.x, -octave))),
        y(two_difference(std::ldexp(q.y, -octave), std::ldexp(p.y, -octave))) {}
  [[nodiscard]] DoubleDouble squared_length() const { return square(x) + square(y); }
};

}  // namespace

double Touch::half_width(double distance) const { return std::sqrt(2 * distance / curvature); }

std::optional<Touch> touch_of(const ArcCircle& one, const ArcCircle& other, double reach) {
  const bool is_one_smaller = one.radius <= other.radius;
  const ArcCircle &small = is_one_smaller ? one : other, &large = is_one_smaller ? other : one;
  const Vector between = large.centre - small.centre;
  const double d = length(between), sum = large.radius + small.radius;
  const double difference = large.radius - small.radius;
  // Most circles are nowhere near this.
  const double roughly = 2 * reach + 0x1p-40 * sum;
  const bool may_be_outside = std::abs(d - sum) <= roughly;
  const bool may_be_inside = std::abs(d - difference) <= roughly;
  if (d == 0 || !(may_be_outside || may_be_inside)) return std::nullopt;
  const int octave = octave_of(std::max({std::abs(between.x), std::abs(between.y), large.radius}));
  const LongStep step(small.centre, large.centre, octave);
  const double r = std::ldexp(small.radius, -octave), big = std::ldexp(large.radius, -octave);
  const auto gap_to = [&](DoubleDouble length_of_both) {
    const DoubleDouble power = step.squared_length() - square(length_of_both);
    return std::ldexp(power.high / (std::ldexp(d, -octave) + length_of_both.high), octave);
  };
  const Vector unit = (1 / d) * between;
  const double outside = gap_to(two_sum(big, r));
  if (may_be_outside && std::abs(outside) <= reach)
    return Touch{small.centre + (small.radius + outside / 2) * unit, outside,
                 1 / small.radius + 1 / large.radius};
  // Of one circle inside another the gap is between the far side of the small one and the large.
  const double inside = -gap_to(two_difference(big, r));
  if (may_be_inside && difference > 0 && std::abs(inside) <= reach)
    return Touch{small.centre + (-(small.radius + inside / 2)) * unit, inside,
                 difference / small.radius / large.radius};
  return std::nullopt;
}

std::optional<Touch> touch_of(const ArcCircle& circle, Point a, Point b, double reach) {
  const double r = circle.radius, along = length(b - a);
  const double height = std::abs(cross((1 / along) * (b - a), circle.centre - a));
  const double far = std::max(length(circle.centre - a), along);
  if (!(std::abs(height - r) <= 2 * reach + 0x1p-40 * far)) return std::nullopt;
  const int octave = octave_of(std::max(far, r));
  const LongStep line(a, b, octave), to_centre(a, circle.centre, octave);
  const DoubleDouble area = line.x * to_centre.y - line.y * to_centre.x;
  const DoubleDouble radius{std::ldexp(r, -octave), 0};
  const DoubleDouble power = square(area) - square(radius) * line.squared_length();
  const double side = std::ldexp(along, -octave);
  const double gap =
      std::ldexp(power.high / (side * (std::abs(area.high) + radius.high * side)), octave);
  if (!(std::abs(gap) <= reach)) return std::nullopt;
  const Point foot = exact_foot(a, b, circle.centre).value_or(nearest_on_line(a, b, circle.centre));
  return Touch{foot, gap, 1 / r};
}

}  // namespace cover
