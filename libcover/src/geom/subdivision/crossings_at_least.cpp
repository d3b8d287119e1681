// Tested by tests/unit/geom/subdivision/crossings_at_least_test.cpp.
#include "geom/subdivision/crossings_at_least.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/containers/order.hpp"
#include "base/random.hpp"
#include "geom/box.hpp"
#include "geom/predicates.hpp"

namespace cover {
namespace {

constexpr std::size_t kPairs = std::size_t{1} << 20U;
constexpr std::size_t kEnough = 1000;  // hits
constexpr double kDeviations = 4;

bool are_opposite(Sign a, Sign b) { return a != Sign::zero && b != Sign::zero && a != b; }

bool cross_inside(const PlainSegment& s, const PlainSegment& t) {
  if (!box_of(std::array{s.a, s.b}).meets(box_of(std::array{t.a, t.b}))) return false;
  return are_opposite(orientation(s.a, s.b, t.a), orientation(s.a, s.b, t.b)) &&
         are_opposite(orientation(t.a, t.b, s.a), orientation(t.a, t.b, s.b));
}

}  // namespace

double crossings_at_least(std::span<const PlainSegment> segments) {
  const std::size_t n = segments.size();
  if (n < 2) return 0;
  Random random;
  std::vector<Point> found;
  std::size_t tried = 0;
  for (; tried < kPairs && found.size() < kEnough; ++tried) {
    const PlainSegment &s = segments[random.below(n)], &t = segments[random.below(n)];
    if (cross_inside(s, t)) found.push_back(SweepPoint(s, t).rounded());
  }
  sort_unique(found);
  const auto hits = static_cast<double>(found.size()), all = static_cast<double>(n);
  const double surely = hits - kDeviations * std::sqrt(hits);
  return std::max(0.0, surely * all * all / 2 / static_cast<double>(tried));
}

}  // namespace cover
