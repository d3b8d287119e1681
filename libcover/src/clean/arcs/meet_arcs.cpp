// Tested by tests/unit/clean/arcs/meet_arcs_test.cpp.
#include "clean/arcs/meet_arcs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "clean/arcs/cut_chords.hpp"
#include "clean/arcs/input_edges.hpp"
#include "clean/change_report.hpp"
#include "clean/ends/loose_ends.hpp"
#include "geom/box.hpp"
#include "geom/curves/arc.hpp"
#include "geom/search/box_tree.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kPartOfLine = 1.0 / 8;  ///< as in welding
/// Compared with the lines beside, as of near misses: rounded decimals miss by less.
constexpr double kWorthTelling = 1e-6;
/// Of a chord, and of coordinates, of which 15 digits are right: what is off an arc by no more is
/// on it. The radius does not count, since an arc may be as flat as one likes.
constexpr double kRoundingOfChord = 0x1p-40, kRoundingOfPlace = 0x1p-46;

double rounding_on(const InputChord& chord, Point p) {
  return std::max(kRoundingOfChord * length(chord.b - chord.a),
                  kRoundingOfPlace * largest_coordinate(std::array{chord.a, chord.b, p}));
}

/// An end of lines.
struct EndOfLines {
  Point at;
  double shortest = 0;  ///< of the lines that end there and are longer than rounding, if any is
  friend constexpr auto operator<=>(const EndOfLines&, const EndOfLines&) = default;
};

/// A box around all ends.
Box box_of_ends(const Input& input) {
  Box box;
  for_each_edge(input, [&](Point a, Point b, std::uint32_t, const InputRef&) {
    if (a == b) return;
    box.add(a);
    box.add(b);
  });
  return box;
}

/// All ends, each place once. A corner that is named, and given again as the end of an arc, is an
/// edge no longer than `rounding`: it says nothing of how far the corner may be from a curve.
std::vector<EndOfLines> ends_of(const Input& input, double rounding) {
  std::vector<EndOfLines> ends;
  for_each_edge(input, [&](Point a, Point b, std::uint32_t, const InputRef&) {
    if (a == b) return;
    const double known = length(b - a) > rounding ? length(b - a) : kInfinity;
    ends.push_back({a, known});
    ends.push_back({b, known});
  });
  std::sort(ends.begin(), ends.end());  // of one place the shortest line comes first
  const auto is_same = [](const EndOfLines& e, const EndOfLines& f) { return e.at == f.at; };
  ends.erase(std::unique(ends.begin(), ends.end(), is_same), ends.end());
  return ends;
}

/// What a chord belongs to, and how that is called.
std::string name_of_chord(const Input& input, const InputChord& chord,
                          const ElementOfFile& element) {
  return fmt::format("the arc of {} from {} to {}", describe_element(input, element),
                     describe(chord.a), describe(chord.b));
}

