// A corner of angle theta gets k = ceil(theta / 120 degrees) disks in equal sectors, each touching
// the two rays of its sector at the same distance t from the corner. (One disk for a convex
// corner near 180 degrees would have a huge radius for its t, and two fail towards 360 degrees.)
// With phi = theta / 2k <= 60 degrees all of it lies within t (1 + sin phi) / cos phi of the
// corner, which is made a fraction below 1/2 of the corner's clearance: so corners cannot touch
// each other or foreign chords. A corner is a visit of a walk to a vertex, found by turning in the
// triangulation; its clearance is what is visible inside the sector, found by flooding from there.
// Tested by tests/unit/covering/fill_disks_test.cpp.
#include "covering/disks/corner_disks.hpp"

#include <algorithm>
#include <cmath>

namespace cover::disks {
namespace {

/// A corner of a triangle: triangle 3 * t + i means corner i of triangle t.
using TriangleCorner = Index;

/// A visit of the boundary to a vertex, or an isolated point.
struct Visit {
  Index vertex = kNoIndex;
  std::vector<TriangleCorner> fan;  ///< counter-clockwise
  Index chord_in = kNoIndex;        ///< kNoIndex: isolated
  double theta = kFullTurn;
  Index first_disk = kNoIndex;  ///< element
  Index disks = 1;
  std::vector<Index> touch;  ///< vertices T_0 ... T_k on the rays

  [[nodiscard]] bool is_isolated() const { return chord_in == kNoIndex; }
};

class CornerDisks {
 public:
  CornerDisks(Packing& packing, const Triangulation& cdt, std::span<const Chord> chords)
      : packing_(packing),
        cdt_(cdt),
        chords_(chords),
        visit_at_(3 * cdt.triangles.size(), kNoIndex) {}

  std::vector<std::array<Index, 2>> run(double fraction) {
    find_visits();
    for (Index k = 0; k < chords_.size(); ++k) {
      packing_.add_element(
          make_line(packing_.point(chords_[k].a), packing_.point(chords_[k].b), k));
    }
    for (Visit& v : visits_) v.is_isolated() ? fill_point(v, fraction) : fill_corner(v, fraction);
    make_cycles();
    packing_.build_index();
    return pairs_of_cycles();
  }

 private:
  [[nodiscard]] Index vertex_of(TriangleCorner c) const { return cdt_.triangles[c / 3].v[c % 3]; }
  [[nodiscard]] Point at(Index vertex) const { return packing_.point(vertex); }

  /// The chord of every locked edge, by the corner opposite to it.
  std::vector<Index> chords_by_edge() const;
  void find_visits();
  /// Fans around the corners from chord to chord; the visit to the start of chord k is number k.
  Visit turn_around(TriangleCorner first, const std::vector<Index>& chord_by_edge) const;
  [[nodiscard]] double clearance(const Visit& visit) const;
  [[nodiscard]] double distance_to_edge(Point p, Index a, Index b) const;
  void fill_corner(Visit& visit, double fraction);
  void fill_point(Visit& visit, double fraction);
  void make_cycles();
  std::vector<std::array<Index, 2>> pairs_of_cycles() const;
  [[nodiscard]] Index disk_towards(const Visit& visit, Point p) const;

