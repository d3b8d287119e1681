// A corner of angle theta gets k = ceil(theta / 120 degrees) disks in equal sectors, each touching
// the two rays of its sector at the same distance t from the corner. (One disk for a convex
// corner near 180 degrees would have a huge radius for its t, and two fail towards 360 degrees.)
// With phi = theta / 2k <= 60 degrees all of it lies within t (1 + sin phi) / cos phi of the
// corner, which is made a fraction below 1/2 of the corner's clearance: so corners cannot touch
// each other or foreign chords. The clearance is that of what is visible inside the sector, found
// by flooding the triangulation from there.
// Tested by tests/unit/disks/fill_disks_test.cpp.
#include "disks/packing/corner_disks.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "disks/packing/visits.hpp"
#include "geom/foot.hpp"

namespace cover::disks {
namespace {

/// The disks of a visit.
struct DiskCorner {
  double theta = kFullTurn;
  Index first_disk = kNone;  ///< element
  Index disks = 1;
  std::vector<Index> touch;  ///< vertices T_0 ... T_k on the rays, from the chord that leaves
};

class CornerDisks {
 public:
  CornerDisks(Packing& packing, const Triangulation& cdt, std::span<const Chord> chords)
      : packing_(packing),
        cdt_(cdt),
        chords_(chords),
        visits_(find_visits(cdt, chords)),
        corners_(visits_.all.size()) {}

  std::vector<std::array<Index, 2>> run(double fraction) {
    for (Index k = 0; k < chords_.size(); ++k) {
      packing_.add_element(make_line(at(chords_[k].a), at(chords_[k].b), k));
    }
    for (Index k = 0; k < corners_.size(); ++k) {
      visit(k).is_isolated() ? fill_point(k, fraction) : fill_corner(k, fraction);
    }
    make_cycles();
    packing_.build_index();
    return pairs_of_cycles();
  }

 private:
  [[nodiscard]] const Visit& visit(Index k) const { return visits_.all[k]; }
  [[nodiscard]] Point at(Index vertex) const { return packing_.point(vertex); }
  [[nodiscard]] double clearance(const Visit& visit) const;
  /// Infinite for an edge seen from outside its triangle: it is hidden, or looked through already.
  [[nodiscard]] double distance_to_edge(Point p, TriangleCorner opposite) const;
  void fill_corner(Index k, double fraction);
  void fill_point(Index k, double fraction);
  void make_cycles();
  std::vector<std::array<Index, 2>> pairs_of_cycles() const;
  [[nodiscard]] Index disk_towards(Index k, Point p) const;

