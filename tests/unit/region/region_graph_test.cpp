#include "region/region_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/run_all.hpp"
#include "clean/pslg.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

/// Adds a closed loop of segments.
void add_loop(Input& input, const testing::Loop& loop, const std::string& name = "") {
  const auto first = static_cast<std::uint32_t>(input.points.size());
  const auto n = static_cast<std::uint32_t>(loop.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    input.points.push_back(loop[k]);
    const auto id = static_cast<long>(input.segments.size() + 1);
    input.segments.push_back({first + k, first + (k + 1) % n, 0, id, 0, name});
  }
}

testing::Loop square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

RegionSeed seed(Point at, std::string material, long id, std::string region = "") {
  RegionSeed out;
  out.at = at;
  out.material = std::move(material);
  out.region = std::move(region);
  out.id = id;
  return out;
}

struct Found {
  Pslg pslg;
  RegionTable table;
  std::vector<Note> notes;
};

Result<Found> find(const Input& input, const Options& options = {}) {
  Found found;
  Report report;
  auto pslg = make_pslg(input, options, report);
  if (!pslg) return pslg.error();
  found.pslg = std::move(*pslg);
  auto table = build_region_table(found.pslg, options, found.notes);
  if (!table) return table.error();
  found.table = std::move(*table);
  return found;
}

/// Three squares inside each other: outer ring, ring, core.
Input nested() {
  Input input;
  input.source = "nested.poly";
  add_loop(input, square(0, 9));
  add_loop(input, square(1, 8));
  add_loop(input, square(2, 7));
  return input;
}

TEST(BuildRegionTable, FindsNestedFacesAndNamesThem) {
  Input input = nested();
  input.seeds = {seed({4, 4}, "7", 1), seed({0.5, 0.5}, "2", 2, "shell")};
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  const auto& regions = found->table.regions;
  ASSERT_EQ(regions.size(), 3U);
  EXPECT_EQ(regions[0].material, 7);
  EXPECT_EQ(regions[0].name, "material_7");
  EXPECT_EQ(regions[0].area, 25);
  EXPECT_EQ(regions[0].sides, 4U);
  EXPECT_EQ(regions[1].material, 2);
  EXPECT_EQ(regions[1].name, "shell");
  EXPECT_EQ(regions[1].area, 32);
  EXPECT_EQ(regions[1].sides, 8U);
  EXPECT_EQ(regions[2].material, 8);
  EXPECT_EQ(regions[2].material_name, "unnamed");
  EXPECT_EQ(regions[2].area, 24);
}

TEST(BuildRegionTable, HolesAndOutsideAreVoid) {
  Input input = nested();
  input.holes = {{{1.5, 1.5}, 1, 0}, {{20, 20}, 2, 0}};
  input.points.push_back({1.5, 5});  // in the hole
  input.points.push_back({4, 5});    // in the core
  input.points.push_back({30, 5});   // outside
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->table.regions.size(), 2U);
  EXPECT_EQ(found->table.regions[0].area, 32);  // unseeded: in geometric order
  EXPECT_EQ(found->table.regions[0].material, 1);
  EXPECT_EQ(found->table.regions[1].area, 25);
  ASSERT_EQ(found->table.void_points.size(), 2U);
  EXPECT_EQ(found->table.void_points[0], VertexId{12});
  EXPECT_EQ(found->table.void_points[1], VertexId{14});
  EXPECT_EQ(found->notes.back().message,
            "2 points lie in the void and are left out, the first at (1.5, 5)");
  input.point_names = {{13, "in"}, {14, "far"}, {12, "W out"}};
  EXPECT_EQ(find(input)->notes.back().message,
            "2 points lie in the void and are left out, the first, 'W out', at (1.5, 5)");
  ASSERT_EQ(found->table.isolated_points.size(), 1U);
  EXPECT_EQ(found->table.isolated_points[0].vertex, VertexId{13});
  EXPECT_EQ(found->table.isolated_points[0].region, RegionId{2});
  ASSERT_EQ(found->table.void_seeds.size(), 1U);
  const Point v = found->table.void_seeds[0];
  EXPECT_TRUE(v.x > 1 && v.x < 8 && v.y > 1 && v.y < 8 &&
              std::max({2 - v.x, v.x - 7, 2 - v.y, v.y - 7}) > 0);
}

