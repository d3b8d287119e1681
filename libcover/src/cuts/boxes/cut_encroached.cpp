// In passes: a pass takes the encroached segments in turn, the longest first, and cuts those whose
// surroundings no other cut of the pass has changed.
//
// A segment is cut into as few pieces as its obstacles allow (box/least_cuts.hpp). That leaves an
// interval for each cut, and in it we try, in this order: the distance from an end at which a
// neighbour's vertex is (shells: equal pieces at a corner never encroach each other, whatever its
// angle), the feet of obstacles (they keep thin layers from cascading), and the middle. The first
// one that encroaches the fewest other sides is taken.
// Tested by tests/unit/cuts/boxes/cut_encroached_test.cpp.
#include "cuts/boxes/cut_encroached.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "box/encroached_sides.hpp"
#include "box/least_cuts.hpp"
#include "box/obstacles.hpp"
#include "cdt/search/delaunay_cavity.hpp"
#include "cuts/before_meshing/least_pieces.hpp"
#include "cuts/before_meshing/onto_arcs.hpp"
#include "cuts/cut_segments.hpp"
#include "cuts/look_budget.hpp"
#include "cuts/periodic/mirror_cuts.hpp"
#include "cuts/room_on_segment.hpp"
#include "cuts/whole_segments.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "region/triangulation_of.hpp"

namespace cover {
namespace {

constexpr int kCutPasses = 256;
/// Ordinary inputs take fewer than ten passes and three times their points. Where a layer is
/// thinner than the root of (length of a side times the spacing of doubles), rounded feet encroach
/// again, and each cut takes more of them: there the passes end, and what is left is named.
constexpr int kFreePasses = 16;
constexpr std::size_t kLeastPoints = 1024;
constexpr std::size_t kPointsPerPoint = 16;
constexpr std::size_t kFeet = 8;  ///< obstacles whose feet are tried for a cut, the nearest
constexpr double kPlaceMargin =
    0x1p-44;  ///< of a segment: how far cuts keep from where they may be
/// Of a segment: what intervals for cuts are rounded by (docs/box_method.md, Theorem 3).
constexpr double kFootRounding = 0x1p-46;
constexpr double kShortestPiece = 0x1p-45;  ///< of a segment: no piece is shorter

/// One region in one pass.
class RegionInPass {
 public:
  explicit RegionInPass(RegionBoundary boundary)
      : boundary_(std::move(boundary)),
        cdt_(triangulation_of(boundary_)),
        at_(locate_sides(cdt_, boundary_.sides)),
        found_(encroached_sides(cdt_, at_)),
        is_encroached_(boundary_.sides.size(), 0),
        touched_(cdt_.triangles.size(), 0),
        finder_(cdt_) {
    for (const EncroachedSide& s : found_) is_encroached_[s.side] = 1;
    side_of_.resize(3 * cdt_.triangles.size(), kNone);
    for (std::uint32_t s = 0; s < at_.size(); ++s) {
      if (at_[s].triangle != kNone) side_of_[3 * at_[s].triangle + at_[s].edge] = s;
    }
  }

  [[nodiscard]] const RegionBoundary& boundary() const { return boundary_; }
  [[nodiscard]] const std::vector<EncroachedSide>& encroached() const { return found_; }
  [[nodiscard]] Point apex(std::size_t side) const {
    const EdgeRef& at = at_[side];
    return cdt_.points[cdt_.triangles[at.triangle].v[at.edge]];
  }
  [[nodiscard]] std::vector<Obstacle> obstacles(std::size_t side) {
    return finder_.obstacles(at_[side]);
  }

  /// How many sides that nothing encroaches so far a vertex at `p` on `side` would encroach.
  std::size_t encroaches(std::size_t side, Point p) {
    std::size_t count = 0;
    for (const std::uint32_t t : cavity_of(side, p)) {
      for (const Corner i : kCorners) {
        const std::uint32_t other = side_of_[3 * t + i];
        if (other == kNone || boundary_.segments[other] == boundary_.segments[side] ||
            is_encroached_[other] != 0)
          continue;
        const auto& v = cdt_.triangles[t].v;
        if (compare_with_90_degrees(cdt_.points[v[i.next()]], p, cdt_.points[v[i.previous()]]) ==
            Sign::positive)
          ++count;
      }
    }
    return count;
  }

