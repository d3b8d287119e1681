// An almond and its neighbour share an interior chord; it occurs once in each direction. So the
// chords that have no partner are exactly the boundary of the remainder, and that this boundary
// closes needs no geometry.
// Tested by tests/unit/almond/chords_test.cpp.
#include "almond/chords.hpp"

#include <algorithm>
#include <cmath>

#include "geom/angle_rounding.hpp"

namespace cover {
namespace {

/// A piece as long as allowed must not fall to rounding: the last 0.3 % of nu(A) are not used.
constexpr double kSpare = 0.003;
/// In theory pieces have a sixth at least; angles of almonds that are no normal numbers have no
/// digits to tell.
constexpr double kShortestPiece = 1.0 / 64;

double piece_limit(double k, double nu) {
  // arccos(cos a / cos b) with a + b = nu, a - b = k nu, without the cancellation where nu is tiny.
  return std::atan(std::sqrt(std::sin(nu) * std::sin(k * nu)) / std::cos((1 + k) * nu / 2)) / nu;
}

/// Chords as the arcs have them, uncut.
std::vector<ArcChord> join_vertices(const ArcLayer& layer) {
  std::vector<ArcChord> chords;
  chords.reserve(layer.vertices.size());
  for (std::uint32_t k = 0; k + 1 < layer.first.size(); ++k) {
    const auto on_arc = layer.of(k);
    for (std::size_t i = 0; i + 1 < on_arc.size(); ++i) {
      chords.push_back({on_arc[i].vertex, on_arc[i + 1].vertex, k, ChordKind::exterior,
                        on_arc[i].place, on_arc[i + 1].place});
    }
  }
  return chords;
}

/// Lists of chords by their first vertex.
class ChordsFrom {
 public:
  ChordsFrom(std::size_t points, std::size_t chords) : head_(points, kNone), next_(chords, kNone) {}

  void add(std::uint32_t c, std::uint32_t from) {
    next_[c] = head_[from];
    head_[from] = c;
  }
  /// The chord from `a` to `b`, or kNone.
  [[nodiscard]] std::uint32_t find(const std::vector<ArcChord>& chords, std::uint32_t a,
                                   std::uint32_t b) const {
    std::uint32_t c = head_[a];
    while (c != kNone && chords[c].b != b) c = next_[c];
    return c;
  }

 private:
  std::vector<std::uint32_t> head_, next_;
};

/// The only chord of an empty almond: the side itself.
bool is_side(const ArcChord& chord) { return chord.place_a == 0 && chord.place_b == 1; }

/// Marks chords that have a partner; returns the almonds of those that occur twice.
///
/// The side of an empty almond is the partner of a chord of the almond that covers it, never of
/// another side: the two sides of a slit are no neighbours.
std::vector<std::uint32_t> pair_chords(std::vector<ArcChord>& chords, std::size_t points) {
  ChordsFrom sides(points, chords.size()), others(points, chords.size());
  std::vector<std::uint32_t> blamed;
  for (std::uint32_t c = 0; c < chords.size(); ++c) {
    const ArcChord& chord = chords[c];
    if (is_side(chord)) {
      sides.add(c, chord.a);
      continue;
    }
    const std::uint32_t twin = others.find(chords, chord.a, chord.b);
    if (twin != kNone) blamed.insert(blamed.end(), {chord.almond, chords[twin].almond});
    others.add(c, chord.a);
  }
  for (ArcChord& chord : chords) {
    if (is_side(chord)) continue;
    std::uint32_t partner = sides.find(chords, chord.b, chord.a);
    if (partner == kNone) partner = others.find(chords, chord.b, chord.a);
    if (partner != kNone) chord.kind = chords[partner].kind = ChordKind::interior;
  }
  return blamed;
}

/// How many pieces a chord is cut into: exterior ones as the rule says, others not at all.
std::size_t count_pieces(const ArcChord& chord, const Almond& almond, const CutRule& rule) {
  if (chord.kind != ChordKind::exterior || almond.kind == AlmondKind::hull_side) return 1;
  const double length = chord.place_b - chord.place_a, longest = rule.longest_piece(almond.nu);
  // 1e-9 of a piece: a sixth of an arc is one piece, not two.
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / longest - 1e-9)));
}

}  // namespace

double CutRule::longest_piece(double almond_nu) const {
  if (paper) return 1.0 / pieces;
  const double needed = nu / almond_nu + kSpare;
  if (piece_limit(kPaperCentre, almond_nu) - needed >= 0.5) return 0.5;
  return std::max(kShortestPiece, std::min(kCentre, piece_limit(kCentre, almond_nu) - needed));
}

bool CutRule::is_kept_by(Point a, Point b, Point c) const {
  if (!is_flatter(a, b, c, std::tan(nu))) return true;
  const double shortest = std::min({length(b - a), length(c - b), length(a - c)});
  return least_nu(a, b, c) + rounding / shortest >= nu * kNuRounded;
}

ChordLayer cut_chords(ArcLayer layer, std::span<const Almond> almonds, const CutRule& rule) {
  std::vector<ArcChord> joined = join_vertices(layer);
  ChordLayer cut;
  cut.blamed = pair_chords(joined, layer.points.size());
  cut.points = std::move(layer.points);
  std::size_t pieces = 0;
  for (ArcChord& chord : joined) {
    const Almond& a = almonds[chord.almond];
    if (chord.kind == ChordKind::exterior && !a.has_arc()) chord.kind = ChordKind::fixed;
    pieces += count_pieces(chord, a, rule);
  }
  cut.chords.reserve(pieces);
  cut.points.reserve(cut.points.size() + pieces - joined.size());
  std::uint32_t almond = 0;
  cut.first.reserve(almonds.size() + 1);
  cut.first.push_back(0);
  for (ArcChord chord : joined) {
    for (; almond < chord.almond; ++almond) {
      cut.first.push_back(static_cast<std::uint32_t>(cut.chords.size()));
    }
    const Almond& a = almonds[chord.almond];
    const std::size_t count = count_pieces(chord, a, rule);
    const double length = chord.place_b - chord.place_a, end = chord.place_b;
    const std::uint32_t last = chord.b;
    for (std::size_t i = 1; i <= count; ++i) {
      if (i == count) {
        chord.b = last;
        chord.place_b = end;
      } else {
        chord.b = static_cast<std::uint32_t>(cut.points.size());
        chord.place_b = end - length * static_cast<double>(count - i) / static_cast<double>(count);
        cut.points.push_back(a.at_place(chord.place_b));
      }
      cut.chords.push_back(chord);
      chord.a = chord.b;
      chord.place_a = chord.place_b;
    }
  }
  while (cut.first.size() <= almonds.size()) {
    cut.first.push_back(static_cast<std::uint32_t>(cut.chords.size()));
  }
  return cut;
}

}  // namespace cover
