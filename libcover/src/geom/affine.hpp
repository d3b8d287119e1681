// Maps of the plane that keep lines straight.
#pragma once

#include <cmath>

#include <cover/point.hpp>

namespace cover {

/// (x, y) -> (a x + b y + c, d x + e y + f)
struct Affine {
  double a = 1, b = 0, c = 0, d = 0, e = 1, f = 0;

  [[nodiscard]] Point operator()(Point p) const {
    return {a * p.x + b * p.y + c, d * p.x + e * p.y + f};
  }
  /// First `inner`, then this.
  [[nodiscard]] Affine after(const Affine& inner) const {
    return {a * inner.a + b * inner.d, a * inner.b + b * inner.e, a * inner.c + b * inner.f + c,
            d * inner.a + e * inner.d, d * inner.b + e * inner.e, d * inner.c + e * inner.f + f};
  }
  [[nodiscard]] bool is_identity() const {
    return a == 1 && b == 0 && c == 0 && d == 0 && e == 1 && f == 0;
  }
  [[nodiscard]] bool is_mirrored() const { return a * e - b * d < 0; }
  /// Whether circles stay circles, up to rounding.
  [[nodiscard]] bool is_similar() const {
    const double size = std::hypot(a, d);
    const double off = is_mirrored() ? std::hypot(a + e, b - d) : std::hypot(a - e, b + d);
    return size > 0 && off <= 1e-12 * size;
  }
};

}  // namespace cover
