// verify_cover() on good meshes, and on every kind of damage done to them.
#include <cover/verify.hpp>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <cover/cover_mesh.hpp>

#include "cdt/cdt.hpp"
#include "geom/vector.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

/// Two squares side by side around a square hole each, an isolated point and a slit in the first,
/// by hand: PSLG, regions and their mesh.
struct Device {
  Pslg pslg;
  RegionTable table;
  TriangleSoup mesh;

  Device() {
    pslg.points = {{0, 0},   {6, 0},  {12, 0}, {12, 6}, {6, 6}, {0, 6},  // outline
                   {2, 2},   {2, 4},  {4, 4},  {4, 2},                   // hole of the first
                   {5, 1},   {5, 2},                                     // slit
                   {1, 5},                                               // isolated
                   {20, 20}, {21, 20}};                                  // a segment in the void
    for (std::size_t v = 0; v < pslg.points.size(); ++v) pslg.point_ids.push_back(long(v) + 1);
    loop({0, 1, 4, 5}, 1);
    loop({1, 2, 3, 4}, 2);
    loop({6, 7, 8, 9}, 1);
    segment(10, 11, 1, 1);
    segment(13, 14, 0, 0);
    pslg.seeds.resize(2);
    table.regions.resize(2);
    table.regions[0].id = RegionId{1};
    table.regions[0].material = 7;
    table.regions[1].id = RegionId{2};
    table.regions[1].material = 3;
    mesh_all();
  }

  [[nodiscard]] Verification check(const VerifyOptions& options = {}) const {
    return verify_cover(pslg, table, mesh, options);
  }

  void loop(const std::vector<std::uint32_t>& v, std::uint32_t region) {
    for (std::size_t i = 0; i < v.size(); ++i) segment(v[i], v[(i + 1) % v.size()], region, 0);
  }

  void segment(std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right) {
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      if (pslg.segments[s].a == VertexId(b) && pslg.segments[s].b == VertexId(a)) {
        table.sides[s].right = RegionId(left);
        return;
      }
    }
    pslg.segments.push_back({VertexId(a), VertexId(b), 0, 0});
    table.sides.push_back({RegionId(left), RegionId(right), kNoInterface});
  }

  /// The constrained Delaunay triangles of both regions.
  void mesh_all() {
    mesh = {};
    mesh.points = pslg.points;
    for (const Region& region : table.regions) {
      std::vector<IndexPair> sides;
      for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
        const auto [a, b] = std::array{pslg.segments[s].a.value(), pslg.segments[s].b.value()};
        if (table.sides[s].left == region.id) sides.push_back({a, b});
        if (table.sides[s].right == region.id) sides.push_back({b, a});
      }
      for (const Triangle& t : triangulate_domain(pslg.points, sides).triangulation.triangles) {
        mesh.triangles.push_back(t.v);
        mesh.region.push_back(region.id.value());
        mesh.material.push_back(region.material);
      }
    }
  }
};

bool has(const Verification& v, int promise, const std::string& text) {
  return std::any_of(v.violations.begin(), v.violations.end(), [&](const Violation& x) {
    return x.promise == promise && x.message.find(text) != std::string::npos;
  });
}

std::string all_of(const Verification& v) {
  std::string text;
  for (const Violation& x : v.violations)
    text += std::to_string(x.promise) + ": " + x.message + "\n";
  return text;
}

TEST(Verify, GoodMeshHasNoViolation) {
  const Verification v = Device().check();
  EXPECT_EQ(all_of(v), "");
  EXPECT_EQ(v.violation_count, 0U);
  EXPECT_EQ(v.segments_whole, 12U);
  EXPECT_EQ(v.regions, 2U);
}

