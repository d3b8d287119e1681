#include "support/inputs/random_regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "geom/predicates.hpp"
#include "support/inputs/shapes.hpp"

namespace cover::testing {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(random);
}
int below(Random& random, int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }

/// 10^-1 to 10^-12, evenly in the exponent.
double tiny(Random& random) { return std::pow(10.0, -uniform(random, 1, 12)); }

Loop square(double half) { return {{-half, -half}, {half, -half}, {half, half}, {-half, half}}; }

bool cross_or_touch(Point a, Point b, Point c, Point d) {
  const auto sign = [](Sign s) { return static_cast<int>(s); };
  const int abc = sign(orientation(a, b, c)), abd = sign(orientation(a, b, d));
  const int cda = sign(orientation(c, d, a)), cdb = sign(orientation(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  const auto between = [](Point p, Point q, Point r) {
    return std::min(p, q) < r && r < std::max(p, q);
  };
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
         (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

/// Points, on a lattice or not, and segments between them that meet only at their ends.
struct Sketch {
  std::vector<Point> points;
  std::vector<IndexPair> segments;
};

Sketch random_sketch(Random& random) {
  Sketch sketch;
  std::set<Point> points;
  const bool lattice = below(random, 2) == 0;
  const int count = 3 + below(random, 14);
  for (int k = 0; k < count; ++k) {
    const Point p{uniform(random, -4, 4), uniform(random, -4, 4)};
    points.insert(lattice ? Point{std::round(p.x), std::round(p.y)} : p);
  }
  if (below(random, 3) == 0) {  // a close pair
    const Point p = *points.begin();
    points.insert({p.x + tiny(random), p.y + uniform(random, -1, 1) * tiny(random)});
  }
  sketch.points.assign(points.begin(), points.end());
  const auto n = static_cast<std::uint32_t>(sketch.points.size());
  for (int k = below(random, 12); k > 0; --k) {
    const auto a = static_cast<std::uint32_t>(random() % n),
               b = static_cast<std::uint32_t>(random() % n);
    if (a == b) continue;
    const Point p = sketch.points[a], q = sketch.points[b];
    const bool free =
        std::none_of(sketch.segments.begin(), sketch.segments.end(),
                     [&](const IndexPair& s) {
                       return cross_or_touch(p, q, sketch.points[s[0]], sketch.points[s[1]]) ||
                              (s[0] == a && s[1] == b) || (s[0] == b && s[1] == a);
                     }) &&
        std::none_of(sketch.points.begin(), sketch.points.end(), [&](Point r) {
          return orientation(p, q, r) == Sign::zero && std::min(p, q) < r && r < std::max(p, q);
        });
    if (free) sketch.segments.push_back({a, b});
  }
  return sketch;
}

/// The component of segments may enclose faces; only forests leave one region.
RandomRegion slits(Random& random) {
  Sketch sketch = random_sketch(random);
  std::vector<Loop> loops{square(6)};
  std::vector<std::uint32_t> root(sketch.points.size());
  for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = v;
  const auto find = [&](std::uint32_t v) {
    while (root[v] != v) v = root[v];
    return v;
  };
  for (const auto& [a, b] : sketch.segments) {
    const std::uint32_t x = find(a), y = find(b);
    if (x == y) continue;
    root[std::max(x, y)] = std::min(x, y);
    loops.push_back({sketch.points[a], sketch.points[b]});
  }
  return {"slits", boundary_of(loops, sketch.points)};
}

RandomRegion star(Random& random) {
  const double smallest = below(random, 2) == 0 ? uniform(random, 0.5, 0.99) : tiny(random);
  return {"star", boundary_of({random_star(4 + below(random, 120), smallest, random)})};
}

RandomRegion regular(Random& random) {
  const int n = 3 + below(random, 40);
  std::vector<Loop> loops{regular_polygon(n)};
  if (below(random, 2) == 0) {
    loops.push_back(reversed(regular_polygon(3 + below(random, 20), uniform(random, 0.05, 0.45))));
  }
  return {"regular", boundary_of(loops)};
}

/// A strip with points at random, or opposite to each other, on both long sides.
RandomRegion strip(Random& random) {
  const double width = tiny(random);
  const int n = 1 + below(random, 12);
  std::set<double> low{0, 1}, high{0, 1};
  for (int k = 1; k < n; ++k) {
    const double x = uniform(random, 0.01, 0.99);
    low.insert(x);
    high.insert(below(random, 2) == 0 ? x : std::min(1.0, x + tiny(random)));
  }
  Loop loop;
  for (const double x : low) loop.push_back({x, 0});
  for (auto x = high.rbegin(); x != high.rend(); ++x) loop.push_back({*x, width});
  return {"strip", boundary_of({loop})};
}

RandomRegion comb(Random& random) {
  const double gap = tiny(random), tooth = below(random, 2) == 0 ? 1 : tiny(random);
  const int n = 1 + below(random, 8);
  Loop loop{{0, 0}};
  double x = 0;
  for (int k = 0; k < n; ++k) {
    loop.push_back({x, 1});
    x += tooth;
    loop.push_back({x, 1});
    loop.push_back({x, uniform(random, 0.1, 0.4)});
    x += gap;
    loop.push_back({x, loop.back().y});
  }
  loop.push_back({x, 1});
  loop.push_back({x + 1, 1});
  loop.push_back({x + 1, 0});
  std::reverse(loop.begin(), loop.end());
  return {"comb", boundary_of({loop})};
}

/// A chord and a polygonised arc over it, seen from inside or from outside.
RandomRegion arc(Random& random) {
  const int n = 3 + below(random, 30);
  const double angle = uniform(random, 0.05, 3.1);
  Loop loop;
  for (int k = 0; k <= n; ++k) {
    const double t = angle * k / n;
    loop.push_back({std::cos(t), std::sin(t)});
  }
  if (below(random, 2) == 0) return {"arc inside", boundary_of({loop})};
  return {"arc outside", boundary_of({square(2), reversed(loop)})};
}

/// Cells of a lattice: collinear and cocircular points, holes, pinched vertices.
RandomRegion cells(Random& random) {
  const int n = 2 + below(random, 4);
  std::map<std::pair<int, int>, bool> full;
  std::vector<std::pair<int, int>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    if (i < 0 || j < 0 || i >= n || j >= n || full.count({i, j}) != 0) continue;
    full[{i, j}] = (i == 0 && j == 0) || below(random, 4) != 0;
    if (!full[{i, j}]) continue;
    for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      stack.emplace_back(i + di, j + dj);
    }
  }
  const auto inside = [&](int i, int j) {
    const auto cell = full.find({i, j});
    return cell != full.end() && cell->second;
  };
  std::vector<Loop> edges;  // directed pairs, put into a boundary by hand
  RegionBoundary boundary = boundary_of({}, [&] {
    std::vector<Point> corners;
    for (const auto& [cell, is_full] : full) {
      if (!is_full) continue;
      const double i = cell.first, j = cell.second;
      corners.insert(corners.end(), {{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}});
    }
    return corners;
  }());
  const auto index = [&](double x, double y) {
    return static_cast<std::uint32_t>(
        std::find(boundary.points.begin(), boundary.points.end(), Point{x, y}) -
        boundary.points.begin());
  };
  for (const auto& [cell, is_full] : full) {
    if (!is_full) continue;
    const auto [i, j] = cell;
    if (!inside(i, j - 1)) boundary.sides.push_back({index(i, j), index(i + 1, j)});
    if (!inside(i + 1, j)) boundary.sides.push_back({index(i + 1, j), index(i + 1, j + 1)});
    if (!inside(i, j + 1)) boundary.sides.push_back({index(i + 1, j + 1), index(i, j + 1)});
    if (!inside(i - 1, j)) boundary.sides.push_back({index(i, j + 1), index(i, j)});
  }
  std::sort(boundary.sides.begin(), boundary.sides.end());
  boundary.segments.clear();
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) boundary.segments.emplace_back(s);
  return {"cells", boundary};
}

/// Holes, regular or not, some nearly touching.
RandomRegion holes(Random& random) {
  std::vector<Loop> loops{square(5)};
  const int n = 1 + below(random, 4);
  const double gap = tiny(random);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (below(random, 4) == 0) continue;
      const double step = 8.0 / n;
      const Point centre{-4 + (i + 0.5) * step, -4 + (j + 0.5) * step};
      const double radius = (1 - gap) * step / 2;
      loops.push_back(reversed(
          below(random, 2) == 0 ? regular_polygon(3 + below(random, 14), radius, centre)
                                : random_star(5 + below(random, 9), 0.2, random, centre, radius)));
    }
  }
  return {"holes", boundary_of(loops)};
}

