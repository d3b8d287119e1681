// Tested by tests/unit/clean/arcs/crossing_chords_test.cpp.
#include "clean/arcs/crossing_chords.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "clean/arcs/cut_chords.hpp"
#include "geom/box.hpp"
#include "geom/curves/arc.hpp"
#include "geom/predicates.hpp"
#include "geom/search/box_tree.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// How often a chord is halved at most. Arcs so near that this does not part them are taken for a
/// mistake, such as one arc drawn twice with two radii, not worth thousands of chords: they are
/// halved kForNothing times.
constexpr int kMostHalvings = 8, kForNothing = 4;
/// Halving one chord lets it cross that of the next arc, and so on: so many arcs in a row.
constexpr int kMostInARow = 64;
/// Of the way along a chord: how well it is known where circles touch, the root of rounding.
constexpr double kTouching = 0x1p-20;
/// Where one circle touches another from inside, the chord of the larger one leaves the tangent by
/// at most so much of the angle by which that of the smaller one does: by less, but for rounding.
constexpr double kPartOfAngle = 1 - 0x1p-10;

/// The common end of two segments that differ.
std::optional<Point> common_end(const InputChord& c, const InputChord& d) {
  if (c.a == d.a || c.a == d.b) return c.a;
  if (c.b == d.a || c.b == d.b) return c.b;
  return std::nullopt;
}

/// Whether two segments without a common end have a point in common; not so if they lie on one
/// line.
bool cross_each_other(const InputChord& c, const InputChord& d) {
  const auto parts = [](const InputChord& line, const InputChord& ends) {
    const Sign one = orientation(line.a, line.b, ends.a),
               other = orientation(line.a, line.b, ends.b);
    return one != other;
  };
  return parts(c, d) && parts(d, c);
}

class ChordParter {
 public:
  ChordParter(const Input& input, const TouchingCircles& touching)
      : input_(input), touching_(touching) {
    for (const InputChord& chord : chords_of(input)) {
      const auto origin = static_cast<std::uint32_t>(chords_.size());
      chords_.push_back(chord);
      pieces_.push_back({chord, origin});
    }
    std::vector<Box> boxes;
    boxes.reserve(chords_.size());
    for (const InputChord& chord : chords_) boxes.push_back(box_where_met(chord));
    arcs_ = BoxTree(boxes);
  }

  void run() {
    for (int round = 0; round < kMostInARow; ++round) {
      const std::vector<int> crossing = find_crossing();
      if (round == 0) note_places(crossing);
      if (!halve(crossing)) break;
    }
    if (where_.empty()) return;
    for (Piece& piece : pieces_) piece.is_new = true;
    gap_ = kInfinity;
    const std::vector<int> crossing = find_crossing();
    left_ =
        crossing.size() - static_cast<std::size_t>(std::count(crossing.begin(), crossing.end(), 0));
  }

