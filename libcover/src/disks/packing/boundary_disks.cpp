// A visit to a centre is a side of its disk, clockwise from the end of the chord that arrives to
// the end of the one that leaves; visits to tangency points are the ends of these sides. A vertex
// visited several times has one disk and several sides, a slit the same disks from both sides.
// Tested by tests/unit/nonobtuse/nonobtuse_test.cpp.
#include "disks/packing/boundary_disks.hpp"

#include "disks/packing/visits.hpp"

namespace cover::disks {

std::vector<std::array<Index, 2>> place_boundary_disks(Packing& packing, const Triangulation& cdt,
                                                       std::span<const Chord> chords,
                                                       std::span<const double> radii) {
  const Visits visits = find_visits(cdt, chords);
  std::vector<Index> element_of(radii.size(), kNone);
  for (Index v = 0; v < radii.size(); ++v) {
    if (radii[v] > 0) element_of[v] = packing.add_element(make_disk(packing.point(v), radii[v], v));
  }
  // The side at a centre, by the chord that leaves it.
  std::vector<Index> side_of(chords.size(), kNone);
  for (Index k = 0; k < visits.all.size(); ++k) {
    const Visit& visit = visits.all[k];
    const Index element = element_of[visit.vertex];
    if (visit.is_isolated()) {
      packing.add_side(element, kNone, kNone);
    } else if (element != kNone) {
      side_of[k] = packing.add_side(element, chords[visit.chord_in].a, chords[k].b);
    }
  }
  // Chord k leaves a tangency point, its chord_in the centre before; k arrives at the centre after.
  std::vector<Index> leaving(chords.size());
  for (Index k = 0; k < chords.size(); ++k) leaving[visits.all[k].chord_in] = k;
  for (Index k = 0; k < chords.size(); ++k) {
    if (side_of[k] == kNone) {
      packing.link(side_of[visits.all[k].chord_in], side_of[leaving[k]]);
    }
  }
  packing.find_cycles();
  packing.build_index();

  std::vector<std::array<Index, 2>> pairs;
  if (packing.cycles.size() < 2) return pairs;
  // A vertex may lie on several cycles; what counts is that of the visit. Where a visit is to a
  // tangency point, the disk before it stands for it.
  const auto side_at = [&](Index k) {
    const Visit& visit = visits.all[k];
    return visit.is_isolated() ? kNone : side_of[k] != kNone ? side_of[k] : side_of[visit.chord_in];
  };
  for (const auto& [u, w] : visits.inner_edges(cdt)) {
    const Index s = side_at(u), t = side_at(w);
    if (s != kNone && t != kNone && packing.sides[s].cycle == packing.sides[t].cycle) continue;
    const Index e = s != kNone ? packing.sides[s].element : element_of[visits.all[u].vertex];
    const Index f = t != kNone ? packing.sides[t].element : element_of[visits.all[w].vertex];
    if (e != f) pairs.push_back({e, f});
  }
  return pairs;
}

}  // namespace cover::disks
