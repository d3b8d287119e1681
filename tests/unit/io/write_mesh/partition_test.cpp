// Parts of a mesh: every triangle in one, sizes alike, ghosts around each.
#include "io/write_mesh/partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include <cover/cover_mesh.hpp>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

MeshView view_of_input(const Input& input) {
  const Result<Output> output = cover_mesh(input);
  EXPECT_TRUE(output);
  return view_of(*output, {});
}

bool share_a_vertex(const MeshView& view, std::size_t a, std::size_t b) {
  const auto p = view.triangles[a], q = view.triangles[b];
  return std::any_of(p.begin(), p.end(),
                     [&](std::uint32_t v) { return std::find(q.begin(), q.end(), v) != q.end(); });
}

TEST(Partition, DividesTheTrianglesEvenly) {
  const MeshView view = view_of_input(testing::checker(12, 4, 1));
  const std::size_t all = view.triangles.size();
  for (const std::uint32_t count : {1U, 2U, 3U, 7U}) {
    SCOPED_TRACE(count);
    const Partition partition = partition_of(view, count);
    ASSERT_EQ(partition.parts.size(), count);
    std::set<std::size_t> met;
    for (std::uint32_t p = 0; p < count; ++p) {
      const std::vector<std::size_t>& own = partition.parts[p].own;
      EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
      const double mean = static_cast<double>(all) / count;
      EXPECT_NEAR(static_cast<double>(own.size()), mean, mean / 8 + 1);
      for (const std::size_t t : own) {
        EXPECT_EQ(partition.owner[t], p);
        EXPECT_TRUE(met.insert(t).second);
      }
    }
    EXPECT_EQ(met.size(), all);
  }
}

TEST(Partition, KeepsSmallRegionsWhole) {
  const MeshView view = view_of_input(testing::checker(12, 4, 1));
  const Partition partition = partition_of(view, 3);
  std::vector<std::set<std::uint32_t>> parts_of(view.region_group.size());
  for (std::size_t t = 0; t < view.triangles.size(); ++t)
    parts_of[place_of(view.region[t])].insert(partition.owner[t]);
  for (const std::set<std::uint32_t>& parts : parts_of) EXPECT_EQ(parts.size(), 1U);
}

TEST(Partition, DividesALargeRegion) {
  const MeshView view = view_of_input(testing::input_of(testing::smooth_star(500, 3)));
  const Partition partition = partition_of(view, 4);
  for (const MeshPart& part : partition.parts)
    EXPECT_NEAR(static_cast<double>(part.own.size()),
                static_cast<double>(view.triangles.size()) / 4, 1);
}

TEST(Partition, GhostsAreTheNeighboursOfOthers) {
  const MeshView view = view_of_input(testing::checker(4, 3, 2));
  const Partition partition = partition_of(view, 3);
  for (std::uint32_t p = 0; p < 3; ++p) {
    const MeshPart& part = partition.parts[p];
    for (std::size_t t = 0; t < view.triangles.size(); ++t) {
      const bool is_near = partition.owner[t] != p &&
                           std::any_of(part.own.begin(), part.own.end(), [&](std::size_t own) {
                             return share_a_vertex(view, own, t);
                           });
      EXPECT_EQ(std::binary_search(part.ghosts.begin(), part.ghosts.end(), t), is_near);
    }
  }
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    for (const std::uint32_t v : view.triangles[t])
      EXPECT_LE(partition.vertex_owner[v], partition.owner[t]);
  }
}

TEST(Partition, BearsMorePartsThanTriangles) {
  const MeshView view = view_of_input(testing::checker(1, 1, 1));
  const Partition partition = partition_of(view, 50);
  std::size_t all = 0;
  for (const MeshPart& part : partition.parts) all += part.own.size();
  EXPECT_EQ(all, view.triangles.size());
}

}  // namespace
}  // namespace cover