  /// Whether a vertex at `p` on `side` changes triangles that another cut has changed.
  bool is_touched(std::size_t side, Point p) {
    const std::vector<std::uint32_t>& cavity = cavity_of(side, p);
    return std::any_of(cavity.begin(), cavity.end(),
                       [&](std::uint32_t t) { return touched_[t] != 0; });
  }
  void touch(std::size_t side, Point p) {
    for (const std::uint32_t t : cavity_of(side, p)) touched_[t] = 1;
  }

 private:
  /// The triangles that a vertex at `p` on `side` replaces.
  const std::vector<std::uint32_t>& cavity_of(std::size_t side, Point p) {
    cavity_.begin(cdt_.triangles.size(), at_[side].triangle);
    cavity_.grow(p, cdt_, [](std::uint32_t, Corner) { return true; });
    return cavity_.triangles();
  }

  RegionBoundary boundary_;
  Triangulation cdt_;
  std::vector<EdgeRef> at_;
  std::vector<EncroachedSide> found_;
  std::vector<std::uint8_t> is_encroached_;  ///< by side
  std::vector<std::uint8_t> touched_;        ///< by triangle
  std::vector<std::uint32_t> side_of_;       ///< by triangle and edge; kNone: no side
  ObstacleFinder finder_;
  DelaunayCavity cavity_;
};

/// A side of a segment that is to be cut.
struct SegmentSide {
  std::size_t region = 0;  ///< index of its view
  std::size_t side = 0;
};

/// A segment with an encroached side.
struct Encroached {
  SegmentId segment;
  double length = 0;
  std::vector<Obstacle> obstacles;  ///< from its smaller end on
  Point by;         ///< sees it under the largest angle of its region; the smaller one of two
  VertexId vertex;  ///< the same
};

class Cutter {
 public:
  Cutter(Prepared& prepared, VertexId first_cut, LookBudget looks)
      : pslg_(prepared.pslg),
        looks_(looks),
        table_(prepared.table),
        uncut_points_(prepared.report.input_points),
        first_cut_(first_cut),
        done_(prepared.report.box_cuts),
        most_points_(most_points_for_boxes(pslg_, done_)),
        dirty_(table_.regions.size(), 1) {}

  /// Returns what is stuck; nothing once the budget is spent.
  std::optional<std::vector<Point>> run() && {
    for (int pass = 0; pass < kCutPasses; ++pass) {
      looks_.spend(pslg_.points.size());
      if (looks_.is_spent()) return std::nullopt;
      boundaries_ = split_regions(pslg_, table_);
      views_.clear();
      views_.resize(boundaries_.size());
      find_sides();
      stuck_.clear();
      const std::vector<SegmentCut> cuts = choose(find_encroached());
      if (cuts.empty()) return std::move(stuck_);
      apply(cuts);
      if (pass >= kFreePasses && pslg_.points.size() > most_points_) break;
    }
    leave_the_rest();
    return std::move(stuck_);
  }

 private:
  [[nodiscard]] Point at(VertexId v) const { return pslg_.points[v.index()]; }
  /// The smaller one first: cuts do not depend on which way round the input has a segment.
  [[nodiscard]] std::pair<Point, Point> ends(const Segment& segment) const {
    return std::minmax({at(segment.a), at(segment.b)});
  }

  RegionInPass& view(std::size_t region) {
    if (!views_[region]) views_[region].emplace(boundaries_[region]);
    return *views_[region];
  }

  void find_sides() {
    sides_.assign(pslg_.segments.size(), {});
    for (std::size_t r = 0; r < boundaries_.size(); ++r) {
      for (std::size_t s = 0; s < boundaries_[r].segments.size(); ++s) {
        if (boundaries_[r].segments[s] != kHullSide)
          sides_[boundaries_[r].segments[s].index()].push_back({r, s});
      }
    }
    segments_at_.assign(pslg_.points.size(), {});
    for (std::uint32_t s = 0; s < pslg_.segments.size(); ++s) {
      segments_at_[pslg_.segments[s].a.index()].push_back(s);
      segments_at_[pslg_.segments[s].b.index()].push_back(s);
    }
  }

  /// Whether a cut at `p` stays clear of the other segments at vertex `v`, an end of its own: no
  /// region sees them through a thin void.
  [[nodiscard]] bool keeps_clear(VertexId v, SegmentId own, Point p) const {
    const auto& around = segments_at_[v.index()];
    return std::all_of(around.begin(), around.end(), [&](std::uint32_t s) {
      const Segment& other = pslg_.segments[s];
      const Point from = at(v), to = at(other.a == v ? other.b : other.a);
      return s == own.index() || dot(to - from, p - from) <= 0 || is_off_line(from, to, p);
    });
  }