TEST(BuildRegionTable, UnseededFacesAreVoidUnderTheOtherRule) {
  Input input = nested();
  input.void_rule = VoidRule::unseeded_faces;
  EXPECT_EQ(find(input)->table.regions.size(), 3U);
  input.seeds = {seed({4, 4}, "silicon", 1)};
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->table.regions.size(), 1U);
  EXPECT_EQ(found->table.regions[0].name, "silicon");
  EXPECT_EQ(found->table.regions[0].material, 1);
  EXPECT_EQ(found->table.void_seeds.size(), 2U);
  EXPECT_EQ(found->table.void_segments.size(), 8U);
  EXPECT_EQ(found->table.void_points.size(), 8U);
  EXPECT_TRUE(found->notes.empty());
}

TEST(BuildRegionTable, TellsOfFacesThatSeedsMayHaveMissed) {
  Input input = nested();
  input.void_rule = VoidRule::unseeded_faces;
  input.seeds_may_miss = true;
  EXPECT_TRUE(find(input)->notes.empty());  // all are regions
  input.seeds = {seed({4, 4}, "silicon", 1)};
  auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->notes.size(), 1U);
  EXPECT_EQ(found->notes[0].message.find("2 closed faces have neither a region nor a hole given "
                                         "inside, the largest at ("),
            0U);
  ASSERT_EQ(found->notes[0].where.size(), 2U);
  const Point p = found->notes[0].where[0];  // 32 of the outer ring are more than 24 of the other
  EXPECT_TRUE(std::min({p.x, p.y, 9 - p.x, 9 - p.y}) < 1);
  input.holes = {{{0.5, 0.5}, 1, 0}};
  found = find(input);
  ASSERT_EQ(found->notes.size(), 1U);
  EXPECT_EQ(found->notes[0].message.find("1 closed face has neither"), 0U);
  input.holes.push_back({{1.5, 1.5}, 2, 0});
  EXPECT_TRUE(find(input)->notes.empty());
}

TEST(BuildRegionTable, TellsOfFacesThatNoRegionOfAPolyNames) {
  Input input = nested();
  input.seeds_may_miss = true;
  input.seeds = {seed({4, 4}, "silicon", 1)};
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->notes.size(), 1U);
  EXPECT_EQ(found->notes[0].message.find("2 closed faces have no region given inside, the largest "
                                         "at ("),
            0U);
  EXPECT_NE(found->notes[0].message.find(": they are 'unnamed'"), std::string::npos);
}

TEST(BuildRegionTable, NumbersMaterialsByFirstAppearanceAroundGivenNumbers) {
  Input input = nested();
  add_loop(input, square(3, 4));
  add_loop(input, square(5, 6));
  input.seeds = {seed({0.5, 0.5}, "oxide", 1), seed({1.5, 1.5}, "1", 2), seed({2.5, 2.5}, "-3", 3),
                 seed({3.5, 3.5}, "oxide", 4), seed({5.5, 5.5}, "", 5)};
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  std::vector<int> materials;
  for (const Region& r : found->table.regions) materials.push_back(r.material);
  EXPECT_EQ(materials, (std::vector<int>{2, 1, 3, 2, 4}));
  EXPECT_TRUE(std::any_of(found->notes.begin(), found->notes.end(), [](const Note& n) {
    return n.message == "material -3 is no positive integer: it becomes number 3";
  }));
}

