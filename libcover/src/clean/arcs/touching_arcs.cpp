// Why the doubles of circles tell: a drawing means that circles touch, but its centres and radii
// are rounded, so that they miss each other or overlap by some units in the last place. Ends that
// miss each other by as little are one, so circles are, too. Where they touch is known far worse:
// circles that overlap by e cross at places that are some sqrt(e r) apart, 1e-8 of the radius. Any
// point between these is as near to both as rounding, so one of them is taken, on both arcs the
// same; an end that lies there before all others.
// Tested by tests/unit/clean/arcs/touching_arcs_test.cpp.
#include "clean/arcs/touching_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <tuple>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "clean/arcs/cut_chords.hpp"
#include "clean/arcs/input_edges.hpp"
#include "clean/ends/loose_ends.hpp"
#include "clean/ends/near_points.hpp"
#include "geom/box.hpp"
#include "geom/curves/arc.hpp"
#include "geom/curves/touch.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/search/box_tree.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kPartOfChord = 1.0 / 8;  ///< as in welding

/// A segment with some width, which asks a tree for boxes that it meets; that around a slanted one
/// would meet many more.
class Strip {
 public:
  Strip(Point a, Point b)
      : box_(box_of(std::array{a, b})),
        a_(a),
        normal_(left_normal((1 / length(b - a)) * (b - a))) {}

  [[nodiscard]] bool meets(const Box& box) const {
    if (!box_.meets(box)) return false;
    const Point middle = midpoint(box.low, box.high);
    const Vector half = box.high - middle;
    const double room = std::abs(normal_.x) * half.x + std::abs(normal_.y) * half.y;
    const double rounding = 0x1p-40 * (room + length(middle - a_));
    return std::abs(dot(normal_, middle - a_)) <= room + rounding;
  }

 private:
  Box box_;
  Point a_;
  Vector normal_;
};

class TouchFinder {
 public:
  TouchFinder(const Input& input, double weld) : input_(input), chords_(chords_of(input)) {
    if (chords_.empty()) return;
    Box box;
    for_each_edge(input, [&](Point a, Point b, std::uint32_t circle, const InputRef&) {
      if (a == b) return;
      box.add(a);
      box.add(b);
      if (circle == 0) straight_.push_back(chord_between(a, b, 0));
    });
    sort_unique(straight_);
    const std::array corners{box.low, box.high};
    largest_ = largest_coordinate(corners);
    tolerance_ = weld * box.extent();
  }

  void find() {
    std::vector<Box> boxes;
    boxes.reserve(chords_.size());
    for (const InputChord& chord : chords_)
      boxes.push_back(box_around_arc(input_, chord, reach_of({circle_of_chord(chord)})));
    const BoxTree tree(boxes);
    for (std::uint32_t k = 0; k < chords_.size(); ++k) {
      tree.visit(boxes[k], [&](std::uint32_t j) {
        if (j > k) look_at_arcs(chords_[k], chords_[j]);
      });
    }
    for (const InputChord& line : straight_) {
      tree.visit(Strip(line.a, line.b), [&](std::uint32_t k) { look_at_line(line, chords_[k]); });
    }
    unite_places();
  }

  /// The input with the places in it.
  [[nodiscard]] Input joined(const ChordCuts& cuts) const {
    Input out = cut_chords(input_, cuts);
    const auto move = [&](std::vector<Point>& points) {
      for (Point& p : points) {
        for (auto to = moved_.find(p); to != moved_.end(); to = moved_.find(p)) p = to->second;
      }
    };
    if (moved_.empty()) return out;
    move(out.points);
    for (InputPolygon& polygon : out.polygons) {
      for (std::vector<Point>& ring : polygon.rings) move(ring);
    }
    for (InputLine& line : out.lines) move(line.points);
    return out;
  }

  [[nodiscard]] bool finds_nothing() const {
    return moved_.empty() && std::none_of(places_.begin(), places_.end(), is_new);
  }

