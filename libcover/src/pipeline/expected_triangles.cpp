// Sizes grow away from fine places and beside long sides, so the wished size alone says too much:
// the field that refinement follows is sampled in every triangle of the region's constrained
// Delaunay triangulation. Tested by tests/unit/pipeline/expected_triangles_test.cpp.
#include "pipeline/expected_triangles.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "cdt/cdt.hpp"
#include "geom/vector.hpp"
#include "quality/size_field.hpp"

namespace cover {
namespace {

/// OpenMesh numbers half-edges, three per triangle and those of the boundary, by int.
constexpr double kMostTriangles = std::numeric_limits<int>::max() / 3.0;
/// Fewer are not worth a closer look.
constexpr double kFew = 1e6;
/// Samples along the edge of a triangle.
constexpr int kSamples = 4;

double triangles_in(double area, double size) {
  return area * 4 / (std::numbers::sqrt3 * size * size);
}

double area_of(const RegionBoundary& boundary) {
  const Point origin = boundary.points.front();
  double doubled_area = 0;
  for (const auto& [a, b] : boundary.sides) {
    doubled_area += cross(boundary.points[a] - origin, boundary.points[b] - origin);
  }
  return doubled_area / 2;
}

/// The smallest size wished anywhere in the region; infinite if there is none.
double smallest_wish(const RegionBoundary& boundary) {
  double smallest = std::numeric_limits<double>::infinity();
  if (boundary.size > 0) smallest = boundary.size;
  for (const double size : boundary.size_at) {
    if (size > 0) smallest = std::min(smallest, size);
  }
  return smallest;
}

/// The size that refinement aims at in a place inside a triangle.
double size_in(const SizeField& sizes, const Triangulation& cdt, const Triangle& t, Point p) {
  double wished = std::numeric_limits<double>::infinity(), least = 0;
  for (const std::uint32_t v : t.v) {
    const double distance = length(p - cdt.points[v]);
    wished = std::min(wished, sizes.near(v, distance));
    least = std::max(least, sizes.least_near(v, distance));
  }
  return std::max(wished, least);
}

}  // namespace

double most_triangles(const RegionBoundary& boundary) {
  return triangles_in(area_of(boundary), smallest_wish(boundary));
}

double expected_triangles(const RegionBoundary& boundary, const Options& options) {
  const double most = most_triangles(boundary);
  if (!(most > kFew)) return most;
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const SizeField sizes(boundary, cdt, options.growth);
  if (!sizes.is_active()) return static_cast<double>(cdt.triangles.size());
  double count = 0;
  for (const Triangle& t : cdt.triangles) {
    const Point a = cdt.points[t.v[0]];
    const Vector u = cdt.points[t.v[1]] - a, v = cdt.points[t.v[2]] - a;
    const double area = cross(u, v) / 2 / (kSamples * kSamples);
    // The centres of the triangles into which parallels to the edges cut it.
    const auto add = [&](double i, double j) {
      const Point p = a + i / kSamples * u + j / kSamples * v;
      count += triangles_in(area, size_in(sizes, cdt, t, p));
    };
    for (int i = 0; i < kSamples; ++i) {
      for (int j = 0; i + j < kSamples; ++j) {
        add(i + 1.0 / 3, j + 1.0 / 3);
        if (i + j + 1 < kSamples) add(i + 2.0 / 3, j + 2.0 / 3);
      }
    }
  }
  return count;
}

Status check_expected_triangles(const RegionTable& table,
                                std::span<const RegionBoundary> boundaries,
                                const Options& options) {
  if (options.method != Method::quality) return ok();
  double all = 0, most = 0;
  const Region* worst = nullptr;
  for (const RegionBoundary& boundary : boundaries) {
    const double expected = expected_triangles(boundary, options);
    all += expected;
    if (expected <= most) continue;
    most = expected;
    worst = &table.region(boundary.id);
  }
  if (all <= kMostTriangles) return ok();
  return Error{
      ErrorCode::bad_option,
      fmt::format("the sizes asked for take about {:.2g} triangles, most of them in region "
                  "{} '{}'; a mesh holds up to {:.2g}",
                  all, worst->id.value(), worst->name, kMostTriangles),
      {},
      {}};
}

}  // namespace cover
