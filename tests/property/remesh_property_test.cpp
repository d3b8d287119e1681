// What must hold where regions are meshed again inside a mesh, on random devices: with the same
// options the same mesh; with any others the triangles of all other regions bit for bit, and every
// promise; nothing that nobody uses is left.
#include <cover/remesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/core.h>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

using testing::must_mesh;

/// The corners of every triangle of the regions that are not `again`, in order.
std::vector<std::array<Point, 3>> rest_of(const TriangleSoup& soup,
                                          const std::vector<bool>& again) {
  std::vector<std::array<Point, 3>> list;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (again[static_cast<std::size_t>(soup.region[t]) - 1]) continue;
    const auto& [a, b, c] = soup.triangles[t];
    list.push_back({soup.points[a], soup.points[b], soup.points[c]});
  }
  return list;
}

class Remeshing : public ::testing::TestWithParam<testing::RandomInput> {
 protected:
  static constexpr std::uint64_t kInputs = 3;

  static Options random_options(std::mt19937_64& random, const RegionTable& table) {
    Options options;
    options.threads = 2;
    if (random() % 3 == 0) options.method = Method::almond;
    if (random() % 3 == 0) options.fill = Fill::disks;
    options.max_angle = Angle::degrees(90 + static_cast<double>(random() % 40));
    if (random() % 2 == 0) {
      double area = 0;
      for (const Region& region : table.regions) area += region.area;
      options.sizes = {{"", std::sqrt(area) / 40, false}};
    }
    return options;
  }

  /// Runs `check` on some inputs; the generator's random lines may leave two seeds in one face.
  template <class Check>
  static void on_inputs(std::uint64_t fallback, Check check) {
    const std::uint64_t first = testing::test_seed(fallback);
    for (std::uint64_t seed = first; seed < first + kInputs; ++seed) {
      SCOPED_TRACE(testing::seed_trace(seed));
      std::mt19937_64 random(seed);
      const Input input = GetParam().make(seed);
      const Result<Prepared> prepared = prepare(input);
      if (prepared) {
        check(input, prepared->table, random);
      } else {
        EXPECT_EQ(prepared.error().code, ErrorCode::conflicting_seeds);
      }
    }
  }

  /// The names of some regions, one at least; `again` by RegionId - 1.
  static std::vector<std::string> choose(std::mt19937_64& random, std::vector<bool>& again) {
    std::vector<std::string> only;
    again[random() % again.size()] = true;
    for (std::size_t r = 0; r < again.size(); ++r) {
      if (random() % 3 == 0) again[r] = true;
      if (again[r]) only.push_back(fmt::format("region:{}", r + 1));
    }
    return only;
  }

  static void expect_untouched(const Input& input, const Output& before, bool is_cut,
                               std::mt19937_64& random) {
    std::vector<bool> again(before.table.regions.size(), false);
    const auto only = choose(random, again);
    const Options options = random_options(random, before.table);
    const Result<Output> after = remesh(input, triangle_soup(before.mesh), only, options);
    ASSERT_TRUE(after) << after.error().message;
    EXPECT_EQ(testing::violations(*after), "");
    const TriangleSoup old = triangle_soup(before.mesh), now = triangle_soup(after->mesh);
    EXPECT_EQ(rest_of(now, again), rest_of(old, again));
    EXPECT_EQ(after->report.replaced.size(), only.size());
    const TriMesh& mesh = before.mesh.tri();
    for (const auto v : mesh.vertices()) {
      if (before.mesh.input_id(v) < 0) break;  // Steiner vertices are the last
      ASSERT_EQ(now.points[std::size_t(v.idx())], old.points[std::size_t(v.idx())]);
    }
    std::vector<bool> used(now.points.size(), false);
    for (const auto& triangle : now.triangles)
      for (const std::uint32_t v : triangle) used[v] = true;
    EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
    if (is_cut) return;
    // The regions meshed again are what the whole gets with these options.
    const TriangleSoup whole = triangle_soup(must_mesh(input, options).mesh);
    for (auto region : {RegionId{1}, RegionId{again.size()}}) {
      if (!again[place_of(region)]) continue;
      EXPECT_EQ(testing::shape_of(testing::part_of(now, region)),
                testing::shape_of(testing::part_of(whole, region)));
    }
  }
};

TEST_P(Remeshing, TouchesTheNamedRegionsOnly) {
  on_inputs(2025, [](const Input& input, const RegionTable&, std::mt19937_64& random) {
    expect_untouched(input, must_mesh(input), false, random);
    Options cutting;
    cutting.split_interfaces = Angle::degrees(100);
    cutting.method = Method::almond;
    expect_untouched(input, must_mesh(input, cutting), true, random);
  });
}

TEST_P(Remeshing, WithTheSameOptionsGivesTheSameMesh) {
  on_inputs(2026, [](const Input& input, const RegionTable& table, std::mt19937_64& random) {
    const Options options = random_options(random, table);
    const Output before = must_mesh(input, options);
    std::vector<bool> again(table.regions.size(), false);
    const Result<Output> after =
        remesh(input, triangle_soup(before.mesh), choose(random, again), options);
    ASSERT_TRUE(after) << after.error().message;
    const TriangleSoup old = triangle_soup(before.mesh), now = triangle_soup(after->mesh);
    EXPECT_EQ(now.points, old.points);
    EXPECT_EQ(now.triangles, old.triangles);
    EXPECT_EQ(now.region, old.region);
    EXPECT_EQ(now.material, old.material);
  });
}

INSTANTIATE_TEST_SUITE_P(Random, Remeshing, ::testing::ValuesIn(testing::kRandomDevices),
                         [](const auto& sample) { return sample.param.name; });

}  // namespace
}  // namespace cover