  Packing& packing_;
  const Triangulation& cdt_;
  std::span<const Chord> chords_;
  Visits visits_;
  std::vector<DiskCorner> corners_;  ///< by visit
};

double CornerDisks::distance_to_edge(Point p, TriangleCorner opposite) const {
  const Triangle& t = cdt_.triangles[opposite / 3];
  const Corner i = opposite % 3;
  const Point a = at(t.v[i.next()]), b = at(t.v[i.previous()]);
  const Vector e = b - a, v = p - a;
  if (cross(e, v) <= 0) return kInfinity;
  return norm(v - part_on_segment(e, v) * e);
}

double CornerDisks::clearance(const Visit& visit) const {
  const Point p = at(visit.vertex);
  double d = kInfinity;
  for (const TriangleCorner c : visit.fan) {
    for (const Index v : cdt_.triangles[c / 3].v) {
      if (v != visit.vertex) d = std::min(d, norm(at(v) - p));
    }
  }
  std::vector<TriangleCorner> open;  // edges to look through, by their opposite corners
  const auto look_at = [&](TriangleCorner c) {
    const double distance = distance_to_edge(p, c);
    if (distance >= d) return;
    if (cdt_.triangles[c / 3].is_locked(c % 3)) {
      d = distance;
    } else {
      open.push_back(c);
    }
  };
  for (const TriangleCorner c : visit.fan) look_at(c);
  while (!open.empty()) {
    const TriangleCorner c = open.back();
    open.pop_back();
    const Index n = cdt_.triangles[c / 3].n[c % 3];
    const Corner i = cdt_.triangles[n].edge_to(c / 3);
    d = std::min(d, norm(at(cdt_.triangles[n].v[i]) - p));
    look_at(3 * n + i.next());
    look_at(3 * n + i.previous());
  }
  return d;
}

void CornerDisks::fill_corner(Index k, double fraction) {
  const Index chord_in = visit(k).chord_in, vertex = visit(k).vertex;
  const Point v = at(vertex);
  const Vector out = packing_.elements[k].d, in = -1.0 * packing_.elements[chord_in].d;
  DiskCorner& corner = corners_[k];
  corner.theta = ccw_angle(out, in);
  if (corner.theta == 0) corner.theta = kFullTurn;
  constexpr double kSector = kFullTurn / 3 * (1 + 1e-12);
  corner.disks = static_cast<Index>(std::max(1.0, std::ceil(corner.theta / kSector)));
  const double phi = corner.theta / (2 * corner.disks);
  const double t = fraction * clearance(visit(k)) * std::cos(phi) / (1 + std::sin(phi));
  packing_.elements[k].from = t;
  packing_.elements[chord_in].to -= t;

  const auto ray = [&](double angle) {
    return std::cos(angle) * out + std::sin(angle) * left_normal(out);
  };
  TriangleDraft& draft = packing_.draft;
  corner.touch.push_back(draft.add_on(packing_.elements[k], v + t * out));
  for (Index j = 1; j < corner.disks; ++j) {
    corner.touch.push_back(draft.add(v + t * ray(2 * j * phi)));
  }
  corner.touch.push_back(draft.add_on(packing_.elements[chord_in], v + t * in));
  corner.first_disk = static_cast<Index>(packing_.elements.size());
  for (Index j = 0; j < corner.disks; ++j) {
    const Point c = v + (t / std::cos(phi)) * ray((2 * j + 1) * phi);
    const Index centre = draft.add(c);
    packing_.add_element(make_disk(c, t * std::tan(phi), centre));
    draft.triangle(vertex, corner.touch[j], centre);
    draft.triangle(vertex, centre, corner.touch[j + 1]);
  }
}

void CornerDisks::fill_point(Index k, double fraction) {
  const Index vertex = visit(k).vertex;
  corners_[k].first_disk =
      packing_.add_element(make_disk(at(vertex), fraction * clearance(visit(k)), vertex));
}

void CornerDisks::make_cycles() {
  // Along every walk: line, the disks of the corner at its end from last to first, next line. The
  // side of chord k is side k.
  std::vector<Index> end_of(chords_.size());
  for (Index k = 0; k < chords_.size(); ++k) end_of[visit(k).chord_in] = corners_[k].touch.back();
  for (Index k = 0; k < chords_.size(); ++k) packing_.add_side(k, corners_[k].touch[0], end_of[k]);
  for (Index k = 0; k < corners_.size(); ++k) {
    const DiskCorner& corner = corners_[k];
    if (visit(k).is_isolated()) {
      packing_.add_side(corner.first_disk, kNone, kNone);
      continue;
    }
    Index last = visit(k).chord_in;
    for (Index j = corner.disks; j-- > 0;) {
      const Index s =
          packing_.add_side(corner.first_disk + j, corner.touch[j + 1], corner.touch[j]);
      packing_.link(last, s);
      last = s;
    }
    packing_.link(last, k);
  }
  packing_.find_cycles();
}

Index CornerDisks::disk_towards(Index k, Point p) const {
  const DiskCorner& corner = corners_[k];
  if (visit(k).is_isolated()) return corner.first_disk;
  const double angle = ccw_angle(packing_.elements[k].d, p - at(visit(k).vertex));
  const auto sector = static_cast<Index>(angle / corner.theta * corner.disks);
  return corner.first_disk + std::min(sector, corner.disks - 1);
}

std::vector<std::array<Index, 2>> CornerDisks::pairs_of_cycles() const {
  std::vector<std::array<Index, 2>> pairs;
  if (packing_.cycles.size() < 2) return pairs;
  std::vector<Index> cycle_of(packing_.elements.size());
  for (const Side& s : packing_.sides) cycle_of[s.element] = s.cycle;
  for (const auto& [u, w] : visits_.inner_edges(cdt_)) {
    const Index e = disk_towards(u, at(visit(w).vertex)), f = disk_towards(w, at(visit(u).vertex));
    if (cycle_of[e] != cycle_of[f]) pairs.push_back({e, f});
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
