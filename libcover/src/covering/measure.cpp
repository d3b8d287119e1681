// All angles of a triangle share one cross product, so two arc tangents give all three: that of
// pi minus the largest, and that of the smallest; the one between is their difference, which loses
// no digits because it is at least half of the first.
#include "covering/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kPi = std::numbers::pi;

/// A triangle from its largest angle's corner on.
struct Sorted {
  Point apex;             ///< corner of the largest angle, opposite to the longest edge
  Point p, q;             ///< the others, counter-clockwise
  double largest_nu = 0;  ///< pi - largest angle
  double smallest = 0;
  double doubled_area = 0;
};

Sorted sort_angles(Point a, Point b, Point c) {
  const double ab = squared_length(b - a), bc = squared_length(c - b), ca = squared_length(a - c);
  Sorted s;
  if (bc >= ab && bc >= ca) {
    s.apex = a, s.p = b, s.q = c;
  } else if (ca >= ab) {
    s.apex = b, s.p = c, s.q = a;
  } else {
    s.apex = c, s.p = a, s.q = b;
  }
  const Vector u = s.p - s.apex, v = s.q - s.apex;
  s.doubled_area = cross(u, v);
  s.largest_nu = std::atan2(std::abs(s.doubled_area), -dot(u, v));
  // The smallest angle faces the shorter of u and v.
  const bool u_shorter = squared_length(u) < squared_length(v);
  const Point at = u_shorter ? s.q : s.p, near = u_shorter ? s.p : s.q;
  s.smallest = std::atan2(std::abs(s.doubled_area), dot(s.apex - at, near - at));
  return s;
}

double largest_coordinate(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

std::size_t bin_of(double radians) {
  return std::min<std::size_t>(17, static_cast<std::size_t>(radians * (18 / kPi)));
}

/// Cotangent of the corner opposite to the half-edge from a to b.
double opposite_cotangent(Point a, Point b, Point corner) {
  const Vector u = a - corner, v = b - corner;
  return dot(u, v) / std::abs(cross(u, v));
}

/// The triangle with the largest angle.
IndexTriple worst_triangle(std::span<const Point> points, std::span<const IndexTriple> triangles) {
  const auto nu = [&](const IndexTriple& t) {
    return sort_angles(points[t[0]], points[t[1]], points[t[2]]).largest_nu;
  };
  return *std::min_element(triangles.begin(), triangles.end(),
                           [&](const auto& s, const auto& t) { return nu(s) < nu(t); });
}

Note bound_missed(const RegionReport& report, std::span<const Point> points, IndexTriple worst) {
  const Point a = points[worst[0]], b = points[worst[1]], c = points[worst[2]];
  return {Note::Kind::bound_missed,
          report.id,
          fmt::format("region {}: the triangle ({}, {}), ({}, {}), ({}, {}) has an angle of {:.9g} "
                      "degrees; the bound is {:.9g}",
                      report.id.value(), a.x, a.y, b.x, b.y, c.x, c.y,
                      report.quality.largest_nu.supplement().in_degrees(),
                      report.nu_bound.supplement().in_degrees()),
          {a, b, c}};
}

}  // namespace

std::vector<Point> all_points(const RegionBoundary& boundary, const RegionMesh& mesh) {
  std::vector<Point> points;
  points.reserve(boundary.points.size() + mesh.steiner.size());
  points.insert(points.end(), boundary.points.begin(), boundary.points.end());
  points.insert(points.end(), mesh.steiner.begin(), mesh.steiner.end());
  return points;
}

Quality measure_angles(std::span<const Point> points, std::span<const IndexTriple> triangles) {
  Quality quality;
  quality.triangles = triangles.size();
  double largest_nu = kPi, smallest = kPi;
  for (const auto& [i, j, k] : triangles) {
    const Sorted s = sort_angles(points[i], points[j], points[k]);
    largest_nu = std::min(largest_nu, s.largest_nu);
    smallest = std::min(smallest, s.smallest);
    if (compare_with_90_degrees(s.p, s.apex, s.q) == Sign::positive) {
      ++quality.obtuse;
      if (compare_with_120_degrees(s.p, s.apex, s.q) == Sign::positive) ++quality.above_120;
      if (s.largest_nu < kPi / 6) ++quality.above_150;
    }
    ++quality.histogram[bin_of(kPi - s.largest_nu)];
    ++quality.histogram[bin_of(s.largest_nu - s.smallest)];
    ++quality.histogram[bin_of(s.smallest)];
    quality.area += s.doubled_area / 2;
  }
  quality.largest_nu = Angle::radians(largest_nu);
  quality.smallest = Angle::radians(smallest);
  return quality;
}

BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        std::span<const IndexPair> sides) {
  BoxMethod box;
  const HalfEdges half_edges(points.size(), triangles);
  std::vector<bool> is_side(half_edges.size(), false);
  for (const auto& [a, b] : sides) {
    const std::uint32_t h = half_edges.find(a, b);
    if (h != HalfEdges::kAbsent) is_side[h] = true;
  }
  for (std::uint32_t h = 0; h < half_edges.size(); ++h) {
    const Point a = points[half_edges.source(h)], b = points[half_edges.target(h)];
    const Point c = points[half_edges.target(HalfEdges::next(h))];
    // |e| d_e / 2 with d_e = |e| |cot| / 2, the distance from the edge's midpoint to the
    // circumcentre
    box.box_area += squared_length(b - a) * std::abs(opposite_cotangent(a, b, c)) / 4;
    const std::uint32_t twin = is_side[h] ? HalfEdges::kAbsent : half_edges.twin(h);
    if (twin == HalfEdges::kAbsent) {
      if (compare_with_90_degrees(a, c, b) == Sign::positive) ++box.obtuse_sides;
    } else if (h < twin) {
      const Point d = points[half_edges.target(HalfEdges::next(twin))];
      if (in_circle(a, b, c, d) == Sign::positive) ++box.non_delaunay_edges;
    }
  }
  // cot a + cot b = sin(a + b) / (sin a sin b): negative just where the edge is not Delaunay.
  box.negative_couplings = box.non_delaunay_edges + box.obtuse_sides;
  return box;
}

void merge(Quality& sum, const Quality& part) {
  sum.triangles += part.triangles;
  sum.largest_nu = std::min(sum.largest_nu, part.largest_nu);
  sum.smallest = std::min(sum.smallest, part.smallest);
  sum.obtuse += part.obtuse;
  sum.above_120 += part.above_120;
  sum.above_150 += part.above_150;
  for (std::size_t i = 0; i < sum.histogram.size(); ++i) sum.histogram[i] += part.histogram[i];
  sum.area += part.area;
}

double angle_rounding(Point a, Point b, Point c, double largest_coordinate) {
  const double shortest = std::min({length(b - a), length(c - b), length(a - c)});
  const double spacing =
      std::nextafter(largest_coordinate, std::numeric_limits<double>::infinity()) -
      largest_coordinate;
  // Each of two corners moves by at most spacing / sqrt 2 against the third along either edge.
  return 4 * spacing / shortest;
}

bool holds_bound(std::span<const Point> points, std::span<const IndexTriple> triangles,
                 Angle nu_bound) {
  const double largest = largest_coordinate(points);
  return std::all_of(triangles.begin(), triangles.end(), [&](const IndexTriple& t) {
    const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
    const double nu = sort_angles(a, b, c).largest_nu;
    return nu >= nu_bound.in_radians() ||
           nu + angle_rounding(a, b, c, largest) >= nu_bound.in_radians();
  });
}

void set_limits(const AngleLimit& limit, RegionReport& report) {
  report.nu_opt = Angle::radians(limit.nu);
  report.nu_bound = Angle::radians(limit.promised_nu());
  report.forced_above_120 = limit.above_120;
  report.forced_above_150 = limit.above_150;
}

void measure(const RegionBoundary& boundary, RegionMesh& mesh) {
  const std::vector<Point> points = all_points(boundary, mesh);
  RegionReport& report = mesh.report;
  report.quality = measure_angles(points, mesh.triangles);
  report.box = measure_boxes(points, mesh.triangles, boundary.sides);
  report.input_vertices = boundary.points.size();
  report.steiner_vertices = mesh.steiner.size();
  report.bound_held =
      !mesh.triangles.empty() && (report.quality.largest_nu >= report.nu_bound ||
                                  holds_bound(points, mesh.triangles, report.nu_bound));
  if (!report.bound_held && !mesh.triangles.empty()) {
    report.notes.push_back(bound_missed(report, points, worst_triangle(points, mesh.triangles)));
  }
}

}  // namespace cover
