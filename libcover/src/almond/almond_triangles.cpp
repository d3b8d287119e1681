// The polygon of an almond has its side as base and its chords around. All its vertices lie on one
// circle, so a triangle over the arc from P1 to P3 has nu = that part of nu(A): large wherever the
// triangle contains a long chord. Without a long chord the centre does it.
// Tested by tests/unit/almond/almond_triangles_test.cpp.
#include "almond/almond_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/predicates.hpp"

namespace cover {
namespace {

class Almonds {
 public:
  Almonds(const ChordLayer& layer, const SplitChords& splits, const CutRule& rule,
          std::vector<Point>& points, std::vector<std::array<std::uint32_t, 3>>& triangles)
      : layer_(layer), splits_(splits), rule_(rule), points_(points), triangles_(triangles) {}

  /// False if rounding made a triangle clockwise, or its angle too large.
  bool triangulate(std::uint32_t k, const Almond& almond) {
    const auto chords = layer_.of(k);
    good_ = true;
    if (chords.size() < 2) return true;  // empty
    const std::size_t first = layer_.first[k], last = layer_.first[k + 1] - 1;
    if (const auto longest = long_chord(chords, almond)) {
      const std::size_t split = first + *longest;
      for (std::size_t c = first; c < split; ++c) fan(almond.v, c);
      for (std::size_t c = split + 1; c <= last; ++c) fan(layer_.chords[split].a, c);
    } else {
      const auto centre = static_cast<std::uint32_t>(points_.size());
      points_.push_back(centre_of(almond, chords));
      add(almond.u, almond.v, centre);
      for (std::size_t c = first; c <= last; ++c) fan(centre, c);
    }
    return good_;
  }

 private:
  /// The first interior chord that is long enough for the two fans.
  [[nodiscard]] std::optional<std::size_t> long_chord(std::span<const ArcChord> chords,
                                                      const Almond& almond) const {
    if (almond.kind == AlmondKind::triangle) return 0;
    const double long_enough = rule_.paper ? 0.5 : std::min(0.5, 1.001 * rule_.nu / almond.nu);
    std::optional<std::size_t> longest;
    for (std::size_t i = 0; i < chords.size(); ++i) {
      const double length = chords[i].place_b - chords[i].place_a;
      if (chords[i].kind != ChordKind::interior || length <= long_enough) continue;
      if (!longest || length > chords[*longest].place_b - chords[*longest].place_a) longest = i;
    }
    return longest;
  }

  /// Midpoint + normal |E|/2 tan((1 - k) nu/2).
  [[nodiscard]] Point centre_of(const Almond& almond, std::span<const ArcChord> chords) const {
    const bool half = rule_.paper || std::any_of(chords.begin(), chords.end(), [](const auto& c) {
                        return c.place_b - c.place_a > kCentre;
                      });
    const double k = half ? kPaperCentre : kCentre;
    return midpoint(almond.from, almond.to) +
           std::tan((1 - k) * almond.nu / 2) / 2 * left_normal(almond.chord());
  }

  /// Triangles between `apex` and the pieces of chord `c`.
  void fan(std::uint32_t apex, std::size_t c) {
    std::uint32_t previous = layer_.chords[c].a;
    for (const std::uint32_t v : splits_.of(c)) {
      add(apex, v, previous);
      previous = v;
    }
    add(apex, layer_.chords[c].b, previous);
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    good_ &= orientation(points_[a], points_[b], points_[c]) == Sign::positive &&
             (!rule_.promises_bound() || rule_.is_kept_by(points_[a], points_[b], points_[c]));
    triangles_.push_back({a, b, c});
  }

  const ChordLayer& layer_;
  const SplitChords& splits_;
  const CutRule& rule_;
  std::vector<Point>& points_;
  std::vector<std::array<std::uint32_t, 3>>& triangles_;
  bool good_ = true;
};

}  // namespace

std::vector<std::uint32_t> triangulate_almonds(
    std::span<const Almond> almonds, const ChordLayer& layer, const SplitChords& splits,
    const CutRule& rule, std::vector<Point>& points,
    std::vector<std::array<std::uint32_t, 3>>& triangles) {
  Almonds work(layer, splits, rule, points, triangles);
  std::vector<std::uint32_t> blamed;
  for (std::uint32_t k = 0; k < almonds.size(); ++k) {
    if (almonds[k].kind == AlmondKind::hull_side) continue;
    if (!work.triangulate(k, almonds[k])) blamed.push_back(k);
  }
  return blamed;
}

}  // namespace cover