/// Two vertices, or a vertex and a side, at a tiny distance.
RandomRegion near(Random& random) {
  const double gap = tiny(random), lean = uniform(random, -0.9, 0.9);
  const double far = below(random, 2) == 0 ? gap : uniform(random, 0.1, 1);
  return {"near", boundary_of({{{-2, -2},
                                {2, -2},
                                {2, 0},
                                {lean, -2 + gap},
                                {2, 0 + far},
                                {2, 2},
                                {-2, 2},
                                {-2, 1},
                                {lean - gap, -2 + 2 * gap + far / 8},
                                {-2, 0.5}}})};
}

}  // namespace

RandomRegion random_region(std::mt19937_64& random) {
  switch (below(random, 9)) {
    case 0:
      return slits(random);
    case 1:
      return star(random);
    case 2:
      return regular(random);
    case 3:
      return strip(random);
    case 4:
      return comb(random);
    case 5:
      return arc(random);
    case 6:
      return cells(random);
    case 7:
      return holes(random);
    default:
      return near(random);
  }
}

RandomRegion random_hull(std::mt19937_64& random) {
  Sketch sketch;
  CdtResult hull;
  do {
    sketch = random_sketch(random);
    hull = triangulate_hull(sketch.points, sketch.segments);
  } while (hull.triangulation.triangles.empty());
  // The region of a triangle: what is reached from it without crossing a segment.
  const auto& triangles = hull.triangulation.triangles;
  std::vector<bool> inside(triangles.size(), false);
  std::vector<std::uint32_t> stack{static_cast<std::uint32_t>(random() % triangles.size())};
  inside[stack[0]] = true;
  RandomRegion region{"hull", boundary_of({}, sketch.points)};
  RegionBoundary& boundary = region.boundary;
  std::vector<std::pair<IndexPair, SegmentId>> sides;
  std::vector<bool> used(sketch.points.size(), false);
  while (!stack.empty()) {
    const Triangle& f = triangles[stack.back()];
    stack.pop_back();
    for (const Corner i : kCorners) {
      used[f.v[i]] = true;
      if (f.is_locked(i) || f.n[i] == kNone) {
        sides.push_back(
            {{f.v[i.next()], f.v[i.previous()]}, f.is_locked(i) ? SegmentId{0U} : kHullSide});
      } else if (!inside[f.n[i]]) {
        inside[f.n[i]] = true;
        stack.push_back(f.n[i]);
      }
    }
  }
  // Keep the points of the region alone.
  std::vector<std::uint32_t> number(used.size(), 0);
  boundary.points.clear();
  boundary.vertices.clear();
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    number[v] = static_cast<std::uint32_t>(boundary.points.size());
    boundary.vertices.emplace_back(boundary.points.size());
    boundary.points.push_back(sketch.points[v]);
  }
  for (auto& [side, segment] : sides) side = {number[side[0]], number[side[1]]};
  std::sort(sides.begin(), sides.end());
  boundary.sides.clear();
  boundary.segments.clear();
  for (const auto& [side, segment] : sides) {
    boundary.sides.push_back(side);
    boundary.segments.push_back(segment);
  }
  return region;
}

RegionBoundary transformed(RegionBoundary boundary, double factor, Point shift) {
  for (Point& p : boundary.points) p = {p.x * factor + shift.x, p.y * factor + shift.y};
  return boundary;
}

}  // namespace cover::testing