TEST(BuildRegionTable, SeparatesInterfacesOutlinesSlitsAndContacts) {
  Input input;
  add_loop(input, square(0, 4));
  input.points.insert(input.points.end(), {{2, 0.5}, {2, 1}, {1, 1}, {1, 3}});
  input.segments.push_back({0, 2, 0, 5, 0, ""});  // the diagonal: an interface
  input.segments.push_back({4, 5, 0, 6, 0, ""});  // a slit below it (2, 0.5)-(2, 1)
  input.segments[2].name = "gate";                // the top
  input.seeds = {seed({3, 1}, "low", 1), seed({1, 3.5}, "high", 2)};
  input.points.resize(6);
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  struct Expected {
    std::string name;
    InterfaceKind kind;
    std::uint32_t left, right;
    double length;
  };
  const std::vector<Expected> expected{{"low_outline", InterfaceKind::outline, 1, 0, 8},
                                       {"low_slit", InterfaceKind::slit, 1, 1, 0.5},
                                       {"low_high", InterfaceKind::interface, 1, 2, std::sqrt(32)},
                                       {"high_outline", InterfaceKind::outline, 2, 0, 4},
                                       {"gate", InterfaceKind::contact, 2, 0, 4}};
  ASSERT_EQ(found->table.interfaces.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Interface& line = found->table.interfaces[k];
    EXPECT_EQ(line.name, expected[k].name);
    EXPECT_EQ(line.kind, expected[k].kind);
    EXPECT_EQ(line.left.value(), expected[k].left);
    EXPECT_EQ(line.right.value(), expected[k].right);
    EXPECT_DOUBLE_EQ(line.length, expected[k].length);
    EXPECT_EQ(line.id.value(), k + 1);
  }
  EXPECT_EQ(found->table.regions[0].sides, 5U);
}

/// What the input calls a contact is the name of nothing else, or solvers put electrodes there.
TEST(BuildRegionTable, NamesOfTheInputAreNoOtherLines) {
  Input input;
  add_loop(input, square(0, 4));
  input.segments.push_back({0, 2, 0, 5, 0, ""});  // the diagonal
  input.segments[0].name = "low_high";            // the bottom
  input.segments[2].name = "high_outline";        // the top
  input.segments[3].name = "high_outline_2";      // the left
  input.seeds = {seed({3, 1}, "low", 1), seed({1, 3.5}, "high", 2)};
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  std::vector<std::string> names;
  for (const Interface& line : found->table.interfaces) {
    names.push_back(line.name);
    EXPECT_EQ(line.kind == InterfaceKind::contact,
              line.name == "low_high" || line.name.starts_with("high_outline"))
        << line.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"low_outline", "low_high", "low_high_2",
                                             "high_outline", "high_outline_2"}));
}

/// Three strips, of which the third is called as the line between the others would be next.
TEST(BuildRegionTable, MadeNamesThatGiveWayAreNoOtherLinesEither) {
  Input input;
  for (int k = 0; k < 3; ++k) {
    const double y = k;
    add_loop(input, {{0, y}, {4, y}, {4, y + 1}, {0, y + 1}});
  }
  input.segments[0].name = "a_b";  // the bottom
  input.seeds = {seed({2, 1.5}, "m", 1, "a"), seed({2, 0.5}, "m", 2, "b"),
                 seed({2, 2.5}, "m", 3, "b_2")};
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  std::set<std::string> names;
  for (const Interface& line : found->table.interfaces)
    EXPECT_TRUE(names.insert(line.name).second) << line.name;
  EXPECT_TRUE(names.contains("a_b") && names.contains("a_b_2") && names.contains("a_b_3"));
}

/// Two pairs of touching squares: a beside b, and further right b beside a.
Input two_pairs() {
  Input input;
  for (const double x : {0.0, 1.0, 5.0, 6.0})
    add_loop(input, {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}});
  input.seeds = {seed({0.5, 0.5}, "a", 1), seed({1.5, 0.5}, "b", 2), seed({5.5, 0.5}, "b", 3),
                 seed({6.5, 0.5}, "a", 4)};
  return input;
}

