// If no vertex lies between chords and the ways over their arcs, and these ways meet nothing, then
// each way can be drawn tight to its chord without passing a vertex: all faces, and what lies in
// them, stay as they are. So two tests suffice: of vertices one by one, of meetings by one
// constrained triangulation of everything.
// Tested by tests/unit/cuts/before_meshing/onto_arcs_test.cpp.
#include "cuts/before_meshing/onto_arcs.hpp"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "cdt/cdt.hpp"
#include "cuts/periodic/mirror_cuts.hpp"
#include "geom/box.hpp"
#include "geom/curves/arc.hpp"
#include "geom/predicates.hpp"
#include "geom/search/box_tree.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

bool is_chord(const Pslg& pslg, SegmentId s) {
  return circle_of(pslg, pslg.segments[s.index()]) != nullptr;
}

class ArcMover {
 public:
  ArcMover(Pslg& pslg, const RegionTable& table, std::vector<SegmentCut> cuts)
      : pslg_(pslg),
        classes_(pslg),
        plain_(std::move(cuts)),
        stays_(pslg.segments.size(), 0),
        places_(pslg.points) {
    for (const Region& region : table.regions) {
      if (region.inside) places_.push_back(*region.inside);
    }
    places_.insert(places_.end(), table.void_seeds.begin(), table.void_seeds.end());
    for (const RegionSeed& seed : pslg.seeds) places_.push_back(seed.at);
    for (const HoleSeed& hole : pslg.holes) places_.push_back(hole.at);
    std::vector<Box> boxes(places_.size());
    for (std::size_t k = 0; k < places_.size(); ++k) boxes[k].add(places_[k]);
    near_ = BoxTree(boxes);
  }

  std::vector<SegmentCut> move(LookBudget& looks) {
    std::vector<SegmentCut> moved = with_arcs();
    for (;;) {
      std::vector<SegmentId> bad = that_pass_places(moved);
      if (bad.empty()) bad = that_meet(moved);
      looks.spend(pslg_.points.size());
      if (bad.empty() || looks.is_spent()) return moved;
      for (const SegmentId s : classes_.with_classes(std::move(bad))) {
        stays_[s.index()] = 1;
        straighten(pslg_.segments[s.index()]);
      }
      moved = with_arcs();
    }
  }

 private:
  [[nodiscard]] Point at(VertexId v) const { return pslg_.points[v.index()]; }

  /// All cuts, those on chords moved unless they have to stay; images are images of the first one.
  [[nodiscard]] std::vector<SegmentCut> with_arcs() const {
    std::vector<SegmentCut> moved;
    for (const SegmentCut& cut : plain_) {
      SegmentCut on_arc = cut;
      if (is_moved(cut)) {
        const Segment& s = pslg_.segments[cut.segment.index()];
        const ArcOver arc(pslg_.circles[s.circle - 1], at(s.a), at(s.b));
        for (Point& p : on_arc.points) p = arc.above(p);
      }
      moved.push_back(std::move(on_arc));
    }
    return classes_.with_images(std::move(moved));
  }

  /// Whether the points go to the arc: that of a chord all of whose images are chords too.
  [[nodiscard]] bool is_moved(const SegmentCut& cut) const {
    if (!is_chord(pslg_, cut.segment) || stays_[cut.segment.index()] != 0) return false;
    if (!classes_.is_periodic(cut.segment)) return true;
    const std::vector<SegmentId> all = classes_.with_classes({cut.segment});
    return std::all_of(all.begin(), all.end(), [&](SegmentId s) { return is_chord(pslg_, s); });
  }

  /// Chords with a place between them and the way in their stead.
  [[nodiscard]] std::vector<SegmentId> that_pass_places(const std::vector<SegmentCut>& cuts) const {
    std::vector<SegmentId> bad;
    for (const SegmentCut& cut : cuts) {
      if (is_moved(cut) && passes_place(cut)) bad.push_back(cut.segment);
    }
    return bad;
  }

  [[nodiscard]] bool passes_place(const SegmentCut& cut) const {
    const Segment& s = pslg_.segments[cut.segment.index()];
    const Point a = at(s.a), b = at(s.b);
    std::vector<Point> way = cut.points;
    way.push_back(b);
    Box around;
    around.add(a);
    for (const Point& p : way) around.add(p);
    bool passes = false;
    near_.visit(around, [&](std::uint32_t place) {
      const Point v = places_[place];
      if (v == a || v == b) return;
      for (std::size_t k = 0; k + 1 < way.size() && !passes; ++k)
        passes = is_in(v, a, way[k], way[k + 1]);
    });
    return passes;
  }

