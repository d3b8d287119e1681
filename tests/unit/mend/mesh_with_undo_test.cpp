#include "mend/mesh_with_undo.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::uint32_t kFixedVertices = JoinedMesh::kFixed;

/// Two squares side by side, with one line between them from (1, 0) to (1, 1); the outer ones stay
/// whole but for the lowest of the left square.
JoinedMesh two_squares() {
  JoinedMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  mesh.line.assign(6, kFixedVertices);
  mesh.lines = {{{1, 0}, {1, 1}}, {{0, 0}, {1, 0}}};
  mesh.pieces = {{1, 4, 0}, {0, 1, 1}, {1, 2, 2}, {2, 3, 2}, {3, 4, 2}, {4, 5, 2}, {5, 0, 2}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
  mesh.region = {0, 0, 1, 1};
  return mesh;
}

using Shape = std::vector<std::pair<IndexTriple, std::uint32_t>>;

/// The triangles that are there, each from its first vertex on, with regions; costs are looked at.
Shape shape_of(const MeshWithUndo& mesh) {
  Shape shape;
  std::size_t bad = 0;
  for (const MeshWithUndo::Triangle& t : mesh.triangles()) {
    if (t.v[0] == kNone) continue;
    IndexTriple v = t.v;
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    shape.push_back({v, t.region});
    bad += t.cost > 0 ? 1 : 0;
  }
  EXPECT_EQ(bad, mesh.bad());
  std::sort(shape.begin(), shape.end());
  return shape;
}

void expect_delaunay(const MeshWithUndo& mesh) {
  const auto& all = mesh.triangles();
  double area = 0;
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    const MeshWithUndo::Triangle& t = all[k];
    if (t.v[0] == kNone) continue;
    const Point a = mesh.at(t.v[0]), b = mesh.at(t.v[1]), c = mesh.at(t.v[2]);
    ASSERT_EQ(orientation(a, b, c), Sign::positive);
    area += cross(b - a, c - a) / 2;
    for (const Corner i : kCorners) {
      if (t.n[i] == kNone) continue;
      const MeshWithUndo::Triangle& o = all[t.n[i]];
      ASSERT_EQ(std::count(o.n.begin(), o.n.end(), k), 1);
      const Corner back =
          static_cast<std::uint32_t>(std::find(o.n.begin(), o.n.end(), k) - o.n.begin());
      EXPECT_EQ(o.line[back], t.line[i]);
      EXPECT_EQ(o.v[back.next()], t.v[i.previous()]);
      if (t.line[i] == JoinedMesh::kInside) {
        EXPECT_EQ(o.region, t.region);
        EXPECT_NE(in_circle(a, b, c, mesh.at(o.v[back])), Sign::positive);
      }
    }
  }
  EXPECT_NEAR(area, 2, 1e-12);
}

// Its Delaunay triangulation has an angle of 153 degrees at (0, 0), the other one none above 105.
TEST(MeshWithUndo, BeginsWithoutFlatTrianglesBeyondTheWorstThatTheMeshDoesNotHave) {
  JoinedMesh quadrilateral;
  quadrilateral.points = {{0, 0}, {10, 0}, {1, 2}, {0, -2}};
  quadrilateral.line.assign(4, kFixedVertices);
  quadrilateral.lines = {{{0, 0}, {1, 2}}};
  quadrilateral.pieces = {{0, 2, 1}, {2, 1, 1}, {1, 3, 1}, {3, 0, 1}};
  quadrilateral.triangles = {{0, 1, 2}, {0, 3, 1}};
  quadrilateral.region = {0, 0};
  const auto shape_with = [&](double worst_cot) {
    WantedAngles wanted;
    wanted.worst_cot = worst_cot;
    return shape_of(MeshWithUndo(quadrilateral, {wanted}));
  };
  const Shape as_it_was{{{0, 1, 2}, 0}, {{0, 3, 1}, 0}}, delaunay{{{0, 3, 2}, 0}, {{1, 2, 3}, 0}};
  EXPECT_EQ(shape_with(-kInfinity), delaunay);
  EXPECT_EQ(shape_with(-3), delaunay);       // 162 degrees
  EXPECT_EQ(shape_with(-0.5), as_it_was);    // 117 degrees
  EXPECT_EQ(shape_with(-0.125), as_it_was);  // 97 degrees
}

