// Points are halved again and again, along the longer side of their box, down to two or three; then
// halves are merged as guibas_stolfi_1985_primitives do, whose text the names follow. A cut across
// is a cut along in a frame that is turned by a right angle, which no predicate notices: so a merge
// looks for the ends of its halves along their hulls. Halves share nothing, edges included: n
// points have no more than 3 n edges at any time, and each half takes those of its own range.
//
// Edges 2 k and 2 k + 1 are one edge from either end. next_ and prev_ go around the first point of
// an edge, counter-clockwise and back.
//
// Segments that are no edges then are made so by flips (sloan_1993_constrained).
// Tested by tests/unit/cdt/divide_test.cpp.
#include "cdt/divide.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>
#include <vector>

#include "base/containers/give_back.hpp"
#include "base/containers/unset_vector.hpp"
#include "geom/box.hpp"
#include "geom/predicates.hpp"
#include "geom/subdivision/rounds.hpp"

namespace cover {
namespace {

using Edge = std::uint32_t;

constexpr std::size_t kTask = 1 << 14;         ///< points: halves of less are one thread's
constexpr std::size_t kSlices = 1 << 10;       ///< of sites, to find the middle one
constexpr std::size_t kMostPoints = 1U << 29;  ///< so that edges have numbers
constexpr std::size_t kFlipsPerPoint = 32;     ///< more than that is another method's

constexpr Edge sym(Edge e) { return e ^ 1U; }

class Divided {
 public:
  Divided(std::span<const Point> points, const Team& team)
      : team_(team),
        sites_(points.size()),
        org_(6 * points.size()),
        next_(6 * points.size()),
        prev_(6 * points.size()) {
    team.each_range(points.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        sites_[k] = {points[k], static_cast<std::uint32_t>(k)};
    });
    team.each_range(org_.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t e = first; e < last; ++e) {
        org_[e] = kNone;
        next_[e] = prev_[e] = 0;
      }
    });
  }

  /// False if two points are one, or all are on one line.
  bool triangulate() {
    hull_ = divide(0, static_cast<std::uint32_t>(sites_.size())).hull;
    return !has_twins_ && hull_is_wide();
  }

  /// False if there is a conflict, or it takes too long.
  bool insert(std::span<const IndexPair> segments) {
    find_heads();
    is_locked_.assign(org_.size() / 2, 0);
    std::vector<std::vector<std::uint32_t>> missing_of(Team::ranges(segments.size(), kManyAtATime));
    std::atomic<bool> has_length = true;
    team_.each_range(segments.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s) {
        const std::uint32_t u = place_[segments[s][0]], v = place_[segments[s][1]];
        if (u == v) {
          has_length = false;
        } else if (const Edge e = find_edge(u, v).edge; e == kNone) {
          missing_of[first / kManyAtATime].push_back(static_cast<std::uint32_t>(s));
        } else {  // a pair may occur twice
          std::atomic_ref(is_locked_[e / 2]).store(1, std::memory_order_relaxed);
        }
      }
    });
    if (!has_length) return false;
    std::vector<std::uint32_t> missing;
    for (const auto& some : missing_of) missing.insert(missing.end(), some.begin(), some.end());
    // In a mixture of their order, since segments that cross the same edges come in rows.
    budget_ = kFlipsPerPoint * sites_.size();
    for (const std::uint32_t k : rounds(missing.size())) {
      const IndexPair& segment = segments[missing[k]];
      if (!insert_segment(place_[segment[0]], place_[segment[1]])) return false;
    }
    give_back(head_);
    give_back(place_);
    return true;
  }

  /// To be called last.
  Triangulation take(std::span<const Point> points) {
    const std::vector<std::uint32_t> ids = take_ids();
    mark_outer_edges();
    const std::vector<std::uint32_t> before = count_triangles();
    Triangulation out;
    out.triangles.resize(before.back());
    write_triangles(ids, before, out.triangles);
    link_triangles(out.triangles);
    give_back(org_);
    give_back(next_);
    give_back(prev_);
    give_back(is_locked_);
    out.points.assign(points.begin(), points.end());
    return out;
  }

 private:
  static constexpr std::uint32_t kOuter = kNone - 1;

  /// Where next_ is not needed any more, the triangle on the left of an edge stands.
  [[nodiscard]] UnsetVector<std::uint32_t>& left() { return next_; }

  /// The numbers of the points, by site; sites are given back.
  std::vector<std::uint32_t> take_ids() {
    std::vector<std::uint32_t> ids(sites_.size());
    team_.each_range(ids.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) ids[k] = sites_[k].id;
    });
    give_back(sites_);
    return ids;
  }

  void mark_outer_edges() {
    std::vector<Edge> outer;
    each_hull_edge(hull_, [&](Edge e) { outer.push_back(sym(e)); });
    set_all(left(), kNone, team_);
    for (const Edge e : outer) left()[e] = kOuter;
  }

  /// Whether a triangle lies on the left of `e`, whose first edge it is.
  [[nodiscard]] bool is_first(Edge e) const {
    if (org_[e] == kNone || next_[e] == kOuter) return false;
    const Edge f = lnext(e);
    return e < f && e < lnext(f);
  }

  /// By range of edges: the triangles before it; all of them at the end.
  [[nodiscard]] std::vector<std::uint32_t> count_triangles() const {
    std::vector<std::uint32_t> before(Team::ranges(next_.size(), kManyAtATime) + 1, 0);
    team_.each_range(next_.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      std::uint32_t own = 0;
      for (std::size_t e = first; e < last; ++e) own += is_first(static_cast<Edge>(e)) ? 1 : 0;
      before[first / kManyAtATime + 1] = own;
    });
    for (std::size_t k = 1; k < before.size(); ++k) before[k] += before[k - 1];
    return before;
  }

  /// In place of neighbours, triangles get their edges.
  void write_triangles(std::span<const std::uint32_t> ids, std::span<const std::uint32_t> before,
                       std::vector<Triangle>& triangles) {
    team_.each_range(left().size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      std::uint32_t number = before[first / kManyAtATime];
      for (std::size_t k = first; k < last; ++k) {
        Edge e = static_cast<Edge>(k);
        if (!is_first(e)) continue;
        Triangle& triangle = triangles[number];
        for (const Corner i : kCorners) {
          triangle.v[i] = ids[org_[e]];
          triangle.n[i.previous()] = e;
          if (is_locked_[e / 2] != 0) triangle.set_locked(i.previous(), true);
          e = lnext(e);
        }
        ++number;
      }
    });
  }

  void link_triangles(std::vector<Triangle>& triangles) {
    team_.each_range(triangles.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        for (const Edge e : triangles[t].n) left()[e] = static_cast<std::uint32_t>(t);
      }
    });
    team_.each_range(triangles.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        for (std::uint32_t& n : triangles[t].n) {
          n = left()[sym(n)];
          if (n == kOuter) n = kNone;
        }
      }
    });
  }

  struct Site {
    Point p;
    std::uint32_t id;
  };
  /// A triangulated range of sites.
  struct Part {
    Edge hull;             ///< an edge counter-clockwise along its hull
    Edge free, last_free;  ///< a list of edges that are not in use, linked by next_
  };
  struct Found {
    Edge edge;         ///< kNone: there is none
    bool from_second;  ///< the second point has no more edges than the first
  };

  [[nodiscard]] Point at(std::uint32_t v) const { return sites_[v].p; }
  [[nodiscard]] std::uint32_t dest(Edge e) const { return org_[sym(e)]; }
  [[nodiscard]] Edge lnext(Edge e) const { return prev_[sym(e)]; }
  [[nodiscard]] std::uint32_t apex(Edge e) const { return dest(lnext(e)); }
  [[nodiscard]] Sign orientation_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(at(a), at(b), at(c));
  }
  [[nodiscard]] bool is_left_turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation_of(a, b, c) == Sign::positive;
  }
  [[nodiscard]] bool is_in_circle(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                  std::uint32_t d) const {
    return in_circle(at(a), at(b), at(c), at(d)) == Sign::positive;
  }

  // Edges.

  Edge take_edge(Part& part, std::uint32_t from, std::uint32_t to) {
    const Edge e = part.free;
    part.free = next_[e];
    next_[e] = prev_[e] = e;
    next_[sym(e)] = prev_[sym(e)] = sym(e);
    org_[e] = from;
    org_[sym(e)] = to;
    return e;
  }
  void splice(Edge a, Edge b) {
    std::swap(next_[a], next_[b]);
    prev_[next_[a]] = a;
    prev_[next_[b]] = b;
  }
  Edge connect(Part& part, Edge a, Edge b) {
    const Edge e = take_edge(part, dest(a), org_[b]);
    splice(e, lnext(a));
    splice(sym(e), b);
    return e;
  }
  void remove(Part& part, Edge e) {
    splice(e, prev_[e]);
    splice(sym(e), prev_[sym(e)]);
    org_[e] = org_[sym(e)] = kNone;
    e &= ~1U;
    next_[e] = part.free;
    part.free = e;
  }
  /// The other diagonal of the two triangles at `e`.
  void flip(Edge e) {
    const Edge a = prev_[e], b = prev_[sym(e)];
    head_[org_[e]] = a;
    head_[dest(e)] = b;
    splice(e, a);
    splice(sym(e), b);
    splice(e, lnext(a));
    splice(sym(e), lnext(b));
    org_[e] = dest(a);
    org_[sym(e)] = dest(b);
  }

  template <class Use>
  void each_hull_edge(Edge hull, Use use) const {
    Edge e = hull;
    do {
      use(e);
      e = next_[sym(e)];
    } while (e != hull);
  }
  [[nodiscard]] bool hull_is_wide() const {
    bool is_wide = false;
    each_hull_edge(hull_, [&](Edge e) {
      is_wide |= orientation_of(org_[hull_], dest(hull_), org_[e]) != Sign::zero;
    });
    return is_wide;
  }

  // Dividing and merging.

  /// Orders points along an axis: x, or y in a frame that is turned by a right angle.
  static bool is_before(bool by_y, Point a, Point b) {
    if (by_y) return a.y != b.y ? a.y < b.y : b.x < a.x;
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }

  Part divide(std::uint32_t first, std::uint32_t last) {
    const std::uint32_t count = last - first;
    if (count <= 3) return triangle_of(first, last);
    const Box box = box_of(first, last);
    const bool by_y = box.height() > box.width();
    const std::uint32_t middle = first + count / 2;
    halve(first, middle, last, by_y, box);
    Part parts[2];
    const auto half = [&](std::size_t k) {
      parts[k] = k == 0 ? divide(first, middle) : divide(middle, last);
    };
    if (count >= kTask) {
      team_.each(2, half);
    } else {
      half(0);
      half(1);
    }
    return has_twins_ ? parts[0] : merge(parts[0], parts[1], by_y);
  }

  [[nodiscard]] Box box_of(std::uint32_t first, std::uint32_t last) const {
    Box box;
    if (!is_for_team(last - first)) {
      for (std::uint32_t k = first; k < last; ++k) box.add(at(k));
      return box;
    }
    std::vector<Box> boxes(Team::ranges(last - first, kManyAtATime));
    team_.each_range(last - first, kManyAtATime, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        boxes[begin / kManyAtATime].add(sites_[first + k].p);
    });
    for (const Box& part : boxes) box.include(part);
    return box;
  }

  /// Whether so many sites are put in halves by all threads.
  [[nodiscard]] bool is_for_team(std::size_t sites) const {
    return team_.workers() > 1 && sites >= 2 * kManyAtATime;
  }

  /// Puts those that come first along an axis before `middle`. In which order does not matter:
  /// it is the sets that decide about everything else.
  void halve(std::uint32_t first, std::uint32_t middle, std::uint32_t last, bool by_y,
             const Box& box) {
    const auto begin = sites_.begin() + first, end = sites_.begin() + last;
    const auto before = [by_y](const Site& a, const Site& b) { return is_before(by_y, a.p, b.p); };
    if (!is_for_team(last - first))
      return std::nth_element(begin, sites_.begin() + middle, end, before);
    // Slices across the axis, of which one has the middle. Rounding keeps their order.
    const double low = by_y ? box.low.y : box.low.x, high = by_y ? box.high.y : box.high.x;
    const double slices = (kSlices - 1) / (high - low);
    if (!std::isfinite(high - low) || !std::isfinite(slices))
      return std::nth_element(begin, sites_.begin() + middle, end, before);
    const auto slice_of = [&](const Site& site) {
      return static_cast<std::size_t>(((by_y ? site.p.y : site.p.x) - low) * slices);
    };
    const std::size_t ranges = Team::ranges(last - first, kManyAtATime);
    const auto each_range = [&](const auto& use) {
      team_.each_range(last - first, kManyAtATime, [&](std::size_t from, std::size_t to) {
        for (std::size_t k = from; k < to; ++k) use(from / kManyAtATime, sites_[first + k]);
      });
    };
    std::vector<std::array<std::uint32_t, kSlices>> in_slice(ranges);
    each_range([&](std::size_t range, const Site& site) { ++in_slice[range][slice_of(site)]; });
    std::size_t chosen = 0;
    std::uint32_t below = 0, inside = 0;
    for (; chosen < kSlices; ++chosen, below += inside) {
      inside = 0;
      for (const auto& counts : in_slice) inside += counts[chosen];
      if (first + below + inside > middle) break;
    }
    // Where sites of each range go: below the slice, into it, above it.
    std::vector<std::array<std::uint32_t, 3>> place(ranges);
    std::array<std::uint32_t, 3> next{0, below, below + inside};
    for (std::size_t r = 0; r < ranges; ++r) {
      place[r] = next;
      for (std::size_t slice = 0; slice < kSlices; ++slice)
        next[slice < chosen ? 0 : slice == chosen ? 1 : 2] += in_slice[r][slice];
    }
    UnsetVector<Site> put(last - first);
    each_range([&](std::size_t range, const Site& site) {
      const std::size_t slice = slice_of(site);
      put[place[range][slice < chosen ? 0 : slice == chosen ? 1 : 2]++] = site;
    });
    team_.each_range(last - first, kManyAtATime, [&](std::size_t from, std::size_t to) {
      std::copy(put.data() + from, put.data() + to, sites_.data() + first + from);
    });
    std::nth_element(begin + below, sites_.begin() + middle, begin + below + inside, before);
  }

  Part triangle_of(std::uint32_t first, std::uint32_t last) {
    Part part{kNone, 6 * first, 6 * last - 2};
    for (Edge e = part.free; e < part.last_free; e += 2) next_[e] = e + 2;
    std::sort(sites_.begin() + first, sites_.begin() + last,
              [](const Site& a, const Site& b) { return a.p < b.p; });
    for (std::uint32_t k = first + 1; k < last; ++k) {
      if (at(k - 1) == at(k)) has_twins_ = true;
    }
    const Edge a = take_edge(part, first, first + 1);
    part.hull = a;
    if (last - first == 2) return part;
    const Edge b = take_edge(part, first + 1, first + 2);
    splice(sym(a), b);
    const Sign sign = orientation_of(first, first + 1, first + 2);
    if (sign != Sign::zero) connect(part, b, a);
    if (sign == Sign::negative) part.hull = sym(a);
    return part;
  }

  Part merge(Part& low, Part& high, bool by_y) {
    Edge ldi = low.hull, rdi = high.hull;  // along the hulls, from the ends that face each other
    each_hull_edge(low.hull, [&](Edge e) {
      if (is_before(by_y, at(dest(ldi)), at(dest(e)))) ldi = e;
    });
    each_hull_edge(high.hull, [&](Edge e) {
      if (is_before(by_y, at(org_[e]), at(org_[rdi]))) rdi = e;
    });
    ldi = sym(ldi);
    if (at(org_[ldi]) == at(org_[rdi])) has_twins_ = true;
    if (has_twins_) return low;
    for (;;) {  // the lower common tangent
      if (is_left_turn(org_[rdi], org_[ldi], dest(ldi))) {
        ldi = lnext(ldi);
      } else if (is_left_turn(org_[ldi], dest(rdi), org_[rdi])) {
        rdi = next_[sym(rdi)];
      } else {
        break;
      }
    }
    Part all{kNone, low.free, high.last_free};
    next_[low.last_free] = high.free;
    Edge base = connect(all, sym(rdi), ldi);
    all.hull = sym(base);
    const auto is_above = [&](Edge e) { return is_left_turn(dest(e), dest(base), org_[base]); };
    for (;;) {
      Edge l = next_[sym(base)], r = prev_[base];
      if (is_above(l)) {
        while (is_in_circle(dest(base), org_[base], dest(l), dest(next_[l])))
          remove(all, std::exchange(l, next_[l]));
      }
      if (is_above(r)) {
        while (is_in_circle(dest(base), org_[base], dest(r), dest(prev_[r])))
          remove(all, std::exchange(r, prev_[r]));
      }
      const bool has_l = is_above(l), has_r = is_above(r);
      if (!has_l && !has_r) return all;
      if (!has_l || (has_r && is_in_circle(dest(l), org_[l], org_[r], dest(r)))) {
        base = connect(all, r, sym(base));
      } else {
        base = connect(all, sym(base), sym(l));
      }
    }
  }

  // Segments.

  /// The last edge that leaves each point.
  void find_heads() {
    place_.resize(sites_.size());
    team_.each_range(sites_.size(), kManyAtATime, [this](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        place_[sites_[k].id] = static_cast<std::uint32_t>(k);
    });
    head_.assign(sites_.size(), kNone);
    team_.each_range(org_.size(), kManyAtATime, [this](std::size_t first, std::size_t last) {
      for (auto e = static_cast<Edge>(first); e < last; ++e) {
        if (org_[e] == kNone) continue;
        const std::atomic_ref head(head_[org_[e]]);
        Edge other = head.load(std::memory_order_relaxed);
        while ((other == kNone || other < e) &&
               !head.compare_exchange_weak(other, e, std::memory_order_relaxed)) {
        }
      }
    });
  }

  /// Around both points at a time: one of them may have very many edges.
  [[nodiscard]] Found find_edge(std::uint32_t u, std::uint32_t v) const {
    Edge a = head_[u], b = head_[v];
    for (;;) {
      if (dest(a) == v) return {a, false};
      if (dest(b) == u) return {sym(b), false};
      a = next_[a];
      b = next_[b];
      if (a == head_[u]) return {kNone, false};
      if (b == head_[v]) return {kNone, true};
    }
  }

  /// The edge opposite to u that the way from u to v crosses first, u on its left; kNone if there
  /// is a point on it.
  [[nodiscard]] Edge first_crossed(std::uint32_t u, std::uint32_t v) const {
    const Edge head = head_[u];
    Edge e = head;
    do {
      const Edge f = next_[e];
      const Sign side = orientation_of(u, dest(e), v);
      if (side == Sign::zero && (at(u) < at(dest(e))) == (at(u) < at(v))) return kNone;
      if (side == Sign::positive && is_left_turn(u, dest(e), dest(f)) &&
          is_left_turn(u, v, dest(f)))
        return lnext(e);
      e = f;
    } while (e != head);
    return kNone;
  }

  bool insert_segment(std::uint32_t u, std::uint32_t v) {
    const Found found = find_edge(u, v);  // others may have made it
    if (found.edge != kNone) {
      is_locked_[found.edge / 2] = 1;
      return true;
    }
    if (found.from_second) std::swap(u, v);
    std::vector<Edge>& crossed = crossed_;
    crossed.clear();
    for (Edge e = first_crossed(u, v);;) {  // its first point is on the right of the segment
      if (e == kNone || is_locked_[e / 2] != 0) return false;
      crossed.push_back(e);
      const Edge f = lnext(sym(e));
      const std::uint32_t w = dest(f);
      if (w == v) break;
      const Sign side = orientation_of(u, v, w);
      if (side == Sign::zero) return false;
      e = side == Sign::positive ? f : lnext(f);
    }
    made_.clear();
    Edge own = kNone;
    for (std::size_t k = 0; k < crossed.size(); ++k) {
      if (budget_-- == 0) return false;
      const Edge e = crossed[k];
      const std::uint32_t a = org_[e], b = dest(e), l = apex(e), r = apex(sym(e));
      if (!is_left_turn(r, l, a) || !is_left_turn(l, r, b)) {
        crossed.push_back(e);
        continue;
      }
      flip(e);
      if ((l == u && r == v) || (l == v && r == u)) {
        own = e;
      } else if (l == u || l == v || r == u || r == v ||
                 orientation_of(u, v, l) == orientation_of(u, v, r)) {
        made_.push_back(e);
      } else {
        crossed.push_back(e);
      }
    }
    if (own == kNone) return false;
    is_locked_[own / 2] = 1;
    return restore();
  }

  /// Flips what was made to Delaunay, and what that makes.
  bool restore() {
    while (!made_.empty()) {
      const Edge e = made_.back();
      made_.pop_back();
      if (is_locked_[e / 2] != 0) continue;
      const std::uint32_t a = org_[e], b = dest(e), l = apex(e), r = apex(sym(e));
      // Beyond an edge of the hull there is no triangle, or one that is clockwise.
      if (!is_left_turn(a, b, l) || !is_left_turn(b, a, r) || !is_in_circle(a, b, l, r)) continue;
      if (budget_-- == 0) return false;
      flip(e);
      for (const Edge f : {lnext(e), lnext(lnext(e)), lnext(sym(e)), lnext(lnext(sym(e)))})
        made_.push_back(f);
    }
    return true;
  }

  const Team& team_;
  UnsetVector<Site> sites_;
  UnsetVector<std::uint32_t> org_;  ///< by edge: the place of its first point; kNone: not in use
  UnsetVector<Edge> next_, prev_;
  std::atomic<bool> has_twins_ = false;
  Edge hull_ = kNone;
  std::vector<std::uint32_t> place_;     ///< of a point among sites
  std::vector<Edge> head_;               ///< by place: an edge from there
  std::vector<std::uint8_t> is_locked_;  ///< by edge / 2
  std::vector<Edge> crossed_, made_;
  std::size_t budget_ = 0;
};

}  // namespace

std::optional<Triangulation> triangulate_divided(std::span<const Point> points,
                                                 std::span<const IndexPair> segments,
                                                 const Team& team) {
  if (points.size() < 3 || points.size() > kMostPoints) return std::nullopt;
  Divided divided(points, team);
  if (!divided.triangulate() || !divided.insert(segments)) return std::nullopt;
  return divided.take(points);
}

}  // namespace cover
