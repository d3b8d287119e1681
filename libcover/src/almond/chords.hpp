// The chords between consecutive vertices of the arcs: what the almonds are made of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "almond/almond.hpp"
#include "almond/arc_layer.hpp"

namespace cover {

/// What lies on the far side of a chord.
enum class ChordKind : std::uint8_t {
  interior,  ///< another almond, or (the paper's "locked") a segment whose own almond is empty
  exterior,  ///< the remainder
  fixed,  ///< the remainder, but the chord must stay whole: there is no arc, it stands in for one
};

/// A chord of the arc of `almond` from `a` to `b`, in the direction from u to v.
/// The almond lies on its right.
struct ArcChord {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t almond = 0;
  ChordKind kind = ChordKind::exterior;
  double place_a = 0;
  double place_b = 0;
};

/// How exterior chords are cut, and where the centre of an almond lies.
struct CutRule {
  bool paper = false;  ///< pieces of 1/`pieces` of the arc, centre at k = 1/2
  int pieces = 6;
  double nu = 0;        ///< what every triangle has to keep: promise 3
  double rounding = 0;  ///< a length: over the shortest edge of a triangle, what rounding the
                        ///< coordinates can change in its angles

  /// The longest exterior piece of the arc of an almond, as a part of the arc.
  ///
  /// A triangle between the centre Q and a piece of j of the arc keeps (g - j) nu(A), with
  /// g = arccos(cos((1+k) nu/2) / cos((1-k) nu/2)) / nu. So j is as large as g - nu/nu(A) allows,
  /// and never above 1/2.
  /// Ref: mitchell_1993_covering, Theorem 5, with the exact constant in place of 2/3
  [[nodiscard]] double longest_piece(double almond_nu) const;

  /// True if the triangle keeps `nu`, up to rounding of its corners.
  [[nodiscard]] bool is_kept_by(Point a, Point b, Point c) const;

  /// The publication's own program cut into three: then its bound is not the one of promise 3.
  [[nodiscard]] bool promises_bound() const { return !paper || pieces >= 5; }
};

/// The parameter k of an almond's centre Q, which sees the side under pi - (1 - k) nu.
inline constexpr double kCentre = 0.495;
inline constexpr double kPaperCentre = 0.5;

/// All chords, by almond.
struct ChordLayer {
  std::vector<Point> points;         ///< those of the arc layer, then where exterior chords are cut
  std::vector<std::uint32_t> first;  ///< by almond, into `chords`; one more at the end
  std::vector<ArcChord> chords;      ///< from u to v
  std::vector<std::uint32_t> blamed;  ///< almonds that claim the same chord on the same side

  [[nodiscard]] std::span<const ArcChord> of(std::size_t almond) const {
    return std::span(chords).subspan(first[almond], first[almond + 1] - first[almond]);
  }
};

/// Makes the chords of all arcs, tells interior from exterior ones, and cuts the latter.
///
/// A chord is interior just where another arc has the same two vertices as neighbours in the
/// opposite order: then that arc's almond is entered at one and left at the other.
/// Cost: O(n)
/// Ref:  mitchell_1993_covering, section 3
ChordLayer cut_chords(ArcLayer layer, std::span<const Almond> almonds, const CutRule& rule);

}  // namespace cover