// The foot of a vertex hardly beside a piece is rounded to its other side.
TEST(MeshWithUndo, NoVertexIsSwallowedByTheHoleOfAnotherOne) {
  JoinedMesh start;
  start.points = {{-1.0418561123062906, 10.822590371134186},
                  {-0.3353603415770599, 9.441066097371566},
                  {-0.9917312208258062, 10.724573147013327},
                  {0.41520278913795172, 11.444063086926464}};
  start.line.assign(4, kFixedVertices);
  start.lines = {{{-3.268265910321986, 15.17624584472152}, start.points[1]}};
  start.pieces = {{0, 1, 0}, {1, 3, 1}, {3, 0, 1}};
  start.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}};
  start.region = {0, 0, 0};
  ASSERT_EQ(orientation(start.points[0], start.points[1], start.points[2]), Sign::positive);
  MeshWithUndo mesh(start, std::vector<WantedAngles>(1));
  const Shape before = shape_of(mesh);
  const auto flat = std::find_if(
      mesh.triangles().begin(), mesh.triangles().end(),
      [](const MeshWithUndo::Triangle& t) { return std::count(t.line.begin(), t.line.end(), 0); });
  ASSERT_NE(flat, mesh.triangles().end());
  const auto edge = std::find(flat->line.begin(), flat->line.end(), 0) - flat->line.begin();
  const auto index = static_cast<std::uint32_t>(flat - mesh.triangles().begin());
  const Spot spot = mesh.on_line(mesh.at(2), index, Corner(static_cast<std::uint32_t>(edge)));
  ASSERT_NE(spot.triangle, kNone);
  ASSERT_NE(orientation(mesh.at(2), mesh.at(0), spot.at), Sign::positive) << "beyond the vertex";
  EXPECT_EQ(mesh.insert(spot), kNone);
  EXPECT_EQ(shape_of(mesh), before);
}

TEST(MeshWithUndo, EveryStepCanBeTakenBack) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  MeshWithUndo mesh(two_squares(), std::vector<WantedAngles>(2));
  std::vector<std::uint32_t> added;
  std::size_t cuts = 0, removed = 0, undone = 0;
  for (int step = 0; step < 3000; ++step) {
    const Shape before = shape_of(mesh);
    const double cost = mesh.cost();
    const std::size_t mark = mesh.mark();
    const std::vector<std::uint32_t> there = added;
    const bool take = added.size() > 40 || (!added.empty() && unit(random) < 0.4);
    if (take) {
      const std::size_t k = random() % added.size();
      if (!mesh.remove(added[k])) {
        EXPECT_EQ(shape_of(mesh), before);
        continue;
      }
      EXPECT_FALSE(mesh.is_there(added[k]));
      added.erase(added.begin() + static_cast<std::ptrdiff_t>(k));
      ++removed;
    } else {
      std::uint32_t t = 0;
      do {
        t = static_cast<std::uint32_t>(random() % mesh.triangles().size());
      } while (mesh.triangles()[t].v[0] == kNone);
      // Often out of the region: then it is a cut, or nowhere.
      const Spot spot = mesh.locate({2.4 * unit(random) - 0.2, 1.4 * unit(random) - 0.2}, t);
      const double change = mesh.change_with(spot);
      const std::uint32_t v = mesh.insert(spot);
      EXPECT_EQ(v == kNone, change == std::numeric_limits<double>::infinity());
      if (v == kNone) continue;
      EXPECT_NEAR(mesh.cost(), cost + change, 1e-5);
      cuts += spot.edge ? 1 : 0;
      added.push_back(v);
    }
    expect_delaunay(mesh);
    if (unit(random) < 0.3) {
      mesh.undo(mark);
      added = there;
      EXPECT_EQ(shape_of(mesh), before);
      EXPECT_NEAR(mesh.cost(), cost, 1e-5);
      expect_delaunay(mesh);
      ++undone;
    }
    if (step % 50 == 0) mesh.keep();
  }
  EXPECT_GT(cuts, 100u);
  EXPECT_GT(removed, 300u);
  EXPECT_GT(undone, 300u);
  while (!added.empty()) {
    ASSERT_TRUE(mesh.remove(added.back()));
    added.pop_back();
  }
  EXPECT_EQ(shape_of(mesh).size(), 4u);
}

