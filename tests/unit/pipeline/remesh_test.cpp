// Regions meshed again inside a mesh: with the same options nothing changes; with others all other
// regions stay, bit for bit; a mesh of something else is refused with places and names.
#include <cover/remesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

using testing::must_mesh;
using testing::violations;

using Names = std::vector<std::string>;

void expect_same(const Mesh& a, const Mesh& b) {
  const TriangleSoup x = triangle_soup(a), y = triangle_soup(b);
  EXPECT_EQ(x.points, y.points);
  EXPECT_EQ(x.triangles, y.triangles);
  EXPECT_EQ(x.region, y.region);
  EXPECT_EQ(x.material, y.material);
  for (std::size_t v = 0; v < x.points.size(); ++v) {
    const TriMesh::VertexHandle handle(static_cast<int>(v));
    EXPECT_EQ(a.input_id(handle), b.input_id(handle));
  }
}

/// The corners of the triangles of a region, in their order.
std::vector<std::array<Point, 3>> triangles_of(const TriangleSoup& soup, RegionId region) {
  std::vector<std::array<Point, 3>> list;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (soup.region[t] != region.value()) continue;
    const auto& [a, b, c] = soup.triangles[t];
    list.push_back({soup.points[a], soup.points[b], soup.points[c]});
  }
  return list;
}

Output must_remesh(const Input& input, const Mesh& onto, const Names& only,
                   const Options& options = {}) {
  Result<Output> output = remesh(input, triangle_soup(onto), only, options);
  EXPECT_TRUE(output) << output.error().message;
  return std::move(output).value();
}

TEST(Remesh, WithTheSameOptionsGivesTheSameMesh) {
  const Input input = testing::checker(4, 6, 21);
  for (const Method method : {Method::quality, Method::almond}) {
    Options options;
    options.method = method;
    options.sizes = {{"1", 0.05, false}};
    const Output before = must_mesh(input, options);
    const Output after =
        must_remesh(input, before.mesh, {"region:2", "region:7", "region:16"}, options);
    expect_same(after.mesh, before.mesh);
    ASSERT_EQ(after.report.replaced.size(), 3U);
    EXPECT_EQ(after.report.replaced[1].region, RegionId{7});
    EXPECT_EQ(after.report.replaced[1].triangles, after.report.regions[6].quality.triangles);
    EXPECT_EQ(after.report.replaced[1].steiner_vertices, after.report.regions[6].steiner_vertices);
    for (std::size_t r = 0; r < 16; ++r) {
      const bool again = r == 1 || r == 6 || r == 15;
      EXPECT_EQ(after.report.regions[r].method == "kept", !again);
      EXPECT_EQ(after.report.regions[r].quality.largest_nu,
                before.report.regions[r].quality.largest_nu);
      EXPECT_EQ(after.report.regions[r].nu_opt, before.report.regions[r].nu_opt);
      EXPECT_EQ(after.report.regions[r].bound_held, before.report.regions[r].bound_held);
    }
    EXPECT_EQ(after.report.steiner_vertices, before.report.steiner_vertices);
    EXPECT_EQ(after.report.quality.triangles, before.report.quality.triangles);
  }
}

TEST(Remesh, WithOtherOptionsLeavesAllElse) {
  const Input input = testing::checker(4, 6, 22);
  const Output before = must_mesh(input);
  Options options;
  options.sizes = {{"", 0.02, false}};
  const Output after = must_remesh(input, before.mesh, {"2", "region:1"}, options);
  EXPECT_EQ(violations(after), "");
  const TriangleSoup old = triangle_soup(before.mesh), now = triangle_soup(after.mesh);
  std::size_t replaced = 0;
  for (const Region& region : after.table.regions) {
    const bool again = region.material == 2 || region.id == RegionId{1};
    replaced += again ? 1 : 0;
    EXPECT_EQ(triangles_of(now, region.id) == triangles_of(old, region.id), !again);
  }
  EXPECT_EQ(after.report.replaced.size(), replaced);
  const std::size_t input_points = after.report.input_points;
  EXPECT_TRUE(std::equal(now.points.begin(), now.points.begin() + std::ptrdiff_t(input_points),
                         old.points.begin()));
  // And back again.
  const Output back = must_remesh(input, after.mesh, {"2", "region:1"});
  expect_same(back.mesh, before.mesh);
}

