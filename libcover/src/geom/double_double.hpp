// Arithmetic with twice the digits of a double: an unevaluated sum of two doubles.
#pragma once

#include <cmath>

namespace cover {

/// high + low, with `high` the double nearest to the sum.
///
/// Every operation is correct to a relative error of 2^-100 of its own result, unless something
/// over- or underflows.
/// Ref: M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building
///      blocks of double-word arithmetic, ACM TOMS 44 (2017)
struct DoubleDouble {
  double high = 0;
  double low = 0;
};

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a - b exactly.
inline DoubleDouble two_difference(double a, double b) { return two_sum(a, -b); }

/// a * b exactly.
inline DoubleDouble two_product(double a, double b) {
  // Veltkamp's splitting: without hardware support std::fma would be slower.
  constexpr double kSplitter = 0x1p27 + 1;
  const double big_a = kSplitter * a, a1 = big_a - (big_a - a), a2 = a - a1;
  const double big_b = kSplitter * b, b1 = big_b - (big_b - b), b2 = b - b1;
  const double product = a * b;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

/// a + b exactly.
/// REQUIRES: |a| >= |b|, or a is zero
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

inline DoubleDouble operator+(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble high = two_sum(x.high, y.high), low = two_sum(x.low, y.low);
  const DoubleDouble sum = quick_two_sum(high.high, high.low + low.high);
  return quick_two_sum(sum.high, low.low + sum.low);
}

inline DoubleDouble operator-(DoubleDouble x) { return {-x.high, -x.low}; }
inline DoubleDouble operator-(DoubleDouble x, DoubleDouble y) { return x + -y; }

inline DoubleDouble operator*(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble high = two_product(x.high, y.high);
  return quick_two_sum(high.high, high.low + (x.high * y.low + x.low * y.high));
}

inline DoubleDouble operator/(DoubleDouble x, DoubleDouble y) {
  const double first = x.high / y.high;
  const DoubleDouble rest = x - y * DoubleDouble{first, 0};
  const double second = rest.high / y.high;
  const DoubleDouble rest2 = rest - y * DoubleDouble{second, 0};
  const DoubleDouble quotient = quick_two_sum(first, second);
  return quotient + DoubleDouble{rest2.high / y.high, 0};
}

}  // namespace cover
