// A line that passes over the plane from left to right keeps the segments that it meets in order.
// It stops at ends and at crossings, where it takes out all segments through the point and puts
// those that go on back in the order of their slopes. Only neighbours can cross next; whether they
// do is told by one orientation of given points, because their order is known:
//
//     below s, t  above:  they cross later  <=>  the end that comes first is on the wrong side.
//
// Touching and overlapping need no case of their own: ends are looked up among the segments, and
// segments on one line, in the order of their numbers, pass through the same ends.
// Tested by tests/unit/geom/subdivision/exact_subdivision_test.cpp, beside all pairs intersected
// one by one.
#include "geom/subdivision/exact_subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace cover {
namespace {

/// So often a line may be led through a node that it passes beside, for each line and in any case.
constexpr std::size_t kLedPerLine = 1000;
constexpr std::size_t kFewLed = 1'000'000;

/// Two units in the last place of the larger coordinate.
double reach_at(Point p) {
  const double size = std::max(std::abs(p.x), std::abs(p.y));
  return 2 * (std::nextafter(size, HUGE_VAL) - size);
}

bool is_within(Point p, Point q, double reach) {
  return std::abs(p.x - q.x) <= reach && std::abs(p.y - q.y) <= reach;
}

/// Whether two points are at most two units in the last place of their coordinates apart.
bool is_next_to(Point p, Point q) { return is_within(p, q, std::max(reach_at(p), reach_at(q))); }

bool is_steep(const PlainSegment& s) { return std::abs(s.b.y - s.a.y) > std::abs(s.b.x - s.a.x); }

Point swapped(Point p) { return {p.y, p.x}; }

/// Whether lines pass through the nodes that they nearly pass, and which axis the sweep goes along.
enum class Snap { off, along_x, along_y };

class Sweep {
 public:
  explicit Sweep(std::span<const PlainSegment> segments, Snap snap = Snap::off,
                 bool to_ends = false)
      : snap_(snap),
        to_ends_(to_ends),
        status_(Order{this}),
        place_(segments.size(), status_.end()),
        stop_(segments.size(), 0),
        rank_(segments.size(), 0) {
    lines_.reserve(segments.size());
    ends_.reserve(2 * segments.size());
    for (const PlainSegment& s : segments) {
      const auto line = static_cast<std::uint32_t>(lines_.size());
      lines_.push_back({std::min(s.a, s.b), std::max(s.a, s.b)});
      ends_.push_back({lines_.back().a, line});
      ends_.push_back({lines_.back().b, line});
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& e, const End& f) {
      return std::pair(e.at, e.line) < std::pair(f.at, f.line);
    });
  }
  Sweep(const Sweep&) = delete;
  Sweep& operator=(const Sweep&) = delete;

  Subdivision run() {
    const std::size_t most = kLedPerLine * lines_.size() + kFewLed;
    while (go_on()) {
      const Place above = take_out();
      put_back(above);
      if (led_ <= most) continue;
      out_.crowd = stop_at_.rounded();
      break;
    }
    return finish();
  }

 private:
  struct End {
    Point at;
    std::uint32_t line;
  };
  struct Crossing {
    SweepPoint at;
    std::uint32_t below, above;
  };
  struct Earlier {
    bool operator()(const Crossing& c, const Crossing& d) const {
      if (c.below == d.below && c.above == d.above) return false;
      return compare(c.at, d.at) == Sign::negative;
    }
  };
  /// From below to above where the sweep stands; lines through its stop as they go on from there.
  struct Order {
    using is_transparent = void;
    const Sweep* sweep;
    bool operator()(std::uint32_t s, std::uint32_t t) const {
      if (!sweep->passes_here(s)) return sweep->side_of(s) == Sign::positive;
      if (!sweep->passes_here(t)) return sweep->side_of(t) == Sign::negative;
      return sweep->rank_[s] < sweep->rank_[t];
    }
    bool operator()(std::uint32_t s, const SweepPoint&) const {
      return sweep->side_of(s) == Sign::positive;
    }
  };
  using Status = std::set<std::uint32_t, Order>;
  using Place = Status::iterator;

  [[nodiscard]] bool passes_here(std::uint32_t line) const { return stop_[line] == stops_; }
  /// On which side of a line the sweep's stop lies.
  [[nodiscard]] Sign side_of(std::uint32_t line) const {
    return stop_at_.side_of(lines_[line].a, lines_[line].b);
  }

  /// Goes on to the next stop. `here_` becomes the lines that are known to pass through it: those
  /// that begin or end there, or one that crosses.
  bool go_on() {
    if (next_ == ends_.size() && crossings_.empty()) return false;
    ++stops_;
    here_.clear();
    const auto crossing = crossings_.begin();
    Sign order = Sign::negative;  // of the next end and the next crossing
    if (crossing != crossings_.end()) {
      order = next_ == ends_.size() ? Sign::positive
                                    : compare(SweepPoint(ends_[next_].at), crossing->at);
    }
    at_end_ = order != Sign::positive;
    stop_at_ = at_end_ ? SweepPoint(ends_[next_].at) : crossing->at;
    if (order != Sign::negative) {
      // Known to pass, so that no sign need be found to be zero, which takes exact arithmetic.
      stop_line(crossing->below);
      stop_line(crossing->above);
      crossings_.erase(crossing);
    }
    if (!at_end_) return true;
    for (const Point at = ends_[next_].at; next_ < ends_.size() && ends_[next_].at == at; ++next_) {
      stop_line(ends_[next_].line);
    }
    return true;
  }

