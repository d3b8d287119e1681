#include "cuts/cut_encroached.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <cover/cover_mesh.hpp>

#include "box/encroached_sides.hpp"
#include "cdt/cdt.hpp"
#include "region/region_graph.hpp"
#include "support/inputs.hpp"

namespace cover {
namespace {

struct Cut {
  Pslg pslg;
  RegionTable table;
  BoxCosts costs;
  std::vector<BoxCut> cuts;
  std::vector<Point> stuck;
};

Cut cut(const Input& input) {
  Result<Prepared> prepared = prepare(input);
  EXPECT_TRUE(prepared.has_value());
  Cut done{prepared->pslg, prepared->table, *box_costs(*prepared), {}, {}};
  cut_encroached(done.pslg, done.table, VertexId{done.pslg.points.size()}, done.cuts, done.stuck);
  return done;
}

std::size_t encroached(const Cut& done) {
  std::size_t count = 0;
  for (const RegionBoundary& b : split_regions(done.pslg, done.table)) {
    const Triangulation cdt = triangulate_domain(b.points, b.sides).triangulation;
    count += encroached_sides(cdt, locate_sides(cdt, b.sides)).size();
  }
  return count;
}

TEST(CutEncroached, LeavesWhatNothingEncroaches) {
  const Cut done = cut(testing::input_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(done.costs.encroached_sides, 0U);
  EXPECT_TRUE(done.cuts.empty());
}

TEST(CutEncroached, CutsALidOverADimpleOnce) {
  const Cut done =
      cut(testing::input_of({{0, 0}, {4, 0}, {5, 2}, {6, 0}, {10, 0}, {10, 3}, {0, 3}}));
  EXPECT_EQ(done.costs.encroached_segments, 1U);
  EXPECT_EQ(done.costs.least_cuts, 1U);
  ASSERT_EQ(done.cuts.size(), 1U);
  EXPECT_EQ(done.cuts[0].at, (Point{5, 3})) << "the foot";
  EXPECT_EQ(done.cuts[0].by, (Point{5, 2}));
  EXPECT_EQ(done.cuts[0].reason, BoxCut::Reason::encroached);
  EXPECT_EQ(encroached(done), 0U);
}

TEST(CutEncroached, SharpCornersOfUnequalSidesTakeOneCut) {
  for (const double degrees : {60.0, 30.0, 5.0, 0.1}) {
    const double u = degrees * std::numbers::pi / 180;
    const Cut done =
        cut(testing::input_of({{0, 0}, {10, 0}, {0.9 * std::cos(u), 0.9 * std::sin(u)}}));
    EXPECT_EQ(encroached(done), 0U) << degrees;
    EXPECT_TRUE(done.stuck.empty());
    EXPECT_GE(done.cuts.size(), done.costs.least_cuts);
    EXPECT_LE(done.cuts.size(), 2 * done.costs.least_cuts) << degrees;
  }
}

TEST(CutEncroached, NeverTakesFewerThanTheBoundAndLeavesNoneEncroached) {
  std::size_t least = 0, cuts = 0;
  for (const testing::RandomInput& kind : testing::kRandomDevices) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Cut done = cut(kind.make(seed));
      EXPECT_GE(done.cuts.size(), done.costs.least_cuts) << kind.name << seed;
      EXPECT_EQ(done.cuts.size(), done.costs.cuts) << kind.name << seed;
      if (done.stuck.empty()) {
        EXPECT_EQ(encroached(done), 0U) << kind.name << seed;
      }
      least += done.costs.least_cuts;
      cuts += done.cuts.size();
    }
  }
  EXPECT_LE(cuts, 2 * least);
}

}  // namespace
}  // namespace cover