TEST(Remesh, KeepsTheCutsOfTheMesh) {
  const Input input = testing::random_cells(12, 23);
  Options cutting;
  cutting.split_interfaces = Angle::degrees(90);
  const Output before = must_mesh(input, cutting);
  ASSERT_GT(before.pslg.points.size(), before.report.input_points);
  const Output after = must_remesh(input, before.mesh, {"region:5"});
  EXPECT_EQ(after.report.input_points, before.report.input_points);
  EXPECT_EQ(violations(after), "");
  EXPECT_EQ(after.pslg.points, before.pslg.points);
  const TriangleSoup old = triangle_soup(before.mesh), now = triangle_soup(after.mesh);
  for (const Region& region : after.table.regions) {
    if (region.id == RegionId{5}) continue;
    EXPECT_EQ(triangles_of(now, region.id), triangles_of(old, region.id));
  }
  ASSERT_EQ(after.report.notes.size(), 1U);
  EXPECT_NE(after.report.notes[0].message.find("cut as in the mesh"), std::string::npos);
  // Asked to cut, it says that it does not.
  const Output same = must_remesh(input, before.mesh, {"region:5"}, cutting);
  EXPECT_EQ(triangle_soup(same.mesh).points, now.points);
  EXPECT_EQ(same.report.notes.size(), 2U);
}

TEST(Remesh, KeepsTheVerticesOfTheMeshInTheirOrder) {
  const Input input = testing::checker(3, 5, 24);
  const Output before = must_mesh(input);
  const Output after = must_remesh(testing::shuffled(input, 3), before.mesh, {"1"});
  EXPECT_EQ(violations(after), "");
  const TriangleSoup old = triangle_soup(before.mesh), now = triangle_soup(after.mesh);
  for (std::size_t v = 0; v < after.report.input_points; ++v) {
    EXPECT_EQ(now.points[v], old.points[v]);
  }
  EXPECT_EQ(testing::shape_of(now), testing::shape_of(old));
}

/// Two squares; the left one has a slit and an isolated point, a point lies in the void.
Input odd_input() {
  Input input = testing::segments_between(
      {{9, 9}, {0, 0}, {2, 0}, {2, 2}, {0, 2}, {4, 0}, {4, 2}, {1, 1}, {1, 1.5}, {0.5, 0.25}},
      {{1, 2}, {2, 3}, {3, 4}, {4, 1}, {2, 5}, {5, 6}, {6, 3}, {7, 8}});
  for (const auto& [x, name] : {std::pair(0.25, "gate"), std::pair(3.0, "oxide")}) {
    RegionSeed seed;
    seed.at = {x, 1.75};
    seed.material = name;
    input.seeds.push_back(seed);
  }
  return input;
}

TEST(Remesh, SlitsIsolatedPointsAndPointsInTheVoid) {
  const Input input = odd_input();
  const Output before = must_mesh(input);
  for (const char* name : {"gate", "oxide"}) {
    expect_same(must_remesh(input, before.mesh, {name}).mesh, before.mesh);
    Options options;
    options.sizes = {{"", 0.3, false}};
    EXPECT_EQ(violations(must_remesh(input, before.mesh, {name}, options)), "");
  }
}

TEST(Remesh, TheConvexHull) {
  Input input = odd_input();
  Options options;
  options.hull = true;
  options.method = Method::almond;
  const Output before = must_mesh(input, options);
  expect_same(must_remesh(input, before.mesh, {"oxide"}, options).mesh, before.mesh);
}