  [[nodiscard]] ChordCuts cuts() const {
    ChordCuts cuts;
    for (const Piece& piece : pieces_) {
      const InputChord& whole = chords_[piece.origin];
      for (const Point p : {piece.chord.a, piece.chord.b}) {
        if (p != whole.a && p != whole.b) cuts[whole].push_back(p);
      }
    }
    for (auto& [whole, points] : cuts) {
      const ArcOver arc = arc_over(whole);
      std::sort(points.begin(), points.end(), [&](Point p, Point q) {
        return std::pair(arc.share_of(p), p) < std::pair(arc.share_of(q), q);
      });
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
    return cuts;
  }

  void tell(std::size_t halved, std::vector<Note>& notes) const {
    if (where_.empty()) return;
    notes.push_back(
        {Note::Kind::warning, kVoid,
         fmt::format(
             "{} crossed chords of other arcs, though their arcs do not cross, the first at {}: {} "
             "cut on {}{}; finer chords keep them apart (a smaller --chord-angle or "
             "--chord-error of DXF, chord_error of JSON)",
             counted(where_.size(), "chord"), describe(where_.front()),
             halved == 1 ? "1 was" : fmt::format("{} were", halved),
             halved == 1 ? "its arc" : "their arcs",
             left_ == 0 ? std::string(", and no longer cross")
                        : fmt::format(", of whose pieces {} still cross", left_) + what_parts()),
         where_});
  }

 private:
  /// Which chords would not cross, where circles are known to lie in each other.
  [[nodiscard]] std::string what_parts() const {
    return gap_ == kInfinity ? "" : fmt::format(" (arcs are {:.2g} apart)", gap_);
  }

  /// A chord, or a piece of one after halving.
  struct Piece {
    InputChord chord;
    std::uint32_t origin = 0;  ///< index into chords_
    int halvings = 0;          ///< that it comes from
    bool is_new = true;        ///< nobody has looked yet whether it crosses others
  };

  [[nodiscard]] ArcOver arc_over(const InputChord& chord) const {
    return cover::arc_over(input_, chord);
  }

  /// Where the arc may be met, up to how well touching places are known.
  [[nodiscard]] Box box_where_met(const InputChord& chord) const {
    return box_around_arc(
        input_, chord,
        2 * kTouching * length(chord.b - chord.a) + arc_over(chord).rounding_at(chord.a));
  }

  /// By piece: how many halvings it may come from, where it crosses another and one is new; else 0.
  std::vector<int> find_crossing() {
    std::vector<Box> boxes;
    boxes.reserve(pieces_.size());
    for (const Piece& piece : pieces_)
      boxes.push_back(box_of(std::array{piece.chord.a, piece.chord.b}));
    const BoxTree tree(boxes);
    std::vector<int> found(pieces_.size(), 0);
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      if (!pieces_[k].is_new) continue;
      tree.visit(boxes[k], [&](std::uint32_t j) {
        if (j == k || (pieces_[j].is_new && j < k)) return;
        look(k, j, found);
      });
    }
    for (Piece& piece : pieces_) piece.is_new = false;
    return found;
  }

