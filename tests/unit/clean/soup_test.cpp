// Whole soups: random ones, and their areas beside an independent exact overlay.
// COVER_LONG_SOUPS=n makes the random tests try n soups of each kind instead of a few hundred.
#include <gtest/gtest.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "cdt/cdt.hpp"
#include "geom/vector.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/soups.hpp"

namespace cover {
namespace {

using testing::add_polygon;
using testing::clean;
using testing::Cleaned;
using testing::rectangle;

std::uint64_t soup_count() { return testing::cases_asked_for("COVER_LONG_SOUPS", 150); }

/// Points and segments meet only at points, and every named side exists.
void expect_valid(const Cleaned& out) {
  std::vector<IndexPair> pairs;
  for (const Segment& s : out.pslg.segments) pairs.push_back({s.a.value(), s.b.value()});
  ASSERT_TRUE(triangulate_hull(out.pslg.points, pairs).conflicts.empty());
  auto sorted = out.pslg.points;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
  const auto boundaries = split_regions(out.pslg, out.table);
  double whole = 0, parts = 0;
  for (const RegionBoundary& b : boundaries) {
    whole += testing::area_of(b);
    parts += out.table.region(b.id).area;
    ASSERT_FALSE(b.sides.empty());
  }
  double size = 0;
  for (const Point& p : out.pslg.points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  ASSERT_NEAR(whole, parts, 1e-9 * parts + 1e-12 * size * size);
}

void add_segment(Input& input, Point a, Point b) {
  InputSegment s;
  s.a = static_cast<std::uint32_t>(input.points.size());
  s.b = s.a + 1;
  s.id = static_cast<long>(input.segments.size());
  input.points.insert(input.points.end(), {a, b});
  input.segments.push_back(s);
}

/// What a generator of random inputs draws from.
struct Dice {
  std::mt19937_64 random;
  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
};

Input crossing_segments(Dice& dice) {
  Input input;
  for (const Point p : {Point{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}) input.points.push_back(p);
  for (std::uint32_t k = 0; k < 4; ++k) {
    input.segments.emplace_back();
    input.segments.back().a = k;
    input.segments.back().b = (k + 1) % 4;
  }
  for (int k = dice.whole(1, 25); k > 0; --k) {
    add_segment(input, {dice.real(0, 1), dice.real(0, 1)}, {dice.real(0, 1), dice.real(0, 1)});
  }
  return input;
}

/// Segments and points on a coarse grid: everything coincides.
Input grid_segments(Dice& dice) {
  Input input = crossing_segments(dice);
  for (Point& p : input.points) p = {std::round(p.x * 4), std::round(p.y * 4)};
  for (int k = dice.whole(0, 5); k > 0; --k) {
    input.points.push_back({double(dice.whole(0, 4)), double(dice.whole(0, 4))});
  }
  return input;
}

Input grid_rectangles(Dice& dice) {
  Input input;
  for (int k = dice.whole(1, 12); k > 0; --k) {
    const int x = dice.whole(0, 5), y = dice.whole(0, 5);
    add_polygon(input, rectangle(x, y, x + dice.whole(1, 4), y + dice.whole(1, 4)),
                "m" + std::to_string(dice.whole(0, 3)));
  }
  return input;
}

/// Rectangles whose corners miss the grid by about 1e-12, in all three ways of being ordered.
Input near_rectangles(Dice& dice) {
  Input input = grid_rectangles(dice);
  for (InputPolygon& p : input.polygons) {
    for (Point& q : p.rings[0])
      q = {q.x + dice.real(-1e-12, 1e-12), q.y + dice.real(-1e-12, 1e-12)};
  }
  return input;
}

/// Rings of random points: self-intersecting in every way.
Input wild_rings(Dice& dice) {
  Input input;
  const double cell = dice.whole(0, 1) == 0 ? 0 : 0.125;
  for (int k = dice.whole(1, 4); k > 0; --k) {
    testing::Loop ring;
    for (int n = dice.whole(3, 12); n > 0; --n) {
      Point p{dice.real(0, 1), dice.real(0, 1)};
      if (cell > 0) p = {std::round(p.x / cell) * cell, std::round(p.y / cell) * cell};
      ring.push_back(p);
    }
    add_polygon(input, ring, "m" + std::to_string(k));
  }
  return input;
}

/// Lines through the same few points of one line, so that they overlap in every way.
Input collinear_segments(Dice& dice) {
  Input input = grid_rectangles(dice);
  const Point a{dice.real(-1, 1), dice.real(-1, 1)};
  const Point step = dice.whole(0, 1) == 0 ? Point{0.25, 0.5} : Point{dice.real(0, 1), 0.3};
  const auto at = [&](int k) { return Point{a.x + k * step.x, a.y + k * step.y}; };
  for (int k = dice.whole(2, 60); k > 0; --k) {
    add_segment(input, at(dice.whole(0, 12)), at(dice.whole(0, 12)));
  }
  return input;
}

/// Copies of the same few segments that miss each other by 1e-12.
Input near_segments(Dice& dice) {
  Input input = crossing_segments(dice);
  const auto copies = static_cast<std::uint32_t>(input.segments.size());
  for (int k = dice.whole(1, 4); k > 0; --k) {
    for (std::uint32_t s = 0; s < copies; ++s) {
      const auto moved = [&](std::uint32_t v) {
        const Point p = input.points[v];
        return Point{p.x + dice.real(-1e-12, 1e-12), p.y + dice.real(-1e-12, 1e-12)};
      };
      add_segment(input, moved(input.segments[s].a), moved(input.segments[s].b));
    }
  }
  return input;
}

/// Segments through one point, exactly or nearly, or that end there.
Input pencil(Dice& dice) {
  Input input;
  const Point centre{dice.real(-1, 1), dice.real(-1, 1)};
  for (int k = dice.whole(3, 80); k > 0; --k) {
    const Point p{dice.whole(-8, 8) / 8.0, dice.real(-1, 1)};
    const double beyond = dice.whole(0, 3) == 0 ? 0 : dice.real(0, 2);
    add_segment(input, p,
                {centre.x + beyond * (centre.x - p.x), centre.y + beyond * (centre.y - p.y)});
  }
  return input;
}

/// Triangles with an edge through one point, exactly or nearly, lines through it, and points at it.
Input pencil_of_triangles(Dice& dice) {
  Input input;
  const Point centre{dice.real(-1, 1), dice.real(-1, 1)};
  const auto beyond = [&](Point p, double part) {
    return Point{centre.x + part * (centre.x - p.x), centre.y + part * (centre.y - p.y)};
  };
  for (int k = dice.whole(2, 25); k > 0; --k) {
    const Point p{dice.whole(-8, 8) / 8.0, dice.real(-1, 1)};
    const Point q = beyond(p, dice.whole(0, 3) == 0 ? 0 : dice.real(0, 2));
    add_polygon(input, {p, q, {dice.real(-1, 1), dice.real(-1, 1)}},
                "m" + std::to_string(dice.whole(0, 3)));
  }
  for (int k = dice.whole(0, 20); k > 0; --k) {
    const Point p{dice.real(-1, 1), dice.real(-1, 1)};
    if (dice.whole(0, 1) == 0) {
      add_segment(input, p, beyond(p, dice.real(0, 2)));
    } else {
      input.points.push_back({centre.x + dice.whole(-4, 4) * 0x1p-53, centre.y});
    }
  }
  return input;
}

/// Segments and points on a lattice of a few units in the last place.
Input lattice_of_doubles(Dice& dice) {
  Input input;
  const int size = dice.whole(2, 40);
  const double unit = std::ldexp(1, -52 + dice.whole(0, 3));
  const Point centre{dice.whole(0, 1) == 0 ? 1 : dice.real(0.5, 2), dice.real(0.01, 8)};
  const auto point = [&] {
    const double step = dice.whole(0, 3) == 0 ? 1000 * unit : unit;
    return Point{centre.x + step * dice.whole(-size, size),
                 centre.y + step * dice.whole(-size, size)};
  };
  for (int k = dice.whole(3, 60); k > 0; --k) {
    const Point a = point();
    add_segment(input, a, point());
  }
  for (int k = dice.whole(0, 9); k > 0; --k) input.points.push_back(point());
  return input;
}

/// Star polygons, bow ties, rings run round twice and spikes.
Input twisted_rings(Dice& dice) {
  Input input;
  for (int k = dice.whole(1, 5); k > 0; --k) {
    const int n = dice.whole(3, 11), step = dice.whole(1, n - 1), rounds = dice.whole(1, 3);
    const double size = dice.whole(1, 4), turn = dice.whole(0, 1) == 0 ? 0 : dice.real(0, 6);
    testing::Loop ring;
    for (int i = 0; i < rounds * n; ++i) {
      const double angle = turn + 2 * std::numbers::pi * (i * step % n) / n;
      ring.push_back({size * std::cos(angle), size * std::sin(angle)});
      if (dice.whole(0, 9) == 0) ring.push_back(ring[ring.size() / 2]);
    }
    add_polygon(input, ring, "m" + std::to_string(dice.whole(0, 2)));
  }
  return input;
}

/// Polygons beside segments, points on and off them, and seeds anywhere.
Input mixture(Dice& dice) {
  Input input = dice.whole(0, 1) == 0 ? grid_rectangles(dice) : near_rectangles(dice);
  for (int k = dice.whole(0, 9); k > 0; --k) {
    add_segment(input, {dice.whole(0, 18) / 2.0, dice.whole(0, 18) / 2.0},
                {dice.real(0, 9), dice.whole(0, 9) * 1.0});
  }
  for (int k = dice.whole(0, 9); k > 0; --k) {
    input.points.push_back({dice.whole(0, 36) / 4.0, dice.whole(0, 36) / 4.0});
  }
  for (int k = dice.whole(0, 2); k > 0; --k) {
    RegionSeed seed;
    seed.at = {dice.real(0, 9), dice.real(0, 9)};
    seed.material = dice.whole(0, 1) == 0 ? "" : "seeded";
    input.seeds.push_back(seed);
  }
  if (dice.whole(0, 3) == 0) input.holes.push_back({{dice.real(0, 9), dice.real(0, 9)}, 1, 0});
  return input;
}

/// Whatever the others make, with exponents from one end of the doubles to the other.
Input vast_range(Dice& dice) {
  Input input = dice.whole(0, 1) == 0 ? wild_rings(dice) : grid_segments(dice);
  const int most = std::array{1020, 250, 250, 60}[static_cast<std::size_t>(dice.whole(0, 3))];
  const auto stretch = [&](Point& p) {
    p = {std::ldexp(p.x, dice.whole(-most, most)), std::ldexp(p.y, dice.whole(-most, most))};
  };
  for (Point& p : input.points) stretch(p);
  for (InputPolygon& polygon : input.polygons) {
    for (Point& p : polygon.rings[0]) stretch(p);
  }
  return input;
}

struct Kind {
  const char* name;
  Input (*make)(Dice&);
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

class RandomSoup : public ::testing::TestWithParam<Kind> {};

TEST_P(RandomSoup, BecomesAPslg) {
  const std::uint64_t seed = testing::test_seed(21);
  SCOPED_TRACE(testing::seed_trace(seed));
  Dice dice{std::mt19937_64(seed)};
  for (std::uint64_t k = 0; k < soup_count(); ++k) {
    SCOPED_TRACE("soup " + std::to_string(k));
    const auto out = clean(GetParam().make(dice));
    if (!out) {
      // No other reason to refuse a soup: seeds at random may contradict it, vast ones be too vast.
      const std::set<ErrorCode> right{ErrorCode::nothing_enclosed, ErrorCode::seed_in_void,
                                      ErrorCode::seed_on_segment, ErrorCode::conflicting_seeds,
                                      ErrorCode::coordinate_out_of_range};
      ASSERT_TRUE(right.contains(out.error().code)) << out.error().message;
      continue;
    }
    ASSERT_NO_FATAL_FAILURE(expect_valid(*out));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, RandomSoup,
    ::testing::Values(
        Kind{"crossing_segments", &crossing_segments}, Kind{"grid_segments", &grid_segments},
        Kind{"grid_rectangles", &grid_rectangles}, Kind{"near_rectangles", &near_rectangles},
        Kind{"wild_rings", &wild_rings}, Kind{"collinear_segments", &collinear_segments},
        Kind{"near_segments", &near_segments}, Kind{"pencil", &pencil},
        Kind{"twisted_rings", &twisted_rings}, Kind{"mixture", &mixture},
        Kind{"vast_range", &vast_range}, Kind{"pencil_of_triangles", &pencil_of_triangles},
        Kind{"lattice_of_doubles", &lattice_of_doubles}),
    [](const auto& test) { return test.param.name; });

TEST(Soup, SizesOfPolygons) {
  Input input;
  add_polygon(input, rectangle(0, 0, 2, 2), "Si", "bulk").size = 0.5;
  add_polygon(input, rectangle(2, 0, 4, 2), "Si", "bulk").size = 0.25;
  add_polygon(input, rectangle(4, 0, 6, 2), "Si", "other");
  add_polygon(input, rectangle(0, 2, 6, 3), "Ox").size = 0.125;
  add_polygon(input, rectangle(1, 2, 2, 3), "Me");  // hides some of it
  const auto sizes = [&](const Options& options) {
    std::map<std::string, std::optional<double>> out;
    const Result<Cleaned> cleaned = clean(input, options);
    EXPECT_TRUE(cleaned);
    for (const Region& region : cleaned->table.regions) out[region.name] = region.size;
    return out;
  };
  using Sizes = std::map<std::string, std::optional<double>>;
  EXPECT_EQ(sizes({}),
            (Sizes{{"bulk", 0.25}, {"other", std::nullopt}, {"Ox", 0.125}, {"Me", std::nullopt}}));
  Options merge;
  merge.merge_materials = true;
  EXPECT_EQ(sizes(merge).at("bulk"), 0.25);
  // A seed over a polygon may wish smaller ones, and takes the polygon's place with its own.
  input.seeds.push_back({{1, 1}, "Si", "", 0.125, 0, 0});
  input.seeds.push_back({{5, 1}, "Si", "", 2.0, 1, 0});
  input.seeds.push_back({{0.5, 2.5}, "Air", "", std::nullopt, 2, 0});
  const Sizes seeded = sizes({});
  EXPECT_EQ(seeded.at("bulk"), 0.125);
  EXPECT_EQ(seeded.at("other"), 2.0);
  EXPECT_EQ(seeded.at("Air"), std::nullopt);
}

TEST(Soup, ThousandsOfSegmentsThroughOnePoint) {
  Input input;
  constexpr int kSegments = 4000;
  for (int k = 0; k < kSegments; ++k) {
    const Point p{1, double(k - kSegments / 2) / kSegments};
    add_segment(input, p, {-p.x, -p.y});
  }
  const auto out = clean(input);
  EXPECT_EQ(out.error().code, ErrorCode::nothing_enclosed);
  add_segment(input, {1, -1}, {1, 1});
  add_segment(input, {-1, -1}, {-1, 1});
  const auto wheel = clean(input);
  ASSERT_TRUE(wheel) << wheel.error().message;
  EXPECT_EQ(wheel->table.regions.size(), 2U * (kSegments - 1));
  ASSERT_NO_FATAL_FAILURE(expect_valid(*wheel));
}

/// Scaled by a power of two everything is the same; shifted exactly the connectivity is.
TEST(Soup, DoesNotDependOnUnitOrOrigin) {
  Dice dice{std::mt19937_64(testing::test_seed(22))};
  for (int k = 0; k < 20; ++k) {
    const Input input = crossing_segments(dice);
    const auto base = clean(input), up = clean(testing::transformed(input, 0x1p30)),
               down = clean(testing::transformed(input, 0x1p-30));
    ASSERT_TRUE(base && up && down);
    ASSERT_EQ(up->pslg.points.size(), base->pslg.points.size());
    ASSERT_EQ(up->pslg.segments.size(), base->pslg.segments.size());
    for (std::size_t v = 0; v < base->pslg.points.size(); ++v) {
      ASSERT_EQ(up->pslg.points[v].x, base->pslg.points[v].x * 0x1p30);
      ASSERT_EQ(down->pslg.points[v].y, base->pslg.points[v].y * 0x1p-30);
    }
    const Input grid = grid_rectangles(dice);
    Input shifted = grid;
    for (InputPolygon& p : shifted.polygons) {
      for (Point& q : p.rings[0]) q = {q.x + 1048576, q.y - 524288};
    }
    const auto here = clean(grid), there = clean(shifted);
    ASSERT_TRUE(here && there);
    ASSERT_EQ(here->pslg.side_seeds, there->pslg.side_seeds);
  }
}

namespace exact {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Set = CGAL::Polygon_set_2<Kernel>;

double area(const Set& set) {
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
  set.polygons_with_holes(std::back_inserter(parts));
  Kernel::FT sum = 0;
  for (const auto& part : parts) {
    sum += part.outer_boundary().area();
    for (auto h = part.holes_begin(); h != part.holes_end(); ++h) sum += h->area();
  }
  return CGAL::to_double(sum);
}

/// Paints simple polygons one over the other.
std::map<std::string, Set> paint(const Input& input) {
  std::map<std::string, Set> out;
  for (const InputPolygon& p : input.polygons) {
    Polygon polygon;
    for (const Point& q : p.rings[0]) polygon.push_back(Kernel::Point_2(q.x, q.y));
    if (polygon.is_clockwise_oriented()) polygon.reverse_orientation();
    for (auto& [material, set] : out) set.difference(polygon);
    out[p.material].join(polygon);
  }
  return out;
}

}  // namespace exact

TEST(Soup, PaintsTheAreasOfAnExactOverlay) {
  const std::uint64_t seed = testing::test_seed(23);
  SCOPED_TRACE(testing::seed_trace(seed));
  Dice dice{std::mt19937_64(seed)};
  for (int k = 0; k < 40; ++k) {
    Input input;
    for (int n = dice.whole(2, 8); n > 0; --n) {
      const Point centre{dice.real(0, 2), dice.real(0, 2)};
      testing::Loop ring = testing::random_star(dice.whole(3, 14), 0.3, dice.random, centre);
      if (dice.whole(0, 1) == 0) ring = testing::reversed(ring);
      add_polygon(input, ring, "m" + std::to_string(dice.whole(0, 3)));
    }
    const auto out = clean(input);
    ASSERT_TRUE(out) << out.error().message;
    for (const auto& [material, set] : exact::paint(input)) {
      ASSERT_NEAR(out->area(material), exact::area(set), 1e-12) << material << " of soup " << k;
    }
  }
}

TEST(Soup, PaintsTheAreasOfAnExactOverlayWhereEdgesMeetNearlyInAPoint) {
  const std::uint64_t seed = testing::test_seed(24);
  SCOPED_TRACE(testing::seed_trace(seed));
  Dice dice{std::mt19937_64(seed)};
  for (int k = 0; k < 40; ++k) {
    const Input input = pencil_of_triangles(dice);
    const auto out = clean(input);
    ASSERT_TRUE(out) << out.error().message;
    for (const auto& [material, set] : exact::paint(input)) {
      ASSERT_NEAR(out->area(material), exact::area(set), 1e-12) << material << " of soup " << k;
    }
  }
}

TEST(Soup, PaintedAndFlattenedFormsHaveTheSameAreas) {
  const double ox = 1.2e-3;
  Input painted, flat;
  add_polygon(painted, rectangle(-1, -2, 11, 3), "air");
  add_polygon(painted, rectangle(0, -2, 10, 0), "Si");
  add_polygon(painted, rectangle(1, -0.5, 3, 0), "n");
  add_polygon(painted, rectangle(7, -0.5, 9, 0), "n");
  add_polygon(painted, rectangle(2, 0, 8, ox), "SiO2");
  add_polygon(painted, rectangle(2.7, -0.1, 7.3, ox), "SiO2");
  add_polygon(painted, rectangle(3, ox, 7, 1), "gate");
  add_polygon(flat,
              {{-1, -2},
               {0, -2},
               {0, 0},
               {2, 0},
               {2, ox},
               {3, ox},
               {3, 1},
               {7, 1},
               {7, ox},
               {8, ox},
               {8, 0},
               {10, 0},
               {10, -2},
               {11, -2},
               {11, 3},
               {-1, 3}},
              "air");
  add_polygon(flat,
              {{0, -2},
               {10, -2},
               {10, 0},
               {9, 0},
               {9, -0.5},
               {7, -0.5},
               {7, -0.1},
               {3, -0.1},
               {3, -0.5},
               {1, -0.5},
               {1, 0},
               {0, 0}},
              "Si");
  add_polygon(flat, {{1, -0.5}, {3, -0.5}, {3, -0.1}, {2.7, -0.1}, {2.7, 0}, {1, 0}}, "n");
  add_polygon(flat, {{7, -0.5}, {9, -0.5}, {9, 0}, {7.3, 0}, {7.3, -0.1}, {7, -0.1}}, "n");
  add_polygon(flat,
              {{2, 0}, {2.7, 0}, {2.7, -0.1}, {7.3, -0.1}, {7.3, 0}, {8, 0}, {8, ox}, {2, ox}},
              "SiO2");
  add_polygon(flat, {{3, ox}, {7, ox}, {7, 1}, {3, 1}}, "gate");
  const auto one = clean(painted), other = clean(flat);
  ASSERT_TRUE(one && other);
  for (const char* material : {"air", "Si", "n", "SiO2", "gate"}) {
    EXPECT_GT(one->area(material), 0);
    EXPECT_NEAR(one->area(material), other->area(material), 1e-12) << material;
  }
}

TEST(Soup, ACornerOnTheSideOfAnotherPolygonIsNoChange) {
  Input input;
  add_polygon(input, rectangle(0, 0, 2, 2), "a");
  add_polygon(input, rectangle(2, 0, 3, 1), "b");
  Options strict;
  strict.strict = true;
  const auto out = clean(input, strict);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->report.changes.empty());
  EXPECT_TRUE(out->report.notes.empty());
  // A contact has no corners to end at: where it meets a side, the side is split.
  input.lines = {{"probe", {{-1, 1}, {1, 1}}, 1}};
  EXPECT_FALSE(clean(input, strict));
}

TEST(Soup, ReportsSplitsWherePolygonsCross) {
  Input input;
  input.source = "t.json";
  add_polygon(input, rectangle(0, 0, 2, 2), "a");
  add_polygon(input, rectangle(1, 0, 3, 1), "b");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  // They cross: the edges of both are split.
  ASSERT_EQ(out->report.changes.size(), 2U);
  const auto found =
      std::find_if(out->report.changes.begin(), out->report.changes.end(), [](const Change& c) {
        return c.message == "the edge of polygon 1 'a' from (2, 0) to (2, 2) was split at (2, 1)";
      });
  ASSERT_NE(found, out->report.changes.end());
  const Change& change = *found;
  EXPECT_EQ(change.kind, Change::Kind::split);
  EXPECT_EQ(change.where, (std::vector<Point>{{2, 1}}));
  ASSERT_EQ(change.inputs.size(), 1U);
  EXPECT_EQ(change.inputs[0].id, 1);
  EXPECT_TRUE(out->tells("2 split: the edge"));
  Options strict;
  strict.strict = true;
  const auto refused = clean(input, strict);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::changed_input);
  EXPECT_NE(refused.error().message.find(change.message), std::string::npos);
}

TEST(Soup, NeedsNoChangeForSharedBordersThatAgree) {
  Input input;
  add_polygon(input, rectangle(0, 0, 1, 1), "a");
  add_polygon(input, testing::reversed(rectangle(1, 0, 2, 1)), "b");
  Options strict;
  strict.strict = true;
  const auto out = clean(input, strict);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.interfaces.size(), 3U);
}

TEST(Soup, KeepsContactsThroughEverything) {
  Input input;
  add_polygon(input, rectangle(0, 0, 4, 4), "Si");
  add_polygon(input, rectangle(1, 3, 3, 5), "metal");
  input.lines = {{"gate", {{0.5, 4}, {3.5, 4}}, 1}, {"probe", {{1, 1}, {2, 2}, {3, 1}}, 2}};
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  double gate = 0, probe = 0;
  for (const Interface& line : out->table.interfaces) {
    if (line.name == "gate") gate += line.length;
    if (line.name == "probe") probe += line.length;
    if (line.name == "gate" || line.name == "probe") {
      EXPECT_EQ(line.kind, InterfaceKind::contact);
    }
  }
  EXPECT_DOUBLE_EQ(gate, 3);
  EXPECT_DOUBLE_EQ(probe, 2 * std::sqrt(2));
}

TEST(Soup, KeepsNamesOfPointsThroughEverything) {
  Input input;
  add_polygon(input, rectangle(0, 0, 4, 4), "Si");
  add_polygon(input, rectangle(1, 3, 3, 5), "metal");
  input.points = {{2, 3.5}, {1, 3}, {0.5, 0.5}, {2, 3.5}};
  input.point_names = {{3, "spring"}, {0, "well"}, {1, "corner"}, {2, "well"}};
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  ASSERT_EQ(out->pslg.named_points.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const NamedPoint& named = out->pslg.named_points[k];
    EXPECT_EQ(named.name, input.point_names[k].name);
    EXPECT_EQ(out->pslg.points[named.vertex.index()], input.points[input.point_names[k].point]);
  }
}

TEST(Soup, WarnsOfContactsOnOneSegment) {
  Input input;
  add_polygon(input, rectangle(0, 0, 4, 4), "Si");
  input.lines = {{"gate", {{0, 4}, {3, 4}}, 1}, {"drain", {{1, 4}, {2, 4}}, 2}};
  input.lines.push_back({"gate", {{2, 4}, {4, 4}}, 3});
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->tells(
      "'drain' and 'gate' both lie on 1 segment, first from (1, 4) to (2, 4): there 'gate' "
      "counts"));
  input.lines[1].points = {{4, 0}, {4, 1}};
  EXPECT_FALSE(clean(input)->tells("both lie on"));
  input.lines[1].points = {{2, 4}, {2, 4}};
  EXPECT_TRUE(clean(input)->tells("the line 'drain' at (2, 4) has length zero"));
}

TEST(Soup, LinesNameWhatSegmentsHaveAnotherNameFor) {
  Input input = testing::input_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  for (std::uint32_t k = 0; k < 4; ++k)
    input.segments.push_back({k, (k + 1) % 4, 0, k, 0, "frame"});
  input.lines = {{"outside", {{0, 0}, {2, 0}}, 1}, {"cold", {{1, 0}, {4, 0}}, 2}};
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  std::map<std::string, double> lengths;
  for (const Segment& s : out->pslg.segments)
    lengths[out->pslg.names[s.name]] +=
        length(out->pslg.points[s.b.index()] - out->pslg.points[s.a.index()]);
  EXPECT_EQ(lengths, (std::map<std::string, double>{{"cold", 2}, {"frame", 12}, {"outside", 2}}));
  EXPECT_TRUE(out->tells("'frame' and 'outside' both lie on 2 segments"));
  EXPECT_TRUE(out->tells("'frame' and 'cold' both lie on 1 segment,"));
  EXPECT_TRUE(out->tells("'cold' and 'outside' both lie on 1 segment,"));
}

TEST(Soup, TellsWhatItDoesToSegments) {
  Input input = testing::input_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  input.points.push_back({0, 0});
  input.points.push_back({2, 0});
  input.segments.push_back({0, 1, 0, 50, 0, ""});
  input.segments.push_back({2, 2, 0, 51, 0, ""});
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->pslg.points.size(), 5U);
  EXPECT_EQ(out->pslg.segments.size(), 5U);
  EXPECT_TRUE(out->tells("point 4 at (0, 0) and point 0 have the same coordinates"));
  EXPECT_TRUE(out->tells("segment 50 from point 0 to point 1 is the same as segment"));
  EXPECT_TRUE(out->tells("segment 51 from point 2 to point 2 at (4, 4) has length zero"));
  EXPECT_TRUE(out->tells("was split at (2, 0)"));
}

TEST(Soup, MergesFacesOfEqualMaterialInAPslg) {
  Input input = testing::checker(3, 1, 4);
  for (RegionSeed& s : input.seeds) s.material = "Si";
  input.seeds[4].material = "core";
  Options merge;
  merge.merge_materials = true;
  const auto out = clean(input, merge);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 2U);
  EXPECT_NEAR(out->area("Si") + out->area("core"), 1, 1e-12);
}