Error refused(const Input& input, const Mesh& onto, const Names& only,
              const Options& options = {}) {
  const Result<Output> output = remesh(input, triangle_soup(onto), only, options);
  EXPECT_FALSE(output);
  return output ? Error{} : output.error();
}

bool says(const Error& error, const char* what) {
  return error.message.find(what) != std::string::npos;
}

TEST(Remesh, RefusesNamesAndOptions) {
  const Input input = odd_input();
  const Output before = must_mesh(input);
  Error error = refused(input, before.mesh, {"gate", "oxid"});
  EXPECT_EQ(error.code, ErrorCode::bad_option);
  EXPECT_TRUE(says(error, "'oxid'") && says(error, "did you mean 'oxide'?")) << error.message;
  for (const char* name : {"3", "region:3", "region:0", "region:x", ""}) {
    EXPECT_EQ(refused(input, before.mesh, {name}).code, ErrorCode::bad_option) << name;
  }
  EXPECT_EQ(refused(input, before.mesh, {}).code, ErrorCode::bad_option);
  Options options;
  options.method = Method::nonobtuse;
  EXPECT_EQ(refused(input, before.mesh, {"gate"}, options).code, ErrorCode::bad_option);
}

TEST(Remesh, WhatASizeFunctionThrowsIsAnError) {
  const Input input = odd_input();
  const Output before = must_mesh(input);
  Options options;
  options.size_field = [](Point) -> double { throw std::runtime_error("no such table"); };
  const Error error = refused(input, before.mesh, {"gate"}, options);
  EXPECT_EQ(error.code, ErrorCode::bad_option);
  EXPECT_TRUE(says(error, "no such table")) << error.message;
}

TEST(Remesh, RefusesAMeshOfSomethingElse) {
  const Input input = odd_input();
  const Mesh mesh = must_mesh(input).mesh;
  Input moved = input;
  moved.points[6] = {4, 2.5};
  Error error = refused(moved, mesh, {"gate"});
  EXPECT_EQ(error.code, ErrorCode::other_mesh);
  EXPECT_TRUE(says(error, "(4, 2.5) is no vertex of the mesh")) << error.message;
  ASSERT_EQ(error.where.size(), 1U);
  EXPECT_EQ(error.where[0], (Point{4, 2.5}));

  Input further = input;  // a segment more
  InputSegment s;
  s.a = 2;
  s.b = 6;
  further.segments.push_back(s);
  error = refused(further, mesh, {"gate"});
  EXPECT_EQ(error.code, ErrorCode::other_mesh);
  EXPECT_TRUE(says(error, "is no edge of the mesh")) << error.message;

  Input fewer = input;  // without the interface
  fewer.segments.erase(fewer.segments.begin() + 1);
  fewer.seeds.pop_back();
  EXPECT_EQ(refused(fewer, mesh, {"gate"}).code, ErrorCode::other_mesh);
}

TEST(Remesh, RefusesAMeshWithoutARegion) {
  const Input input = odd_input();
  const TriangleSoup half = testing::part_of(triangle_soup(must_mesh(input).mesh), RegionId{1});
  const Result<Output> output = remesh(input, half, Names{"gate"});
  ASSERT_FALSE(output);
  const Error& error = output.error();
  EXPECT_EQ(error.code, ErrorCode::other_mesh);
  EXPECT_TRUE(says(error, "no triangles in region 2 'oxide' were found")) << error.message;
}

TEST(Remesh, RefusesMaterialsOfOtherTriangles) {
  const Input input = odd_input();
  TriangleSoup mesh = triangle_soup(must_mesh(input).mesh);
  mesh.material.pop_back();
  const Result<Output> output = remesh(input, mesh, Names{"gate"});
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::other_mesh);
  EXPECT_TRUE(says(output.error(), "and materials of")) << output.error().message;
  mesh.material.clear();  // not known
  EXPECT_TRUE(remesh(input, mesh, Names{"gate"}));
}

