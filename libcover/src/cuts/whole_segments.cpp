// Tested by tests/unit/cuts/whole_segments_test.cpp.
#include "cuts/whole_segments.hpp"

#include <cmath>

#include "geom/curves/arc.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Spacings of doubles from its line: a place so near stays; one so far at most was taken there by
/// rounding. What is farther off lies on an arc, whose pieces leave its chord.
constexpr double kOnLine = 2, kFarthestRounded = 16;

Point back_on_line(Point a, Point b, Point p) {
  const Vector along = b - a;
  const double off = cross(along, p - a) / length(along);
  const double spacing = spacing_of(std::array{a, b});
  if (std::abs(off) <= kOnLine * spacing || std::abs(off) > kFarthestRounded * spacing) return p;
  return p + (off / length(along)) * Vector{along.y, -along.x};
}

}  // namespace

WholeSegments::WholeSegments(const Pslg& pslg, std::size_t uncut_points) {
  const std::vector<Segment>& segments = pslg.segments;
  ends_.reserve(segments.size());
  for (std::size_t s = 0; s < segments.size();) {
    std::size_t last = s;  // pieces of a segment are consecutive
    while (segments[last].b.index() >= uncut_points && last + 1 < segments.size()) ++last;
    const std::array<Point, 2> ends{pslg.points[segments[s].a.index()],
                                    pslg.points[segments[last].b.index()]};
    for (; s <= last; ++s) {
      ends_.push_back(ends);
      is_chord_.push_back(circle_of(pslg, segments[s]) != nullptr ? 1 : 0);
    }
  }
}

Point WholeSegments::on_whole(SegmentId s, Point p) const {
  const auto [a, b] = ends_[s.index()];
  return is_chord_[s.index()] != 0 ? p : back_on_line(a, b, p);
}

}  // namespace cover