  /// The encroached segments of the regions that changed, the longest first.
  std::vector<Encroached> find_encroached() {
    std::vector<Encroached> found;
    std::vector<std::uint32_t> index(pslg_.segments.size(), kNone);
    for (std::size_t r = 0; r < boundaries_.size(); ++r) {
      if (dirty_[r] == 0) continue;
      RegionInPass& v = view(r);
      looks_.spend(boundaries_[r].points.size());
      dirty_[r] = v.encroached().empty() ? 0 : 1;
      for (const EncroachedSide& e : v.encroached()) add(v, e, index, found);
    }
    std::sort(found.begin(), found.end(), [&](const Encroached& x, const Encroached& y) {
      if (x.length != y.length) return x.length > y.length;
      const Segment &s = pslg_.segments[x.segment.index()], &t = pslg_.segments[y.segment.index()];
      return std::minmax(at(s.a), at(s.b)) < std::minmax(at(t.a), at(t.b));
    });
    return found;
  }

  void add(RegionInPass& v, const EncroachedSide& e, std::vector<std::uint32_t>& index,
           std::vector<Encroached>& found) const {
    const SegmentId id = v.boundary().segments[e.side];
    if (id == kHullSide) return;
    const Segment& segment = pslg_.segments[id.index()];
    std::vector<Obstacle> obstacles = v.obstacles(e.side);
    const VertexId first = at(segment.a) < at(segment.b) ? segment.a : segment.b;
    const bool is_turned = v.boundary().vertices[v.boundary().sides[e.side][0]] != first;
    if (is_turned) obstacles = turned_round(std::move(obstacles));
    if (index[id.index()] == kNone) {
      index[id.index()] = static_cast<std::uint32_t>(found.size());
      found.push_back({id, length(at(segment.b) - at(segment.a)), std::move(obstacles),
                       v.boundary().points[e.vertex], v.boundary().vertices[e.vertex]});
    } else {
      Encroached& other = found[index[id.index()]];
      other.obstacles = merged(std::move(other.obstacles), obstacles);
      // Whichever region has the lower number, the same vertex is told.
      if (const Point by = v.boundary().points[e.vertex]; by < other.by)
        other.by = by, other.vertex = v.boundary().vertices[e.vertex];
    }
  }

  std::vector<SegmentCut> choose(const std::vector<Encroached>& found) {
    const PeriodicClasses classes(pslg_);
    whole_.emplace(pslg_, uncut_points_);
    std::vector<SegmentCut> cuts;
    std::map<SegmentId, BoxCut> told;  // reasons
    for (const Encroached& e : found) {
      const std::vector<SegmentCut> images = classes.images({e.segment, places_on(e)});
      if (!has_room(images)) {
        const Segment& s = pslg_.segments[e.segment.index()];
        stuck_.push_back(midpoint(at(s.a), at(s.b)));
        continue;
      }
      if (waits(images)) continue;
      const BoxCut::Reason reason =
          e.vertex < first_cut_ ? BoxCut::Reason::encroached : BoxCut::Reason::encroached_by_cut;
      for (const SegmentCut& cut : images) {
        for (const Point p : cut.points) {
          for (const SegmentSide& s : sides_[cut.segment.index()]) view(s.region).touch(s.side, p);
        }
        told.emplace(cut.segment, BoxCut{{}, reason, e.by});
        cuts.push_back(cut);
      }
    }
    std::sort(cuts.begin(), cuts.end(),
              [](const SegmentCut& x, const SegmentCut& y) { return x.segment < y.segment; });
    cuts = onto_arcs(pslg_, table_, std::move(cuts), looks_);
    for (const SegmentCut& cut : cuts) {
      BoxCut& done = told.at(cut.segment);
      for (const Point p : cut.points) {
        done.at = p;
        done_.push_back(done);
      }
    }
    return cuts;
  }

  /// Whether there are points, and images of them have room too.
  bool has_room(const std::vector<SegmentCut>& images) {
    if (images[0].points.empty()) return false;
    return images.size() == 1 ||
           std::all_of(images.begin(), images.end(), [&](const SegmentCut& cut) {
             const Segment& segment = pslg_.segments[cut.segment.index()];
             std::vector<Point> apexes;
             for (const SegmentSide& s : sides_[cut.segment.index()])
               apexes.push_back(view(s.region).apex(s.side));
             return std::all_of(cut.points.begin(), cut.points.end(), [&](Point p) {
               return has_room_on_segment(at(segment.a), at(segment.b), p, apexes);
             });
           });
  }