  void stop_line(std::uint32_t line) {
    stop_[line] = stops_;
    here_.push_back(line);
  }

  /// Takes all lines through the stop out of the status and adds them to `here_`. Returns the place
  /// above them.
  Place take_out() {
    const auto known = std::find_if(here_.begin(), here_.end(), [this](std::uint32_t line) {
      return place_[line] != status_.end();
    });
    Place low = known != here_.end() ? place_[*known] : status_.lower_bound(stop_at_);
    const auto contains_stop = [this](Place p) {
      return passes_here(*p) || side_of(*p) == Sign::zero;
    };
    Place high = low;
    while (low != status_.begin() && contains_stop(std::prev(low))) --low;
    while (high != status_.end() && contains_stop(high)) ++high;
    for (Place p = low; p != high; ++p) {
      place_[*p] = status_.end();
      if (!passes_here(*p)) stop_line(*p);
    }
    return status_.erase(low, high);
  }

  /// Puts the lines that go on back below `above` and looks for their next crossings.
  void put_back(Place above) {
    const std::uint32_t node = add_node();
    if (at_end_) {
      std::erase_if(here_, [this](std::uint32_t l) { return lines_[l].b == stop_at_.rounded(); });
    }
    std::sort(here_.begin(), here_.end(), [this](std::uint32_t s, std::uint32_t t) {
      const Sign turn = cross_sign(lines_[s].a, lines_[s].b, lines_[t].a, lines_[t].b);
      return turn != Sign::zero ? turn == Sign::positive : s < t;
    });
    const Place below = above == status_.begin() ? status_.end() : std::prev(above);
    for (std::uint32_t k = 0; k < here_.size(); ++k) {
      rank_[here_[k]] = k;
      place_[here_[k]] = status_.emplace_hint(above, here_[k]);
    }
    if (snap_ != Snap::off && (to_ends_ || !at_end_) && !attracts_[node]) {
      attracts_[node] = true;
      snap_neighbours(node, below, above);
    }
    if (here_.empty()) {
      if (below != status_.end() && above != status_.end()) look_ahead(*below, *above);
      return;
    }
    if (below != status_.end()) look_ahead(*below, here_.front());
    if (above != status_.end()) look_ahead(here_.back(), *above);
  }

  /// Leads the flat lines that pass very near the node at the stop through it. They are found by
  /// going up and down from it, because a steep line in between is nearer still in the direction
  /// of y.
  void snap_neighbours(std::uint32_t node, Place below, Place above) {
    const Point at = out_.nodes[node];
    const double reach = reach_at(at);
    const auto look = [&](std::uint32_t line) {
      const PlainSegment& s = lines_[line];
      const double away = distance_along_y(s, at);
      if (!(away <= 2 * reach)) return false;
      // So the node is nearer to the line than to its ends, and the line becomes shorter pieces.
      const bool is_near_end = is_within(s.a, at, 2 * reach) || is_within(s.b, at, 2 * reach);
      if (away <= reach && !is_steep(s) && !is_near_end) {
        visits_.emplace_back(line, node);
        ++led_;
      }
      return true;
    };
    for (Place p = above; p != status_.end() && look(*p); ++p) {
    }
    if (below == status_.end()) return;
    for (Place p = below; look(*p) && p != status_.begin();) --p;
  }

  /// Notes where a line crosses the one next above it, if it does.
  void look_ahead(std::uint32_t below, std::uint32_t above) {
    const PlainSegment &s = lines_[below], &t = lines_[above];
    const bool cross = s.b < t.b ? orientation(t.a, t.b, s.b) == Sign::positive
                                 : orientation(s.a, s.b, t.b) == Sign::negative;
    if (cross) crossings_.insert({SweepPoint(s, t), below, above});
  }

  /// The number of the node at the stop. Only without snapping may several be at one place.
  std::uint32_t add_node() {
    const Point at = at_end_ ? stop_at_.rounded() : place_of_crossing();
    auto node = static_cast<std::uint32_t>(out_.nodes.size());
    if (snap_ != Snap::off) node = node_at_.emplace(at, node).first->second;
    if (node == out_.nodes.size()) {
      out_.nodes.push_back(at);
      attracts_.push_back(false);
    }
    for (const std::uint32_t line : here_) visits_.emplace_back(line, node);
    return node;
  }

  [[nodiscard]] bool is_end(Point p) const {
    const auto found = std::lower_bound(ends_.begin(), ends_.end(), p,
                                        [](const End& e, Point q) { return e.at < q; });
    return found != ends_.end() && found->at == p;
  }

