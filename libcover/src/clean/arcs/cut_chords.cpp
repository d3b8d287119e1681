// Tested by tests/unit/clean/arcs/meet_arcs_test.cpp.
#include "clean/arcs/cut_chords.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/containers/order.hpp"
#include "clean/arcs/input_edges.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Puts points between the ends of chords.
class ChordCutter {
 public:
  ChordCutter(const Input& input, const ChordCuts& cuts)
      : cuts_(cuts),
        has_straight_cuts_(std::any_of(cuts.begin(), cuts.end(),
                                       [](const auto& cut) { return cut.first.circle == 0; })),
        out_(input) {}

  Input cut() {
    cut_segments();
    for (InputPolygon& polygon : out_.polygons) {
      polygon.circles.resize(polygon.rings.size());
      for (std::size_t r = 0; r < polygon.rings.size(); ++r)
        cut_path(polygon.rings[r], polygon.circles[r], true);
    }
    for (InputLine& line : out_.lines) cut_path(line.points, line.circles, false);
    return std::move(out_);
  }

 private:
  /// The points between a and b, in this order.
  [[nodiscard]] std::vector<Point> between(Point a, Point b, std::uint32_t circle) const {
    const auto found = cuts_.find(chord_between(a, b, circle));
    if (found == cuts_.end()) return {};
    std::vector<Point> points = found->second;
    if (b < a) std::reverse(points.begin(), points.end());
    return points;
  }

  void cut_segments() {
    std::vector<InputSegment> segments;
    segments.reserve(out_.segments.size());
    for (InputSegment& s : out_.segments) {
      InputSegment piece = s;
      for (const Point p : between(out_.points[s.a], out_.points[s.b], s.circle)) {
        piece.b = index_of(p);
        segments.push_back(piece);
        piece.a = piece.b;
      }
      piece.b = s.b;
      segments.push_back(std::move(piece));
    }
    out_.segments = std::move(segments);
  }

  void cut_path(std::vector<Point>& points, std::vector<std::uint32_t>& circles, bool is_closed) {
    if (circles.empty() && !has_straight_cuts_) return;
    circles.resize(points.size());
    std::vector<Point> whole;
    std::vector<std::uint32_t> circle_of;
    for (std::size_t k = 0; k < points.size(); ++k) {
      whole.push_back(points[k]);
      circle_of.push_back(circles[k]);
      if (k + 1 == points.size() && !is_closed) continue;
      const Point next = points[k + 1 < points.size() ? k + 1 : 0];
      for (const Point p : between(points[k], next, circles[k])) {
        whole.push_back(p);
        circle_of.push_back(circles[k]);
      }
    }
    points = std::move(whole);
    circles = std::move(circle_of);
  }

  /// A point of the input at this place, or a new one.
  std::uint32_t index_of(Point p) {
    if (indices_.empty()) {
      for (std::size_t k = 0; k < out_.points.size(); ++k)
        indices_.emplace(out_.points[k], static_cast<std::uint32_t>(k));
    }
    const auto next = static_cast<std::uint32_t>(out_.points.size());
    const auto [at, is_new] = indices_.emplace(p, next);
    if (!is_new) return at->second;
    out_.points.push_back(p);
    if (!out_.point_ids.empty()) out_.point_ids.push_back(-1);
    if (!out_.point_lines.empty()) out_.point_lines.push_back(0);
    if (!out_.point_markers.empty()) out_.point_markers.push_back(0);
    return next;
  }

  const ChordCuts& cuts_;
  bool has_straight_cuts_;
  Input out_;
  std::map<Point, std::uint32_t> indices_;
};

}  // namespace

InputChord chord_between(Point a, Point b, std::uint32_t circle) {
  return a < b ? InputChord{a, b, circle} : InputChord{b, a, circle};
}

bool is_short_enough(const ArcCircle& circle, Point a, Point b) {
  constexpr double kLongestChord = 1.8;  // of the radius; of 120 degrees it is 1.73
  return a != b && length(b - a) < kLongestChord * circle.radius;
}

std::vector<InputChord> chords_of(const Input& input) {
  std::vector<InputChord> chords;
  for_each_edge(input, [&](Point a, Point b, std::uint32_t circle, const InputRef&) {
    if (circle != 0 && is_short_enough(input.circles[circle - 1], a, b))
      chords.push_back(chord_between(a, b, circle));
  });
  sort_unique(chords);
  return chords;
}

ArcOver arc_over(const Input& input, const InputChord& chord) {
  return {input.circles[chord.circle - 1], chord.a, chord.b};
}

Box box_around_arc(const Input& input, const InputChord& chord, double more) {
  const Point middle = arc_over(input, chord).middle();
  const double away = length(middle - midpoint(chord.a, chord.b)) + more;
  Box box = box_of(std::array{chord.a, chord.b});
  box.low = box.low + Vector{-away, -away};
  box.high = box.high + Vector{away, away};
  return box;
}

Input cut_chords(const Input& input, const ChordCuts& cuts) {
  return ChordCutter(input, cuts).cut();
}

}  // namespace cover