  /// Whether other cuts have changed the surroundings of one of these.
  bool waits(const std::vector<SegmentCut>& images) {
    return std::any_of(images.begin(), images.end(), [&](const SegmentCut& cut) {
      const auto& sides = sides_[cut.segment.index()];
      return std::any_of(cut.points.begin(), cut.points.end(), [&](Point p) {
        return std::any_of(sides.begin(), sides.end(), [&](const SegmentSide& s) {
          return view(s.region).is_touched(s.side, p);
        });
      });
    });
  }

  /// Where to cut; empty if there is no room.
  std::vector<Point> places_on(const Encroached& e) {
    const Segment& segment = pslg_.segments[e.segment.index()];
    const auto [a, b] = ends(segment);
    const std::vector<double> earliest = earliest_cuts(e.obstacles);
    std::vector<Point> apexes;
    for (const SegmentSide& s : sides_[e.segment.index()])
      apexes.push_back(view(s.region).apex(s.side));
    std::vector<Point> places;
    double start = 0;
    for (std::size_t k = 0; k < earliest.size(); ++k) {
      const double low = std::max(earliest[k], start + kShortestPiece);
      const double high = std::min(longest_piece(e.obstacles, start, 0), 1 - kShortestPiece);
      const auto place = best_place(e, low, high, apexes);
      if (!place) return {};
      start = place->along;
      places.push_back(place->at);
    }
    if (a != at(segment.a)) std::reverse(places.begin(), places.end());
    return places;
  }

  /// The least place for each cut such that those after it suffice; at least one.
  static std::vector<double> earliest_cuts(const std::vector<Obstacle>& obstacles) {
    const std::vector<Obstacle> back = turned_round(obstacles);
    std::vector<double> starts;
    std::size_t first = 0;
    for (double end = longest_piece(back, 0, 0); end < 1;) {
      starts.push_back(1 - end);
      while (first < back.size() && back[first].along <= end) ++first;
      end = longest_piece(back, end, first);
    }
    std::reverse(starts.begin(), starts.end());
    if (starts.empty()) starts.push_back(0);  // encroached by less than rounding
    return starts;
  }

  /// A place for a cut.
  struct Place {
    double along = 0;  ///< in parts of the segment
    Point at;
  };

  std::optional<Place> best_place(const Encroached& e, double low, double high,
                                  const std::vector<Point>& apexes) {
    const Segment& segment = pslg_.segments[e.segment.index()];
    const auto [a, b] = ends(segment);
    std::optional<Place> best;
    std::size_t least = 0;
    for (Place place : places_between(e, low, high)) {
      place.at = whole_->on_whole(e.segment, place.at);
      const Point p = place.at;
      if (!has_room_on_segment(a, b, p, apexes) || !keeps_clear(segment.a, e.segment, p) ||
          !keeps_clear(segment.b, e.segment, p))
        continue;
      std::size_t encroached = 0;
      for (const SegmentSide& s : sides_[e.segment.index()])
        encroached += view(s.region).encroaches(s.side, p);
      if (best && encroached >= least) continue;
      best = place;
      least = encroached;
      if (least == 0) break;
    }
    return best;
  }

  /// Whether a cut at part `t` of a segment is so near to its end that an obstacle at `height` sees
  /// the two as a needle.
  static bool leaves_a_needle(double t, double height) {
    return std::min(t, 1 - t) < kNeedle * height;
  }

  /// Whether an obstacle sees its segment from so flat an angle that its own segment, seen from a
  /// foot rounded by a unit in the last place, would be cut hardly beside it.
  static bool is_flat(const Obstacle& o) {
    return o.height < 2 * kNeedle * std::max(o.along, 1 - o.along);
  }