std::vector<std::string> names_of_interfaces(const RegionTable& table) {
  std::vector<std::string> names;
  for (const Interface& line : table.interfaces) {
    if (line.kind == InterfaceKind::interface) names.push_back(line.name);
  }
  return names;
}

TEST(BuildRegionTable, InterfacesOfTheSameTwoNamesHaveOne) {
  using Names = std::vector<std::string>;
  Input input = two_pairs();
  auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(names_of_interfaces(found->table), (Names{"a_b", "a_b"}));
  // The first gives it.
  for (std::size_t k : {0U, 1U}) std::swap(input.seeds[2 * k], input.seeds[2 * k + 1]);
  found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(names_of_interfaces(found->table), (Names{"b_a", "b_a"}));
  // And both give way alike.
  input.segments[0].name = "b_a";
  found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(names_of_interfaces(found->table), (Names{"b_a_2", "b_a_2"}));
}

TEST(BuildRegionTable, OrdersAnInterfaceAlongItsChain) {
  const Input input = testing::shuffled(testing::input_of(testing::regular_polygon(50)), 3);
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->table.interfaces.size(), 1U);
  const auto& chain = found->table.interfaces[0].segments;
  ASSERT_EQ(chain.size(), 50U);
  const auto end = [&](SegmentId s, bool last) {
    const Segment& segment = found->pslg.segments[s.index()];
    const bool forward = found->table.sides[s.index()].left == RegionId{1};
    return forward == last ? segment.b : segment.a;
  };
  for (std::size_t k = 1; k < chain.size(); ++k) {
    EXPECT_EQ(end(chain[k - 1], true), end(chain[k], false));
  }
}

TEST(BuildRegionTable, RefusesSeedsThatMakeNoSense) {
  const auto refuse = [](Input input, ErrorCode code, const std::string& message) {
    const auto found = find(input);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, code);
    EXPECT_EQ(found.error().message, message);
    EXPECT_FALSE(found.error().where.empty());
    EXPECT_FALSE(found.error().inputs.empty());
  };
  Input input = nested();
  input.seeds = {seed({9.5, 4}, "1", 3)};
  refuse(
      input, ErrorCode::seed_in_void,
      "nested.poly: region seed 3 '1' at (9.5, 4) lies outside of all segments, or what is around "
      "it is open");
  input.holes = {{{4, 4}, 1, 0}};
  input.seeds = {seed({5, 4}, "1", 3)};
  refuse(input, ErrorCode::seed_in_void, "nested.poly: region seed 3 '1' at (5, 4) lies in a hole");
  input = nested();
  input.seeds = {seed({1, 4}, "1", 3)};
  input.seeds[0].line = 40;
  refuse(input, ErrorCode::seed_on_segment,
         "nested.poly: region seed 3 '1' at (1, 4) (line 40) lies on a segment");
  input.seeds = {seed({2, 2}, "1", 3)};
  refuse(input, ErrorCode::seed_on_segment,
         "nested.poly: region seed 3 '1' at (2, 2) lies on a segment");
  input.seeds.clear();
  input.holes = {{{8, 4}, 2, 0}};
  refuse(input, ErrorCode::seed_on_segment, "nested.poly: hole seed 2 at (8, 4) lies on a segment");
  input = nested();
  input.seeds = {seed({4, 4}, "1", 3), seed({5, 5}, "2", 4)};
  refuse(input, ErrorCode::conflicting_seeds,
         "nested.poly: region seed 3 '1' at (4, 4) and region seed 4 '2' at (5, 5) are in the same "
         "face "
         "but disagree on its material");
}

