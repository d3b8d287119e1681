// Sizes grow away from fine places and beside long sides, so the wished size alone says too much:
// the field that refinement follows is sampled in every triangle of the region's constrained
// Delaunay triangulation.
// Tested by tests/unit/sizes/expected_triangles_test.cpp.
#include "sizes/expected_triangles.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "cdt/cdt.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"
#include "region/triangulation_of.hpp"
#include "sizes/size_field.hpp"

namespace cover {
namespace {

/// OpenMesh numbers half-edges, three per triangle and those of the boundary, by int.
constexpr double kMostTriangles = std::numeric_limits<int>::max() / 3.0;
/// Fewer are not worth a closer look.
constexpr double kFew = 1e6;
/// Samples along the edge of a triangle; fewer where there are many triangles.
constexpr int kSamples = 4;
constexpr std::size_t kManyTriangles = 20'000;
/// What a sample stands for is looked at more closely if it takes more triangles: near the tip of a
/// cone of sizes, one sample says far too much.
constexpr double kMostInSample = 1e3;
constexpr int kDeepest = 20;

/// Measured: 153 at 261,192 triangles and 168 at 1,047,192 in one region.
constexpr double kBytesPerTriangle = 168;
/// While it is meshed. Measured: 50 at 245,066 triangles and 83 at 966,990.
constexpr double kBytesPerTriangleOfRegion = 84;
constexpr double kBytesPerSide = 400;  ///< of the input and its regions
constexpr double kBytesAtFirst = 3e7;  ///< of the program and its libraries
/// Estimates are a third too high at the most: see tests/unit/pipeline/estimate_test.cpp.
constexpr double kSurely = 2.0 / 3;

double triangles_in(double area, double size) {
  return area * 4 / (std::numbers::sqrt3 * size * size);
}

double area_of(const RegionBoundary& boundary) {
  const Point origin = boundary.points.front();
  double doubled = 0;
  for (const auto& [a, b] : boundary.sides)
    doubled += doubled_area(origin, boundary.points[a], boundary.points[b]);
  return doubled / 2;
}

/// The smallest size wished anywhere in the region, by its boundary; infinite if there is none.
double smallest_wish(const RegionBoundary& boundary) {
  double smallest = kInfinity;
  if (boundary.size > 0) smallest = boundary.size;
  for (const double size : boundary.size_at) {
    if (size > 0) smallest = std::min(smallest, size);
  }
  return smallest;
}

double shortest_side(const RegionBoundary& boundary) {
  double shortest = kInfinity;
  for (const auto& [a, b] : boundary.sides)
    shortest = std::min(shortest, length(boundary.points[b] - boundary.points[a]));
  return shortest;
}

/// The integral over the triangles of a region's constrained Delaunay triangulation.
class SampledRegion {
 public:
  SampledRegion(const RegionBoundary& boundary, const Options& options)
      : cdt_(triangulation_of(boundary)),
        sizes_(boundary, cdt_, options.growth, background_of(boundary, options)),
        will_be_cut_(options.split_interfaces),
        samples_(cdt_.triangles.size() > kManyTriangles ? 1 : kSamples) {}

  /// What the samples say.
  struct Sum {
    double triangles = 0;       ///< more than a mesh holds: at least as many
    double finest = kInfinity;  ///< size of all of them
    Point at{};
  };

  [[nodiscard]] Sum sum() const {
    Sum sum;
    if (!sizes_.is_active()) {
      sum.triangles = static_cast<double>(cdt_.triangles.size());
      return sum;
    }
    for (const Triangle& t : cdt_.triangles) {
      const Point a = cdt_.points[t.v[0]];
      add(t, {a, cdt_.points[t.v[1]] - a, cdt_.points[t.v[2]] - a}, samples_, 0, sum);
      if (sum.triangles > kMostTriangles) break;
    }
    return sum;
  }

 private:
  /// A part of a triangle: a corner and the edges from there.
  struct Part {
    Point a;
    Vector u, v;
  };