  void note_places(const std::vector<int>& crossing) {
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (crossing[k] > 0) where_.push_back(midpoint(pieces_[k].chord.a, pieces_[k].chord.b));
    }
  }

  /// Whether what is drawn of two circles meets. Where it does, chords cross too, though not always
  /// those below the very place, and that is as it should be.
  bool do_arcs_meet(std::uint32_t one, std::uint32_t other) {
    if (touching_.contains(std::minmax(one, other))) return false;
    const auto [known, is_new] = do_meet_.try_emplace(std::minmax(one, other), false);
    if (!is_new) return known->second;
    const auto is_drawn = [&](std::uint32_t circle, Point p) {
      bool is_there = false;
      arcs_.visit(box_of(std::array{p}), [&](std::uint32_t k) {
        if (is_there || chords_[k].circle != circle) return;
        const double share = arc_over(chords_[k]).share_of(p);
        is_there = share >= -kTouching && share <= 1 + kTouching;
      });
      return is_there;
    };
    for (const Point p : common_points(input_.circles[one - 1], input_.circles[other - 1]))
      known->second |= is_drawn(one, p) && is_drawn(other, p);
    return known->second;
  }

  /// The halvings after which a piece of the larger of two circles, one inside the other, is no
  /// farther off its arc than the circles from each other.
  int halvings_for(const Piece& piece, const ArcCircle& own, const ArcCircle& other) {
    const double gap = own.radius - other.radius - length(own.centre - other.centre);
    if (!(gap > 0) || !(gap < own.radius)) return kForNothing;
    gap_ = std::min(gap_, gap);
    const double half = length(piece.chord.b - piece.chord.a) / (2 * own.radius);
    // The height over half a chord h of a radius of 1 is about h^2 / 2; one more for rounding.
    const double needed =
        piece.halvings + 1 + std::ceil(std::log2(half / std::sqrt(2 * gap / own.radius)));
    return needed <= kMostHalvings ? std::max(static_cast<int>(needed), kForNothing) : kForNothing;
  }

  /// Says that a piece crosses one of another circle.
  void note_crossing(std::uint32_t k, const InputChord& other, std::vector<int>& found) {
    const Piece& piece = pieces_[k];
    found[k] = std::max(found[k], halvings_for(piece, input_.circles[piece.chord.circle - 1],
                                               input_.circles[other.circle - 1]));
  }

  void look(std::uint32_t k, std::uint32_t j, std::vector<int>& found) {
    const InputChord &c = pieces_[k].chord, &d = pieces_[j].chord;
    if (c.circle == d.circle) return;
    if (const auto end = common_end(c, d)) return look_at_touching(k, j, *end, found);
    if (!cross_each_other(c, d)) return;
    if (do_arcs_meet(c.circle, d.circle)) return;
    const ArcOver over_c = arc_over(c), over_d = arc_over(d);
    const bool by_c = over_c.cuts_off(d.a) || over_c.cuts_off(d.b);
    const bool by_d = over_d.cuts_off(c.a) || over_d.cuts_off(c.b);
    if (by_c || !by_d) note_crossing(k, d, found);
    if (by_d || !by_c) note_crossing(j, c, found);
  }

  /// Chords from the point where one circle touches another from inside would lie on each other, or
  /// change sides, if that of the larger one were no finer.
  void look_at_touching(std::uint32_t k, std::uint32_t j, Point end, std::vector<int>& found) {
    const InputChord &c = pieces_[k].chord, &d = pieces_[j].chord;
    if (!touching_.contains(std::minmax(c.circle, d.circle))) return;
    const ArcCircle &one = input_.circles[c.circle - 1], &other = input_.circles[d.circle - 1];
    if (dot(one.centre - end, other.centre - end) <= 0) return;
    const Vector along_c = (c.a == end ? c.b : c.a) - end, along_d = (d.a == end ? d.b : d.a) - end;
    if (dot(along_c, along_d) <= 0) return;
    const double angle_c = length(along_c) / one.radius, angle_d = length(along_d) / other.radius;
    if (one.radius > other.radius) {
      if (angle_c > kPartOfAngle * angle_d) found[k] = std::max(found[k], kForNothing);
    } else if (angle_d > kPartOfAngle * angle_c) {
      found[j] = std::max(found[j], kForNothing);
    }
  }

  /// False if none may be halved.
  bool halve(const std::vector<int>& crossing) {
    const std::size_t before = pieces_.size();
    for (std::size_t k = 0; k < crossing.size(); ++k) {
      if (pieces_[k].halvings >= crossing[k]) continue;
      const Piece whole = pieces_[k];
      const Point middle = arc_over(whole.chord).middle();
      const auto piece = [&](Point p) {
        InputChord chord = whole.chord;
        chord.a = std::min(p, middle);
        chord.b = std::max(p, middle);
        return Piece{chord, whole.origin, whole.halvings + 1};
      };
      pieces_[k] = piece(whole.chord.a);
      pieces_.push_back(piece(whole.chord.b));
    }
    return pieces_.size() > before;
  }

  const Input& input_;
  const TouchingCircles& touching_;
  std::vector<InputChord> chords_;  ///< as the input has them
  std::vector<Piece> pieces_;
  BoxTree arcs_;  ///< around the arcs over chords_
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> do_meet_;  ///< by two numbers of circles
  std::vector<Point> where_;  ///< the middles of the chords that crossed at first
  std::size_t left_ = 0;      ///< pieces that still cross
  double gap_ = kInfinity;    ///< the least between circles of which one is inside the other
};

}  // namespace

std::optional<Input> part_crossing_chords(const Input& input, const TouchingCircles& touching,
                                          std::vector<Note>& notes) {
  if (input.circles.empty()) return std::nullopt;
  ChordParter parter(input, touching);
  parter.run();
  const ChordCuts cuts = parter.cuts();
  parter.tell(cuts.size(), notes);
  if (cuts.empty()) return std::nullopt;
  return cut_chords(input, cuts);
}

}  // namespace cover