  /// What is to be put on chords and lines: the places, and beside these ends on the longer chord
  /// as far away as the end of the shorter one. Else that would be seen from its end at an angle
  /// that is next to flat.
  [[nodiscard]] ChordCuts cuts() const {
    std::map<InputChord, AlongChord> along;
    for (const Place& place : places_) {
      for (const InputChord& chord : {place.one, place.other}) {
        if (is_new_on(chord, place)) put(place.at, chord, along[chord]);
      }
    }
    std::vector<Wish> wishes;
    for (const Place& place : places_) {
      if (place.one.circle != 0 && is_new(place)) wish_for_ends_beside(place, along, wishes);
    }
    for (const Wish& wish : wishes) {
      AlongChord& points = along[wish.chord];
      const auto next = points.lower_bound(share_of(wish.chord, wish.at));
      const Point after = next == points.end() ? wish.chord.b : next->second;
      const Point before = next == points.begin() ? wish.chord.a : std::prev(next)->second;
      if (std::min(length(after - wish.at), length(before - wish.at)) >= wish.room)
        put(wish.at, wish.chord, points);
    }
    ChordCuts cuts;
    for (const auto& [chord, points] : along) {
      for (const auto& [share, at] : points) cuts[chord].push_back(at);
    }
    return cuts;
  }

  void add_circles(TouchingCircles& circles) const {
    for (const Place& place : places_) {
      if (place.one.circle != 0 && place.other.circle != 0)
        circles.insert(std::minmax(place.one.circle, place.other.circle));
    }
  }

  void tell(std::vector<Change>& changes) const {
    std::map<InputChord, std::optional<ElementOfFile>> elements;
    for (const Place& place : places_) {
      for (const InputChord& chord : {place.one, place.other}) elements.try_emplace(chord);
    }
    for_each_edge(input_, [&](Point a, Point b, std::uint32_t circle, const ElementOfFile& ref) {
      const auto found = elements.find(chord_between(a, b, circle));
      if (found != elements.end() && !found->second) found->second = ref;
    });
    using Circles = std::pair<std::uint32_t, std::uint32_t>;
    std::set<std::tuple<Point, Circles, InputChord>> told;
    for (const Place& place : places_) {
      if (!is_new(place) && place.apart == 0) continue;
      const ElementOfFile one = *elements.at(place.one), other = *elements.at(place.other);
      // Where an end of an arc is, two of its chords end.
      const Circles circles = std::minmax(place.one.circle, place.other.circle);
      const InputChord line = place.one.circle == 0 ? place.one : InputChord{};
      if (!told.emplace(place.at, circles, line).second) continue;
      const char* what = place.one.circle == 0 ? "a side" : "an arc";
      std::string message =
          fmt::format("{} of {} touches an arc of {} at {}", what, describe_element(input_, one),
                      describe_element(input_, other), describe(place.at));
      if (place.is_bent) {
        message += fmt::format(", {} by {}", place.gap > 0 ? "which it misses" : "overlapping it",
                               describe_roughly(std::abs(place.gap)));
      }
      message += place.apart > 0 ? fmt::format(", where ends of both were {} apart and are one now",
                                               describe_roughly(place.apart))
                                 : "; that is an end of both now";
      const bool is_moved = place.is_bent || place.apart > 0;
      changes.push_back({is_moved ? Change::Kind::welded : Change::Kind::split,
                         std::move(message),
                         {place.at},
                         {one, other}});
    }
  }

 private:
  /// Where two curves touch.
  struct Place {
    Point at;
    InputChord one, other;
    double gap = 0;
    double reach = 0;        ///< what is as near is the same place
    bool is_an_end = false;  ///< of one of them, so that it has to stay
    bool is_bent = false;    ///< the gap is wider than rounding
    double apart = 0;        ///< how far from this an end is that becomes it
    Point moved{};           ///< that end
  };

  using AlongChord = std::map<double, Point>;  ///< points inside a chord, by their share of it

  /// A point for a chord, where there is room.
  struct Wish {
    InputChord chord;
    Point at;
    double room = 0;  ///< to all others there
  };

