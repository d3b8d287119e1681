// Chords are known again by the very coordinates of their ends, which cleaning keeps wherever it
// leaves a line whole.
// Tested by tests/unit/clean/remember_arcs_test.cpp.
#include "clean/remember_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/complaint.hpp"
#include "clean/arcs/cut_chords.hpp"
#include "clean/arcs/input_edges.hpp"
#include "clean/ends/loose_ends.hpp"
#include "clean/ends/near_points.hpp"
#include "geom/box.hpp"
#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kBesideChord = 0x1p-40;  ///< of a chord: a piece of it is as near

/// Calls `f` with the ends and the circle of every chord, and the element that it belongs to.
template <class F>
void for_each_chord(const Input& input, F f) {
  for_each_edge(input, [&](Point a, Point b, std::uint32_t circle, const InputRef& ref) {
    if (circle != 0) f(a, b, circle, ref);
  });
}

using Ends = std::pair<Point, Point>;          ///< the smaller first
using Chords = std::map<Ends, std::uint32_t>;  ///< and the number of their circle

/// Finds segments by ends that lie near theirs: within rounding, or as far as welding moves them.
class NearlyEqual {
 public:
  NearlyEqual(const Pslg& pslg, double weld)
      : points_(pslg.points),
        rounding_(rounding_of(pslg.points)),
        most_(std::max(rounding_, weld)),
        near_points_(pslg.points, most_, [](std::uint32_t) { return true; }) {
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      const Point a = pslg.points[pslg.segments[s].a.index()];
      const Point b = pslg.points[pslg.segments[s].b.index()];
      segments_.emplace(std::minmax(a, b), Found{s, pslg.segments[s].circle != 0});
    }
  }

  [[nodiscard]] std::optional<std::size_t> segment(const Ends& ends) const {
    const double part = length(ends.second - ends.first) / kWeldedPart;
    const double reach = std::max(rounding_, std::min(most_, part));
    const std::vector<Point> near_first = near(ends.first, reach);
    const std::vector<Point> near_second = near(ends.second, reach);
    for (const Point a : near_first) {
      for (const Point b : near_second) {
        const auto found = segments_.find(std::minmax(a, b));
        if (found == segments_.end()) continue;
        // The chord of another arc may run along this one; but what is still where it was drawn
        // was not united with it.
        const bool was_moved = (a == ends.first || near_first[0] != ends.first) &&
                               (b == ends.second || near_second[0] != ends.second);
        if (!found->second.is_chord || was_moved) return found->second.segment;
      }
    }
    return std::nullopt;
  }

 private:
  struct Found {
    std::size_t segment = 0;
    bool is_chord = false;  ///< already known as one
  };

  /// The nearest first.
  [[nodiscard]] std::vector<Point> near(Point p, double reach) const {
    std::vector<Point> out;
    near_points_.visit(p, [&](std::uint32_t v) {
      if (length(points_[v] - p) <= reach) out.push_back(points_[v]);
    });
    std::sort(out.begin(), out.end(), [&](Point a, Point b) {
      const double to_a = squared_length(a - p), to_b = squared_length(b - p);
      return to_a != to_b ? to_a < to_b : a < b;
    });
    return out;
  }

  /// Welding moves an end by an eighth of the lines there at most; this leaves room for two welds
  /// and takes no piece of a chord for it.
  static constexpr double kWeldedPart = 4;

  std::span<const Point> points_;
  double rounding_;
  double most_;
  NearPoints near_points_;
  std::map<Ends, Found> segments_;
};

/// Whether a segment of `pslg` runs along the chord ab from one of its ends.
class PieceFinder {
 public:
  explicit PieceFinder(const Pslg& pslg) : pslg_(pslg) {
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      for (const VertexId v : {pslg.segments[s].a, pslg.segments[s].b})
        at_.emplace(pslg.points[v.index()], s);
    }
  }

  [[nodiscard]] bool has_piece(Point a, Point b) const {
    for (const auto& [end, other] : {std::pair(a, b), std::pair(b, a)}) {
      const auto [first, last] = at_.equal_range(end);
      for (auto k = first; k != last; ++k) {
        const Segment& s = pslg_.segments[k->second];
        const Point p = pslg_.points[s.a.index()], q = pslg_.points[s.b.index()];
        const Vector along = other - end, step = (p == end ? q : p) - end;
        if (dot(along, step) > 0 && length(step) < length(along) &&
            std::abs(cross(along, step)) <= kBesideChord * squared_length(along))
          return true;
      }
    }
    return false;
  }

 private:
  const Pslg& pslg_;
  std::multimap<Point, std::size_t> at_;
};

}  // namespace