  /// Places that may be good, the best first.
  [[nodiscard]] std::vector<Place> places_between(const Encroached& e, double low,
                                                  double high) const {
    const Segment& segment = pslg_.segments[e.segment.index()];
    const std::pair<Point, Point> both = ends(segment);
    const Point a = both.first, b = both.second;
    const double margin = std::min(kPlaceMargin, (high - low) / 4);
    const auto is_between = [&](double t) { return t > low + margin && t < high - margin; };
    const auto place_at = [&](double t) { return Place{t, at_part(a, b, t)}; };
    std::vector<Place> shells, places;
    std::vector<std::pair<double, Place>> feet;  // with their heights
    for (const Obstacle& o : e.obstacles) {
      for (const double t : {length(o.at - a) / e.length, 1 - length(o.at - b) / e.length}) {
        if (is_between(t) && !leaves_a_needle(t, o.height)) shells.push_back(place_at(t));
      }
      if (leaves_a_needle(o.along, o.height)) {
        const double t = o.along < 0.5 ? o.height : 1 - o.height;
        if (is_between(t)) {
          feet.emplace_back(o.height, place_at(t));
          continue;
        }
      }
      const Point rounded = foot_on(a, b, o.at);
      const std::optional<Point> exact = exact_foot(a, b, o.at);
      const Place foot{o.along, exact && is_flat(o) ? *exact : rounded};
      // An exact foot is right with the interval for it rounded away, as it is in thin layers.
      const double slack = exact == rounded ? kFootRounding : -margin;
      if (foot.along > low - slack && foot.along < high + slack) feet.emplace_back(o.height, foot);
    }
    std::sort(feet.begin(), feet.end(), [](const auto& x, const auto& y) {
      return x.first != y.first ? x.first < y.first : x.second.along < y.second.along;
    });
    feet.resize(std::min(feet.size(), kFeet));
    // Where any cut will do, as for vertices on the rim of the disk, pieces should be long.
    const bool is_anywhere = low <= kShortestPiece && high >= 1 - kShortestPiece;
    if (is_anywhere) places.push_back(place_at((low + high) / 2));
    for (const auto& [height, foot] : feet) places.push_back(foot);
    if (!is_anywhere) places.push_back(place_at((low + high) / 2));
    shells.resize(std::min(shells.size(), kFeet));
    places.insert(places.end(), shells.begin(), shells.end());
    return places;
  }

  /// Names what is still encroached after the last pass.
  void leave_the_rest() {
    boundaries_ = split_regions(pslg_, table_);
    views_.clear();
    views_.resize(boundaries_.size());
    stuck_.clear();
    for (const Encroached& e : find_encroached()) {
      const Segment& s = pslg_.segments[e.segment.index()];
      stuck_.push_back(midpoint(at(s.a), at(s.b)));
    }
  }

  void apply(const std::vector<SegmentCut>& cuts) {
    for (const SegmentCut& cut : cuts) {
      for (const SegmentSide& s : sides_[cut.segment.index()]) dirty_[s.region] = 1;
    }
    cut_segments(pslg_, table_, cuts);
  }

  Pslg& pslg_;
  LookBudget looks_;  ///< in each pass at all points, and at those of regions that changed
  RegionTable& table_;
  std::size_t uncut_points_;
  VertexId first_cut_;
  std::vector<BoxCut>& done_;
  std::vector<Point> stuck_;            ///< of the present pass
  std::size_t most_points_;             ///< with more of them it is a cascade
  std::optional<WholeSegments> whole_;  ///< of the present pass
  std::vector<RegionBoundary> boundaries_;
  std::vector<std::optional<RegionInPass>> views_;       ///< by region, of the present pass
  std::vector<std::vector<SegmentSide>> sides_;          ///< by segment
  std::vector<std::vector<std::uint32_t>> segments_at_;  ///< by vertex
  std::vector<std::uint8_t> dirty_;                      ///< by region
};

}  // namespace

std::size_t most_points_for_boxes(const Pslg& pslg, std::span<const BoxCut> cuts) {
  const std::size_t points = pslg.points.size();
  return kLeastPoints + kPointsPerPoint * (points - std::min(points, cuts.size()));
}

std::vector<Point> cut_encroached(Prepared& prepared, VertexId first_cut) {
  return *Cutter(prepared, first_cut, LookBudget()).run();
}

std::optional<CountedBoxCuts> count_box_cuts(Prepared prepared, std::size_t most_looks) {
  prepared.report.box_cuts.clear();
  const VertexId first_cut{prepared.pslg.points.size()};
  prepared.report.input_points = first_cut.index();
  const auto stuck = Cutter(prepared, first_cut, LookBudget(most_looks)).run();
  if (!stuck) return std::nullopt;
  return CountedBoxCuts{prepared.report.box_cuts.size(), stuck->size()};
}

}  // namespace cover