TEST(BuildRegionTable, RefusesWhatEnclosesNothing) {
  Input input;
  input.source = "open.poly";
  input.points = {{0, 0}, {1, 0}, {1, 1}, {2, 5}};
  input.segments = {{0, 1, 0, 1, 0, ""}, {1, 2, 0, 2, 0, ""}};
  EXPECT_EQ(
      find(input).error().message,
      "open.poly: the segments enclose nothing; only one segment ends at point 0 at (0, 0) and "
      "at point 2 at (1, 1); --hull meshes the convex hull around them");
  EXPECT_EQ(find(input).error().where, (std::vector<Point>{{0, 0}, {1, 1}}));
  input.points = {{0, 0}, {1, 1}, {2, 2}};
  EXPECT_EQ(find(input).error().message, "open.poly: all points lie on one line");
  input.points = {{0, 0}, {1, 1}};
  input.segments.pop_back();
  EXPECT_EQ(find(input).error().message, "open.poly: there are fewer than three different points");
  input.points.insert(input.points.end(), {{0, 1e-9}, {1, 1 + 1e-9}});
  input.segments.push_back({2, 3, 0, 2, 0, ""});
  Options weld;
  weld.weld = 1e-6;
  EXPECT_EQ(find(input, weld).error().message,
            "open.poly: there are fewer than three different points after welding (--weld)");
  input = nested();
  input.holes = {{{0.5, 0.5}, 1, 0}, {{1.5, 1.5}, 2, 0}, {{4, 4}, 3, 0}};
  EXPECT_EQ(find(input).error().code, ErrorCode::nothing_enclosed);
  EXPECT_EQ(find(input).error().message, "nested.poly: the hole seeds leave no region");
}

TEST(BuildRegionTable, TakesTheConvexHullOnRequest) {
  Input input;
  input.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {3, 2}};
  input.segments = {{0, 2, 0, 1, 0, ""}, {1, 2, 0, 2, 0, ""}};
  Options hull;
  hull.hull = true;
  const auto found = find(input, hull);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->pslg.segments.size(), 3U);  // cut at the point on the diagonal
  input.points[4] = {1, 2};
  const auto good = find(input, hull);
  ASSERT_TRUE(good) << good.error().message;
  ASSERT_EQ(good->table.regions.size(), 2U);
  EXPECT_EQ(good->table.hull_sides.size(), 3U);
  EXPECT_EQ(good->table.isolated_points.size(), 2U);
  EXPECT_EQ(good->table.regions[0].material_name, "unnamed");
  input.segments.clear();
  const auto points_only = find(input, hull);
  ASSERT_TRUE(points_only) << points_only.error().message;
  EXPECT_EQ(points_only->table.hull_sides.size(), 4U);
  input.points.resize(2);
  EXPECT_EQ(find(input, hull).error().code, ErrorCode::nothing_enclosed);
}

TEST(BuildRegionTable, WarnsOfContactsInTheVoid) {
  Input input;
  add_loop(input, square(0, 4));
  input.points.insert(input.points.end(), {{6, 0}, {6, 4}, {5, 2}});
  input.segments.push_back({4, 5, 0, 4, 0, "lost"});
  input.segments[1].name = "gate";  // the right side
  input.segments.push_back({1, 6, 0, 5, 0, "gate"});
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->notes.size(), 2U);  // their points are no others than theirs
  EXPECT_EQ(found->notes[0].message,
            "'gate' lies in the void with 1 of its 2 segments and is left out there, first from "
            "(4, 0) to (5, 2)");
  EXPECT_EQ(found->notes[1].message,
            "'lost' lies wholly in the void and is left out there, first from (6, 0) to (6, 4)");
}

TEST(BuildRegionTable, WarnsOfNearMisses) {
  Input input;
  input.source = "near.poly";
  add_loop(input, square(0, 4));
  add_loop(input, {{1, 0x1p-30}, {2, 1}, {1, 2}});
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->notes.size(), 1U);
  EXPECT_EQ(found->notes[0].kind, Note::Kind::warning);
  EXPECT_EQ(found->notes[0].message,
            "point 4 at (1, 9.313225746154785e-10) is only 9.31e-10 away from the "
            "segment between point 0 at (0, 0) and point 1 at (4, 0) (--weld closes such gaps)");
  EXPECT_EQ(found->notes[0].where.at(0), (Point{1, 0x1p-30}));
}

