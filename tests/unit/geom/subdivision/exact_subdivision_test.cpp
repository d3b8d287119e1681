#include "geom/subdivision/exact_subdivision.hpp"

#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <set>

#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using Piece = std::pair<Point, Point>;

/// The different pieces of all segments, sorted.
std::vector<Piece> pieces_of(const std::vector<PlainSegment>& segments) {
  const Subdivision cuts = subdivide(segments);
  std::vector<Piece> out;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto path = cuts.path_of(s);
    EXPECT_EQ(cuts.nodes[path.front()], std::min(segments[s].a, segments[s].b));
    EXPECT_EQ(cuts.nodes[path.back()], std::max(segments[s].a, segments[s].b));
    for (std::size_t k = 1; k < path.size(); ++k) {
      EXPECT_LT(path[k - 1], path[k]);
      out.emplace_back(cuts.nodes[path[k - 1]], cuts.nodes[path[k]]);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

TEST(Subdivide, CutsAtCrossingsAndTouches) {
  const std::vector<PlainSegment> cross{{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}, {{2, 1}, {1, 1}}};
  const Point c{1, 1};
  EXPECT_EQ(pieces_of(cross),
            (std::vector<Piece>{{{0, 0}, c}, {{0, 2}, c}, {c, {2, 0}}, {c, {2, 1}}, {c, {2, 2}}}));
}

TEST(Subdivide, CutsOverlapsAtTheSamePlaces) {
  const std::vector<PlainSegment> overlap{{{0, 0}, {2, 0}}, {{3, 0}, {1, 0}}, {{1, 0}, {2, 0}}};
  EXPECT_EQ(pieces_of(overlap),
            (std::vector<Piece>{{{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}, {{2, 0}, {3, 0}}}));
}

TEST(Subdivide, RoundsIntersectionsToTheNearestDouble) {
  // The line y = x and the line from (0, 1) to (3, 0) meet at 3/4; y = x and the line from (0, 1)
  // to (2, 0) at 2/3, which is no double.
  const std::vector<PlainSegment> lines{{{0, 0}, {1, 1}}, {{0, 1}, {3, 0}}, {{0, 1}, {2, 0}}};
  const std::vector<Point> nodes = subdivide(lines).nodes;
  const double third = 2.0 / 3;  // division rounds to nearest
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), Point{third, third}), 1);
  EXPECT_EQ(std::count(nodes.begin(), nodes.end(), Point{0.75, 0.75}), 1);
}

TEST(Subdivide, TakesWhatIsNextToAnEndForTheNearestEnd) {
  // They cross at 1 - 2^-53, a double, and one unit in the last place from the end of the first.
  const std::vector<PlainSegment> lines{{{0, 0}, {1, 1}}, {{0, 2}, {2, -0x1p-51}}};
  EXPECT_EQ(pieces_of(lines),
            (std::vector<Piece>{
                {{0, 0}, {1, 1}}, {{0, 2}, {1, 1}}, {{1, 1}, {1, 1}}, {{1, 1}, {2, -0x1p-51}}}));
}

namespace witness {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

double nearest(const Kernel::FT& lazy) {
  const auto exact = lazy.exact();
  const double d = CGAL::to_double(exact);  // one of the two doubles beside it
  const double other = std::nextafter(d, exact > d ? HUGE_VAL : -HUGE_VAL);
  return CGAL::abs(exact - d) <= CGAL::abs(exact - other) ? d : other;
}

/// Every segment cut at what it has in common with each of the others.
std::vector<Piece> pieces_of(const std::vector<PlainSegment>& segments) {
  std::vector<Kernel::Segment_2> lines;
  for (const PlainSegment& s : segments) {
    lines.emplace_back(Kernel::Point_2(s.a.x, s.a.y), Kernel::Point_2(s.b.x, s.b.y));
  }
  std::vector<Piece> out;
  for (const Kernel::Segment_2& line : lines) {
    std::set<Kernel::Point_2> stops{line.source(), line.target()};
    for (const Kernel::Segment_2& other : lines) {
      const auto common = CGAL::intersection(line, other);
      if (!common) continue;
      if (const auto* p = boost::get<Kernel::Point_2>(&*common)) {
        stops.insert(*p);
      } else {
        const auto& shared = boost::get<Kernel::Segment_2>(*common);
        stops.insert({shared.source(), shared.target()});
      }
    }
    std::vector<Point> rounded;
    for (const Kernel::Point_2& p : stops) {
      rounded.push_back({nearest(p.x()), nearest(p.y())});
    }
    for (std::size_t k = 1; k < rounded.size(); ++k) out.emplace_back(rounded[k - 1], rounded[k]);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace witness

/// Segments with ends on a grid of n cells a side, so that much coincides; n = 0: anywhere.
std::vector<PlainSegment> random_segments(int count, int n, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto coordinate = [&] {
    return n == 0 ? uniform(random) : std::floor(uniform(random) * n);
  };
  std::vector<PlainSegment> out;
  while (static_cast<int>(out.size()) < count) {
    const PlainSegment s{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (s.a != s.b) out.push_back(s);
  }
  return out;
}

TEST(Subdivide, AgreesWithAllPairs) {
  const std::uint64_t seed = testing::test_seed(31);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    const int cells = std::array{0, 3, 6, 20}[static_cast<std::size_t>(k % 4)];
    const auto segments = random_segments(4 + k / 6, cells, random);
    ASSERT_EQ(pieces_of(segments), witness::pieces_of(segments));
  }
}

}  // namespace
}  // namespace cover
