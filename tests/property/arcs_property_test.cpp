// Random devices of arcs and lines, whole and cut in every way: all promises hold, cuts lie on the
// arcs, and of second order no triangle is inverted, by another test than the one that is made.
#include <gtest/gtest.h>

#include <random>

#include <cover/adopt_cuts.hpp>
#include <cover/cover_mesh.hpp>
#include <cover/curved_mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/verify.hpp>

#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"
#include "support/inputs/shapes.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

/// Random devices: COVER_ARC_TRIALS if set.
std::size_t arc_trials() { return testing::cases_asked_for("COVER_ARC_TRIALS", 80); }

Options random_arc_options(std::mt19937_64& random) {
  Options options;
  options.effort = Effort::fast;
  const std::size_t kind = random() % 5;
  if (kind == 1 || kind == 2) options.split_interfaces = Angle::degrees(kind == 1 ? 90 : 120);
  if (kind == 2 || kind == 3) {
    options.split_interfaces = Angle::degrees(120);
    options.sizes = {{"", kind == 2 ? 0.3 : 0.08, false}};
  }
  if (kind == 4) options.box_method = true;
  return options;
}

/// The smallest Jacobian of a triangle with six nodes over 66 places, from the shape functions.
long double least_jacobian(const MeshView& view, std::span<const std::uint32_t> nodes) {
  constexpr int kSteps = 10;
  long double least = 1;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const long double r = static_cast<long double>(i) / kSteps,
                        s = static_cast<long double>(j) / kSteps, q = 1 - r - s;
      const long double dr[6] = {1 - 4 * q, 4 * r - 1, 0, 4 * (q - r), 4 * s, -4 * s};
      const long double ds[6] = {1 - 4 * q, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (q - s)};
      long double xr = 0, yr = 0, xs = 0, ys = 0;
      // From the first corner on: differences of near coordinates.
      const Point o = view.points[nodes[0]];
      for (std::size_t k = 0; k < 6; ++k) {
        const long double x = static_cast<long double>(view.points[nodes[k]].x) - o.x,
                          y = static_cast<long double>(view.points[nodes[k]].y) - o.y;
        xr += dr[k] * x, yr += dr[k] * y, xs += ds[k] * x, ys += ds[k] * y;
      }
      least = std::min(least, xr * ys - xs * yr);
    }
  }
  return least;
}

/// What was seen of devices.
struct Seen {
  std::size_t curved = 0, straight = 0;  ///< edges on arcs
  std::size_t moved = 0;                 ///< nodes that gave way to arcs
  std::size_t cut = 0;                   ///< devices
};

void check_device(std::uint64_t seed, Seen& seen) {
  std::mt19937_64 random(seed);
  const Input input = testing::random_arc_device(seed);
  const Result<Output> output = cover_mesh(input, random_arc_options(random));
  ASSERT_TRUE(output) << output.error().message;
  ASSERT_EQ(testing::violations(*output), "");
  const CurvedMesh curved = curved_mesh(*output);
  for (const CurvedEdge& edge : curved.edges) ++(edge.is_straight ? seen.straight : seen.curved);
  seen.moved += curved.moved.size();
  seen.cut += output->pslg.points.size() > output->report.input_points ? 1 : 0;
  WriteOptions order_2;
  order_2.order = 2;
  const MeshView view = view_of(*output, order_2);
  for (std::size_t t = 0; t < view.triangles.size(); ++t)
    ASSERT_GT(least_jacobian(view, view.triangles[t]), 0) << "triangle " << t;
  // Pieces of arcs end on their circles.
  for (const Segment& s : output->pslg.segments) {
    const ArcCircle* circle = circle_of(output->pslg, s);
    if (circle == nullptr) continue;
    for (const VertexId v : {s.a, s.b}) {
      ASSERT_NEAR(length(output->pslg.points[v.index()] - circle->centre), circle->radius, 1e-12);
    }
  }
  // The mesh is known again from the input alone.
  Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared);
  const TriangleSoup soup = triangle_soup(output->mesh);
  adopt_cuts(prepared->pslg, prepared->table, soup);
  VerifyOptions verify;
  verify.bound = false;
  const Verification found = verify_cover(prepared->pslg, prepared->table, soup, verify);
  ASSERT_TRUE(found.violations.empty()) << found.violations[0].message;
}

TEST(Arcs, NoTriangleOfSecondOrderIsInverted) {
  const std::uint64_t first = testing::test_seed(3000);
  Seen seen;
  for (std::uint64_t seed = first; seed < first + arc_trials(); ++seed) {
    SCOPED_TRACE(testing::seed_trace(seed));
    ASSERT_NO_FATAL_FAILURE(check_device(seed, seen));
  }
  RecordProperty("curved", std::to_string(seen.curved));
  RecordProperty("straight", std::to_string(seen.straight));
  RecordProperty("moved", std::to_string(seen.moved));
  EXPECT_GT(seen.curved, 20 * seen.straight);
  EXPECT_GT(seen.cut, arc_trials() / 4);
}

// An arc was cut on its chord, and an edge inside a region leads to a vertex of the arc too.
TEST(Arcs, ACutOnAChordIsFoundAlongBordersOnly) {
  Seen seen;
  check_device(101033, seen);
}

// Cuts of pieces of arcs were put back on the chord of the whole arc.
TEST(Arcs, CutsStayOnThem) {
  Seen seen;
  check_device(9100310, seen);
  check_device(9100336, seen);
}

}  // namespace
}  // namespace cover