TEST(Soup, MergesFacesOfOneMaterialHoweverItsNumberIsSpelled) {
  Input input = testing::checker(3, 1, 4);
  for (RegionSeed& s : input.seeds) s.material = "7";
  input.seeds[0].material = "7.0";
  input.seeds[5].material = "07";
  input.seeds[4].material = "70";
  Options merge;
  merge.merge_materials = true;
  const auto out = clean(input, merge);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 2U);
}

TEST(Soup, NamedBordersThatAreNotMergedAreTold) {
  Input input = testing::checker(3, 1, 4);
  for (RegionSeed& s : input.seeds) s.material = "Si";
  for (InputSegment& s : input.segments) {
    const Point a = input.points[s.a], b = input.points[s.b];
    if (a.x == b.x && a.x > 0.2 && a.x < 0.5) s.name = "border";
  }
  Options merge;
  merge.merge_materials = true;
  const auto out = clean(input, merge);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 2U);
  EXPECT_TRUE(
      out->tells("3 segments have one material on both sides and stay for the name, so "
                 "regions are not merged there: the first, 'border', is from ("));
  EXPECT_FALSE(clean(input)->tells("stay for the name"));
  for (InputSegment& s : input.segments) s.name = "";
  EXPECT_FALSE(clean(input, merge)->tells("stay for the name"));
}

