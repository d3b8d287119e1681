// Tested by tests/unit/faces/seeds_test.cpp.
#include "faces/beyond_chords.hpp"

#include "geom/box.hpp"
#include "geom/curves/arc.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {

BeyondChords::BeyondChords(const Pslg& pslg, const Faces& faces) : pslg_(pslg), faces_(faces) {
  if (pslg.circles.empty()) return;
  std::vector<Box> boxes;
  for (std::uint32_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& segment = pslg.segments[s];
    if (circle_of(pslg, segment) == nullptr) continue;
    const Point a = pslg.points[segment.a.index()], b = pslg.points[segment.b.index()];
    const double reach = length(b - a);  // twice what the arc, the shorter one, is high at most
    Box box;
    for (const Point p : {a, b}) {
      box.add(p + Vector{-reach, -reach});
      box.add(p + Vector{reach, reach});
    }
    chords_.push_back(s);
    boxes.push_back(box);
  }
  boxes_ = BoxTree(boxes);
}

bool BeyondChords::holds(Point p, std::optional<std::uint32_t> face) const {
  bool found = false;
  boxes_.visit(Box{p, p}, [&](std::uint32_t k) {
    const Segment& segment = pslg_.segments[chords_[k]];
    const Point a = pslg_.points[segment.a.index()], b = pslg_.points[segment.b.index()];
    if (found || !ArcOver(*circle_of(pslg_, segment), a, b).cuts_off(p)) return;
    const std::size_t side = orientation(a, b, p) == Sign::positive ? 0 : 1;
    found = !face || faces_.of_segment[chords_[k]][side] == *face;
  });
  return found;
}

}  // namespace cover