TEST(Verify, OrderAndNumberingOfTheMeshDoNotMatter) {
  Device d;
  std::mt19937_64 random(testing::test_seed(1));
  std::vector<std::uint32_t> order(d.mesh.points.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  std::shuffle(order.begin(), order.end(), random);
  for (std::uint32_t k = 0; k < order.size(); ++k) d.mesh.points[order[k]] = d.pslg.points[k];
  for (auto& t : d.mesh.triangles) {
    for (auto& v : t) v = order[v];
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  std::reverse(d.mesh.triangles.begin(), d.mesh.triangles.end());
  std::reverse(d.mesh.material.begin(), d.mesh.material.end());
  d.mesh.region.clear();
  EXPECT_EQ(all_of(d.check()), "");
}

TEST(Verify, RegionIdsMayBeNumberedOtherwise) {
  Device d;
  for (auto& r : d.mesh.region) r = 50 - r;
  EXPECT_EQ(all_of(d.check()), "");
}

TEST(Verify, MissingTriangle) {
  Device d;
  for (std::size_t k = 0; k < d.mesh.triangles.size(); ++k) {
    Device damaged;
    damaged.mesh.triangles.erase(damaged.mesh.triangles.begin() + long(k));
    damaged.mesh.region.erase(damaged.mesh.region.begin() + long(k));
    damaged.mesh.material.erase(damaged.mesh.material.begin() + long(k));
    EXPECT_GT(damaged.check().violation_count, 0U) << "without triangle " << k;
  }
}

TEST(Verify, TriangleTwice) {
  Device d;
  d.mesh.triangles.push_back(d.mesh.triangles[3]);
  d.mesh.region.push_back(d.mesh.region[3]);
  d.mesh.material.push_back(d.mesh.material[3]);
  EXPECT_TRUE(has(d.check(), 2, "overlap"));
}

TEST(Verify, ClockwiseAndFlatTriangles) {
  Device d;
  std::swap(d.mesh.triangles[0][0], d.mesh.triangles[0][1]);
  EXPECT_TRUE(has(d.check(), 2, "is clockwise"));
  Device flat;
  flat.mesh.triangles[0] = {0, 1, 2};
  EXPECT_TRUE(has(flat.check(), 2, "is flat"));
}

TEST(Verify, PointMovedByOneUnitInTheLastPlace) {
  for (std::uint32_t v = 0; v < 13; ++v) {
    Device d;
    double& x = d.mesh.points[v].x;
    x = std::nextafter(x, 100);
    const Verification found = d.check();
    EXPECT_TRUE(has(found, 1, "point " + std::to_string(v + 1) + " at")) << all_of(found);
  }
}

TEST(Verify, IsolatedPointLeftOut) {
  Device d;
  d.pslg.points[12] = {100, 100};
  d.mesh_all();
  d.pslg.points[12] = {1, 5};
  const Verification v = d.check();
  EXPECT_TRUE(has(v, 1, "point 13 at (1, 5) is no vertex")) << all_of(v);
  EXPECT_EQ(v.points_missing, 1U);
}

/// Cuts the interface 1-4, from (6, 0) to (6, 6), at its middle; on one of its sides only, if
/// asked.
std::uint32_t cut_interface(Device& d, bool one_side = false) {
  const auto middle = static_cast<std::uint32_t>(d.mesh.points.size());
  d.mesh.points.push_back({6, 3});
  const std::size_t before = d.mesh.triangles.size();
  for (std::size_t k = 0; k < before; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      auto& t = d.mesh.triangles[k];
      const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (!((a == 1 && b == 4) || (a == 4 && b == 1 && !one_side))) continue;
      t = {a, middle, c};
      d.mesh.triangles.push_back({middle, b, c});
      d.mesh.region.push_back(d.mesh.region[k]);
      d.mesh.material.push_back(d.mesh.material[k]);
      break;
    }
  }
  EXPECT_EQ(d.mesh.triangles.size(), before + (one_side ? 1 : 2));
  return middle;
}

TEST(Verify, SegmentSplitByAVertex) {
  Device d;
  const std::uint32_t middle = cut_interface(d);
  const Verification v = d.check();
  EXPECT_TRUE(has(v, 1, "from point 2 at (6, 0) to point 5 at (6, 6) is no edge")) << all_of(v);
  const Verification allowed = d.check({.allow_split = true});
  EXPECT_EQ(all_of(allowed), "");
  EXPECT_EQ(allowed.segments_whole, 11U);
  // Off the segment by more than rounding it is no split any more.
  d.mesh.points[middle].x = 6 + 1e-9;
  EXPECT_GT(d.check({.allow_split = true}).violation_count, 0U);
}

/// A cut of the segment between points 2 and 3, rounded, lies beside it: the region on one side has
/// an edge between them, inside, and a flat triangle beyond.
TEST(Verify, SegmentSplitBesideAnEdgeBetweenItsEnds) {
  const Input input = testing::segments_between(
      {{20.59233386725629, 28.654040432860977},
       {8120544.6720304536, -5835816.5007822933},
       {8120687.1487188051, -5835618.2457998786},
       {5416860.9166774964, -3892503.3604942956},
       {163.0690222174205, 226.90902284732843},
       {8120687.1487190695, -5835618.2457995098},
       {5609168.249619795, -4030705.7481935862},
       {163.069022482804, 226.90902321660712}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {4, 2}, {2, 5}, {5, 6}, {6, 7}, {7, 4}});
  Options options;
  options.method = Method::almond;
  const auto whole = prepare(input, options);
  ASSERT_TRUE(whole) << whole.error().message;
  options.split_interfaces = Angle::degrees(90);
  const auto output = cover_mesh(input, options);
  ASSERT_TRUE(output) << output.error().message;
  TriangleSoup mesh = triangle_soup(output->mesh);
  const bool has_edge = std::any_of(
      mesh.triangles.begin(), mesh.triangles.end(), [](const std::array<std::uint32_t, 3>& t) {
        return std::count(t.begin(), t.end(), 2U) + std::count(t.begin(), t.end(), 3U) == 2;
      });
  EXPECT_TRUE(has_edge) << "no edge beside the cut: take another drawing";
  const auto found =
      verify_cover(whole->pslg, whole->table, mesh, {.bound = false, .allow_split = true});
  EXPECT_TRUE(found.violations.empty()) << found.violations.front().message;
  // Its regions tell which is the segment, and vouch for nothing.
  std::swap(mesh.region.front(), mesh.region.back());
  EXPECT_FALSE(verify_cover(whole->pslg, whole->table, mesh, {.bound = false, .allow_split = true})
                   .violations.empty());
}

/// The same beside the void: what lies between the ends' edge and the pieces is the region's.
TEST(Verify, SegmentSplitBesideTheVoid) {
  const Input input =
      testing::segments_between({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const auto whole = prepare(input);
  ASSERT_TRUE(whole) << whole.error().message;
  TriangleSoup mesh;
  mesh.points = input.points;
  mesh.points.push_back({0.5, -0x1p-53});
  mesh.triangles = {{0, 4, 1}, {0, 1, 2}, {0, 2, 3}};
  mesh.region = {1, 1, 1};
  mesh.material = {1, 1, 1};
  const VerifyOptions split{.bound = false, .allow_split = true};
  const Verification found = verify_cover(whole->pslg, whole->table, mesh, split);
  EXPECT_TRUE(found.violations.empty()) << found.violations.front().message;
  EXPECT_FALSE(verify_cover(whole->pslg, whole->table, mesh, {.bound = false}).violations.empty());
  mesh.points[4].y = -1e-9;  // no rounding
  EXPECT_FALSE(verify_cover(whole->pslg, whole->table, mesh, split).violations.empty());
}

TEST(Verify, SegmentSplitOnOneSideOnly) {
  Device d;
  (void)cut_interface(d, true);
  const Verification v = d.check({.allow_split = true});
  EXPECT_TRUE(has(v, 2, "no edge of the triangles on the other side")) << all_of(v);
}

TEST(Verify, HangingVertexInside) {
  Device d;
  // Cuts one inner edge on one of its two sides only.
  for (std::size_t k = 0; k < d.mesh.triangles.size(); ++k) {
    auto& t = d.mesh.triangles[k];
    const Point a = d.mesh.points[t[0]], b = d.mesh.points[t[1]];
    const bool inner =
        std::count_if(d.pslg.segments.begin(), d.pslg.segments.end(), [&](const Segment& s) {
          return (s.a.value() == t[0] && s.b.value() == t[1]) ||
                 (s.b.value() == t[0] && s.a.value() == t[1]);
        }) == 0;
    if (!inner) continue;
    const auto middle = static_cast<std::uint32_t>(d.mesh.points.size());
    d.mesh.points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
    d.mesh.triangles.push_back({middle, t[1], t[2]});
    d.mesh.region.push_back(d.mesh.region[k]);
    d.mesh.material.push_back(d.mesh.material[k]);
    d.mesh.triangles[k][1] = middle;
    break;
  }
  EXPECT_TRUE(has(d.check(), 2, "no triangle on its other side"));
}

TEST(Verify, HoleFilled) {
  Device d;
  d.mesh.triangles.push_back({6, 9, 8});
  d.mesh.triangles.push_back({6, 8, 7});
  d.mesh.region.insert(d.mesh.region.end(), {1, 1});
  d.mesh.material.insert(d.mesh.material.end(), {7, 7});
  const Verification v = d.check();
  EXPECT_TRUE(has(v, 2, "lies in the void")) << all_of(v);
}

TEST(Verify, TriangleOutside) {
  Device d;
  d.mesh.points.push_back({3, -3});
  d.mesh.triangles.push_back({0, 15, 1});
  d.mesh.region.push_back(1);
  d.mesh.material.push_back(7);
  const Verification v = d.check();
  EXPECT_TRUE(has(v, 2, "lies in the void")) << all_of(v);
  EXPECT_TRUE(has(v, 2, "no triangle on its other side")) << all_of(v);
}

TEST(Verify, IslandInTheVoid) {
  Device d;
  d.mesh.points.insert(d.mesh.points.end(), {{30, 0}, {31, 0}, {30, 1}});
  d.mesh.triangles.push_back({15, 16, 17});
  d.mesh.region.push_back(1);
  d.mesh.material.push_back(7);
  EXPECT_TRUE(has(d.check(), 2, "hangs together with no segment"));
}

TEST(Verify, InterfaceThatIsNoEdge) {
  Device d;
  // Flips the interface 1-4 into the edge between its two apices.
  std::uint32_t apex[2] = {0, 0};
  std::size_t at[2] = {0, 0};
  for (std::size_t k = 0; k < d.mesh.triangles.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& t = d.mesh.triangles[k];
      if (t[i] == 1 && t[(i + 1) % 3] == 4) apex[0] = t[(i + 2) % 3], at[0] = k;
      if (t[i] == 4 && t[(i + 1) % 3] == 1) apex[1] = t[(i + 2) % 3], at[1] = k;
    }
  }
  d.mesh.triangles[at[0]] = {apex[0], 1, apex[1]};
  d.mesh.triangles[at[1]] = {apex[1], 4, apex[0]};
  const Verification v = d.check();
  EXPECT_TRUE(has(v, 1, "is no edge of the mesh")) << all_of(v);
  EXPECT_TRUE(has(v, 2, "hangs together with triangles of both")) << all_of(v);
}

TEST(Verify, VerticesNotShared) {
  Device d;
  // The second region gets its own copies of the interface's ends.
  d.mesh.points.push_back(d.mesh.points[1]);
  d.mesh.points.push_back(d.mesh.points[4]);
  for (std::size_t k = 0; k < d.mesh.triangles.size(); ++k) {
    if (d.mesh.region[k] != 2) continue;
    for (auto& v : d.mesh.triangles[k]) v = v == 1 ? 15 : v == 4 ? 16 : v;
  }
  const Verification v = d.check();
  EXPECT_TRUE(has(v, 2, "are both at (6, 0)")) << all_of(v);
  EXPECT_TRUE(has(v, 2, "are both at (6, 6)")) << all_of(v);
}

TEST(Verify, WrongMaterialAndRegionId) {
  Device d;
  d.mesh.material[1] = 3;
  EXPECT_TRUE(has(d.check(), 4, "triangle 1 at"));
  EXPECT_EQ(d.check().violation_count, 1U);
  Device swapped;
  swapped.mesh.region[1] = 2;
  EXPECT_TRUE(has(swapped.check(), 2, "RegionId 2"));
  Device merged;
  for (auto& r : merged.mesh.region) r = 1;
  EXPECT_GT(merged.check().violation_count, 0U);
  Device without;
  without.mesh.material.clear();
  EXPECT_TRUE(has(without.check(), 4, "no array of materials"));
  without.mesh.material.assign(3, 7);
  EXPECT_TRUE(has(without.check(), 4, "not one material per triangle"));
}

TEST(Verify, GroupsNeedNotHaveTheNumbersOfMaterials) {
  Device d;
  for (auto& material : d.mesh.material) material = material == 7 ? 1 : 4;
  EXPECT_TRUE(has(d.check(), 4, "has material 1 instead of 7"));
  const VerifyOptions groups{.material_numbers = false};
  EXPECT_EQ(all_of(d.check(groups)), "");
  // A region may be in two groups, but no group in two materials.
  d.mesh.material[0] = 9;
  EXPECT_EQ(all_of(d.check(groups)), "");
  d.mesh.material[0] = 4;
  EXPECT_TRUE(has(d.check(groups), 4, "in region 1 of material 7")) << all_of(d.check(groups));
}

TEST(Verify, SaysWhatItDidNotCheck) {
  Device d;
  EXPECT_TRUE(d.check().unchecked.empty());
  EXPECT_EQ(d.check({.bound = false}).unchecked.size(), 1U);
  EXPECT_EQ(d.check({.materials = false}).unchecked, std::vector<std::string>{"materials"});
  EXPECT_EQ(d.check({.material_numbers = false}).unchecked.size(), 1U);
  EXPECT_EQ(d.check({.allow_split = true}).unchecked.size(), 2U);
  d.mesh.material.clear();
  EXPECT_EQ(d.check({.allow_split = true}).unchecked.size(), 3U);
}

TEST(Verify, RegionIdsCountWhereSegmentsMayBeSplit) {
  Device d;
  (void)cut_interface(d);
  EXPECT_EQ(all_of(d.check({.allow_split = true})), "");
  d.mesh.region[1] = 2;
  EXPECT_TRUE(has(d.check({.allow_split = true}), 2, "RegionId 2"));
}

/// A vertex close to the first edge of triangle `t`, at `share` of it, off it by `e` of the height.
void flatten(Device& d, std::size_t t, double share, double e) {
  const auto v = d.mesh.triangles[t];
  const Point a = d.mesh.points[v[0]], b = d.mesh.points[v[1]], c = d.mesh.points[v[2]];
  const auto steiner = static_cast<std::uint32_t>(d.mesh.points.size());
  const Point foot = a + share * (b - a);
  d.mesh.points.push_back(foot + e * (c - foot));
  d.mesh.triangles[t] = {v[0], v[1], steiner};
  d.mesh.triangles.push_back({v[1], v[2], steiner});
  d.mesh.triangles.push_back({v[2], v[0], steiner});
  d.mesh.region.insert(d.mesh.region.end(), 2, d.mesh.region[t]);
  d.mesh.material.insert(d.mesh.material.end(), 2, d.mesh.material[t]);
}

TEST(Verify, BoundMissed) {
  Device d;
  flatten(d, 0, 0.5, 1e-6);
  const Verification found = d.check();
  EXPECT_TRUE(has(found, 3, "the bound is")) << all_of(found);
  EXPECT_EQ(found.violation_count, 1U);
  EXPECT_EQ(all_of(d.check({.bound = false})), "");
}

/// Where another triangle of the region has a larger angle, by rounding alone.
TEST(Verify, TheAngleToldIsThatOfTheTriangleNamed) {
  Device d;
  flatten(d, 0, 0.5, 1e-2);
  const auto other = static_cast<std::size_t>(
      std::find(d.mesh.region.begin() + 1, d.mesh.region.end(), d.mesh.region[0]) -
      d.mesh.region.begin());
  flatten(d, other, 1e-15, 1e-17);
  const Verification found = d.check();
  const auto v = d.mesh.triangles[0];
  const double nu = least_nu(d.mesh.points[v[0]], d.mesh.points[v[1]], d.mesh.points[v[2]]);
  EXPECT_TRUE(has(found, 3, "triangle 0 with")) << all_of(found);
  EXPECT_TRUE(
      has(found, 3,
          fmt::format("an angle of {:.9g} degrees", Angle::radians(nu).supplement().in_degrees())))
      << all_of(found);
}

TEST(Verify, GarbageIsNamedAndHarmless) {
  Device d;
  d.mesh.triangles.push_back({0, 1, 4000000000U});
  d.mesh.triangles.push_back({2, 2, 3});
  d.mesh.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0});
  d.mesh.points.push_back({std::numeric_limits<double>::infinity(), 0});
  d.mesh.triangles.push_back({0, 1, 15});
  d.mesh.triangles.push_back({0, 1, 16});
  d.mesh.region.insert(d.mesh.region.end(), 4, 1);
  d.mesh.material.insert(d.mesh.material.end(), 4, 7);
  const Verification v = d.check();
  EXPECT_EQ(v.violation_count, 4U) << all_of(v);
  EXPECT_TRUE(has(v, 2, "4000000000"));
}

