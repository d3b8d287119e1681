// Tested by tests/unit/almond/fill/remainder_test.cpp.
#include "almond/fill/remainder.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "base/containers/order.hpp"
#include "geom/predicates.hpp"

namespace cover {
namespace {

/// Almonds whose chords meet vertex `v` of the remainder.
void blame_vertex(const Remainder& r, const ChordLayer& layer, std::uint32_t v,
                  std::vector<std::uint32_t>& almonds) {
  for (std::size_t c = 0; c < r.chords.size(); ++c) {
    if (r.chords[c].a == v || r.chords[c].b == v) {
      almonds.push_back(layer.chords[r.arc_chord[c]].almond);
    }
  }
}

/// The almonds whose chords cross `chord`.
void blame_all_across(const Remainder& r, const ChordLayer& layer, std::span<const Point> points,
                      const Chord& chord, std::vector<std::uint32_t>& almonds) {
  const Point a = points[chord.a], b = points[chord.b];
  const auto are_on_both_sides = [](Sign p, Sign q) {
    return static_cast<int>(p) * static_cast<int>(q) < 0;
  };
  for (std::size_t k = 0; k < r.chords.size(); ++k) {
    const Point c = points[r.chords[k].a], d = points[r.chords[k].b];
    if (are_on_both_sides(orientation(a, b, c), orientation(a, b, d)) &&
        are_on_both_sides(orientation(c, d, a), orientation(c, d, b)))
      almonds.push_back(layer.chords[r.arc_chord[k]].almond);
  }
}

/// The almonds that a conflict of the constrained triangulation points at. Of a side that has no
/// arc any more, all that cross it: one by one they would take some trials each.
std::vector<std::uint32_t> blame_for(const Remainder& r, const ChordLayer& layer,
                                     std::span<const Almond> of_sides,
                                     std::span<const Point> points, const CdtConflict& conflict) {
  std::vector<std::uint32_t> almonds;
  const auto chord = [&](std::uint32_t c) {
    almonds.push_back(layer.chords[r.arc_chord[c]].almond);
  };
  switch (conflict.kind) {
    case CdtConflict::Kind::duplicate_point:
      blame_vertex(r, layer, conflict.first, almonds);
      blame_vertex(r, layer, conflict.second, almonds);
      break;
    case CdtConflict::Kind::point_on_segment:
      blame_vertex(r, layer, conflict.first, almonds);
      chord(conflict.second);
      break;
    case CdtConflict::Kind::crossing:
      for (const std::uint32_t c : {conflict.first, conflict.second}) {
        chord(c);
        if (!of_sides[almonds.back()].has_arc())
          blame_all_across(r, layer, points, r.chords[c], almonds);
      }
      break;
  }
  return almonds;
}

/// The almonds of all `conflicts`, but for those that share an almond with one before: where many
/// chords cross one, it is the one to be changed, not all of them.
std::vector<std::uint32_t> blame(const Remainder& r, const ChordLayer& layer,
                                 std::span<const Almond> of_sides, std::span<const Point> points,
                                 std::span<const CdtConflict> conflicts) {
  std::vector<std::uint32_t> almonds;
  std::vector<bool> is_blamed(of_sides.size(), false);
  for (const CdtConflict& conflict : conflicts) {
    const std::vector<std::uint32_t> more = blame_for(r, layer, of_sides, points, conflict);
    if (std::any_of(more.begin(), more.end(), [&](std::uint32_t k) { return is_blamed[k]; }))
      continue;
    for (const std::uint32_t k : more) is_blamed[k] = true;
    almonds.insert(almonds.end(), more.begin(), more.end());
  }
  return almonds;
}

/// Beside an almond the fill need not be better than the almond itself: 35 degrees for one of 60,
/// and less in proportion. (Else a flat almond in a narrow place would cost vertices without end.)
double fill_nu(const Almond& almond) {
  return almond.kind == AlmondKind::hull_side ? std::numbers::pi : almond.nu * 7 / 12;
}

}  // namespace

Remainder find_remainder(const ChordLayer& layer, std::span<const Almond> almonds,
                         std::span<const std::uint32_t> isolated, std::size_t most_conflicts) {
  Remainder r;
  std::vector<Point> points;
  std::vector<std::uint32_t> local(layer.points.size(), kNone);
  const auto add = [&](std::uint32_t v) {
    if (local[v] == kNone) {
      local[v] = static_cast<std::uint32_t>(r.vertex.size());
      r.vertex.push_back(v);
      points.push_back(layer.points[v]);
    }
    return local[v];
  };
  const auto chords = static_cast<std::size_t>(
      std::count_if(layer.chords.begin(), layer.chords.end(),
                    [](const ArcChord& chord) { return chord.kind != ChordKind::interior; }));
  std::vector<IndexPair> pairs;
  pairs.reserve(chords);
  r.chords.reserve(chords);
  r.arc_chord.reserve(chords);
  for (std::uint32_t c = 0; c < layer.chords.size(); ++c) {
    const ArcChord& chord = layer.chords[c];
    if (chord.kind == ChordKind::interior) continue;
    const std::uint32_t a = add(chord.a), b = add(chord.b);
    pairs.push_back({a, b});
    r.chords.push_back({a, b, chord.kind == ChordKind::fixed, fill_nu(almonds[chord.almond])});
    r.arc_chord.push_back(c);
  }
  if (r.chords.empty()) return r;
  for (const std::uint32_t v : isolated) add(v);

  CdtResult result = triangulate_domain(points, pairs, most_conflicts);
  if (!result.conflicts.empty()) {
    r.blamed = blame(r, layer, almonds, points, result.conflicts);
    return r;
  }
  r.cdt = std::move(result.triangulation);
  for (const std::uint32_t c : match_chords(r.cdt, r.chords, r.edges)) {
    r.blamed.push_back(layer.chords[r.arc_chord[c]].almond);
  }
  return r;
}

Remainder whole_region(const Triangulation& cdt, const ChordLayer& layer,
                       std::span<const Almond> almonds) {
  Remainder r;
  reserve_for_refinement(cdt.points.size(), cdt.triangles.size(), r.cdt, r.edges);
  r.cdt.points.assign(cdt.points.begin(), cdt.points.end());
  r.cdt.triangles.assign(cdt.triangles.begin(), cdt.triangles.end());
  r.vertex.resize(cdt.points.size());
  std::iota(r.vertex.begin(), r.vertex.end(), 0U);
  r.chords.reserve(layer.chords.size());
  r.arc_chord.reserve(layer.chords.size());
  for (std::uint32_t c = 0; c < layer.chords.size(); ++c) {
    const ArcChord& chord = layer.chords[c];
    const bool locked = chord.kind == ChordKind::fixed;
    r.chords.push_back({chord.a, chord.b, locked, fill_nu(almonds[chord.almond])});
    r.arc_chord.push_back(c);
  }
  for (const std::uint32_t c : match_chords(r.cdt, r.chords, r.edges)) {
    r.blamed.push_back(layer.chords[r.arc_chord[c]].almond);
  }
  return r;
}

RemainderPart part_of(const Remainder& remainder, std::span<const std::uint32_t> members,
                      std::size_t known) {
  RemainderPart part;
  std::vector<std::uint32_t> vertices, chords;
  for (const std::uint32_t t : members) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = remainder.cdt.triangles[t].v[i], c = remainder.edges[t][i];
      if (v < known) vertices.push_back(v);
      if (c != kNone) chords.push_back(c);
    }
  }
  sort_unique(vertices);
  sort_unique(chords);
  part.vertex = std::move(vertices);
  part.chord = std::move(chords);
  const auto local = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(part.vertex.begin(), part.vertex.end(), v) -
                                      part.vertex.begin());
  };
  for (const std::uint32_t v : part.vertex) part.task.points.push_back(remainder.cdt.points[v]);
  for (const std::uint32_t c : part.chord) {
    const Chord& chord = remainder.chords[c];
    part.task.chords.push_back({local(chord.a), local(chord.b), chord.locked, chord.nu});
  }
  return part;
}

std::vector<std::uint32_t> connected_parts(const Triangulation& cdt) {
  std::vector<std::uint32_t> part(cdt.triangles.size(), kNone), stack;
  std::uint32_t count = 0;
  for (std::uint32_t start = 0; start < cdt.triangles.size(); ++start) {
    if (part[start] != kNone) continue;
    part[start] = count;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (const std::uint32_t next : cdt.triangles[t].n) {
        if (next == kNone || part[next] != kNone) continue;
        part[next] = count;
        stack.push_back(next);
      }
    }
    ++count;
  }
  return part;
}

}  // namespace cover
