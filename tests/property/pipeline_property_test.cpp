// What must hold of the whole pipeline on any input, tried on random ones with many regions:
// its promises; a region meshed alone as inside the whole; the same mesh, ids aside, for any order
// of points, segments and seeds; the same for any unit, and after shifts that are exact; the same
// bytes for any number of threads. And its promises again on graphs without any shape.
#include <cover/cover_mesh.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

using testing::must_mesh;
using testing::shape_of;

struct Way {
  const char* name;
  cover::Method method;
  Fill fill;
};

const Way kWays[] = {
    {"refine", cover::Method::almond, Fill::refine},
    {"disks", cover::Method::almond, Fill::disks},
    {"quality", cover::Method::quality, Fill::refine},
};

class Pipeline : public ::testing::TestWithParam<std::tuple<testing::RandomInput, Way>> {
 protected:
  static constexpr std::uint64_t kInputs = 3;

  /// Runs `check` on some inputs of the kind under test.
  template <class Check>
  void on_inputs(Check check) const {
    const std::uint64_t first = testing::test_seed(2024);
    for (std::uint64_t seed = first; seed < first + kInputs; ++seed) {
      SCOPED_TRACE(testing::seed_trace(seed));
      check(std::get<0>(GetParam()).make(seed));
    }
  }

  [[nodiscard]] static Options options(unsigned threads = 2) {
    Options options;
    options.method = std::get<1>(GetParam()).method;
    options.fill = std::get<1>(GetParam()).fill;
    options.threads = threads;
    return options;
  }

  static TriangleSoup soup_of(const Input& input, unsigned threads = 2) {
    return triangle_soup(must_mesh(input, options(threads)).mesh);
  }
};

TEST_P(Pipeline, KeepsItsPromises) {
  on_inputs([](const Input& input) {
    const Output output = must_mesh(input, options());
    EXPECT_EQ(testing::violations(output), "");
    for (const Region& region : output.table.regions) {
      const double area = output.report.regions[place_of(region.id)].quality.area;
      EXPECT_NEAR(area, region.area, 1e-12 * region.area);
    }
    // Euler's formula, for domains without holes.
    const TriMesh& mesh = output.mesh.tri();
    std::size_t on_outline = 0;
    for (const auto e : mesh.edges()) on_outline += mesh.is_boundary(e);
    EXPECT_EQ(2 * mesh.n_edges(), 3 * mesh.n_faces() + on_outline);
  });
}

TEST_P(Pipeline, MeshesARegionAloneAsInsideTheWhole) {
  on_inputs([](const Input& input) {
    const Output output = must_mesh(input, options());
    const TriangleSoup soup = triangle_soup(output.mesh);
    for (std::size_t r = 0; r < output.table.regions.size(); r += 3) {
      const RegionId id = output.table.regions[r].id;
      EXPECT_EQ(shape_of(soup_of(testing::region_alone(output, id))),
                shape_of(testing::part_of(soup, id)))
          << "region " << id.value();
    }
  });
}

TEST_P(Pipeline, DoesNotDependOnTheOrderOfTheInput) {
  on_inputs([](const Input& input) {
    const auto shape = shape_of(soup_of(input));
    for (const std::uint64_t seed : {5U, 6U})
      EXPECT_EQ(shape_of(soup_of(testing::shuffled(input, seed))), shape);
  });
}

TEST_P(Pipeline, DoesNotDependOnTheUnit) {
  on_inputs([](const Input& input) {
    const TriangleSoup plain = soup_of(input);
    for (const double factor : {0x1p30, 0x1p-30, 0x1p60, 0x1p-60}) {
      const TriangleSoup scaled = soup_of(testing::transformed(input, factor));
      ASSERT_EQ(scaled.triangles, plain.triangles) << factor;
      for (std::size_t v = 0; v < plain.points.size(); ++v) {
        ASSERT_EQ(scaled.points[v],
                  (Point{plain.points[v].x * factor, plain.points[v].y * factor}));
      }
    }
  });
}

TEST_P(Pipeline, KeepsItsConnectivityAfterAnExactShift) {
  on_inputs([](Input input) {
    const auto rounded = [](double x) { return std::round(x * 0x1p24) / 0x1p24; };
    for (Point& p : input.points) p = {rounded(p.x), rounded(p.y)};
    const TriangleSoup here = soup_of(input);
    const TriangleSoup there = soup_of(testing::transformed(input, 1, {1024, -4096}));
    EXPECT_EQ(there.triangles, here.triangles);
  });
}

TEST_P(Pipeline, DoesNotDependOnTheNumberOfThreads) {
  on_inputs([](const Input& input) {
    const TriangleSoup one = soup_of(input, 1);
    for (const unsigned threads : {2U, 8U}) {
      const TriangleSoup more = soup_of(input, threads);
      EXPECT_EQ(more.points, one.points);
      EXPECT_EQ(more.triangles, one.triangles);
      EXPECT_EQ(more.region, one.region);
      EXPECT_EQ(more.material, one.material);
    }
  });
}

/// Promises 1 to 3 on anything: COVER_LONG_GRAPHS says how many graphs, 40 by default.
TEST(PlanarGraph, KeepsItsPromisesByEveryMethod) {
  const std::uint64_t first = testing::test_seed(77);
  const std::uint64_t graphs = testing::cases_asked_for("COVER_LONG_GRAPHS", 40);
  std::size_t meshed = 0;
  for (std::uint64_t seed = first; seed < first + graphs; ++seed) {
    SCOPED_TRACE(testing::seed_trace(seed));
    const int sizes[] = {6, 15, 40, 120};
    const Input input = testing::planar_graph(sizes[seed % 4], seed);
    for (int which = 0; which < 4; ++which) {
      Options options;
      options.method = which == 0 ? cover::Method::quality : cover::Method::almond;
      options.paper = which == 2;
      options.fill = which == 3 ? Fill::disks : Fill::refine;
      const Result<Output> output = cover_mesh(input, options);
      if (!output) {
        EXPECT_EQ(output.error().code, ErrorCode::nothing_enclosed) << output.error().message;
        break;
      }
      ++meshed;
      EXPECT_EQ(testing::violations(*output), "") << "method " << which;
      for (const RegionReport& region : output->report.regions) {
        EXPECT_TRUE(region.bound_held) << "method " << which << ", region " << region.id.value();
      }
    }
  }
  EXPECT_GT(meshed, graphs);
}

INSTANTIATE_TEST_SUITE_P(Random, Pipeline,
                         ::testing::Combine(::testing::ValuesIn(testing::kRandomDevices),
                                            ::testing::ValuesIn(kWays)),
                         [](const auto& sample) {
                           return std::string(std::get<0>(sample.param).name) + "_" +
                                  std::get<1>(sample.param).name;
                         });

}  // namespace
}  // namespace cover
