#include "support/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <string>

namespace cover::testing {
namespace {

/// Adds points and chains of segments to an Input.
class Sketch {
 public:
  std::uint32_t point(Point p) {
    input.points.push_back(p);
    return static_cast<std::uint32_t>(input.points.size() - 1);
  }
  void segment(std::uint32_t a, std::uint32_t b) {
    InputSegment s;
    s.a = a;
    s.b = b;
    s.id = static_cast<long>(input.segments.size());
    input.segments.push_back(s);
  }
  Input input;
};

}  // namespace

Input checker(int cells, int pieces, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> offset(-0.08, 0.08);
  Sketch sketch;
  const auto n = static_cast<std::size_t>(cells);
  const double side = 1.0 / cells;
  std::vector<std::uint32_t> corner((n + 1) * (n + 1));
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      corner[i * (n + 1) + j] =
          sketch.point({static_cast<double>(i) / cells, static_cast<double>(j) / cells});
    }
  }
  const auto chain = [&](std::size_t i, std::size_t j, bool horizontal, bool straight) {
    std::uint32_t last = corner[i * (n + 1) + j];
    for (int m = 1; m < pieces; ++m) {
      const double t = static_cast<double>(m) / pieces, o = straight ? 0 : offset(random);
      const double x = static_cast<double>(i) + (horizontal ? t : o);
      const double y = static_cast<double>(j) + (horizontal ? o : t);
      const std::uint32_t next = sketch.point({x * side, y * side});
      sketch.segment(last, next);
      last = next;
    }
    sketch.segment(last, horizontal ? corner[(i + 1) * (n + 1) + j] : corner[i * (n + 1) + j + 1]);
  };
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      if (i < n) chain(i, j, true, j == 0 || j == n);
      if (j < n) chain(i, j, false, i == 0 || i == n);
      if (i < n && j < n) {
        RegionSeed s;
        s.at = {(static_cast<double>(i) + 0.5) * side, (static_cast<double>(j) + 0.5) * side};
        s.material = std::to_string(1 + (i + j) % 2);
        s.id = static_cast<long>(sketch.input.seeds.size());
        sketch.input.seeds.push_back(s);
      }
    }
  }
  return sketch.input;
}

Loop smooth_star(int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> jitter(-0.35, 0.35), phase(0, 2 * std::numbers::pi),
      weight(0.5, 1);
  std::vector<double> t(static_cast<std::size_t>(n)), r(static_cast<std::size_t>(n), 1.0);
  for (int i = 0; i < n; ++i) {
    t[static_cast<std::size_t>(i)] = (i + jitter(random)) * 2 * std::numbers::pi / n;
  }
  for (int k = 2; k <= n / 8; k *= 2) {
    const double p = phase(random), w = weight(random);
    for (std::size_t i = 0; i < t.size(); ++i) r[i] += 0.35 / k * w * std::cos(k * t[i] + p);
  }
  Loop loop;
  for (std::size_t i = 0; i < t.size(); ++i)
    loop.push_back({r[i] * std::cos(t[i]), r[i] * std::sin(t[i])});
  return loop;
}

Input input_of(const Loop& loop) {
  Sketch sketch;
  for (const Point& p : loop) sketch.point(p);
  const auto n = static_cast<std::uint32_t>(loop.size());
  for (std::uint32_t i = 0; i < n; ++i) sketch.segment(i, (i + 1) % n);
  return sketch.input;
}

Input shuffled(const Input& input, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> order(input.points.size()), place(order.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  Input out = input;
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    out.points[k] = input.points[order[k]];
    if (!input.point_ids.empty()) out.point_ids[k] = input.point_ids[order[k]];
    if (!input.point_markers.empty()) out.point_markers[k] = input.point_markers[order[k]];
  }
  for (InputSegment& s : out.segments) {
    s.a = place[s.a];
    s.b = place[s.b];
    if (random() % 2 == 0) std::swap(s.a, s.b);
  }
  std::shuffle(out.segments.begin(), out.segments.end(), random);
  return out;
}

Input transformed(const Input& input, double factor, Point shift) {
  Input out = input;
  const auto move = [&](Point& p) { p = {p.x * factor + shift.x, p.y * factor + shift.y}; };
  for (Point& p : out.points) move(p);
  for (RegionSeed& s : out.seeds) move(s.at);
  for (HoleSeed& h : out.holes) move(h.at);
  for (InputPolygon& polygon : out.polygons) {
    for (auto& ring : polygon.rings) {
      for (Point& p : ring) move(p);
    }
  }
  for (InputLine& line : out.lines) {
    for (Point& p : line.points) move(p);
  }
  return out;
}

}  // namespace cover::testing
