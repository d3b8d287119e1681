// The stages of the almond method on one region.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "almond/chords.hpp"
#include "support/inputs/shapes.hpp"

namespace cover::testing {

/// All stages up to the chords of one region.
struct Stages {
  RegionBoundary boundary;
  Triangulation cdt;
  AngleLimit limit;
  std::vector<Almond> almonds;
  CutRule rule;
  ChordLayer layer;

  explicit Stages(RegionBoundary region, bool paper = true) : boundary(std::move(region)) {
    cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
    limit = angle_limit(cdt, boundary.sides, boundary.segments);
    almonds = make_almonds(cdt, boundary.sides, boundary.segments, limit, {});
    rule = {paper, 6, limit.promised_nu(), 1e-15};
    layer = cut_chords(lay_arcs(cdt, almonds, 1), almonds, rule);
  }
  [[nodiscard]] std::size_t count(ChordKind kind) const {
    return static_cast<std::size_t>(std::count_if(layer.chords.begin(), layer.chords.end(),
                                                  [&](const auto& c) { return c.kind == kind; }));
  }
};

inline RegionBoundary square() { return boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}); }

}  // namespace cover::testing
