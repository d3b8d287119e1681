// A vertex over layers of thickness T lies at base + T along, whatever lies between: errors do not
// add up from row to row. At corners the lines parallel to both edges at distance T meet in the
// mitre; the columns of a square start from the feet of earlier tips.
// Tested by tests/unit/layers/front/offsets_test.cpp.
#include "layers/front/offsets.hpp"

#include <cmath>

#include "base/numbers.hpp"

namespace cover::layers {
namespace {

Vector mitre(Vector from, Vector to) { return (1 / (1 + dot(from, to))) * (from + to); }

/// `v` turned right.
Vector turned_right(Vector v, double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  return {c * v.x + s * v.y, c * v.y - s * v.x};
}

Offset plain(Point base, Vector along) { return {Offset::Kind::plain, base, along, {}, {}}; }

Offset corner(Point base, Vector from, Vector to) {
  return {Offset::Kind::corner, base, mitre(from, to), from, to};
}

/// The three corners of the square beside `c`.
std::vector<Offset> square(const Offset& c, double below) {
  return {plain(c.base + below * (c.along - c.from), c.from), c,
          plain(c.base + below * (c.along - c.to), c.to)};
}

/// Around a vertex of the boundary by `degrees`: two squares for about 180, else triangles.
std::vector<Offset> fan(const Offset& f, double degrees) {
  if (degrees >= 180 - 2 * kSkew) {
    const Vector ahead = turned_right(f.from, degrees / 2);
    return {plain(f.base, f.from), corner(f.base, f.from, ahead), plain(f.base, ahead),
            corner(f.base, ahead, f.to), plain(f.base, f.to)};
  }
  const int pieces = static_cast<int>(std::ceil(degrees / kMitre));
  std::vector<Offset> out{plain(f.base, f.from)};
  for (int k = 1; k < pieces; ++k)
    out.push_back(plain(f.base, turned_right(f.from, degrees * k / pieces)));
  out.push_back(plain(f.base, f.to));
  return out;
}

}  // namespace

double turning_angle(Vector from, Vector to) {
  return std::atan2(cross(from, to), dot(from, to)) / kDegree;
}

Offset offset_of(Point base, Vector from, Vector to, bool turn_back) {
  const double right = turn_back ? 180 : -turning_angle(from, to);
  if (right <= kMitre) return plain(base, mitre(from, to));
  if (std::abs(right - 90) <= kSkew) return corner(base, from, to);
  return {Offset::Kind::fan, base, {}, from, to};
}

std::vector<Offset> tops_of(const Offset& offset, double below) {
  switch (offset.kind) {
    case Offset::Kind::plain:
      break;
    case Offset::Kind::corner:
      return square(offset, below);
    case Offset::Kind::fan: {
      const double right = -turning_angle(offset.from, offset.to);
      return fan(offset, right <= 0 ? right + 360 : right);
    }
  }
  return {offset};
}

Vector normal_between(const Offset& a, const Offset& b) {
  if (b.kind == Offset::Kind::corner) return b.from;
  if (a.kind == Offset::Kind::corner) return a.to;
  const Vector middle = a.along + b.along;
  return (1 / length(middle)) * middle;
}

}  // namespace cover::layers