  Packing& packing_;
  const Triangulation& cdt_;
  std::span<const Chord> chords_;
  std::vector<Visit> visits_;
  std::vector<Index> visit_at_;  ///< by TriangleCorner
};

std::vector<Index> CornerDisks::chords_by_edge() const {
  struct Entry {
    Index a, b, chord;
  };
  std::vector<Entry> sorted;
  for (Index k = 0; k < chords_.size(); ++k) sorted.push_back({chords_[k].a, chords_[k].b, k});
  const auto less = [](const Entry& s, const Entry& t) {
    return s.a != t.a ? s.a < t.a : s.b < t.b;
  };
  std::sort(sorted.begin(), sorted.end(), less);
  std::vector<Index> result(visit_at_.size(), kNoIndex);
  for (TriangleCorner c = 0; c < result.size(); ++c) {
    const Triangle& t = cdt_.triangles[c / 3];
    const int i = static_cast<int>(c % 3);
    if (!t.is_locked(i)) continue;
    const Entry wanted{t.v[static_cast<std::size_t>(next3(i))],
                       t.v[static_cast<std::size_t>(prev3(i))], 0};
    const auto it = std::lower_bound(sorted.begin(), sorted.end(), wanted, less);
    if (it != sorted.end() && !less(wanted, *it)) result[c] = it->chord;
  }
  return result;
}

Visit CornerDisks::turn_around(TriangleCorner first,
                               const std::vector<Index>& chord_by_edge) const {
  Visit visit;
  visit.vertex = vertex_of(first);
  TriangleCorner c = first;
  while (true) {
    visit.fan.push_back(c);
    const Triangle& t = cdt_.triangles[c / 3];
    const int i = static_cast<int>(c % 3);
    const int exit = next3(i);  // the edge on the left, from the third corner to this vertex
    if (t.is_locked(exit)) {
      visit.chord_in = chord_by_edge[c - c % 3 + static_cast<Index>(exit)];
      return visit;
    }
    const Index n = t.n[static_cast<std::size_t>(exit)];
    c = 3 * n + static_cast<Index>(cdt_.triangles[n].corner_of(visit.vertex));
    if (c == first) return visit;
  }
}

void CornerDisks::find_visits() {
  const std::vector<Index> chord_by_edge = chords_by_edge();
  visits_.resize(chords_.size());
  for (TriangleCorner c = 0; c < visit_at_.size(); ++c) {
    if (chord_by_edge[c] == kNoIndex) continue;
    const Index start = c - c % 3 + static_cast<Index>(next3(static_cast<int>(c % 3)));
    visits_[chord_by_edge[c]] = turn_around(start, chord_by_edge);
  }
  for (Index k = 0; k < visits_.size(); ++k) {
    for (const TriangleCorner c : visits_[k].fan) visit_at_[c] = k;
  }
  for (TriangleCorner c = 0; c < visit_at_.size(); ++c) {  // what is left is isolated
    if (visit_at_[c] != kNoIndex) continue;
    visits_.push_back(turn_around(c, chord_by_edge));
    for (const TriangleCorner f : visits_.back().fan) {
      visit_at_[f] = static_cast<Index>(visits_.size() - 1);
    }
  }
}

double CornerDisks::distance_to_edge(Point p, Index a, Index b) const {
  const Vector e = at(b) - at(a), v = p - at(a);
  const double t = std::clamp(dot(v, e) / squared_length(e), 0.0, 1.0);
  return length(v - t * e);
}

double CornerDisks::clearance(const Visit& visit) const {
  const Point p = at(visit.vertex);
  double d = std::numeric_limits<double>::infinity();
  std::vector<TriangleCorner> open;  // edges to look through, by their opposite corner
  const auto look_at = [&](TriangleCorner c) {
    const Triangle& t = cdt_.triangles[c / 3];
    const int i = static_cast<int>(c % 3);
    const double distance = distance_to_edge(p, t.v[static_cast<std::size_t>(next3(i))],
                                             t.v[static_cast<std::size_t>(prev3(i))]);
    if (distance >= d) return;
    if (t.is_locked(i)) {
      d = distance;
    } else {
      open.push_back(c);
    }
  };
  for (const TriangleCorner c : visit.fan) {
    const Triangle& t = cdt_.triangles[c / 3];
    for (const Index v : t.v) {
      if (v != visit.vertex) d = std::min(d, length(at(v) - p));
    }
  }
  for (const TriangleCorner c : visit.fan) look_at(c);
  while (!open.empty()) {
    const TriangleCorner c = open.back();
    open.pop_back();
    const Index n = cdt_.triangles[c / 3].n[c % 3];
    const int i = cdt_.triangles[n].edge_to(c / 3);
    d = std::min(d, length(at(cdt_.triangles[n].v[static_cast<std::size_t>(i)]) - p));
    look_at(3 * n + static_cast<Index>(next3(i)));
    look_at(3 * n + static_cast<Index>(prev3(i)));
  }
  return d;
}

void CornerDisks::fill_corner(Visit& visit, double fraction) {
  const auto chord_out = static_cast<Index>(&visit - visits_.data());
  const Point v = at(visit.vertex);
  const Vector out = packing_.elements[chord_out].d,
               in = -1.0 * packing_.elements[visit.chord_in].d;
  visit.theta = turn(out, in);
  if (visit.theta == 0) visit.theta = kFullTurn;
  const double third = kFullTurn / 3;
  visit.disks = static_cast<Index>(std::max(1.0, std::ceil(visit.theta / third * (1 - 1e-12))));
  const double phi = visit.theta / (2 * visit.disks);
  const double t = fraction * clearance(visit) * std::cos(phi) / (1 + std::sin(phi));
  packing_.elements[chord_out].from = t;
  packing_.elements[visit.chord_in].to -= t;

  const auto ray = [&](double angle) {
    return std::cos(angle) * out + std::sin(angle) * left_normal(out);
  };
  for (Index j = 0; j <= visit.disks; ++j) {
    if (j == 0) {
      visit.touch.push_back(packing_.draft.add_on(packing_.elements[chord_out], v + t * out));
    } else if (j < visit.disks) {
      visit.touch.push_back(packing_.draft.add(v + t * ray(2 * j * phi)));
    } else {
      visit.touch.push_back(packing_.draft.add_on(packing_.elements[visit.chord_in], v + t * in));
    }
  }
  visit.first_disk = static_cast<Index>(packing_.elements.size());
  for (Index j = 0; j < visit.disks; ++j) {
    const Point c = v + (t / std::cos(phi)) * ray((2 * j + 1) * phi);
    const Index centre = packing_.draft.add(c);
    packing_.add_element(make_disk(c, t * std::tan(phi), centre));
    packing_.draft.triangle(visit.vertex, visit.touch[j], centre);
    packing_.draft.triangle(visit.vertex, centre, visit.touch[j + 1]);
  }
}

void CornerDisks::fill_point(Visit& visit, double fraction) {
  visit.first_disk =
      packing_.add_element(make_disk(at(visit.vertex), fraction * clearance(visit), visit.vertex));
}

void CornerDisks::make_cycles() {
  // Along every walk: line, the disks of the corner at its end from last to first, next line.
  std::vector<Index> end_of(chords_.size());
  for (const Visit& v : visits_) {
    if (!v.is_isolated()) end_of[v.chord_in] = v.touch.back();
  }
  for (Index k = 0; k < chords_.size(); ++k) packing_.add_side(k, visits_[k].touch[0], end_of[k]);
  for (Index k = 0; k < visits_.size(); ++k) {
    const Visit& v = visits_[k];
    if (v.is_isolated()) {
      packing_.add_side(v.first_disk, kNoIndex, kNoIndex);
      continue;
    }
    Index last = v.chord_in;  // the side of chord k is side k
    for (Index j = v.disks; j-- > 0;) {
      const Index s = packing_.add_side(v.first_disk + j, v.touch[j + 1], v.touch[j]);
      packing_.link(last, s);
      last = s;
    }
    packing_.link(last, k);
  }
  for (Index s = 0; s < packing_.sides.size(); ++s) {
    if (packing_.sides[s].cycle == kNoIndex) packing_.add_cycle(s);
  }
}

Index CornerDisks::disk_towards(const Visit& visit, Point p) const {
  if (visit.is_isolated()) return visit.first_disk;
  const auto chord_out = static_cast<Index>(&visit - visits_.data());
  const double angle = turn(packing_.elements[chord_out].d, p - at(visit.vertex));
  const auto sector = static_cast<Index>(angle / visit.theta * visit.disks);
  return visit.first_disk + std::min(sector, visit.disks - 1);
}

std::vector<std::array<Index, 2>> CornerDisks::pairs_of_cycles() const {
  std::vector<std::array<Index, 2>> pairs;
  if (packing_.cycles.size() < 2) return pairs;
  std::vector<Index> cycle_of_visit(visits_.size());
  for (const Side& s : packing_.sides) {
    if (packing_.elements[s.element].is_line()) cycle_of_visit[s.element] = s.cycle;
  }
  for (Index k = 0; k < visits_.size(); ++k) {
    if (visits_[k].is_isolated()) cycle_of_visit[k] = kNoIndex - 1 - k;  // a cycle of its own
  }
  for (TriangleCorner c = 0; c < visit_at_.size(); ++c) {
    const Triangle& t = cdt_.triangles[c / 3];
    const Index n = t.n[c % 3];
    if (t.is_locked(static_cast<int>(c % 3)) || n < c / 3) continue;
    const Visit& u =
        visits_[visit_at_[c - c % 3 + static_cast<Index>(next3(static_cast<int>(c % 3)))]];
    const Visit& w =
        visits_[visit_at_[c - c % 3 + static_cast<Index>(prev3(static_cast<int>(c % 3)))]];
    if (cycle_of_visit[static_cast<std::size_t>(&u - visits_.data())] ==
        cycle_of_visit[static_cast<std::size_t>(&w - visits_.data())]) {
      continue;
    }
    pairs.push_back({disk_towards(u, at(w.vertex)), disk_towards(w, at(u.vertex))});
  }
  return pairs;
}

}  // namespace

std::vector<std::array<Index, 2>> place_corner_disks(Packing& packing, const Triangulation& cdt,
                                                     std::span<const Chord> chords,
                                                     double fraction) {
  return CornerDisks(packing, cdt, chords).run(fraction);
}

}  // namespace cover::disks
