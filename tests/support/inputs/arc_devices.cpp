#include "support/inputs/arc_devices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace cover::testing {
namespace {

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

std::uint32_t point_at(Input& input, Point p) {
  const auto at = std::find(input.points.begin(), input.points.end(), p);
  if (at == input.points.end()) {
    input.points.push_back(p);
    return static_cast<std::uint32_t>(input.points.size() - 1);
  }
  return static_cast<std::uint32_t>(at - input.points.begin());
}

void add_segment(Input& input, Point a, Point b, std::uint32_t circle, const char* name = "") {
  InputSegment segment;
  segment.a = point_at(input, a);
  segment.b = point_at(input, b);
  segment.id = static_cast<long>(input.segments.size());
  segment.name = name;
  segment.circle = circle;
  input.segments.push_back(segment);
}

Point on_circle(Point centre, double radius, double turn) {
  return {centre.x + radius * std::cos(turn), centre.y + radius * std::sin(turn)};
}

/// Chords from one angle to another; the ends are as given where they are.
void add_arc(Input& input, Point centre, double radius, double from, double to, int chords,
             Point first, Point last) {
  input.circles.push_back({centre, radius});
  const auto circle = static_cast<std::uint32_t>(input.circles.size());
  for (int k = 0; k < chords; ++k) {
    const auto place = [&](int j) {
      return j == 0        ? first
             : j == chords ? last
                           : on_circle(centre, radius, from + (to - from) * j / chords);
    };
    add_segment(input, place(k), place(k + 1), circle);
  }
}

constexpr double kPi = std::numbers::pi;

void add_ring(Input& input, Point c, double size, Random& random) {
  const double outer = size * between(random, 0.2, 0.45);
  const int chords = 3 + static_cast<int>(random() % 22);
  // Inside of the chords' middles, by much or by hardly anything.
  const double room = outer * std::cos(kPi / chords);
  const double inner = room * (random() % 3 == 0 ? 1 - std::pow(10, between(random, -6, -1))
                                                 : between(random, 0.3, 0.9));
  const int inner_chords = random() % 2 == 0 ? chords : 3 + static_cast<int>(random() % 22);
  add_circle(input, c, outer, chords, "outer", between(random, 0, 1));
  add_circle(input, c, inner, inner_chords, "inner", between(random, 0, 1));
}

void add_half_disc(Input& input, Point c, double size, Random& random) {
  const double r = size * between(random, 0.1, 0.45), turn = between(random, 0, 2 * kPi);
  const Point a = on_circle(c, r, turn), b = on_circle(c, r, turn + kPi);
  add_arc(input, c, r, turn, turn + kPi, 2 + static_cast<int>(random() % 12), a, b);
  add_segment(input, b, a, 0);
}

void add_lens(Input& input, Point c, double size, Random& random) {
  const double half = size * between(random, 0.1, 0.4);
  const Point a{c.x - half, c.y}, b{c.x + half, c.y};
  for (const double side : {1.0, -1.0}) {
    const double angle = between(random, 0.1, 1.2);  // half of the arc's
    const double r = half / std::sin(angle);
    const Point centre{c.x, c.y - side * r * std::cos(angle)};
    const double middle = side * kPi / 2;
    add_arc(input, centre, r, middle + side * angle, middle - side * angle,
            1 + static_cast<int>(random() % 8), a, b);
  }
}

void add_rounded(Input& input, Point c, double size, Random& random) {
  const double w = size * between(random, 0.15, 0.4), h = size * between(random, 0.15, 0.4);
  const double r = std::min(w, h) * between(random, 0.05, 0.9);
  const int chords = 1 + static_cast<int>(random() % 6);
  const Point centres[] = {{c.x + w - r, c.y + h - r},
                           {c.x - w + r, c.y + h - r},
                           {c.x - w + r, c.y - h + r},
                           {c.x + w - r, c.y - h + r}};
  Point before = on_circle(centres[3], r, 2 * kPi);
  const Point start = before;
  for (int k = 0; k < 4; ++k) {
    const double from = k * kPi / 2;
    const Point a = on_circle(centres[k], r, from);
    const Point b = k == 3 ? start : on_circle(centres[k], r, from + kPi / 2);
    add_segment(input, before, a, 0);
    add_arc(input, centres[k], r, from, from + kPi / 2, chords, a, b);
    before = b;
  }
}

void add_gear(Input& input, Point c, double size, Random& random) {
  const int teeth = 3 + static_cast<int>(random() % 6);
  const double outer = size * between(random, 0.25, 0.45),
               inner = outer * between(random, 0.5, 0.9);
  const Point start = on_circle(c, outer, 0);
  Point here = start;
  for (int k = 0; k < teeth; ++k) {
    const double step = 2 * kPi / teeth, turn = k * step;
    const Point a = on_circle(c, outer, turn + step / 2), b = on_circle(c, inner, turn + step / 2);
    const Point d = on_circle(c, inner, turn + step);
    const Point e = k + 1 == teeth ? start : on_circle(c, outer, turn + step);
    const int chords = 1 + static_cast<int>(random() % 5) + (teeth < 4 ? 1 : 0);
    add_arc(input, c, outer, turn, turn + step / 2, chords, here, a);
    add_segment(input, a, b, 0);
    add_arc(input, c, inner, turn + step / 2, turn + step, chords, b, d);
    add_segment(input, d, e, 0);
    here = e;
  }
}

}  // namespace

void add_circle(Input& input, Point centre, double radius, int chords, const char* name,
                double turn) {
  input.circles.push_back({centre, radius});
  const auto circle = static_cast<std::uint32_t>(input.circles.size());
  for (int k = 0; k < chords; ++k) {
    const auto place = [&](int j) {
      return on_circle(centre, radius, turn + 2 * kPi * (j % chords) / chords);
    };
    add_segment(input, place(k), place(k + 1), circle, name);
  }
}

InputPolygon disc_of(const Input& circle, const char* material) {
  InputPolygon disc;
  disc.rings = {circle.points};
  disc.circles = {std::vector<std::uint32_t>(circle.points.size(), 1)};
  disc.material = material;
  return disc;
}

Input random_arc_device(std::uint64_t seed) {
  Random random(seed);
  Input input;
  const Point corners[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (int k = 0; k < 4; ++k) add_segment(input, corners[k], corners[(k + 1) % 4], 0, "frame");
  for (int cell = 0; cell < 4; ++cell) {
    const Point c{0.5 + cell % 2 + between(random, -0.01, 0.01), 0.5 + cell / 2};
    switch (random() % 5) {
      case 0:
        add_ring(input, c, 1, random);
        break;
      case 1:
        add_half_disc(input, c, 1, random);
        break;
      case 2:
        add_lens(input, c, 1, random);
        break;
      case 3:
        add_rounded(input, c, 1, random);
        break;
      default:
        add_gear(input, c, 1, random);
        break;
    }
  }
  return input;
}

}  // namespace cover::testing