  static bool is_new_on(const InputChord& chord, const Place& place) {
    return place.apart == 0 && place.at != chord.a && place.at != chord.b;
  }
  static bool is_new(const Place& place) {
    return is_new_on(place.one, place) || is_new_on(place.other, place);
  }

  /// Of the arc or line; 0 at a, 1 at b.
  [[nodiscard]] double share_of(const InputChord& chord, Point p) const {
    return chord.circle == 0 ? part_on_line(chord.a, chord.b, p)
                             : arc_over(input_, chord).share_of(p);
  }

  void put(Point p, const InputChord& chord, AlongChord& points) const {
    points.emplace(share_of(chord, p), p);
  }

  /// The ends next to a place on a chord.
  [[nodiscard]] std::vector<Point> ends_beside(
      Point place, const InputChord& chord, const std::map<InputChord, AlongChord>& along) const {
    const auto found = along.find(chord);
    if (place == chord.a || place == chord.b) {
      if (found == along.end()) return {place == chord.a ? chord.b : chord.a};
      const AlongChord& points = found->second;
      return {place == chord.a ? points.begin()->second : points.rbegin()->second};
    }
    if (found == along.end()) return {};
    const AlongChord& points = found->second;
    const auto at = points.find(share_of(chord, place));
    if (at == points.end()) return {};
    return {at == points.begin() ? chord.a : std::prev(at)->second,
            std::next(at) == points.end() ? chord.b : std::next(at)->second};
  }

  void wish_for_ends_beside(const Place& place, const std::map<InputChord, AlongChord>& along,
                            std::vector<Wish>& wishes) const {
    for (const Point p : ends_beside(place.at, place.one, along)) {
      for (const Point q : ends_beside(place.at, place.other, along)) {
        const double to_p = length(p - place.at), to_q = length(q - place.at);
        if (dot(p - place.at, q - place.at) <= 0) continue;
        const double least = std::min(to_p, to_q), most = std::max(to_p, to_q);
        if (least > (1 - kPartOfChord) * most) continue;
        const InputChord& chord = to_p > to_q ? place.one : place.other;
        const ArcCircle& circle = circle_of_chord(chord);
        const auto angle_of = [&](double chord_length) {
          return std::asin(std::min(1.0, chord_length / 2 / circle.radius));
        };
        const ArcOver arc(circle, place.at, to_p > to_q ? p : q);
        wishes.push_back({chord, arc.at(angle_of(least) / angle_of(most)), kPartOfChord * least});
      }
    }
  }

  [[nodiscard]] const ArcCircle& circle_of_chord(const InputChord& chord) const {
    return input_.circles[chord.circle - 1];
  }

  /// What is left to rounding of the drawing and of circles.
  [[nodiscard]] double rounding_of_circles(std::initializer_list<ArcCircle> circles) const {
    Point most{largest_, 0};
    for (const ArcCircle& circle : circles) {
      const std::array sizes{circle.centre, Point{circle.radius, 0}};
      most.x = std::max(most.x, largest_coordinate(sizes));
    }
    return rounding_of(std::array{most});
  }

  [[nodiscard]] double reach_of(std::initializer_list<ArcCircle> circles) const {
    return std::max(rounding_of_circles(circles), tolerance_);
  }

  void look_at_arcs(const InputChord& c, const InputChord& d) {
    if (c.circle == d.circle) return;
    const ArcCircle &one = circle_of_chord(c), &other = circle_of_chord(d);
    look(c, d, touch_of(one, other, reach_of({one, other})), rounding_of_circles({one, other}));
  }

  void look_at_line(const InputChord& line, const InputChord& d) {
    const ArcCircle& circle = circle_of_chord(d);
    look(line, d, touch_of(circle, line.a, line.b, reach_of({circle})),
         rounding_of_circles({circle}));
  }