TEST(BuildRegionTable, TellsInErrorsThatLinesDoNotQuiteMeet) {
  Input input;
  input.source = "near.poly";
  add_loop(input, square(0, 4));
  input.points.insert(input.points.end(), {{2, 0x1p-30}, {2, 4 - 0x1p-30}});
  input.segments.push_back({4, 5, 0, 9, 0, ""});
  for (const double x : {1.0, 3.0}) {
    input.seeds.emplace_back();
    input.seeds.back().at = {x, 1};
    input.seeds.back().id = static_cast<long>(x);
    input.seeds.back().material = x > 2 ? "b" : "a";
  }
  EXPECT_EQ(
      find(input).error().message,
      "near.poly: region seed 1 'a' at (1, 1) and region seed 3 'b' at (3, 1) are in the same face "
      "but disagree on its material; point 4 at (2, 9.313225746154785e-10) is only "
      "9.31e-10 away from the segment between point 0 at (0, 0) and point 1 at (4, 0), and so "
      "at 1 more place (--weld closes such gaps)");
  input.points[4].y = 1;
  input.points[5].y = 3;
  EXPECT_EQ(
      find(input).error().message,
      "near.poly: region seed 1 'a' at (1, 1) and region seed 3 'b' at (3, 1) are in the same face "
      "but disagree on its material");
}

TEST(BuildRegionTable, WarnsOfAllPointsNearOneLongSegment) {
  Input input;
  add_loop(input, square(0, 8));
  for (int k = 1; k < 8; ++k) {
    const double x = k;
    add_loop(input, {{x, 0x1p-30}, {x + 0.25, 1}, {x - 0.25, 1}});
  }
  const auto found = find(input);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->notes.size(), 7U);
}

/// A line from the left side of a square into it, that begins `gap` away from it.
Input undershoot(double gap) {
  Input input;
  add_loop(input, square(0, 8));
  input.points.insert(input.points.end(), {{gap, 3}, {2, 3}, {4, 4}});
  input.segments.push_back({4, 5, 0, 9, 0, ""});
  input.segments.push_back({5, 6, 0, 10, 0, ""});
  return input;
}

/// The end of a line is no corner of a layer.
TEST(BuildRegionTable, WarnsOfLinesThatEndNearASegment) {
  const auto found = find(undershoot(0x1p-10));
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->notes.size(), 1U);
  EXPECT_EQ(found->notes[0].message,
            "point 4 at (0.0009765625, 3) is only 0.000977 away from the segment between point 3 "
            "at (0, 8) and point 0 at (0, 0): a line ends there (--weld 2e-04 closes such gaps)");
  EXPECT_EQ(find(undershoot(0x1p-30))->notes.size(), 1U);  // once
  EXPECT_TRUE(find(undershoot(0x1p-6))->notes.empty());
  Input corner = undershoot(0x1p-10);
  corner.points[4] = {0x1p-11, 0x1p-11};
  const auto beside = find(corner);
  ASSERT_TRUE(beside) << beside.error().message;
  ASSERT_EQ(beside->notes.size(), 1U);
  EXPECT_EQ(beside->notes[0].message.substr(0, 30), "point 4 at (0.00048828125, 0.0");
  Input chain = undershoot(0x1p-10);  // short segments, of a line that is as long
  chain.points[5] = {0.125, 3};
  EXPECT_EQ(find(chain)->notes.size(), 1U);
}