TEST(MeshWithUndo, CutsBothRegionsAndOnlyLinesThatMayBe) {
  MeshWithUndo mesh(two_squares(), std::vector<WantedAngles>(2));
  const Spot between = mesh.locate({1.5, 0.4}, 0);  // triangle 0 lies in the left square
  ASSERT_TRUE(between.edge);
  EXPECT_EQ(between.at, (Point{1, 0.4}));
  const std::uint32_t v = mesh.insert(between);
  ASSERT_NE(v, kNone);
  EXPECT_EQ(mesh.vertices()[v].line, 0u);
  const JoinedMesh cut = mesh.result(two_squares());
  EXPECT_EQ(cut.points.size(), 7u);
  EXPECT_EQ(cut.triangles.size(), 6u);
  std::size_t pieces = 0;
  for (const JoinedMesh::Piece& piece : cut.pieces) pieces += piece.line == 0 ? 1 : 0;
  EXPECT_EQ(pieces, 2u);
  // Nothing is cut beyond the ends of a piece.
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    for (int e = 0; e < 3; ++e) {
      const MeshWithUndo::Triangle& triangle = mesh.triangles()[t];
      if (triangle.v[0] == kNone || triangle.line[static_cast<std::size_t>(e)] != 0) continue;
      for (const double y : {-3.0, -0.2, 1.1, 5.0})
        EXPECT_EQ(mesh.insert(mesh.on_line({1.2, y}, t, e)), kNone);
    }
  }
  // The right side of the right square stays whole.
  std::uint32_t right = 0;
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    if (mesh.triangles()[t].v[0] != kNone && mesh.triangles()[t].region == 1) right = t;
  }
  EXPECT_EQ(mesh.locate({2.5, 0.5}, right).triangle, kNone);
}

TEST(MeshWithUndo, CountsWhatIsObtuseAndWhatIsTooSharp) {
  JoinedMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {1, 1}};
  mesh.line.assign(3, kFixedVertices);
  mesh.pieces = {{0, 1, 7}, {1, 2, 7}, {2, 0, 7}};
  mesh.triangles = {{0, 1, 2}};
  mesh.region = {0};
  EXPECT_EQ(MeshWithUndo(mesh, {{0}}).bad(), 1u);
  mesh.points[2] = {1, 2};  // angles of 63.4 and 33.7 degrees at the base
  EXPECT_EQ(MeshWithUndo(mesh, {{0}}).bad(), 0u);
  EXPECT_EQ(MeshWithUndo(mesh, {{1.6}}).bad(), 0u);  // cot 33.7 is 1.5
  EXPECT_EQ(MeshWithUndo(mesh, {{1.4}}).bad(), 1u);
  // Right angles but for rounding: bad only opposite to pieces of lines.
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t exactly = 0;
  for (int k = 0; k < 200; ++k) {
    const Point p{unit(random), unit(random)};
    const Vector u{0.1 + unit(random), unit(random)};
    mesh.points = {p, p + u, p + left_normal(u)};
    const bool is_obtuse =
        compare_with_90_degrees(mesh.points[1], p, mesh.points[2]) == Sign::positive;
    mesh.pieces = {{1, 2, 7}};
    EXPECT_EQ(MeshWithUndo(mesh, {{0}}).bad(), is_obtuse ? 1u : 0u);
    mesh.pieces = {{0, 1, 7}, {2, 0, 7}};
    EXPECT_EQ(MeshWithUndo(mesh, {{0}}).bad(), 0u);
    exactly += is_obtuse ? 1 : 0;
  }
  EXPECT_GT(exactly, 20u);
}

}  // namespace
}  // namespace cover