TEST(Verify, RandomGarbageEndsWithViolations) {
  std::mt19937_64 random(testing::test_seed(7));
  SCOPED_TRACE(testing::seed_trace(testing::test_seed(7)));
  for (int round = 0; round < 200; ++round) {
    Device d;
    for (auto& t : d.mesh.triangles) {
      for (auto& v : t) v = random() % 4 != 0 ? v : std::uint32_t(random() % 18);
    }
    for (const bool split : {false, true}) {
      EXPECT_GT(d.check({.allow_split = split}).violation_count, 0U);
    }
  }
}

TEST(Verify, AtMostTenOfAKindAreListed) {
  Device d;
  for (auto& m : d.mesh.material) m = 99;
  const Verification v = d.check();
  EXPECT_EQ(v.violation_count, d.mesh.triangles.size());
  EXPECT_EQ(v.violations.size(), 10U);
}

/// A hundred thousand triangles, so that work is divided, with every few thousandth one damaged.
TEST(Verify, AnyNumberOfThreadsFindsTheSame) {
  const Input input = testing::checker(40, 12, 1);
  const Result<Prepared> prepared = prepare(input);
  const Result<Output> output = cover_mesh(input);
  ASSERT_TRUE(prepared && output);
  const TriangleSoup good = triangle_soup(output->mesh);
  ASSERT_GT(good.triangles.size(), 70'000U);
  std::mt19937_64 random(testing::test_seed(11));
  SCOPED_TRACE(testing::seed_trace(testing::test_seed(11)));
  for (int round = 0; round < 8; ++round) {
    TriangleSoup mesh = good;
    for (std::size_t k = 0; round > 0 && k < 20; ++k) {
      const std::size_t t = random() % mesh.triangles.size();
      if (round % 4 == 1) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
      if (round % 4 == 2) mesh.triangles[t][2] = std::uint32_t(random() % (mesh.points.size() + 1));
      if (round % 4 == 3) mesh.points[mesh.triangles[t][0]].x += 1e-9;
      if (round % 4 == 0) mesh.region[t] += 1, mesh.material[t] += 1;
    }
    VerifyOptions options{.box_method = true, .threads = 1};
    const Verification one = verify_cover(prepared->pslg, prepared->table, mesh, options);
    EXPECT_EQ(one.violations.empty(), round == 0) << all_of(one);
    for (const unsigned threads : {2U, 3U, 7U}) {
      options.threads = threads;
      const Verification found = verify_cover(prepared->pslg, prepared->table, mesh, options);
      EXPECT_EQ(found.violation_count, one.violation_count);
      EXPECT_EQ(all_of(found), all_of(one));
      EXPECT_EQ(found.segments_whole, one.segments_whole);
      EXPECT_EQ(found.regions, one.regions);
      EXPECT_EQ(found.triangle_regions, one.triangle_regions);
      EXPECT_EQ(found.limits.size(), one.limits.size());
      EXPECT_EQ(found.negative_couplings.size(), one.negative_couplings.size());
    }
  }
}

TEST(Verify, EmptyMeshLacksEverything) {
  Device d;
  d.mesh = {};
  const Verification v = d.check();
  EXPECT_TRUE(has(v, 1, "is no vertex of the mesh"));
  EXPECT_EQ(v.regions, 0U);
}

TEST(Verify, NegativeCouplingsAreListedOnRequestAndNoViolations) {
  Device device;
  EXPECT_TRUE(device.check().negative_couplings.empty());
  VerifyOptions options;
  options.box_method = true;
  Verification found = device.check(options);
  EXPECT_TRUE(found.violations.empty());
  // The plain constrained Delaunay triangulation: sides that a point encroaches, nothing else.
  ASSERT_FALSE(found.negative_couplings.empty());
  for (const NegativeCoupling& c : found.negative_couplings) {
    EXPECT_EQ(c.kind, NegativeCoupling::Kind::encroached);
    EXPECT_GT((c.a.x - c.apex.x) * (c.apex.x - c.b.x) + (c.a.y - c.apex.y) * (c.apex.y - c.b.y), 0);
  }
  EXPECT_GT(found.obtuse, 0U);
  // The square without anything in it, with a vertex too near a side: that is nobody's fault.
  device = {};
  const std::size_t before = found.negative_couplings.size();
  auto& mesh = device.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.region[t] != 2) continue;
    mesh.triangles.erase(mesh.triangles.begin() + long(t));
    mesh.region.erase(mesh.region.begin() + long(t));
    mesh.material.erase(mesh.material.begin() + long(t--));
  }
  const auto v = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({9, 1});
  for (const auto& [a, b] : {std::array{1U, 2U}, {2U, 3U}, {3U, 4U}, {4U, 1U}}) {
    mesh.triangles.push_back({a, b, v});
    mesh.region.push_back(2);
    mesh.material.push_back(3);
  }
  found = device.check(options);
  EXPECT_EQ(found.negative_couplings.size(), before + 1);
  EXPECT_TRUE(
      std::any_of(found.negative_couplings.begin(), found.negative_couplings.end(),
                  [](const NegativeCoupling& c) {
                    return c.kind == NegativeCoupling::Kind::given_up && c.apex == Point{9, 1};
                  }));
}

