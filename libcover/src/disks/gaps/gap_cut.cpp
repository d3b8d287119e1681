// The circle's centre lies beyond the chord of side i. A cut from a point s_i on side i to a point
// s_j on the opposite side j makes two quadrilaterals with better centres. Disks touching i and j
// between the other two sides k and l form a family; for each, its contacts s_i, s_j are cocircular
// with the tangency points around k and with those around l (only these points are used, not the
// disk). The family is parametrised by the angle a between side i and the left circle in T_i, the
// tangency point of i and k: then half the arc of the left circle over side k is pi - gamma_k - a.
//
//                 j            Conditions: all half angles of both quadrilaterals, as seen from
//            T_k--s_j--T_j     their centres cl and cr, are at most pi/2. The slack is a minimum
//      k      |cl  |m cr|   l  of monotone functions of a; its maximum is found by sampling and
//            T_i--s_i--T_l     golden section. A cut with positive slack existed in each of
//                 i            134,000 sampled gaps; none is known to fail but where opposite
//                              sides nearly touch, which is split beforehand.
// Tested by tests/unit/disks/gaps/gap_test.cpp.
#include "base/numbers.hpp"
#include "disks/gaps/gap.hpp"
#include "geom/foot.hpp"
#include "geom/triangle.hpp"

#include <algorithm>
#include <cmath>

namespace cover::disks {
namespace {

struct Cut {
  Point si, sj, cl, cr;
  double slack = -kInfinity;
};

/// Mirror image of `p`, a point of the rim of `e`, in the line through the centres of `e` and of a
/// circle around `c`: where that circle meets the rim again.
Point mirrored(const Element& e, Point p, Point c) {
  if (e.is_line()) return p + (-2 * dot(e.d, p - c)) * e.d;
  const Vector u = c - e.c, v = p - e.c;
  return e.c + (2 * part_on_line(u, v)) * u + (-1.0) * v;
}

/// pi/2 minus the largest half angle of the quadrilateral as seen from `c`.
double slack(Point c, const std::array<Point, 4>& q) {
  double widest = 0;
  for (std::size_t k = 0; k < 4; ++k)
    widest = std::max(widest, ccw_angle(q[k] - c, q[(k + 1) & 3] - c));
  return std::numbers::pi / 2 - widest / 2;
}

/// Cuts side 0 from side 2; sides 1 (k) and 3 (l) lie to the left and to the right of the cut.
class Cutter {
 public:
  Cutter(const TriangleDraft& draft, const Gap& gap, double gamma_k)
      : gap_(gap),
        ti_(draft.points[gap.t[0]]),
        tk_(draft.points[gap.t[1]]),
        tj_(draft.points[gap.t[2]]),
        tl_(draft.points[gap.t[3]]),
        gamma_k_(gamma_k) {}

  [[nodiscard]] Cut at(double a) const {
    Cut cut;
    const double beta = std::numbers::pi - gamma_k_ - a;
    const Vector chord = tk_ - ti_;
    cut.cl = midpoint(ti_, tk_) + (0.5 * std::cos(beta) / std::sin(beta)) * left_normal(chord);
    cut.si = mirrored(gap_.e[0], ti_, cut.cl);
    cut.sj = mirrored(gap_.e[2], tk_, cut.cl);
    cut.cr = circumcentre(tj_, tl_, cut.si);
    const double s = std::min(slack(cut.cl, {ti_, tk_, cut.sj, cut.si}),
                              slack(cut.cr, {tj_, tl_, cut.si, cut.sj}));
    if (std::isfinite(s)) cut.slack = s;
    return cut;
  }

  [[nodiscard]] Cut best(double limit) const {
    constexpr int kSamples = 24;
    constexpr int kGoldenSteps = 30;
    int start = 1;
    Cut best = at(limit / (kSamples + 1));
    for (int k = 2; k <= kSamples; ++k) {
      const Cut cut = at(limit * k / (kSamples + 1));
      if (cut.slack > best.slack) best = cut, start = k;
    }
    double low = limit * (start - 1) / (kSamples + 1), high = limit * (start + 1) / (kSamples + 1);
    constexpr double kGolden = 0.6180339887498949;
    for (int k = 0; k < kGoldenSteps; ++k) {
      const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
      const Cut first = at(a), second = at(b);
      if (first.slack > best.slack) best = first;
      if (second.slack > best.slack) best = second;
      first.slack > second.slack ? high = b : low = a;
    }
    return best;
  }

 private:
  const Gap& gap_;
  Point ti_, tk_, tj_, tl_;
  double gamma_k_;
};

}  // namespace

GapKind fill_by_cut(TriangleDraft& draft, const Gap& gap, const GapAngles& angles, int side) {
  const Gap g = gap.from_side(side);
  const auto i = static_cast<std::size_t>(side), k = static_cast<std::size_t>((side + 1) & 3);
  const Cut cut = Cutter(draft, g, angles.gamma[k]).best(angles.beta[i] + angles.gamma[i]);
  const Index si = draft.add_on(g.e[0], cut.si), sj = draft.add_on(g.e[2], cut.sj);
  const Index cl = draft.add(cut.cl), cr = draft.add(cut.cr);
  fan(draft, g.e[1], g.t[0], g.t[1], cl);
  fan(draft, g.e[3], g.t[2], g.t[3], cr);
  fan(draft, g.e[0], g.t[3], si, cr);
  fan(draft, g.e[0], si, g.t[0], cl);
  fan(draft, g.e[2], g.t[1], sj, cl);
  fan(draft, g.e[2], sj, g.t[2], cr);
  const Index m = draft.add(midpoint(cut.si, cut.sj));
  draft.triangle(sj, m, cl);
  draft.triangle(m, si, cl);
  draft.triangle(si, m, cr);
  draft.triangle(m, sj, cr);
  return GapKind::cut;
}

}  // namespace cover::disks
