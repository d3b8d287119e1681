// What parts of a mesh show is what the whole shows; what they cannot show they leave to it.
#include <cover/check_in_parts.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/mesh.hpp>
#include <cover/write_mesh.hpp>

#include "cdt/triangulation.hpp"
#include "io/vtk_files/mapped_triangles.hpp"
#include "mesh/mesh_builder.hpp"
#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

constexpr std::size_t kAFew = 40;  // triangles at a time

struct Case {
  Prepared prepared;
  Output output;
};

Case meshed(const Input& input) {
  Options options;
  options.threads = 2;
  Result<Prepared> prepared = prepare(input, options);
  Result<Output> output = cover_mesh(input, options);
  EXPECT_TRUE(prepared && output);
  return {*std::move(prepared), *std::move(output)};
}

std::string read(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(CheckInParts, FindsWhatTheWholeFinds) {
  const testing::TemporaryFolder folder;
  for (const testing::RandomInput& device : testing::kRandomDevices) {
    const Case mesh = meshed(device.make(11));
    const Verification whole =
        verify_cover(mesh.prepared.pslg, mesh.prepared.table, triangle_soup(mesh.output.mesh));
    ASSERT_EQ(whole.violation_count, 0U);
    for (const char* name : {"x.vtu", "x.vtkhdf"}) {
      for (const std::size_t few : {std::size_t{1}, kAFew, std::size_t{1000000}}) {
        SCOPED_TRACE(::testing::Message() << device.name << ' ' << name << ' ' << few);
        const std::string path = folder.path() / name;
        ASSERT_TRUE(write_mesh(mesh.output, path));
        Options options;
        options.threads = 2;
        const auto parts = check_in_parts(mesh.prepared, path, {}, options, few);
        ASSERT_TRUE(parts);
        EXPECT_EQ(parts->triangles, mesh.output.mesh.triangles());
        EXPECT_EQ(parts->found.regions, whole.regions);
        EXPECT_EQ(parts->found.segments_whole, whole.segments_whole);
        EXPECT_EQ(parts->found.within_rounding, whole.within_rounding);
        EXPECT_EQ(parts->found.unchecked, whole.unchecked);
        ASSERT_EQ(parts->found.limits.size(), whole.limits.size());
        for (std::size_t r = 0; r < whole.limits.size(); ++r) {
          EXPECT_EQ(parts->found.limits[r].largest_nu, whole.limits[r].largest_nu);
          EXPECT_EQ(parts->found.limits[r].smallest, whole.limits[r].smallest);
        }
      }
    }
  }
}

TEST(CheckInParts, DividesALargePartAmongThreads) {
  const testing::TemporaryFolder folder;
  const Case mesh = meshed(testing::checker(40, 12, 1));
  const std::string path = folder.path() / "x.vtu";
  ASSERT_TRUE(write_mesh(mesh.output, path));
  for (const unsigned threads : {1U, 3U}) {
    Options options;
    options.threads = threads;
    const auto found = check_in_parts(mesh.prepared, path, {}, options, 10'000'000);
    ASSERT_TRUE(found.has_value());
    EXPECT_GT(found->triangles, 70'000U);
    EXPECT_EQ(found->found.regions, mesh.prepared.table.regions.size());
    EXPECT_EQ(found->found.segments_whole, mesh.prepared.pslg.segments.size());
  }
}

TEST(CheckInParts, HoldsOnAwkwardGraphs) {
  const testing::TemporaryFolder folder;
  std::size_t held = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const Input input = testing::planar_graph(60, seed);
    const Result<Output> output = cover_mesh(input);
    const Result<Prepared> prepared = prepare(input);
    if (!output || !prepared) continue;
    const std::string path = folder.path() / "x.vtkhdf";
    ASSERT_TRUE(write_mesh(*output, path));
    const Verification whole =
        verify_cover(prepared->pslg, prepared->table, triangle_soup(output->mesh));
    const auto parts = check_in_parts(*prepared, path, {}, {}, kAFew);
    EXPECT_EQ(parts.has_value(), whole.violation_count == 0);
    if (!parts) continue;
    ++held;
    EXPECT_EQ(parts->found.regions, whole.regions);
    EXPECT_EQ(parts->found.segments_whole, whole.segments_whole);
  }
  EXPECT_GT(held, 5U);
}

/// A number anywhere in the arrays of corners, places, regions or materials changed: nothing that
/// the whole refuses is let pass.
TEST(CheckInParts, LetsNothingPassThatTheWholeRefuses) {
  const testing::TemporaryFolder folder;
  const Case mesh = meshed(testing::checker(4, 3, 2));
  const std::string path = folder.path() / "x.vtkhdf";
  ASSERT_TRUE(write_mesh(mesh.output, path));
  const std::string good = read(path);
  const auto place_of = [&](const auto& numbers, std::size_t k) {
    const auto value = numbers[k];
    // The view does not tell where it lies; its neighbours do.
    constexpr std::size_t kEnough = 9;
    std::string bytes(sizeof value * kEnough, ' ');
    for (std::size_t i = 0; i < kEnough; ++i) {
      const auto next = numbers[k + i];
      std::memcpy(bytes.data() + i * sizeof value, &next, sizeof value);
    }
    return good.find(bytes);
  };
  const auto mapped = map_triangles(path);
  ASSERT_TRUE(mapped);
  std::size_t refused = 0;
  const auto damage = [&](std::size_t at, const void* value, std::size_t size) {
    ASSERT_NE(at, std::string::npos);
    std::string bad = good;
    std::memcpy(bad.data() + at, value, size);
    const std::string other = folder.path() / "y.vtkhdf";
    std::ofstream(other, std::ios::binary) << bad;
    ++refused;
    EXPECT_FALSE(check_in_parts(mesh.prepared, other, {}, {}, kAFew)) << at;
  };
  for (std::size_t k = 0; k + 9 < 3 * mapped->triangles; k += 31) {
    const std::int64_t other = mapped->corners[k] == 0 ? 1 : mapped->corners[k] - 1, none = -1;
    damage(place_of(mapped->corners, k), &other, sizeof other);
    damage(place_of(mapped->corners, k), &none, sizeof none);
  }
  for (std::size_t p = 0; p + 3 < mapped->points; p += 7) {
    const double moved = mapped->places[3 * p] + 0.5;
    damage(place_of(mapped->places, 3 * p), &moved, sizeof moved);
  }
  EXPECT_GT(refused, 50U);
}

/// Two vertices at one point of the input, each for the regions of other parts: each part alone is
/// sound.
TEST(CheckInParts, SeesThatPartsDoNotShareAVertex) {
  const testing::TemporaryFolder folder;
  Case mesh = meshed(testing::checker(2, 1, 2));
  TriangleSoup soup = triangle_soup(mesh.output.mesh);
  std::vector<IndexTriple> triangles(soup.triangles.begin(), soup.triangles.end());
  const auto last = soup.region.back();
  std::uint32_t shared = kNone;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t v : triangles[t]) {
      if (soup.region[t] == last && soup.points[v] == Point{0.5, 0.5}) shared = v;
    }
  }
  ASSERT_NE(shared, kNone);
  const auto copy = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back(soup.points[shared]);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (soup.region[t] == last)
      std::replace(triangles[t].begin(), triangles[t].end(), shared, copy);
  Output split = std::move(mesh.output);
  split.mesh = MeshBuilder(soup.points, triangles).build();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const TriMesh::FaceHandle face(static_cast<int>(t));
    split.mesh.set_region(face, RegionId{static_cast<std::size_t>(soup.region[t])});
    split.mesh.set_material(face, static_cast<int>(soup.material[t]));
  }
  ASSERT_TRUE(write_mesh(split, folder.path() / "x.vtu"));
  EXPECT_GT(verify_cover(mesh.prepared.pslg, mesh.prepared.table, triangle_soup(split.mesh))
                .violation_count,
            0U);
  EXPECT_FALSE(check_in_parts(mesh.prepared, folder.path() / "x.vtu", {}, {}, 1));
}