/// A frame of two polygons around a gap, the right one cut in two by a line.
Input frame_and_line() {
  Input input;
  input.source = "x.json";
  add_polygon(input, rectangle(0, 0, 6, 4), "a", "left");
  input.polygons[0].rings.push_back({{1, 1}, {2, 1}, {2, 3}, {1, 3}});
  add_polygon(input, rectangle(4, 0, 6, 4), "b");
  input.lines = {{"", {{4, 2}, {6, 2}}, 1}};
  return input;
}

RegionSeed seed_at(Point at, std::string material) {
  RegionSeed seed;
  seed.at = at;
  seed.material = std::move(material);
  return seed;
}

TEST(Soup, SeedsWinOverPolygons) {
  Input input = frame_and_line();
  input.seeds = {seed_at({5, 3}, "c"), seed_at({1.5, 2}, "gas"), seed_at({3, 3}, "")};
  input.seeds[2].size = 0.25;
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_DOUBLE_EQ(out->area("a"), 14);
  EXPECT_DOUBLE_EQ(out->area("b"), 4);
  EXPECT_DOUBLE_EQ(out->area("c"), 4);
  EXPECT_DOUBLE_EQ(out->area("gas"), 2);
  ASSERT_EQ(out->table.regions.size(), 4U);
  const auto left = std::find_if(out->table.regions.begin(), out->table.regions.end(),
                                 [](const Region& r) { return r.name == "left"; });
  ASSERT_NE(left, out->table.regions.end());
  EXPECT_EQ(left->size, 0.25);
  Options merge;
  merge.merge_materials = true;
  input.seeds[0].material = "b";
  const auto merged = clean(input, merge);
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_EQ(merged->table.regions.size(), 3U);
  EXPECT_DOUBLE_EQ(merged->area("b"), 8);
}

