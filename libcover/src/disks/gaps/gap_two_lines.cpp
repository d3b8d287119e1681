// Disk, line, disk, line. On each line, touched at A by one disk and at B by the other, there is a
// point M that sees the two centres at a right angle: |AM| |MB| = r0 r2, which has a solution
// because disjoint disks have |AB|^2 >= 4 r0 r2. Three right triangles per line, which meet in the
// line of centres: 6.
// Tested by tests/unit/disks/gaps/gap_test.cpp.
#include "disks/gaps/gap.hpp"

#include <algorithm>
#include <cmath>

namespace cover::disks {
namespace {

/// The triangles between line side k and the line of centres.
void fill_half(TriangleDraft& draft, const Gap& gap, int k) {
  const Element& line = gap.e[static_cast<std::size_t>(k)];
  const Element& first = gap.e[static_cast<std::size_t>((k + 3) & 3)];
  const Element& second = gap.e[static_cast<std::size_t>((k + 1) & 3)];
  const Index a = gap.begin_of(k), b = gap.end_of(k);
  const Vector ab = draft.points[b] - draft.points[a];
  const double l = norm(ab);
  const double root = std::sqrt(std::max(0.0, l * l - 4 * first.r * second.r));
  // The root nearer to the smaller disk; the smaller root by the product, without cancellation.
  const double near = 2 * first.r * second.r / (l + root);
  const double am = first.r <= second.r ? near : l - near;
  const Index m = draft.add_on(line, draft.points[a] + (am / l) * ab);
  draft.triangle(first.id, a, m);
  draft.triangle(first.id, m, second.id);
  draft.triangle(m, b, second.id);
}

}  // namespace

GapKind fill_two_lines(TriangleDraft& draft, const Gap& gap) {
  fill_half(draft, gap, 1);
  fill_half(draft, gap, 3);
  return GapKind::two_lines;
}

}  // namespace cover::disks