TEST(CheckInParts, LeavesOtherFilesToTheWhole) {
  const testing::TemporaryFolder folder;
  const Case mesh = meshed(testing::checker(2, 2, 1));
  for (const auto& [name, order] : {std::pair{"x.vtu", 2}, {"x.msh", 1}, {"x.vtm", 1}}) {
    const std::string path = folder.path() / name;
    ASSERT_TRUE(write_mesh(mesh.output, path, WriteOptions{.order = order}));
    EXPECT_FALSE(check_in_parts(mesh.prepared, path, {})) << name;
  }
  EXPECT_FALSE(check_in_parts(mesh.prepared, folder.path() / "none.vtu", {}));
  // One point beside the plane of the others.
  const auto& tri = mesh.output.mesh.tri();
  const auto last = tri.point(tri.vertex_handle(static_cast<unsigned>(tri.n_vertices() - 1)));
  const auto bytes_of = [&](double z) {
    const std::array<double, 3> place{last[0], last[1], z};
    return std::string(reinterpret_cast<const char*>(place.data()), sizeof place);
  };
  for (const char* name : {"plane.vtu", "plane.vtkhdf"}) {
    ASSERT_TRUE(write_mesh(mesh.output, folder.path() / name));
    EXPECT_TRUE(check_in_parts(mesh.prepared, folder.path() / name, {})) << name;
    std::string text = read(folder.path() / name);
    const std::size_t at = text.find(bytes_of(0));
    ASSERT_NE(at, std::string::npos);
    std::ofstream(folder.path() / name, std::ios::binary)
        << text.replace(at, sizeof(double) * 3, bytes_of(5));
    EXPECT_FALSE(check_in_parts(mesh.prepared, folder.path() / name, {})) << name;
  }
  const std::string path = folder.path() / "x.vtkhdf";
  ASSERT_TRUE(write_mesh(mesh.output, path));
  std::ofstream(folder.path() / "cut.vtkhdf", std::ios::binary)
      << read(path).substr(0, read(path).size() / 2);
  EXPECT_FALSE(check_in_parts(mesh.prepared, folder.path() / "cut.vtkhdf", {}));
}

}  // namespace
}  // namespace cover