/// The corners of polygons, in order.
std::vector<Point> corners_of(const Input& input) {
  std::vector<Point> corners;
  for (const InputPolygon& polygon : input.polygons) {
    for (const std::vector<Point>& ring : polygon.rings)
      corners.insert(corners.end(), ring.begin(), ring.end());
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// An end on an arc.
struct Meeting {
  double share = 0;  ///< of the way along the arc
  double same = 0;   ///< what is nearer is the same point, and left to welding
  double off = 0;    ///< how far it is from the arc, more than rounding; 0: on it
  Point at;
  friend constexpr auto operator<=>(const Meeting&, const Meeting&) = default;
};

class ArcMeeter {
 public:
  ArcMeeter(const Input& input, double weld) : input_(input), chords_(chords_of(input)) {
    const Box box = box_of_ends(input);
    extent_ = box.extent();
    tolerance_ = weld * extent_;
    const double rounding = box.is_empty() ? 0 : rounding_of(std::array{box.low, box.high});
    welded_ = std::max(tolerance_, rounding);
    ends_ = ends_of(input, rounding);
  }

  /// By chord: the ends that lie on its arc.
  ChordCuts find() {
    std::vector<Box> boxes;
    boxes.reserve(chords_.size());
    for (const InputChord& chord : chords_) {
      boxes.push_back(box_around(chord));
      reach_.push_back(reach_of(chord));
    }
    const BoxTree tree(boxes);
    for (const EndOfLines& end : ends_) {
      tree.visit(box_of(std::array{end.at}), [&](std::uint32_t k) {
        if (may_be_near(end.at, k)) look(end, chords_[k]);
      });
    }
    ChordCuts cuts;
    for (auto& [chord, meetings] : meetings_) {
      std::vector<Point> points = points_along(chord, meetings);
      if (!points.empty()) cuts.emplace(chord, std::move(points));
    }
    return cuts;
  }

  void tell(std::vector<Change>& changes, std::vector<Note>& notes) const {
    tell_cuts(changes);
    if (!too_far_.empty()) {
      const std::string count = too_far_.size() == 1
                                    ? "1 end of a line is"
                                    : fmt::format("{} ends of lines are", too_far_.size());
      notes.push_back({Note::Kind::warning,
                       kVoid,
                       fmt::format("{} within --weld of an arc, but too far off its circle for an "
                                   "end of it, the first at {}: the arc is not bent so far",
                                   count, describe(*too_far_.begin())),
                       {too_far_.begin(), too_far_.end()}});
    }
    if (missed_.empty()) return;
    const auto& [nearest, off] = *missed_.begin();
    std::vector<Point> where;
    double widest = 0;
    for (const auto& [at, away] : missed_) {
      where.push_back(at);
      widest = std::max(widest, away);
    }
    notes.push_back(
        {Note::Kind::warning, kVoid,
         fmt::format("{} close to an arc and not on it, the first at {}, which misses it by {}: {} "
                     "closes such gaps",
                     missed_.size() == 1 ? "1 end of a line is"
                                         : fmt::format("{} ends of lines are", missed_.size()),
                     describe(nearest), describe_roughly(off), weld_closing(widest / extent_)),
         std::move(where)});
  }

 private:
  /// As of straight lines: those that were bent to an end, and those that were split.
  void tell_cuts(std::vector<Change>& changes) const {
    if (bent_.empty() && split_.empty()) return;
    std::map<InputChord, std::vector<ElementOfFile>> elements;
    for_each_edge(input_, [&](Point a, Point b, std::uint32_t circle, const ElementOfFile& ref) {
      const InputChord chord = chord_between(a, b, circle);
      if (bent_.contains(chord) || split_.contains(chord)) elements[chord].push_back(ref);
    });
    for (const auto& [chord, meetings] : bent_) {
      const ElementOfFile& element = elements.at(chord).front();
      for (const Meeting& m : meetings)
        changes.push_back({Change::Kind::welded,
                           fmt::format("{} was bent by {} to the end of a line at {}",
                                       name_of_chord(input_, chord, element),
                                       describe_roughly(m.off), describe(m.at)),
                           {m.at},
                           {element}});
    }
    const std::vector<Point> corners = corners_of(input_);
    for (const auto& [chord, all] : split_) {
      const std::vector<Point>& points = all;
      std::vector<Point> inside = points;  // those at which a side of a polygon counts as split
      std::erase_if(inside,
                    [&](Point p) { return std::binary_search(corners.begin(), corners.end(), p); });
      const auto told = [&](const InputRef& element) -> const std::vector<Point>& {
        // That a polygon's side ends in the middle of another's is what painting is for.
        return element.kind == InputKind::polygon ? inside : points;
      };
      std::vector<ElementOfFile> split = elements.at(chord);
      std::erase_if(split, [&](const InputRef& element) { return told(element).empty(); });
      if (split.empty()) continue;
      const auto line = std::find_if(split.begin(), split.end(), [](const InputRef& element) {
        return element.kind != InputKind::polygon;
      });
      const std::vector<Point>& where = told(line != split.end() ? *line : split.front());
      changes.push_back(
          {Change::Kind::split,
           fmt::format("{} was split at {}", name_of_chord(input_, chord, split.front()),
                       list_of_places(where)),
           where,
           {split.front()}});
    }
  }

  [[nodiscard]] const ArcCircle& circle_of_chord(const InputChord& chord) const {
    return input_.circles[chord.circle - 1];
  }

  /// All that is of interest to the arc over a chord lies in it.
  [[nodiscard]] Box box_around(const InputChord& chord) const {
    return box_around_arc(
        input_, chord,
        tolerance_ + rounding_on(chord, chord.a) + kWorthTelling * length(chord.b - chord.a));
  }

  /// No end that is farther off the chord's circle is of interest, but for rounding. The arc is off
  /// that circle by less than five times what its ends are.
  [[nodiscard]] double reach_of(const InputChord& chord) const {
    const ArcCircle& circle = circle_of_chord(chord);
    const double off =
        std::max(distance_to_circle(circle, chord.a), distance_to_circle(circle, chord.b));
    return 5 * off + tolerance_ + (kWorthTelling + kRoundingOfChord) * length(chord.b - chord.a) +
           kRoundingOfChord * circle.radius;
  }

  /// Boxes around chords of many circles with one centre lie over each other.
  [[nodiscard]] bool may_be_near(Point p, std::uint32_t k) const {
    const InputChord& chord = chords_[k];
    const double largest = largest_coordinate(std::array{chord.a, chord.b, p});
    return distance_to_circle(circle_of_chord(chord), p) <= reach_[k] + kRoundingOfPlace * largest;
  }

  void look(const EndOfLines& end, const InputChord& chord) {
    if (end.at == chord.a || end.at == chord.b) return;
    const ArcOver arc = arc_over(input_, chord);
    const double share = arc.share_of(end.at);
    if (!(share > 0 && share < 1)) return;
    const double off = arc.distance_from_circle(end.at), rounding = rounding_on(chord, end.at);
    const double reach = std::min(std::max(rounding, tolerance_), kPartOfLine * end.shortest);
    const double same = std::min(reach, welded_);
    const double from_end = std::min(length(end.at - chord.a), length(end.at - chord.b));
    if (from_end <= same) return;
    const double near = kWorthTelling * std::min(end.shortest, length(chord.b - chord.a));
    if (off <= reach && is_off_circle(circle_of_chord(chord), end.at)) {
      too_far_.insert(end.at);
    } else if (off <= reach) {
      meetings_[chord].push_back({share, same, off <= rounding ? 0 : off, end.at});
    } else if (off <= near && from_end > near) {  // near misses of two points are told as such
      missed_.emplace(end.at, off);
    }
  }

  /// The ends on one arc, without those that are the same as the one before.
  std::vector<Point> points_along(const InputChord& chord, std::vector<Meeting>& meetings) {
    std::sort(meetings.begin(), meetings.end());
    std::vector<Point> points;
    for (const Meeting& m : meetings) {
      if (!points.empty() && length(m.at - points.back()) <= m.same) continue;
      points.push_back(m.at);
      if (m.off > 0) {
        bent_[chord].push_back(m);
      } else {
        split_[chord].push_back(m.at);
      }
    }
    return points;
  }

  const Input& input_;
  std::vector<InputChord> chords_;
  std::vector<double> reach_;  ///< by chord
  std::vector<EndOfLines> ends_;
  double extent_ = 0;  ///< of the drawing
  double tolerance_ = 0;
  double welded_ = 0;  ///< ends that are nearer to each other become one after this
  std::map<InputChord, std::vector<Meeting>> meetings_;
  std::map<InputChord, std::vector<Meeting>> bent_;
  std::map<InputChord, std::vector<Point>> split_;
  std::map<Point, double> missed_;
  std::set<Point> too_far_;  ///< within the tolerance, but is_off_circle()
};

}  // namespace

std::optional<Input> meet_arcs(const Input& input, double weld, std::vector<Change>& changes,
                               std::vector<Note>& notes) {
  if (input.circles.empty()) return std::nullopt;
  ArcMeeter meeter(input, weld);
  const ChordCuts cuts = meeter.find();
  meeter.tell(changes, notes);
  if (cuts.empty()) return std::nullopt;
  return cut_chords(input, cuts);
}

}  // namespace cover
