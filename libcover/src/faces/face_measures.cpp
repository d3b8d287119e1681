// Tested by tests/unit/region/region_graph_test.cpp.
#include "faces/face_measures.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Neumaier's compensated sum: the error does not grow with the number of terms.
class Sum {
 public:
  void add(double x) {
    const double t = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - t) + x : (x - t) + sum_;
    sum_ = t;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

std::array<Point, 3> corners(const Faces& faces, std::size_t t) {
  const Triangle& f = faces.triangulation.triangles[t];
  const auto& p = faces.triangulation.points;
  return {p[f.v[0]], p[f.v[1]], p[f.v[2]]};
}

Point centroid(const std::array<Point, 3>& c) {
  return c[0] + (1.0 / 3) * ((c[1] - c[0]) + (c[2] - c[0]));
}

bool strictly_inside(const std::array<Point, 3>& c, Point p) {
  return orientation(c[0], c[1], p) == Sign::positive &&
         orientation(c[1], c[2], p) == Sign::positive &&
         orientation(c[2], c[0], p) == Sign::positive;
}

/// For faces whose largest triangle does not hold its own rounded centroid: any triangle that does,
/// or an inner edge that holds its own rounded midpoint.
void search_inside(const Faces& faces, std::vector<bool>& wanted, std::vector<FaceMeasure>& out) {
  for (std::size_t t = 0; t < faces.of_triangle.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[t];
    if (!wanted[face]) continue;
    const auto c = corners(faces, t);
    if (strictly_inside(c, centroid(c))) {
      out[face].inside = centroid(c);
      wanted[face] = false;
    }
  }
  for (std::size_t t = 0; t < faces.of_triangle.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[t];
    const Triangle& f = faces.triangulation.triangles[t];
    const auto c = corners(faces, t);
    for (std::size_t i = 0; i < 3 && wanted[face]; ++i) {
      const Point u = c[(i + 1) % 3], v = c[(i + 2) % 3], m = midpoint(u, v);
      if (f.is_locked(static_cast<int>(i)) || f.n[i] == kNone || m == u || m == v) continue;
      if (orientation(u, v, m) != Sign::zero) continue;
      out[face].inside = m;
      wanted[face] = false;
    }
  }
}

}  // namespace

std::vector<FaceMeasure> measure_faces(const Faces& faces) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<FaceMeasure> out(faces.count);
  for (FaceMeasure& m : out) m.smallest_side.first = {kInfinity, kInfinity};
  std::vector<Sum> doubled(faces.count);
  std::vector<double> largest(faces.count, -1);
  std::vector<bool> missing(faces.count, true);
  for (std::size_t t = 0; t < faces.of_triangle.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[t];
    const Triangle& f = faces.triangulation.triangles[t];
    const auto c = corners(faces, t);
    const double area = cross(c[1] - c[0], c[2] - c[0]);
    doubled[face].add(area);
    if (area > largest[face]) {
      largest[face] = area;
      out[face].inside = centroid(c);
      missing[face] = !strictly_inside(c, centroid(c));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!f.is_locked(static_cast<int>(i)) && f.n[i] != kNone) continue;
      const std::pair side(c[(i + 1) % 3], c[(i + 2) % 3]);
      out[face].smallest_side = std::min(out[face].smallest_side, side);
    }
  }
  for (std::size_t f = 0; f < faces.count; ++f) out[f].area = doubled[f].value() / 2;
  search_inside(faces, missing, out);
  for (std::size_t f = 0; f < faces.count; ++f) {
    if (missing[f]) out[f].inside.reset();
  }
  return out;
}

}  // namespace cover