  /// Whether p lies in the triangle abc or on its sides, whichever way round it is.
  static bool is_in(Point p, Point a, Point b, Point c) {
    const std::array signs{orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)};
    const auto has = [&](Sign sign) {
      return std::find(signs.begin(), signs.end(), sign) != signs.end();
    };
    return !(has(Sign::positive) && has(Sign::negative));
  }

  /// Chords whose way meets other segments.
  [[nodiscard]] std::vector<SegmentId> that_meet(const std::vector<SegmentCut>& cuts) const {
    if (std::none_of(cuts.begin(), cuts.end(), [&](const SegmentCut& c) { return is_moved(c); }))
      return {};
    std::vector<Point> points = pslg_.points;
    std::vector<IndexPair> pieces;
    std::vector<SegmentId> of_piece, of_point(points.size());  // those of cuts count
    auto cut = cuts.begin();
    for (std::size_t k = 0; k < pslg_.segments.size(); ++k) {
      const Segment& s = pslg_.segments[k];
      std::uint32_t from = s.a.value();
      const auto add = [&](std::uint32_t to) {
        pieces.push_back({from, to});
        of_piece.emplace_back(k);
        from = to;
      };
      if (cut != cuts.end() && cut->segment.index() == k) {
        for (const Point& p : cut->points) {
          points.push_back(p);
          of_point.emplace_back(k);
          add(static_cast<std::uint32_t>(points.size() - 1));
        }
        ++cut;
      }
      add(s.b.value());
    }
    std::vector<std::uint8_t> moved(pslg_.segments.size(), 0);
    for (const SegmentCut& c : cuts) moved[c.segment.index()] = is_moved(c) ? 1 : 0;
    std::vector<SegmentId> bad;
    const auto note = [&](SegmentId s) {
      if (moved[s.index()] != 0) bad.push_back(s);
    };
    const std::size_t given = pslg_.points.size();
    for (const CdtConflict& conflict : triangulate_hull(points, pieces).conflicts) {
      if (conflict.kind == CdtConflict::Kind::crossing) {
        note(of_piece[conflict.first]);
      } else if (conflict.first >= given) {
        note(of_point[conflict.first]);
      }
      if (conflict.kind != CdtConflict::Kind::duplicate_point) {
        note(of_piece[conflict.second]);
      } else if (conflict.second >= given) {
        note(of_point[conflict.second]);
      }
    }
    return bad;  // what chords met without being moved is nobody's fault here
  }

  Pslg& pslg_;
  PeriodicClasses classes_;
  std::vector<SegmentCut> plain_;
  std::vector<std::uint8_t> stays_;  ///< by segment
  std::vector<Point> places_;        ///< vertices and seeds
  BoxTree near_;                     ///< of these
};

}  // namespace

std::vector<SegmentCut> onto_arcs(Pslg& pslg, const RegionTable& table,
                                  std::vector<SegmentCut> cuts, LookBudget& looks) {
  const bool any = std::any_of(cuts.begin(), cuts.end(),
                               [&](const SegmentCut& cut) { return is_chord(pslg, cut.segment); });
  if (!any) return cuts;
  return ArcMover(pslg, table, std::move(cuts)).move(looks);
}

void warn_of_straight_arcs(const Pslg& pslg, std::vector<Note>& notes) {
  constexpr std::size_t kStraightTold = 8;
  std::vector<Point> where;
  for (const Segment& s : pslg.segments) {
    if ((s.circle & kStraightened) != 0)
      where.push_back(midpoint(pslg.points[s.a.index()], pslg.points[s.b.index()]));
  }
  if (where.empty()) return;
  const std::size_t count = where.size();
  const Point first = where[0];
  where.resize(std::min(count, kStraightTold));
  notes.push_back(
      {Note::Kind::warning, kVoid,
       fmt::format("{} of arcs {} straight, the first at {}: {} cut on the chord, since "
                   "the arc has no room or the method cuts chords",
                   counted(count, "piece"), count == 1 ? "is" : "are", describe(first),
                   count == 1 ? "it was" : "they were"),
       std::move(where)});
}

}  // namespace cover
