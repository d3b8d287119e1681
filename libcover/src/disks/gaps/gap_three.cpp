// Three sides. Three disks: the circle through the tangency points is the incircle of the triangle
// of centres, so its centre I sees every tangency point at a right angle to the radius: 6 triangles
// (c, T, I). Two disks and a line: the common tangent of the disks meets the line in M, and
// tangents from M are equally long, so that M is also the middle between the contacts A, B on the
// line; radii are at right angles to tangents: 4 triangles.
// Tested by tests/unit/disks/gaps/gap_test.cpp.
#include "disks/gaps/gap.hpp"
#include "geom/triangle.hpp"

namespace cover::disks {
namespace {

GapKind with_line(TriangleDraft& draft, const Gap& gap) {  // the line is side 2
  const Index a = gap.begin_of(2), b = gap.end_of(2), t = gap.end_of(0);
  const Index m = draft.add_on(gap.e[2], midpoint(draft.points[a], draft.points[b]));
  draft.triangle(b, gap.e[0].id, m);
  draft.triangle(gap.e[0].id, t, m);
  draft.triangle(t, gap.e[1].id, m);
  draft.triangle(gap.e[1].id, a, m);
  return GapKind::two_disks_line;
}

}  // namespace

GapKind fill_three(TriangleDraft& draft, const Gap& gap) {
  for (int k = 0; k < 3; ++k) {
    if (gap.e[static_cast<std::size_t>(k)].is_line())
      return with_line(draft, gap.from_side((k + 1) % 3));
  }
  const Index centre = draft.add(
      circumcentre(draft.points[gap.t[0]], draft.points[gap.t[1]], draft.points[gap.t[2]]));
  for (int k = 0; k < 3; ++k) {
    const Index c = gap.e[static_cast<std::size_t>(k)].id;
    draft.triangle(gap.begin_of(k), c, centre);
    draft.triangle(c, gap.end_of(k), centre);
  }
  return GapKind::three_disks;
}

}  // namespace cover::disks
