// Tested by tests/unit/cuts/before_meshing/cut_for_layers_test.cpp.
#include "layers/wall_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.hpp"
#include "geom/curves/arc.hpp"
#include "layers/front/offsets.hpp"
#include "layers/front/side_links.hpp"
#include "layers/front/thickness.hpp"

namespace cover::layers {
namespace {

/// Of a wall's length: the highest row; what is left of the wall is no shorter than half of a row.
constexpr double kMost = 0.5;
/// Of a side's length: so far from a corner at its end feet may lie, since there may be another.
constexpr double kFarthest = 0.5;
/// Of the way between feet: so much farther from the corner they lie than right below the vertices.
/// The coupling across the mitre is zero there, and rounding would make it negative. It is less
/// than what vertices may be apart that become one (LayerFront::closing).
constexpr double kBeyond = 0x1p-22;
constexpr int kHalvings = 64;  ///< after these, a share of a way has the digits of a double

/// The share of the way along an arc from `foot` on where it is that high. Halving serves, since
/// the arc rises all the way: walls are about upright, and no chord spans nearly half a circle.
double share_at_height(const ArcOver& arc, Point foot, Vector normal, double height) {
  double low = 0, high = 1;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    (dot(arc.at(middle) - foot, normal) < height ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::vector<WallPoint> wall_points(const Pslg& pslg, const RegionBoundary& boundary,
                                   std::span<const LayerRule> rules,
                                   std::span<const NextToEnds> pieces) {
  std::vector<WallPoint> out;
  const auto start = [&](std::uint32_t s) { return boundary.points[boundary.sides[s][0]]; };
  const auto end = [&](std::uint32_t s) { return boundary.points[boundary.sides[s][1]]; };
  /// The vertex next to the start of a side, or to its end.
  const auto next_to = [&](std::uint32_t s, bool is_start) {
    const SegmentId segment = boundary.segments[s];
    if (pieces.empty() || segment == kHullSide) return is_start ? end(s) : start(s);
    const bool forward =
        pslg.segments[segment.index()].a == boundary.vertices[boundary.sides[s][0]];
    const NextToEnds& next = pieces[segment.index()];
    return is_start == forward ? next.after_a : next.before_b;
  };
  /// Of a line whose first segment is `edge`, up the wall from `foot` to `top`.
  const auto climb = [&](std::uint32_t edge, Vector normal, std::uint32_t wall, Point foot,
                         Point top) {
    const std::size_t number = boundary.layers[edge] - 1;
    const LayerRule& rule = rules[number];
    const Vector up = top - foot;
    const double height = dot(up, normal);
    const Thickness thickness(rule, height);
    const ArcCircle* circle = circle_of(pslg, pslg.segments[boundary.segments[wall].index()]);
    const std::optional<ArcOver> arc =
        circle != nullptr ? std::optional(ArcOver(*circle, foot, top)) : std::nullopt;
    for (int k = 0; k < thickness.rows(); ++k) {
      const double layer = thickness.layer(k);
      if (rule.count == 0 && k > 0 && layer > length(end(edge) - start(edge))) break;
      if (height - thickness.total(k + 1) < kMost * layer) break;
      const double share = arc ? share_at_height(*arc, foot, normal, thickness.total(k + 1))
                               : thickness.total(k + 1) / height;
      out.push_back({wall, foot + share * up, share * length(up), layer, number});
    }
  };
  const auto is_straight = [&](std::uint32_t s) {
    const SegmentId segment = boundary.segments[s];
    return segment != kHullSide && circle_of(pslg, pslg.segments[segment.index()]) == nullptr;
  };
  /// The feet of the vertices in the mitre of an inner corner, on both sides of it: with these,
  /// right triangles fill the mitre.
  const auto step_back = [&](std::uint32_t s, std::uint32_t n, double turn) {
    if (boundary.layers[s] == 0 || boundary.layers[n] == 0) return;
    const std::size_t number = boundary.layers[s] - 1, other = boundary.layers[n] - 1;
    const LayerRule& rule = rules[number];
    if (rule.count == 0 || !is_straight(s) || !is_straight(n)) return;
    if (!lays_the_same(rule, rules[other])) return;
    const double slope = std::tan(turn / 2 * kDegree);
    const double room = kFarthest * std::min(length(end(s) - start(s)), length(end(n) - start(n)));
    const Thickness thickness(rule, room / slope);
    for (int k = 0; k < thickness.rows(); ++k) {
      const double step = slope * thickness.layer(k);
      const double away = slope * thickness.total(k + 1) + kBeyond * step;
      const Vector back = start(s) - end(s), ahead = end(n) - start(n);
      out.push_back({s, end(s) + (away / length(back)) * back, away, step, number});
      out.push_back({n, start(n) + (away / length(ahead)) * ahead, away, step, other});
    }
  };
  const std::vector<std::uint32_t> next = next_sides(boundary);
  for (std::uint32_t s = 0; s < next.size(); ++s) {
    const std::uint32_t n = next[s];
    const Vector before = unit_normal(next_to(s, false), end(s));
    const Vector after = unit_normal(start(n), next_to(n, true));
    const double turn = turning_angle(before, after);
    if (turn > kMitre && turn < kInnerMitre) step_back(s, n, turn);
    if (std::abs(turn - 90) > kSkew) continue;
    if (boundary.layers[s] != 0 && boundary.segments[n] != kHullSide)
      climb(s, before, n, start(n), end(n));
    if (boundary.layers[n] != 0 && boundary.segments[s] != kHullSide)
      climb(n, after, s, end(s), start(s));
  }
  return out;
}

}  // namespace cover::layers