  [[nodiscard]] Point place_of_crossing() const {
    const Point rounded = stop_at_.rounded();
    const auto ends_next_to_it = [&](std::uint32_t line) {
      return is_next_to(lines_[line].a, rounded) || is_next_to(lines_[line].b, rounded);
    };
    if (std::none_of(here_.begin(), here_.end(), ends_next_to_it) || is_end(rounded)) {
      return rounded;
    }
    Point nearest = rounded;
    bool found = false;
    for (const std::uint32_t line : here_) {
      for (const Point end : {lines_[line].a, lines_[line].b}) {
        if (!is_next_to(end, rounded)) continue;
        if (!std::exchange(found, true)) nearest = end;
        const Sign order = stop_at_.compare_distances(end, nearest);
        if (order == Sign::negative || (order == Sign::zero && is_before(end, nearest))) {
          nearest = end;
        }
      }
    }
    return nearest;
  }

  /// The same whichever axis the sweep goes along.
  [[nodiscard]] bool is_before(Point p, Point q) const {
    return snap_ == Snap::along_y ? swapped(p) < swapped(q) : p < q;
  }

  /// Sorts the visits by line.
  Subdivision finish() {
    out_.first.assign(lines_.size() + 1, 0);
    for (const auto& [line, node] : visits_) ++out_.first[line + 1];
    std::partial_sum(out_.first.begin(), out_.first.end(), out_.first.begin());
    out_.path.resize(visits_.size());
    std::vector<std::size_t> next(out_.first.begin(), out_.first.end() - 1);
    for (const auto& [line, node] : visits_) out_.path[next[line]++] = node;
    return std::move(out_);
  }

  Snap snap_;
  bool to_ends_;
  std::vector<PlainSegment> lines_;  ///< from the smaller end to the larger one
  std::vector<End> ends_;            ///< sorted
  std::size_t next_ = 0;             ///< of ends_
  std::set<Crossing, Earlier> crossings_;
  Status status_;
  std::vector<Place> place_;  ///< by line, status_.end() where it is not there

  SweepPoint stop_at_{Point{}};
  bool at_end_ = false;  ///< a line begins or ends at the stop
  std::uint32_t stops_ = 0;
  std::vector<std::uint32_t> here_;  ///< lines through the stop
  std::vector<std::uint32_t> stop_;  ///< by line: the last stop that it passed
  std::vector<std::uint32_t> rank_;  ///< by line: place among those through its last stop

  std::map<Point, std::uint32_t> node_at_;  ///< only with snapping
  std::vector<bool> attracts_;              ///< by node: its neighbours were led through it
  std::vector<std::pair<std::uint32_t, std::uint32_t>> visits_;  ///< line and node
  std::size_t led_ = 0;  ///< of these: led through a node beside the line
  Subdivision out_;
};

}  // namespace

Subdivision subdivide(std::span<const PlainSegment> segments) { return Sweep(segments).run(); }

Subdivision subdivide_and_snap(std::span<const PlainSegment> segments, bool to_ends) {
  std::vector<PlainSegment> turned;
  turned.reserve(segments.size());
  for (const PlainSegment& s : segments) turned.push_back({swapped(s.a), swapped(s.b)});
  Subdivision out;
  const Subdivision flat = Sweep(segments, Snap::along_x, to_ends).run();
  if ((out.crowd = flat.crowd)) return out;
  const Subdivision steep = Sweep(turned, Snap::along_y, to_ends).run();
  if (steep.crowd) {
    out.crowd = swapped(*steep.crowd);
    return out;
  }
  out.nodes = flat.nodes;
  for (const Point& p : steep.nodes) out.nodes.push_back(swapped(p));
  out.first.push_back(0);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const bool along_y = is_steep(segments[s]);
    const PlainSegment& line = along_y ? turned[s] : segments[s];
    const Subdivision& cuts = along_y ? steep : flat;
    const bool falls = (line.a.x < line.b.x) != (line.a.y < line.b.y);
    const auto start = static_cast<std::ptrdiff_t>(out.path.size());
    const auto path = cuts.path_of(s);
    out.path.push_back(path.front());
    for (const std::uint32_t node : path) {
      if (node != path.front() && node != path.back()) out.path.push_back(node);
    }
    // All lines of one direction meet the nodes in the same order, whichever is led through them.
    // A node that rounding moved beyond an end still lies between the ends on the way.
    std::sort(out.path.begin() + start + 1, out.path.end(), [&](std::uint32_t i, std::uint32_t j) {
      const Point p = cuts.nodes[i], q = cuts.nodes[j];
      return p.x != q.x ? p.x < q.x : falls ? p.y > q.y : p.y < q.y;
    });
    out.path.push_back(path.back());
    if (along_y) {
      for (auto k = out.path.begin() + start; k != out.path.end(); ++k) {
        *k += static_cast<std::uint32_t>(flat.nodes.size());
      }
      if ((segments[s].b < segments[s].a) != (line.b < line.a)) {
        std::reverse(out.path.begin() + start, out.path.end());
      }
    }
    out.first.push_back(out.path.size());
  }
  return out;
}

}  // namespace cover