  void look(const InputChord& c, const InputChord& d, const std::optional<Touch>& touch,
            double rounding) {
    if (!touch) return;
    const double shortest = std::min(length(c.b - c.a), length(d.b - d.a));
    const double room = kPartOfChord * shortest, gap = std::abs(touch->gap);
    if (!(touch->half_width(std::max(gap, rounding)) <= room)) return;
    const double reach = std::max(tolerance_, rounding);
    const double same = std::min(room, touch->half_width(reach));
    const std::optional<Point> end_of_c = end_near(c, touch->at, same),
                               end_of_d = end_near(d, touch->at, same);
    // An end of an arc that lies on a side is where polygons meet, as ends of straight sides do.
    if (c.circle == 0 && end_of_d && orientation(c.a, c.b, *end_of_d) == Sign::zero) return;
    if (!end_of_c && !is_between_ends(c, touch->at)) return;
    if (!end_of_d && !is_between_ends(d, touch->at)) return;
    Place place{touch->at, c, d, touch->gap, reach, end_of_c || end_of_d, gap > rounding, 0, {}};
    if (end_of_d) place.at = *end_of_d;
    if (end_of_c) place.at = *end_of_c;
    if (end_of_c && end_of_d && *end_of_c != *end_of_d) {
      // Two ends that are no farther apart are one; others stay as they were drawn.
      if (length(*end_of_c - *end_of_d) > reach) return;
      const auto [one, other] = std::minmax(*end_of_c, *end_of_d);
      place.at = one;
      place.moved = other;
      place.apart = length(other - one);
    }
    const auto is_off = [&](const InputChord& chord) {
      return chord.circle != 0 && is_off_circle(circle_of_chord(chord), place.at);
    };
    if (!is_off(c) && !is_off(d)) places_.push_back(place);
  }

  static std::optional<Point> end_near(const InputChord& chord, Point p, double distance) {
    const double to_a = length(p - chord.a), to_b = length(p - chord.b);
    if (std::min(to_a, to_b) > distance) return std::nullopt;
    return to_a <= to_b ? chord.a : chord.b;
  }

  [[nodiscard]] bool is_between_ends(const InputChord& chord, Point p) const {
    const double share = share_of(chord, p);
    return share > 0 && share < 1;
  }

  /// Takes one point where several curves touch, and an end of any line that is there.
  void unite_places() {
    if (places_.empty()) return;
    for (const Place& place : places_) {
      if (place.apart > 0) moved_.emplace(place.moved, place.at);
    }
    std::stable_sort(places_.begin(), places_.end(), [](const Place& p, const Place& q) {
      return std::tuple(!p.is_an_end, p.at, p.one, p.other) <
             std::tuple(!q.is_an_end, q.at, q.one, q.other);
    });
    std::vector<Point> points;
    for_each_edge(input_, [&](Point a, Point b, std::uint32_t, const InputRef&) {
      points.push_back(a);
      points.push_back(b);
    });
    sort_unique(points);
    const std::size_t given = points.size();
    double reach = 0;
    for (const Place& place : places_) {
      points.push_back(place.at);
      reach = std::max(reach, place.reach);
    }
    const NearPoints near(points, reach, [](std::uint32_t) { return true; });
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (places_[k].is_an_end) continue;
      auto first = static_cast<std::uint32_t>(given + k);
      near.visit(points[first], [&](std::uint32_t v) {
        if (length(points[v] - points[given + k]) <= places_[k].reach) first = std::min(first, v);
      });
      places_[k].at = first < given ? points[first] : places_[first - given].at;
    }
  }

  const Input& input_;
  std::vector<InputChord> chords_;
  std::vector<InputChord> straight_;  ///< the lines that are no chords
  double largest_ = 0;                ///< coordinate of the drawing
  double tolerance_ = 0;
  std::vector<Place> places_;
  std::map<Point, Point> moved_;  ///< ends that become others
};

}  // namespace

std::optional<Input> join_touching_arcs(const Input& input, double weld, TouchingCircles& circles,
                                        std::vector<Change>& changes) {
  if (input.circles.empty()) return std::nullopt;
  TouchFinder finder(input, weld);
  finder.find();
  finder.add_circles(circles);
  if (finder.finds_nothing()) return std::nullopt;
  finder.tell(changes);
  return finder.joined(finder.cuts());
}

}  // namespace cover
