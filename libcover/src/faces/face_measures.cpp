// See face_measures.hpp.
#include "faces/face_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include <cover/ids.hpp>
#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "geom/predicates.hpp"
#include "geom/triangle.hpp"
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

/// For faces whose largest triangle does not hold its own rounded centroid: any triangle that does,
/// or an inner edge that holds its own rounded midpoint.
void search_inside(const Faces& faces, std::vector<bool>& wanted, std::vector<FaceMeasure>& out) {
  for (std::size_t t = 0; t < faces.of_triangle.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[t];
    if (!wanted[face]) continue;
    const auto [a, b, c] = corners(faces, t);
    const Point middle = centroid(a, b, c);
    if (is_strictly_inside(a, b, c, middle)) {
      out[face].inside = middle;
      wanted[face] = false;
    }
  }
  for (std::size_t t = 0; t < faces.of_triangle.size(); ++t) {
    const std::uint32_t face = faces.of_triangle[t];
    const Triangle& f = faces.triangulation.triangles[t];
    const auto c = corners(faces, t);
    for (const Corner i : kCorners) {
      if (!wanted[face]) break;
      const Point u = c[i.next()], v = c[i.previous()], m = midpoint(u, v);
      if (f.is_locked(i) || f.n[i] == kNone || m == u || m == v) continue;
      if (orientation(u, v, m) != Sign::zero) continue;
      out[face].inside = m;
      wanted[face] = false;
    }
  }
}

/// What some triangles tell of a face.
struct Measured {
  double largest = -1;  ///< twice the area of a triangle
  Point inside;         ///< its centroid, as rounded
  bool is_inside = false;
  bool has_triangles = false;
  std::pair<Point, Point> smallest_side{{kInfinity, kInfinity}, {}};

  /// Those of later triangles.
  void add(const Measured& later) {
    const std::pair smallest = std::min(smallest_side, later.smallest_side);
    const bool has_some = has_triangles || later.has_triangles;
    if (later.largest > largest) *this = later;
    smallest_side = smallest;
    has_triangles = has_some;
  }
};

/// Measures the triangles from `first` to before `last`; `add_area(t, twice its area)` for each.
template <class AddArea>
void measure_some(const Faces& faces, std::size_t first, std::size_t last,
                  std::vector<Measured>& of_face, const AddArea& add_area) {
  for (std::size_t t = first; t < last; ++t) {
    Measured& face = of_face[faces.of_triangle[t]];
    const Triangle& f = faces.triangulation.triangles[t];
    const auto c = corners(faces, t);
    const double area = doubled_area(c[0], c[1], c[2]);
    add_area(t, area);
    face.has_triangles = true;
    if (area > face.largest) {
      face.largest = area;
      face.inside = centroid(c[0], c[1], c[2]);
      face.is_inside = is_strictly_inside(c[0], c[1], c[2], face.inside);
    }
    for (const Corner i : kCorners) {
      if (!f.is_locked(i) && f.n[i] != kNone) continue;
      const std::pair side(c[i.next()], c[i.previous()]);
      face.smallest_side = std::min(face.smallest_side, side);
    }
  }
}

}  // namespace

std::vector<FaceMeasure> measure_faces(const Faces& faces, const Team& team) {
  constexpr std::size_t kFew = 64;
  const std::size_t triangles = faces.of_triangle.size();
  std::vector<Measured> measured(faces.count);
  std::vector<Sum> doubled(faces.count);
  if (team.workers() > 1 && faces.count <= kFew && triangles > kItemsAtATime) {
    std::vector<std::vector<Measured>> parts(Team::ranges(triangles, kItemsAtATime), measured);
    std::vector<double> areas(triangles);  // which are summed in their order
    team.each_range(triangles, kItemsAtATime, [&](std::size_t first, std::size_t last) {
      measure_some(faces, first, last, parts[first / kItemsAtATime],
                   [&](std::size_t t, double area) { areas[t] = area; });
    });
    for (const std::vector<Measured>& part : parts) {
      for (std::size_t f = 0; f < faces.count; ++f) measured[f].add(part[f]);
    }
    for (std::size_t t = 0; t < triangles; ++t) doubled[faces.of_triangle[t]].add(areas[t]);
  } else {
    measure_some(faces, 0, triangles, measured,
                 [&](std::size_t t, double area) { doubled[faces.of_triangle[t]].add(area); });
  }
  std::vector<FaceMeasure> out(faces.count);
  std::vector<bool> missing(faces.count);
  for (std::size_t f = 0; f < faces.count; ++f) {
    out[f].area = doubled[f].value() / 2;
    out[f].smallest_side = measured[f].smallest_side;
    out[f].inside = measured[f].inside;
    missing[f] = !measured[f].is_inside && measured[f].has_triangles;
    if (!measured[f].has_triangles) out[f].inside.reset();
  }
  if (std::find(missing.begin(), missing.end(), true) != missing.end())
    search_inside(faces, missing, out);
  for (std::size_t f = 0; f < faces.count; ++f) {
    if (missing[f]) out[f].inside.reset();
  }
  return out;
}

void warn_of_sliver(const std::string& what, const FaceMeasure& measure, std::vector<Note>& notes) {
  const Point at = measure.smallest_side.first;
  notes.push_back({Note::Kind::warning,
                   kVoid,
                   fmt::format("{} at {} is so thin that no double lies inside: a seed in a "
                               ".poly cannot name it",
                               what, describe(at)),
                   {at}});
}

}  // namespace cover
