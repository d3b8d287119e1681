#include "support/inputs/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "geom/spatial_order.hpp"
#include "geom/vector.hpp"

namespace cover::testing {

RegionBoundary boundary_of(const std::vector<Loop>& loops, const std::vector<Point>& isolated) {
  std::map<Point, std::uint32_t> index;
  for (const Loop& loop : loops) {
    for (const Point& p : loop) index.emplace(p, 0U);
  }
  for (const Point& p : isolated) index.emplace(p, 0U);
  RegionBoundary boundary;
  boundary.id = RegionId{1};
  std::vector<Point> ascending;
  for (const auto& [point, unused] : index) ascending.push_back(point);
  for (const std::uint32_t k : spatial_order(ascending)) {
    index[ascending[k]] = static_cast<std::uint32_t>(boundary.points.size());
    boundary.vertices.emplace_back(boundary.points.size());
    boundary.points.push_back(ascending[k]);
  }
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      boundary.sides.push_back({index[loop[i]], index[loop[(i + 1) % loop.size()]]});
    }
  }
  std::sort(boundary.sides.begin(), boundary.sides.end());
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) boundary.segments.emplace_back(s);
  return boundary;
}

Loop regular_polygon(int n, double radius, Point centre) {
  Loop loop;
  for (int k = 0; k < n; ++k) {
    const double t = 2 * std::numbers::pi * k / n;
    loop.push_back({centre.x + radius * std::cos(t), centre.y + radius * std::sin(t)});
  }
  return loop;
}

Loop random_star(int n, double smallest, std::mt19937_64& random, Point centre, double radius) {
  std::uniform_real_distribution<double> uniform(smallest, 1);
  Loop loop;
  for (int k = 0; k < n; ++k) {
    const double t = 2 * std::numbers::pi * k / n, r = radius * uniform(random);
    loop.push_back({centre.x + r * std::cos(t), centre.y + r * std::sin(t)});
  }
  return loop;
}

Loop wavy_square(int per_side, double by, std::mt19937_64& random) {
  std::uniform_real_distribution<double> off(-by, by);
  const Loop corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Loop loop;
  for (std::size_t s = 0; s < 4; ++s) {
    const Point from = corners[s];
    const Vector along = corners[(s + 1) % 4] - from;
    loop.push_back(from);
    for (int k = 1; k < per_side; ++k) {
      loop.push_back(
          from + ((static_cast<double>(k) / per_side) * along + off(random) * left_normal(along)));
    }
  }
  return loop;
}

Loop reversed(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

double doubled_area(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point a = loop[i], b = loop[(i + 1) % loop.size()];
    sum += (a.x - loop[0].x) * (b.y - loop[0].y) - (a.y - loop[0].y) * (b.x - loop[0].x);
  }
  return sum;
}

double area_of(const RegionBoundary& boundary) {
  const Point o = boundary.points[0];
  double sum = 0;
  for (const auto& [i, j] : boundary.sides) {
    const Point a = boundary.points[i], b = boundary.points[j];
    sum += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return sum / 2;
}

std::uint64_t cases_asked_for(const char* variable, std::uint64_t usual) {
  const char* value = std::getenv(variable);
  return value != nullptr ? std::strtoull(value, nullptr, 10) : usual;
}

std::uint64_t test_seed(std::uint64_t fallback) {
  return cases_asked_for("COVER_TEST_SEED", fallback);
}

std::string seed_trace(std::uint64_t seed) { return "COVER_TEST_SEED=" + std::to_string(seed); }

}  // namespace cover::testing
