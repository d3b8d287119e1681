// Tested by tests/unit/cuts/before_meshing/split_interfaces_test.cpp.
#include "cuts/before_meshing/broken_cuts.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/faults/internal_fault.hpp"
#include "cdt/cdt.hpp"
#include "cuts/cut_segments.hpp"

namespace cover {
namespace {

using Cuts = std::vector<VertexId>;

Cuts all_cuts(const Pslg& pslg, VertexId first) {
  Cuts cuts;
  for (std::size_t v = first.index(); v < pslg.points.size(); ++v) cuts.emplace_back(v);
  return cuts;
}

/// Where segments meet in the void. What a cut moved may meet what is as it was.
Cuts cuts_of_conflicts(const Pslg& pslg, const std::vector<CdtConflict>& conflicts,
                       VertexId first) {
  Cuts cuts;
  const auto note = [&](std::uint32_t v) {
    if (v >= first.index()) cuts.emplace_back(v);
  };
  const auto note_segment = [&](std::uint32_t s) {
    note(pslg.segments[s].a.value());
    note(pslg.segments[s].b.value());
  };
  for (const CdtConflict& conflict : conflicts) {
    if (conflict.kind == CdtConflict::Kind::crossing) {
      note_segment(conflict.first);
    } else {
      note(conflict.first);
    }
    if (conflict.kind == CdtConflict::Kind::duplicate_point) {
      note(conflict.second);
    } else {
      note_segment(conflict.second);
    }
  }
  if (cuts.empty()) cuts = all_cuts(pslg, first);
  if (cuts.empty()) throw InternalFault("segments meet in the void", {});
  return cuts;
}

/// A cut beside a side of the hull that is in line with it may lie outside by rounding; the hull
/// would have another side then.
Cuts cuts_of_hull(const RegionTable& table, const Triangulation& whole, VertexId first) {
  std::vector<std::array<VertexId, 2>> sides;
  for (const HullSide& side : table.hull_sides) sides.push_back({side.a, side.b});
  std::sort(sides.begin(), sides.end());
  Cuts cuts;
  for (const Triangle& t : whole.triangles) {
    for (const Corner i : kCorners) {
      if (t.n[i] != kNone || t.is_locked(i)) continue;
      const std::array<VertexId, 2> ends{VertexId{t.v[i.next()]}, VertexId{t.v[i.previous()]}};
      if (std::binary_search(sides.begin(), sides.end(), ends)) continue;
      for (const VertexId v : ends) {
        if (v >= first) cuts.push_back(v);
      }
    }
  }
  return cuts;
}

/// A cut may pass what hangs in the void beside it, and cross nothing.
Cuts cuts_of_passed(const Pslg& pslg, const RegionTable& table, const Triangulation& whole,
                    VertexId first) {
  const std::vector<VertexId> passed = void_in_regions(pslg, table, whole);
  if (passed.empty()) return {};
  const auto is_passed = [&](std::uint32_t v) {
    return std::binary_search(passed.begin(), passed.end(), VertexId{v});
  };
  Cuts cuts;
  for (const Triangle& t : whole.triangles) {
    if (std::none_of(t.v.begin(), t.v.end(), is_passed)) continue;
    for (const std::uint32_t v : t.v) {
      if (v >= first.index()) cuts.emplace_back(v);
    }
  }
  return cuts.empty() ? all_cuts(pslg, first) : cuts;
}

}  // namespace

std::vector<VertexId> cuts_that_broke(const RegionBoundary& boundary, const Flaw& flaw,
                                      VertexId first, bool all) {
  Cuts cuts;
  if (!all) {
    for (const std::uint32_t v : flaw.points) {
      if (boundary.vertices[v] >= first) cuts.push_back(boundary.vertices[v]);
    }
  }
  if (!cuts.empty()) return cuts;
  std::copy_if(boundary.vertices.begin(), boundary.vertices.end(), std::back_inserter(cuts),
               [&](VertexId v) { return v >= first; });
  if (cuts.empty()) throw InternalFault(flaw.what, flaw.where);
  return cuts;
}

std::vector<VertexId> cuts_that_broke_void(const Pslg& pslg, const RegionTable& table,
                                           VertexId first) {
  const CdtResult whole = triangulate_whole(pslg);
  if (!whole.conflicts.empty()) return cuts_of_conflicts(pslg, whole.conflicts, first);
  Cuts cuts;
  if (!table.hull_sides.empty()) cuts = cuts_of_hull(table, whole.triangulation, first);
  const Cuts passed = cuts_of_passed(pslg, table, whole.triangulation, first);
  cuts.insert(cuts.end(), passed.begin(), passed.end());
  return cuts;
}

}  // namespace cover