  /// Adds what `part` of `t` takes, cut by parallels to its edges into as many parts as `samples`
  /// squared; its size is that in the middle.
  void add(const Triangle& t, const Part& part, int samples, int depth, Sum& sum) const {
    const double step = 1.0 / samples;
    const auto at = [&](double i, double j) {
      return part.a + i * step * part.u + j * step * part.v;
    };
    const auto add_one = [&](const Part& small) {
      const Point middle = small.a + 1.0 / 3 * (small.u + small.v);
      const double size = size_in(t, middle);
      if (size < sum.finest) sum.finest = size, sum.at = middle;
      const double here = triangles_in(cross(small.u, small.v) / 2, size);
      if (here <= kMostInSample || depth == kDeepest) {
        sum.triangles += here;
      } else if (sum.triangles <= kMostTriangles) {
        add(t, small, 2, depth + 1, sum);
      }
    };
    const Vector u = step * part.u, v = step * part.v;
    for (int i = 0; i < samples; ++i) {
      for (int j = 0; i + j < samples; ++j) {
        add_one({at(i, j), u, v});
        if (i + j + 1 < samples) add_one({at(i + 1, j + 1), -1.0 * u, -1.0 * v});
      }
    }
  }

  /// The size that refinement aims at in a place inside a triangle.
  [[nodiscard]] double size_in(const Triangle& t, Point p) const {
    double wished = sizes_.largest_at(p), least = 0;
    for (const std::uint32_t v : t.v) {
      const double distance = length(p - cdt_.points[v]);
      wished = std::min(wished, sizes_.near(v, distance));
      least = std::max(least, sizes_.least_near(v, distance));
    }
    return will_be_cut_ ? wished : std::max(wished, least);
  }

  Triangulation cdt_;
  SizeField sizes_;
  bool will_be_cut_;  ///< long sides: then they do not enlarge the triangles beside them
  int samples_;
};

}  // namespace

double memory_for(double triangles, std::size_t sides) {
  return kBytesAtFirst + kBytesPerTriangle * triangles + kBytesPerSide * static_cast<double>(sides);
}

double most_triangles(const RegionBoundary& boundary) {
  return triangles_in(area_of(boundary), smallest_wish(boundary));
}

double expected_triangles(const RegionBoundary& boundary, const Options& options) {
  double most = most_triangles(boundary);
  if (options.growth)
    most = std::max(most, triangles_in(area_of(boundary), shortest_side(boundary)));
  if (!options.size_field && !boundary.size_function && !(most > kFew)) return most;
  return SampledRegion(boundary, options).sum().triangles;
}

double about_triangles(const RegionBoundary& boundary, const Options& options) {
  // 1.5 to 1.7 in maps and devices.
  constexpr double kTrianglesPerSide = 1.6;
  const double by_sizes =
      options.method == Method::quality ? SampledRegion(boundary, options).sum().triangles : 0;
  return std::max(by_sizes, kTrianglesPerSide * static_cast<double>(boundary.sides.size()));
}

Status check_expected_triangles(const RegionTable& table,
                                std::span<const RegionBoundary> boundaries, const Options& options,
                                Held held, double memory) {
  if (options.method != Method::quality) return ok();
  double all = 0, most = 0;
  std::size_t sides = 0;
  const RegionBoundary* worst = nullptr;
  for (const RegionBoundary& boundary : boundaries) {
    const double expected = expected_triangles(boundary, options);
    all += expected;
    sides += boundary.sides.size();
    if (expected <= most) continue;
    most = expected;
    worst = &boundary;
  }
  const auto where = [&] {
    const SampledRegion::Sum sum = SampledRegion(*worst, options).sum();
    return fmt::format("most of them in region {} '{}', where edges of {} are asked for at {}",
                       worst->id.value(), table.region(worst->id).name,
                       describe_roughly(sum.finest), describe(sum.at));
  };
  if (all <= kMostTriangles) {
    const double bytes = held == Held::all ? memory_for(all, sides)
                                           : kBytesAtFirst + kBytesPerTriangleOfRegion * most;
    if (worst == nullptr || kSurely * bytes <= memory) return ok();
    return Error{ErrorCode::out_of_memory,
                 fmt::format("the sizes asked for take about {:.2g} triangles and {:.3g} GB of "
                             "memory{}, and there are {:.3g}; {}",
                             all, bytes / kGigabyte,
                             held == Held::all ? "" : " in their largest region alone",
                             memory / kGigabyte, where()),
                 {},
                 {}};
  }
  return Error{
      ErrorCode::bad_option,
      fmt::format("the sizes asked for take more triangles than a mesh can hold, {:.2g}; {}",
                  kMostTriangles, where()),
      {},
      {}};
}

}  // namespace cover
