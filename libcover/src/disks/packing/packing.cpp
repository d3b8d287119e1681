// Sides are found by the place of a point on the rim of its element; the elements by a scan of the
// cycle while that is short, by the trees when it is long.
// Tested by tests/unit/disks/packing/packing_test.cpp.
#include "disks/packing/packing.hpp"

#include <algorithm>
#include <cmath>

#include "base/containers/order.hpp"

namespace cover::disks {
namespace {

/// Up to this length a cycle is scanned: a query of the trees costs about as much.
constexpr Index kShortCycle = 40;

/// How far off its side a point may lie by rounding, in radians or relative to a line's length.
constexpr double kOnSide = 1e-9;

/// The clockwise angle from `a` to `b` around the centre of `disk`.
double clockwise(const Element& disk, Point a, Point b) {
  return ccw_angle(b - disk.c, a - disk.c);
}

}  // namespace

Index TriangleDraft::add(Point p) {
  points.push_back(p);
  return static_cast<Index>(points.size() - 1);
}

Index TriangleDraft::add_on(const Element& e, Point p) {
  const Index vertex = add(p);
  if (e.is_line()) on_chord.push_back({e.id, vertex});
  return vertex;
}

Index Packing::add_element(const Element& e) {
  elements.push_back(e);
  sides_by_place_.emplace_back();
  full_circle_.push_back(kNone);
  return static_cast<Index>(elements.size() - 1);
}

Index Packing::add_side(Index element, Index start, Index end) {
  const auto side = static_cast<Index>(sides.size());
  sides.push_back({element, start, end, kNone, kNone, kNone});
  if (start == kNone) {
    full_circle_[element] = side;
    link(side, side);
  } else {
    sides_by_place_[element][place(elements[element], point(start))] = side;
  }
  return side;
}

void Packing::link(Index side, Index next) {
  sides[side].next = next;
  sides[next].prev = side;
}

Index Packing::add_cycle(Index side) {
  const auto cycle = static_cast<Index>(cycles.size());
  cycles.push_back({side, 0});
  Index s = side;
  do {
    sides[s].cycle = cycle;
    ++cycles.back().size;
    s = sides[s].next;
  } while (s != side);
  return cycle;
}

void Packing::find_cycles() {
  cycles.clear();
  for (Side& s : sides) s.cycle = kNone;
  for (Index s = 0; s < sides.size(); ++s) {
    if (sides[s].cycle == kNone) add_cycle(s);
  }
}

void Packing::build_index() {
  lines_ = LineTree(elements);
  for (Index e = 0; e < elements.size(); ++e) {
    if (elements[e].is_disk()) disks_.insert(elements[e], e);
  }
}

double Packing::extent(Index side) const {
  const Side& s = sides[side];
  const Element& e = elements[s.element];
  if (e.is_line()) return dot(e.d, point(s.end) - point(s.start));
  if (s.start == s.end) return kFullTurn;
  return clockwise(e, point(s.start), point(s.end));
}

bool Packing::is_on(Index side, Point x) const {
  const Side& s = sides[side];
  if (s.is_full_circle() || (s.start == s.end)) return true;
  const Element& e = elements[s.element];
  const double total = extent(side);
  if (e.is_line()) {
    const double t = dot(e.d, x - point(s.start));
    return t >= -kOnSide * total && t <= total * (1 + kOnSide);
  }
  const double angle = clockwise(e, point(s.start), x);
  return angle <= total + kOnSide || angle >= kFullTurn - kOnSide;
}

double Packing::place(const Element& e, Point x) const {
  const Vector v = x - e.c;
  if (e.is_line()) return dot(e.d, v);
  double t = v.y / (std::abs(v.x) + std::abs(v.y));
  if (v.x < 0) {
    t = 2 - t;
  } else if (v.y < 0) {
    t = 4 + t;
  }
  return 4 - t;
}

std::optional<Index> Packing::side_at(Index element, Point x, Index cycle) const {
  const auto fits = [&](Index side) {
    return (cycle == kNone || sides[side].cycle == cycle) && is_on(side, x);
  };
  if (const Index full = full_circle_[element]; full != kNone) {
    return fits(full) ? std::optional(full) : std::nullopt;
  }
  const auto& by_place = sides_by_place_[element];
  if (by_place.empty()) return std::nullopt;
  const auto previous = [&](auto it) {
    return std::prev(it == by_place.begin() ? by_place.end() : it);
  };
  // Near an end of a side the neighbour may be the one meant.
  const auto after = by_place.upper_bound(place(elements[element], x));
  const auto at = previous(after);
  for (const auto it : {at, previous(at), after == by_place.end() ? by_place.begin() : after}) {
    if (fits(it->second)) return it->second;
  }
  return std::nullopt;
}

Index Packing::nearest_obstacle(Point x, double bound, Index cycle, Index skip1,
                                Index skip2) const {
  Index best = kNone;
  const auto look_at = [&](Index e) {
    if (e == skip1 || e == skip2) return bound;
    const double distance = obstacle_distance(elements[e], x);
    if (distance < bound) bound = distance, best = e;
    return bound;
  };
  if (cycle != kNone && cycles[cycle].size <= kShortCycle) {
    Index s = cycles[cycle].side;
    for (Index k = 0; k < cycles[cycle].size; ++k, s = sides[s].next) look_at(sides[s].element);
    return best;
  }
  // Disks first: those at the ends of lines are near where the lines themselves do not count, and
  // the bound that they give saves visiting whole bundles of lines.
  disks_.visit(x, bound, look_at);
  lines_.visit(x, bound, look_at);
  return best;
}

std::vector<Index> Packing::elements_within(Point x, double bound, Index cycle) const {
  std::vector<Index> result;
  const auto look_at = [&](Index e) {
    if (obstacle_distance(elements[e], x) < bound) result.push_back(e);
    return bound;
  };
  if (cycle != kNone && cycles[cycle].size <= kShortCycle) {
    Index s = cycles[cycle].side;
    for (Index k = 0; k < cycles[cycle].size; ++k, s = sides[s].next) look_at(sides[s].element);
  } else {
    lines_.visit(x, bound, look_at);
    disks_.visit(x, bound, look_at);
  }
  sort_unique(result);
  return result;
}

void Packing::split_side(const Contact& contact, Index vertex, Index* before, Index* after) {
  Side& s = sides[contact.side];
  *before = contact.side;
  if (s.is_full_circle()) {
    s.start = s.end = vertex;
    full_circle_[s.element] = kNone;
    sides_by_place_[s.element][place(elements[s.element], contact.at)] = contact.side;
    *after = contact.side;
    return;
  }
  const Index end = s.end, next = s.next, cycle = s.cycle;
  s.end = vertex;
  *after = add_side(s.element, vertex, end);  // invalidates s
  sides[*after].cycle = cycle;
  link(*after, next);
}

std::vector<Index> Packing::insert_disk(Circle disk, std::vector<Contact> contacts) {
  const auto angle = [&](const Contact& c) { return ccw_angle({1, 0}, c.at - disk.c); };
  std::sort(contacts.begin(), contacts.end(), [&](const Contact& a, const Contact& b) {
    const double s = angle(a), t = angle(b);
    return s != t ? s < t : a.side < b.side;
  });
  const Index element = add_element(make_disk(disk.c, disk.r, draft.add(disk.c)));
  disks_.insert(elements[element], element);

  const std::size_t n = contacts.size();
  std::vector<Index> vertex(n), before(n), after(n), arcs(n);
  for (std::size_t k = 0; k < n; ++k) {
    vertex[k] = draft.add_on(element_of(contacts[k].side), contacts[k].at);
    split_side(contacts[k], vertex[k], &before[k], &after[k]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t previous = (k + n - 1) % n;
    arcs[k] = add_side(element, vertex[k], vertex[previous]);
    link(before[k], arcs[k]);
    link(arcs[k], after[previous]);
  }
  return arcs;
}

std::vector<Index> Packing::split_cycle(Index cycle, std::span<const Index> new_sides) {
  // All new cycles are walked in step; the one still unfinished when the others are done keeps the
  // old label, so that every side is relabelled O(log n) times in all.
  struct Walk {
    Index start, at, size;
  };
  std::vector<Walk> open, closed;
  for (const Index s : new_sides) open.push_back({s, s, 0});
  const Index disk = sides[new_sides[0]].element;
  const Index total = cycles[cycle].size + 2 * static_cast<Index>(new_sides.size());
  while (open.size() > 1) {
    for (std::size_t k = 0; k < open.size() && open.size() > 1;) {
      Walk& w = open[k];
      w.at = sides[w.at].next;
      ++w.size;
      if (w.at == w.start) {
        closed.push_back(w);
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
      } else if (sides[w.at].element == disk) {
        return {};
      } else {
        ++k;
      }
    }
  }
  std::vector<Index> result{cycle};
  Index rest = total;
  for (const Walk& w : closed) {
    rest -= w.size;
    result.push_back(add_cycle(w.start));
  }
  cycles[cycle] = {open[0].start, rest};
  for (const Index s : new_sides) {
    if (s == open[0].start) sides[s].cycle = cycle;
  }
  return result;
}

}  // namespace cover::disks
