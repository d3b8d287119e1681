// One disk A has an arc above 180 degrees. The disk D on the line from its centre at right angles
// to the opposite side B that just fills the clearance between A and B splits the wide arc, and its
// own two arcs are exactly 180 degrees. On each side of D lies a third element X:
//  - if D does not reach X, (A, X, B, D) is a gap of four sides without a wide arc;
//  - if D overlaps X, no gap is left. The radical axis of D and X (X itself, if a line) meets the
//    common tangents of D and A and of D and B in P_A and P_B, which have equal tangents to all
//    three elements and so right angles at their contacts; the foot M of D's centre on the axis
//    lies between the centres. 12 triangles, fewer by those of the centre of a line.
// Tested by tests/unit/disks/gaps/gap_test.cpp.
#include "disks/gaps/gap.hpp"

namespace cover::disks {
namespace {

/// One half of a gap split by disk `d`: sides a (from ta), x, b (to tb), d, counter-clockwise.
struct Half {
  Element a, x, b, d;
  Index ta = 0, tax = 0, txb = 0, tb = 0;
};

/// The point of the line through `m` along `w` that lies on the tangent of `disk` in `t`.
Point on_tangent(Point m, Vector w, const Element& disk, Point t) {
  const Vector n = t - disk.c;
  return m + (dot(n, t - m) / dot(n, w)) * w;
}

void fill_overlap(TriangleDraft& draft, const Half& h) {
  const Element& d = h.d;
  Point m;
  Vector w;
  if (h.x.is_line()) {
    m = contact(h.x, d.c);
    w = h.x.d;
  } else {
    const Vector v = h.x.c - d.c;
    const double delta = norm(v);
    m = d.c + ((delta * delta + d.r * d.r - h.x.r * h.x.r) / (2 * delta * delta)) * v;
    w = (1 / delta) * left_normal(v);
  }
  // Neighbours are not both lines, so P_A and P_B split at most one chord each.
  const Index pa = draft.add_on(h.x.is_line() ? h.x : h.a, on_tangent(m, w, d, draft.points[h.ta]));
  const Index foot = draft.add_on(h.x, m);
  const Index pb = draft.add_on(h.x.is_line() ? h.x : h.b, on_tangent(m, w, d, draft.points[h.tb]));
  if (h.a.is_disk()) {
    draft.triangle(h.ta, h.a.id, pa);
    draft.triangle(h.a.id, h.tax, pa);
  }
  draft.triangle(foot, d.id, pa);
  draft.triangle(d.id, h.ta, pa);
  draft.triangle(h.tb, d.id, pb);
  draft.triangle(d.id, foot, pb);
  if (h.x.is_disk()) {
    draft.triangle(h.tax, h.x.id, pa);
    draft.triangle(h.x.id, foot, pa);
    draft.triangle(foot, h.x.id, pb);
    draft.triangle(h.x.id, h.txb, pb);
  }
  if (h.b.is_disk()) {
    draft.triangle(h.txb, h.b.id, pb);
    draft.triangle(h.b.id, h.tb, pb);
  }
}

/// Returns whether the half was a gap.
bool fill_half(TriangleDraft& draft, const Half& h) {
  constexpr double kReached = 1e-3;  // of the radius: a thinner gap is not worth its triangles
  if (signed_distance(h.x, h.d.c) - h.d.r <= kReached * h.d.r) {
    fill_overlap(draft, h);
    return false;
  }
  const Gap gap{4, {h.a, h.x, h.b, h.d}, {h.tax, h.txb, h.tb, h.ta}};
  const GapAngles angles = measure(draft, gap);
  for (int k = 0; k < 4; ++k) {
    if (angles.beta[static_cast<std::size_t>(k)] > std::numbers::pi / 2 + kFlatGap) {
      fill_by_cut(draft, gap, angles, k);
      return true;
    }
  }
  fill_good(draft, gap, angles);
  return true;
}

}  // namespace

GapKind fill_reflex(TriangleDraft& draft, const Gap& gap) {
  const Element& a = gap.e[0];
  const Element& b = gap.e[2];
  const Point on_b = contact(b, a.c);
  const Vector u = (1 / norm(on_b - a.c)) * (on_b - a.c);
  const Point on_a = a.c + a.r * u;
  const Point centre = midpoint(on_a, on_b);
  const Index ta = draft.add(on_a), tb = draft.add_on(b, on_b);
  const Element d = make_disk(centre, norm(on_b - on_a) / 2, draft.add(centre));
  // Side 0 runs from t[3] to t[0]: side 1 lies beyond its end, side 3 before its start.
  const bool first = fill_half(draft, {a, gap.e[1], b, d, ta, gap.t[0], gap.t[1], tb});
  const bool second = fill_half(draft, {b, gap.e[3], a, d, tb, gap.t[2], gap.t[3], ta});
  return first && second ? GapKind::reflex : GapKind::reflex_overlap;
}

}  // namespace cover::disks
