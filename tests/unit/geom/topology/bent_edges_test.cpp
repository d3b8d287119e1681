#include "geom/topology/bent_edges.hpp"

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(BentEdges, AreThoseWithANodeOffTheMiddle) {
  TriangleSoup soup;
  soup.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  soup.triangles = {{0, 1, 2}, {2, 3, 0}};
  std::vector<std::array<Point, 3>> middles{{{{1, -0.1}, {2, 1}, {1, 1}}},
                                            {{{1, 2 + 1e-10}, {0.1, 1}, {1, 1}}}};
  using Bent = std::map<std::pair<std::uint32_t, std::uint32_t>, Point>;
  EXPECT_EQ(bent_edges(soup, middles), (Bent{{{0, 1}, {1, -0.1}}, {{0, 3}, {0.1, 1}}}));
  middles.pop_back();
  EXPECT_EQ(bent_edges(soup, middles), Bent()) << "nodes of one triangle only";
}

}  // namespace
}  // namespace cover
