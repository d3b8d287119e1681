#include "cuts/after_meshing/mesh_with_closed_clefts.hpp"

#include <gtest/gtest.h>

#include "../clefts/comb.hpp"
#include "without_obtuse.hpp"

namespace cover {
namespace {

/// Teeth that nearly touch kept obtuse triangles, however long they were searched.
TEST(MeshWithClosedClefts, NoTriangleOfACombIsObtuse) {
  for (const double gap : {1e-3, 1e-6}) {
    const Output output = mesh_of(comb(8, gap));
    EXPECT_EQ(output.report.quality.obtuse, 0u) << gap;
    for (const RegionReport& region : output.report.regions) EXPECT_TRUE(region.bound_held);
  }
}

TEST(MeshWithClosedClefts, DependsOnNeitherUnitNorThreads) {
  expect_same_for_threads_and_unit(comb(2, 1e-6));
}

}  // namespace
}  // namespace cover