TEST(Verify, HullSidesMayBeSplit) {
  // A segment in the middle of four points: the domain is their hull.
  Device d;
  d.pslg = {};
  d.table = {};
  d.pslg.points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {3, 4}, {5, 4}};
  d.pslg.segments = {{VertexId{4U}, VertexId{5U}, 0, 0}};
  d.table.sides = {{RegionId{1}, RegionId{1}, kNoInterface}};
  d.table.regions.resize(1);
  d.table.regions[0].id = RegionId{1};
  d.table.regions[0].material = 1;
  d.mesh = {};
  d.mesh.points = d.pslg.points;
  d.mesh.points.push_back({4, 0});  // on a hull side
  d.mesh.triangles = {{0, 6, 4}, {6, 5, 4}, {6, 1, 5}, {1, 2, 5}, {2, 3, 5}, {5, 3, 4}, {3, 0, 4}};
  EXPECT_EQ(all_of(d.check({.hull = true})), "");
  EXPECT_GT(d.check().violation_count, 0U);
  d.mesh.triangles.pop_back();
  EXPECT_GT(d.check({.hull = true}).violation_count, 0U);
}

TEST(Verify, AHullWithoutSegmentsIsOneRegion) {
  Device d;
  d.pslg = {};
  d.table = {};
  d.pslg.points = {{0, 0}, {8, 0}, {0, 8}, {2, 2}};
  for (const auto& [a, b] : {std::pair{0U, 1U}, {1U, 2U}, {2U, 0U}})
    d.table.hull_sides.push_back({VertexId{a}, VertexId{b}, RegionId{1}});
  d.table.regions.resize(1);
  d.table.regions[0].id = RegionId{1};
  d.table.regions[0].material = 1;
  d.mesh = {};
  d.mesh.points = d.pslg.points;
  d.mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_EQ(all_of(d.check({.hull = true})), "");
  d.mesh.triangles.pop_back();
  EXPECT_GT(d.check({.hull = true}).violation_count, 0U);
}

TEST(Verify, ScaledAndShiftedMeshesAreTheSame) {
  for (const double factor : {0x1p-40, 1.0, 0x1p40}) {
    for (const double shift : {0.0, 1024.0}) {
      Device d;
      for (auto* points : {&d.pslg.points, &d.mesh.points}) {
        for (Point& p : *points) p = {(p.x + shift) * factor, (p.y + shift) * factor};
      }
      EXPECT_EQ(all_of(d.check()), "");
    }
  }
}

}  // namespace
}  // namespace cover
