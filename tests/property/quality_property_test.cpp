// In no region is the quality method worse than the plain constrained Delaunay triangulation or the
// almond method, unless it meets the region's target: the largest angle asked for, or the least
// possible one.
#include <cover/cover_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "cdt/cdt.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

using testing::must_mesh;

constexpr double kRounding = 1e-7;  ///< degrees

struct Kind {
  const char* name;
  Input (*make)(std::uint64_t seed);
};
std::ostream& operator<<(std::ostream& out, const Kind& kind) { return out << kind.name; }

const Kind kKinds[] = {
    {"cells", [](std::uint64_t seed) { return testing::random_cells(24, seed); }},
    {"stars", [](std::uint64_t seed) { return testing::nested_stars(4, 17, seed); }},
    {"rectangles", [](std::uint64_t seed) { return testing::rectangles(6, 5, seed); }},
    {"checker", [](std::uint64_t seed) { return testing::checker(4, 5, seed); }},
};

double largest_angle_of_cdt(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  double largest = 0;
  for (const Triangle& t : cdt.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      largest = std::max(largest, angle_at(cdt.points[t.v[(i + 1) % 3]], cdt.points[t.v[i]],
                                           cdt.points[t.v[(i + 2) % 3]]));
    }
  }
  return Angle::radians(largest).in_degrees();
}

double largest_angle(const RegionReport& report) {
  return report.quality.largest_nu.supplement().in_degrees();
}

class Quality : public ::testing::TestWithParam<std::tuple<Kind, double>> {};

TEST_P(Quality, WithTheLargestAngleFirstIsNoWorseThanThePlainMethods) {
  const auto& [kind, max_angle] = GetParam();
  const std::uint64_t first = testing::test_seed(77);
  for (std::uint64_t seed = first; seed < first + 4; ++seed) {
    SCOPED_TRACE(testing::seed_trace(seed));
    const Input input = kind.make(seed);
    Options options;
    options.max_angle = Angle::degrees(max_angle);
    options.prefer = Prefer::largest;
    const Output quality = must_mesh(input, options);
    options.method = Method::almond;
    const Output almond = must_mesh(input, options);
    const auto boundaries = split_regions(quality.pslg, quality.table);
    ASSERT_EQ(boundaries.size(), quality.report.regions.size());
    for (const RegionBoundary& boundary : boundaries) {
      const std::size_t r = place_of(boundary.id);
      const RegionReport& report = quality.report.regions[r];
      const double target = std::max(max_angle, report.nu_opt.supplement().in_degrees());
      const double plain =
          std::min(largest_angle_of_cdt(boundary), largest_angle(almond.report.regions[r]));
      EXPECT_LE(largest_angle(report), std::max(target, plain) + kRounding)
          << "region " << boundary.id.value() << ", " << report.method;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Random, Quality,
                         ::testing::Combine(::testing::ValuesIn(kKinds),
                                            ::testing::Values(100.0, 90.0)),
                         [](const auto& at) {
                           return std::string(std::get<0>(at.param).name) + "_" +
                                  std::to_string(static_cast<int>(std::get<1>(at.param)));
                         });

}  // namespace
}  // namespace cover