TEST(Soup, HoleSeedsMakeFacesOfPolygonsVoid) {
  Input input = frame_and_line();
  input.holes = {{{5, 1}, 7, 0}, {{1.5, 2}, 8, 0}};
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_DOUBLE_EQ(out->area("a"), 14);
  EXPECT_DOUBLE_EQ(out->area("b"), 4);
  EXPECT_EQ(out->table.void_seeds.size(), 2U);
}

TEST(Soup, RefusesSeedsThatContradictEachOtherBesidePolygons) {
  Input input = frame_and_line();
  input.seeds = {seed_at({9, 9}, "c")};
  EXPECT_EQ(clean(input).error().code, ErrorCode::seed_in_void);
  input.seeds = {seed_at({5, 2}, "c")};
  EXPECT_EQ(clean(input).error().code, ErrorCode::seed_on_segment);
  input.seeds = {seed_at({5, 3}, "c"), seed_at({5, 3.5}, "d")};
  EXPECT_EQ(clean(input).error().code, ErrorCode::conflicting_seeds);
  input.seeds = {seed_at({5, 3}, "c")};
  input.holes = {{{5, 3.5}, 7, 0}};
  EXPECT_EQ(clean(input).error().code, ErrorCode::seed_in_void);
}

TEST(Soup, RefusesInfiniteCorners) {
  Input input;
  input.source = "x.json";
  add_polygon(input, rectangle(0, 0, 1, 1), "a");
  input.polygons[0].rings[0][1].x = HUGE_VAL;
  EXPECT_EQ(clean(input).error().message,
            "x.json: the corner at (inf, 0) of polygon 1 is not finite");
}

TEST(Soup, HasNothingToSayOfPolygonsWithoutArea) {
  Input input;
  input.source = "x.json";
  add_polygon(input, {{0, 0}, {1, 1}}, "line");
  EXPECT_EQ(clean(input).error().code, ErrorCode::nothing_enclosed);
  EXPECT_EQ(clean(input).error().message,
            "x.json: no polygon covers anything; polygon 1 'line' has fewer than three different "
            "corners");
  add_polygon(input, rectangle(2, 2, 3, 3), "a");
  const auto out = clean(input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_TRUE(out->tells("polygon 1 'line' has fewer than three different corners"));
  EXPECT_FALSE(out->tells("covered by others"));
  EXPECT_FALSE(out->tells("has no inside"));
  EXPECT_EQ(out->pslg.points.size(), 4U);
}

}  // namespace
}  // namespace cover
