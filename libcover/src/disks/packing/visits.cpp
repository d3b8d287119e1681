// Tested by tests/unit/disks/fill_disks_test.cpp.
#include "disks/packing/visits.hpp"

#include <algorithm>

#include "geom/topology/half_edges.hpp"

namespace cover::disks {
namespace {

/// The chord of every locked edge, by the corner opposite to it.
std::vector<Index> chords_by_edge(const Triangulation& cdt, std::span<const Chord> chords) {
  std::vector<Index> sorted(chords.size());
  for (Index k = 0; k < sorted.size(); ++k) sorted[k] = k;
  const auto ends = [&](Index k) { return std::array<Index, 2>{chords[k].a, chords[k].b}; };
  std::sort(sorted.begin(), sorted.end(), [&](Index k, Index l) { return ends(k) < ends(l); });
  std::vector<Index> result(3 * cdt.triangles.size(), kNone);
  for (TriangleCorner c = 0; c < result.size(); ++c) {
    const Triangle& t = cdt.triangles[c / 3];
    const Corner i = c % 3;
    if (!t.is_locked(i)) continue;
    const std::array<Index, 2> wanted{t.v[i.next()], t.v[i.previous()]};
    const auto it = std::lower_bound(sorted.begin(), sorted.end(), wanted,
                                     [&](Index k, const auto& e) { return ends(k) < e; });
    if (it != sorted.end() && ends(*it) == wanted) result[c] = *it;
  }
  return result;
}

/// Turns counter-clockwise from `first` to the next chord, or all the way round.
Visit turn_around(const Triangulation& cdt, TriangleCorner first,
                  const std::vector<Index>& chord_by_edge) {
  Visit visit;
  visit.vertex = cdt.triangles[first / 3].v[first % 3];
  TriangleCorner c = first;
  do {
    visit.fan.push_back(c);
    // The edge on the left, from the triangle's third corner to this vertex.
    const TriangleCorner exit = HalfEdges::next(c);
    if (cdt.triangles[c / 3].is_locked(exit % 3)) {
      visit.chord_in = chord_by_edge[exit];
      return visit;
    }
    const Index n = cdt.triangles[c / 3].n[exit % 3];
    c = 3 * n + cdt.triangles[n].corner_of(visit.vertex);
  } while (c != first);
  return visit;
}

}  // namespace

Visits find_visits(const Triangulation& cdt, std::span<const Chord> chords) {
  const std::vector<Index> chord_by_edge = chords_by_edge(cdt, chords);
  Visits visits;
  visits.all.resize(chords.size());
  visits.at_corner.assign(chord_by_edge.size(), kNone);
  for (TriangleCorner c = 0; c < chord_by_edge.size(); ++c) {
    if (chord_by_edge[c] == kNone) continue;
    visits.all[chord_by_edge[c]] = turn_around(cdt, HalfEdges::next(c), chord_by_edge);
  }
  for (Index k = 0; k < visits.all.size(); ++k) {
    for (const TriangleCorner c : visits.all[k].fan) visits.at_corner[c] = k;
  }
  for (TriangleCorner c = 0; c < visits.at_corner.size(); ++c) {  // what is left is isolated
    if (visits.at_corner[c] != kNone) continue;
    visits.all.push_back(turn_around(cdt, c, chord_by_edge));
    for (const TriangleCorner f : visits.all.back().fan) {
      visits.at_corner[f] = static_cast<Index>(visits.all.size() - 1);
    }
  }
  return visits;
}

std::vector<Visits::Edge> Visits::inner_edges(const Triangulation& cdt) const {
  std::vector<Edge> edges;
  for (TriangleCorner c = 0; c < at_corner.size(); ++c) {
    const Triangle& t = cdt.triangles[c / 3];
    if (t.is_locked(c % 3) || t.n[c % 3] < c / 3) continue;
    edges.push_back({at_corner[HalfEdges::next(c)], at_corner[HalfEdges::previous(c)]});
  }
  return edges;
}

}  // namespace cover::disks