std::optional<Error> find_bad_arcs(const Input& input) {
  Complaint range(ErrorCode::id_out_of_range, input.source);
  Complaint off(ErrorCode::coordinate_out_of_range, input.source);
  for_each_chord(input, [&](Point a, Point b, std::uint32_t number, InputRef ref) {
    const std::string name = fmt::format("{} {}", describe_kind(ref.kind), ref.id);
    if (number > input.circles.size()) {
      range.add(fmt::format("{} is a chord of a circle that does not exist", name), {a, b}, {ref});
      return;
    }
    const ArcCircle& circle = input.circles[number - 1];
    const bool is_circle = std::isfinite(circle.centre.x) && std::isfinite(circle.centre.y) &&
                           std::isfinite(circle.radius) && circle.radius > 0;
    if (!is_circle) {
      off.add(fmt::format("{} is a chord of a circle about {} with the radius {}", name,
                          describe(circle.centre), circle.radius),
              {a, b}, {ref});
      return;
    }
    for (const Point end : {a, b}) {
      if (!is_off_circle(circle, end)) continue;
      off.add(
          fmt::format("the end {} of an arc of {} is off its circle about {} with the radius {} "
                      "by {}",
                      describe(end), name, describe(circle.centre), describe(circle.radius),
                      describe_roughly(distance_to_circle(circle, end))),
          {end}, {ref});
    }
  });
  if (!range.empty()) return range.error();
  if (!off.empty()) return off.error();
  return std::nullopt;
}

void remember_arcs(const Input& input, double weld, Pslg& pslg, std::vector<Note>& notes) {
  if (input.circles.empty()) return;
  pslg.circles = input.circles;
  Chords chords;
  for_each_chord(input, [&](Point a, Point b, std::uint32_t circle, InputRef) {
    if (is_short_enough(input.circles[circle - 1], a, b)) chords.emplace(std::minmax(a, b), circle);
  });
  for (Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    s.circle = 0;
    const auto found = chords.find(std::minmax(a, b));
    if (found == chords.end()) continue;
    s.circle = found->second;
    chords.erase(found);
  }
  if (chords.empty()) return;
  Box box;  // lone points do not count for welding either
  for (const Segment& s : pslg.segments) {
    for (const VertexId v : {s.a, s.b}) box.add(pslg.points[v.index()]);
  }
  const NearlyEqual nearly_equal(pslg, weld * box.extent());
  std::erase_if(chords, [&](const Chords::value_type& chord) {
    const auto segment = nearly_equal.segment(chord.first);
    if (!segment) return false;
    Segment& s = pslg.segments[*segment];
    const ArcCircle& circle = pslg.circles[chord.second - 1];
    const auto is_off = [&](VertexId v) { return is_off_circle(circle, pslg.points[v.index()]); };
    if (is_off(s.a) || is_off(s.b)) return false;
    if (s.circle == 0) s.circle = chord.second;
    return true;
  });
  const PieceFinder pieces(pslg);
  std::vector<Point> where;
  for (const auto& [ends, circle] : chords) {
    if (pieces.has_piece(ends.first, ends.second))
      where.push_back(midpoint(ends.first, ends.second));
  }
  if (where.empty()) return;
  const std::size_t count = where.size();
  constexpr std::size_t kPlacesTold = 8;
  std::string message = fmt::format(
      "{} of arcs, the first at {}, {} cut or touched by other lines; the pieces stay straight",
      counted(count, "chord"), describe(where[0]), count == 1 ? "is" : "are");
  where.resize(std::min(count, kPlacesTold));
  notes.push_back({Note::Kind::warning, kVoid, std::move(message), std::move(where)});
}

}  // namespace cover