TEST(Remesh, ANearbyPathOfOtherVerticesIsNoCutSegment) {
  // The mesh has one vertex more on the interface, a little beside the segment of the input.
  Input bent = odd_input();
  bent.points.push_back({2 + 1e-9, 1});
  bent.segments[1].b = 10;
  InputSegment s;
  s.a = 10;
  s.b = 3;
  bent.segments.push_back(s);
  const Mesh mesh = must_mesh(bent).mesh;
  EXPECT_EQ(refused(odd_input(), mesh, {"gate"}).code, ErrorCode::other_mesh);
  // On the segment it is taken for a cut.
  bent.points.back() = {2, 1};
  const Mesh cut = must_mesh(bent).mesh;
  expect_same(must_remesh(odd_input(), cut, {"gate"}).mesh, cut);
}

TEST(Remesh, SaysWhereMaterialsDiffer) {
  const Input input = odd_input();
  const Mesh mesh = must_mesh(input).mesh;
  Input other = input;
  other.seeds[1].material = "7";
  const Output after = must_remesh(other, mesh, {"gate"});
  const auto told = [&](std::string_view words) {
    return std::count_if(
        after.report.notes.begin(), after.report.notes.end(),
        [&](const Note& note) { return note.message.find(words) != std::string::npos; });
  };
  EXPECT_EQ(told("1 region"), 1);
  EXPECT_EQ(told("void"), 1);  // of the lone point in it
  EXPECT_EQ(after.report.notes.size(), 2U);
  EXPECT_EQ(violations(after), "");
}

TEST(Remesh, TrianglesOfAnyToolWillDo) {
  // A square cut in two by hand, in an order of its own, and without regions and materials.
  const Input input = testing::segments_between({{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                                {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
  TriangleSoup soup;
  soup.points = {{0.75, 0.25}, {0, 1}, {1, 1}, {0, 0}, {1, 0}, {7, 7}};
  soup.triangles = {{3, 2, 1}, {0, 3, 4}, {2, 3, 0}, {2, 0, 4}};
  Options options;
  options.sizes = {{"", 0.2, false}};
  const Prepared prepared = prepare(input).value();
  const bool lower_first =
      prepared.table.regions[0].inside->x > prepared.table.regions[0].inside->y;
  const Output after =
      remesh(input, soup, Names{lower_first ? "region:2" : "region:1"}, options).value();
  EXPECT_EQ(violations(after), "");
  const auto kept = triangles_of(triangle_soup(after.mesh), RegionId{lower_first ? 1 : 2});
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept[0], (std::array{Point{0.75, 0.25}, Point{0, 0}, Point{1, 0}}));
  const TriangleSoup now = triangle_soup(after.mesh);
  EXPECT_TRUE(std::find(now.points.begin(), now.points.end(), Point{7, 7}) == now.points.end());
}

TEST(Remesh, WhatASizeFunctionThrowsAtAnyCallIsAnError) {
  const Input input = testing::checker(2, 3, 15);
  const TriangleSoup mesh = triangle_soup(must_mesh(input).mesh);
  for (int at = 1;; at = 1 + at * 5 / 4) {
    int calls = 0;
    Options options;
    options.threads = 1;
    options.size_field = [&](Point) -> double {
      if (++calls == at) throw std::runtime_error("no data here");
      return 0.3;
    };
    const Result<Output> output = remesh(input, mesh, Names{"1"}, options);
    if (calls < at) break;
    ASSERT_FALSE(output) << at;
    EXPECT_EQ(output.error().code, ErrorCode::bad_option) << at << output.error().message;
  }
}

TEST(Remesh, StopsWhenAsked) {
  const Input input = testing::checker(10, 6, 15);
  const TriangleSoup mesh = triangle_soup(must_mesh(input).mesh);
  std::stop_source stop;
  Callbacks callbacks;
  callbacks.stop = stop.get_token();
  callbacks.progress = [&](const Progress&) { stop.request_stop(); };
  const Result<Output> output = remesh(input, mesh, Names{"1"}, {}, callbacks);
  ASSERT_FALSE(output);
  EXPECT_EQ(output.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace cover
