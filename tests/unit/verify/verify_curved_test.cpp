#include <cover/mesh_view.hpp>
#include <cover/verify_curved.hpp>

#include <gtest/gtest.h>

#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

/// A disc cut on its rim, of second order.
class VerifyCurved : public ::testing::Test {
 protected:
  VerifyCurved() {
    Input input;
    testing::add_circle(input, {1, 2}, 3, 8);
    Options options;
    options.split_interfaces = Angle::degrees(120);
    options.sizes = {{"", 1, false}};
    output_ = testing::must_mesh(input, options);
    soup_ = triangle_soup(output_.mesh);
    WriteOptions order_2;
    order_2.order = 2;
    const MeshView view = view_of(output_, order_2);
    for (std::size_t t = 0; t < view.triangles.size(); ++t) {
      const auto nodes = view.triangles[t];
      middles_.push_back({view.points[nodes[3]], view.points[nodes[4]], view.points[nodes[5]]});
    }
  }

  [[nodiscard]] CurvedVerification verify() const {
    return verify_curved(output_.pslg, soup_, middles_);
  }

  /// Moves the middle node of an edge, on both sides.
  void move(std::size_t triangle, std::size_t edge, Vector by) {
    const Point before = middles_[triangle][edge];
    for (auto& of_triangle : middles_) {
      for (Point& p : of_triangle) {
        if (p == before) p = p + by;
      }
    }
  }

  Output output_;
  TriangleSoup soup_;
  std::vector<std::array<Point, 3>> middles_;
};

TEST_F(VerifyCurved, AMeshOfTheRunHolds) {
  const CurvedVerification found = verify();
  EXPECT_EQ(found.violation_count, 0U);
  EXPECT_EQ(found.on_arcs, output_.pslg.segments.size());
  EXPECT_EQ(found.straight, 0U);
}

TEST_F(VerifyCurved, NodesOffTheirArcAreFound) {
  std::size_t t = 0, e = 0;
  const auto is_on_rim = [&] { return std::abs(length(middles_[t][e] - Point{1, 2}) - 3) < 1e-12; };
  while (!is_on_rim()) e == 2 ? (++t, e = 0) : ++e;
  const Point at = middles_[t][e];
  move(t, e, 1e-6 * (at - Point{1, 2}));
  const CurvedVerification found = verify();
  ASSERT_EQ(found.violation_count, 1U);
  EXPECT_NE(found.violations[0].message.find("not on the arc, nor"), std::string::npos)
      << found.violations[0].message;
}

TEST_F(VerifyCurved, InvertedTrianglesAndTornEdgesAreFound) {
  std::size_t t = 0, e = 0;
  const auto is_inner = [&] { return length(middles_[t][e] - Point{1, 2}) < 2.5; };
  while (!is_inner()) e == 2 ? (++t, e = 0) : ++e;
  const Point corner = soup_.points[soup_.triangles[t][(e + 2) % 3]];
  const Point kept = middles_[t][e];
  middles_[t][e] = middles_[t][e] + 1e-3 * (corner - kept);
  EXPECT_NE(verify().violations.at(0).message.find("two middle nodes"), std::string::npos);
  middles_[t][e] = kept;
  move(t, e, 0.9 * (corner - kept));
  EXPECT_NE(verify().violations.at(0).message.find("Jacobian"), std::string::npos);
}

}  // namespace
}  // namespace cover