TEST(BuildRegionTable, DoesNotDependOnScaleOrOrder) {
  const Input input = testing::checker(8, 3, 5);
  const auto base = find(input);
  ASSERT_TRUE(base) << base.error().message;
  ASSERT_EQ(base->table.regions.size(), 64U);
  for (const double factor : {0x1p30, 0x1p-30}) {
    const auto scaled = find(testing::transformed(input, factor));
    ASSERT_TRUE(scaled);
    for (std::size_t k = 0; k < 64; ++k) {
      EXPECT_EQ(scaled->table.regions[k].area, base->table.regions[k].area * factor * factor);
    }
  }
  Input other_order = testing::shuffled(input, 9);
  other_order.seeds = input.seeds;  // whose order is that of the regions
  const auto mixed = find(other_order);
  ASSERT_TRUE(mixed);
  for (std::size_t k = 0; k < 64; ++k) {
    EXPECT_NEAR(mixed->table.regions[k].area, base->table.regions[k].area, 1e-15);
    EXPECT_EQ(mixed->table.regions[k].material, base->table.regions[k].material);
    EXPECT_EQ(mixed->table.regions[k].sides, base->table.regions[k].sides);
  }
}

/// Rings of many points, squares inside them, points near to each other and to a segment.
TEST(BuildRegionTable, IsTheSameForAnyNumberOfThreads) {
  Input input;
  for (int ring = 1; ring <= 3; ++ring) {
    testing::Loop loop;
    for (int k = 0; k < 30'000; ++k) {
      const double turn = 2 * 3.14159265358979 * k / 30'000;
      const double radius = ring + 0.01 * std::sin(40 * turn);
      loop.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    }
    add_loop(input, loop, ring == 2 ? "middle" : "");
  }
  add_loop(input, square(-0.5, 0.5));
  for (const Point p : {Point{0.1, 0.2}, Point{0.1, 0.2 + 1e-9}, Point{0.3, 0.5 - 1e-9}})
    input.points.push_back(p);
  input.seeds = {seed({1.5, 0}, "3", 1), seed({0, 0}, "5", 2)};
  const auto made = [&](const Team& team) {
    Report report;
    std::optional<Triangulation> whole;
    const auto pslg = make_pslg(input, {}, report, &whole, team);
    EXPECT_TRUE(pslg && whole);
    std::vector<Note> notes;
    auto table = build_triangulated_table(*pslg, {}, notes, std::move(whole), team);
    EXPECT_TRUE(table);
    return std::pair(*std::move(table), std::move(notes));
  };
  const auto [alone, notes] = made(Team());
  EXPECT_EQ(alone.table.regions.size(), 4U);
  EXPECT_EQ(alone.table.isolated_points.size(), 3U);
  EXPECT_EQ(alone.triangulated.size(), 4U);
  EXPECT_GE(notes.size(), 2U);
  for (const unsigned workers : {2U, 3U, 7U}) {
    with_team(workers, [&, &alone = alone, &notes = notes](const Team& team) {
      const auto [table, told] = made(team);
      ASSERT_EQ(told.size(), notes.size());
      for (std::size_t k = 0; k < told.size(); ++k) EXPECT_EQ(told[k].message, notes[k].message);
      ASSERT_EQ(table.table.regions.size(), alone.table.regions.size());
      for (std::size_t r = 0; r < alone.table.regions.size(); ++r) {
        const Region &one = table.table.regions[r], &other = alone.table.regions[r];
        EXPECT_EQ(one.area, other.area);
        EXPECT_EQ(one.inside, other.inside);
        EXPECT_EQ(one.sides, other.sides);
      }
      for (std::size_t s = 0; s < alone.table.sides.size(); ++s) {
        ASSERT_EQ(table.table.sides[s].left, alone.table.sides[s].left);
        ASSERT_EQ(table.table.sides[s].right, alone.table.sides[s].right);
        ASSERT_EQ(table.table.sides[s].interface, alone.table.sides[s].interface);
      }
      for (std::size_t k = 0; k < alone.triangulated.size(); ++k)
        EXPECT_EQ(table.triangulated[k].triangles, alone.triangulated[k].triangles);
    });
  }
}

}  // namespace
}  // namespace cover
