// Insertion is Bowyer's and Watson's: the triangles whose circle contains the new vertex are
// replaced by a fan around it. The cavity is collected, looked at, and only then dug: if a chord on
// its rim is encroached upon, or the fan would not be counter-clockwise in exact arithmetic,
// nothing has changed.
// Tested by tests/unit/almond/fill/refine_large_angles_test.cpp.
#include "almond/fill/refine_large_angles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/containers/bucket_queue.hpp"
#include "base/containers/order.hpp"
#include "base/team.hpp"
#include "cdt/search/delaunay_cavity.hpp"
#include "cdt/search/sight.hpp"
#include "geom/predicates.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

class Refiner {
 public:
  Refiner(Triangulation& cdt, ChordEdges& edges, std::span<const Chord> chords,
          const RefineGoal& goal, const Team& team)
      : cdt_(cdt),
        edges_(edges),
        chords_(chords),
        goal_(goal),
        team_(team),
        first_points_(cdt.points.size()),
        tan_target_(cdt.points.size(), std::tan(goal.target_nu)),
        version_(cdt.triangles.size(), 0) {
    std::vector<double> tan_target(chords.size());
    team.each_range(chords.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c) tan_target[c] = tan_target_of(chords[c]);
    });
    for (std::size_t c = 0; c < chords.size(); ++c) {
      for (const std::uint32_t v : {chords[c].a, chords[c].b}) {
        tan_target_[v] = std::min(tan_target_[v], tan_target[c]);
      }
    }
  }

  Refinement run(const std::stop_token& stop) {
    reserve();
    std::size_t budget = goal_.budget;
    enqueue_all();
    Refinement result;
    result.target_reached = true;
    while (!queue_.empty()) {
      const Bad bad = queue_.pop();
      if (version_[bad.triangle] != bad.version) continue;
      if (budget == 0 || stop.stop_requested()) {
        result.target_reached = false;
        break;
      }
      --budget;
      if (wasted_ > most_wasted() || seen_ > most_seen(goal_.budget - budget)) {
        result.target_reached = false;
        break;
      }
      if (!treat(bad.triangle)) result.target_reached = false;
      // A chord was split far away: the triangle is still there.
      else if (version_[bad.triangle] == bad.version)
        enqueue(bad.triangle);
    }
    result.splits = sorted_splits();
    if (!result.target_reached) result.blocking = find_blocking();
    return result;
  }

 private:
  /// Triangles passed in vain, because of locked chords, after which it is not tried any longer: a
  /// few dozen are normal for a triangle that cannot be mended; where long thin triangles lie side
  /// by side, each of them may pass all others.
  [[nodiscard]] std::size_t most_wasted() const { return 10000 + 100 * cdt_.triangles.size(); }

  /// Triangles in cavities, and turned over about ends of chords, after so many tries. Ten for each
  /// are many, but for the first ones.
  /// Where all points lie nearly on one line or circle, every cavity has nearly all triangles, and
  /// every test is exact.
  [[nodiscard]] std::size_t most_seen(std::size_t tries) const {
    return 64 * (tries + 256 + first_points_);
  }

  /// A triangle with too large an angle.
  struct Bad {
    std::uint32_t triangle, version;
  };
  /// An edge of the rim of a cavity, the cavity on its left.
  struct Rim {
    std::uint32_t a, b;
    std::uint32_t outer;  ///< triangle behind it
    Corner outer_edge;    ///< its edge there
    std::uint32_t chord;
    bool locked;
  };

  void reserve() {
    reserve_for_refinement(cdt_.points.size(), cdt_.triangles.size(), cdt_, edges_);
    tan_target_.reserve(cdt_.points.capacity());
    fan_at_.reserve(cdt_.points.capacity());
    version_.reserve(cdt_.triangles.capacity());
    cavity_.reserve(cdt_.triangles.capacity());
  }

  [[nodiscard]] Point corner(const Triangle& f, Corner i) const { return cdt_.points[f.v[i]]; }

  static Corner longest_edge(Point a, Point b, Point c) {
    const double ea = squared_length(c - b), eb = squared_length(a - c), ec = squared_length(b - a);
    return ea >= eb && ea >= ec ? 0U : eb >= ec ? 1U : 2U;
  }

  void enqueue_all() {
    std::vector<std::int16_t> bucket(cdt_.triangles.size());
    team_.each_range(bucket.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        bucket[t] = static_cast<std::int16_t>(bucket_of(static_cast<std::uint32_t>(t)));
    });
    for (std::uint32_t t = 0; t < bucket.size(); ++t)
      if (bucket[t] != kGood) queue_.push(bucket[t], {t, version_[t]});
  }

  /// Queues `t` if it has too large an angle; the flattest come first.
  void enqueue(std::uint32_t t) {
    if (const int bucket = bucket_of(t); bucket != kGood) queue_.push(bucket, {t, version_[t]});
  }

  /// Where it belongs in the queue; kGood: nowhere.
  [[nodiscard]] int bucket_of(std::uint32_t t) const {
    const Triangle& f = cdt_.triangles[t];
    const Corner i = longest_edge(corner(f, 0), corner(f, 1), corner(f, 2));
    const Vector u = corner(f, i.next()) - corner(f, i), v = corner(f, i.previous()) - corner(f, i);
    const double flat = -dot(u, v), area = std::abs(cross(u, v));
    const double target = std::min({tan_target_[f.v[0]], tan_target_[f.v[1]], tan_target_[f.v[2]]});
    if (!(flat > 0 && area < target * flat)) return kGood;
    return std::max(kRightAngle + half_octave(area / flat), 0);
  }

  /// Targets are below 90 degrees, where the tangent grows.
  [[nodiscard]] double tan_target_of(const Chord& chord) const {
    return std::tan(std::min(goal_.target_nu, chord.nu));
  }

  /// Inserts a vertex against the large angle of `t`; false if that is not possible.
  bool treat(std::uint32_t t) {
    passed_ = 0;
    const Triangle& f = cdt_.triangles[t];
    const Corner i = longest_edge(corner(f, 0), corner(f, 1), corner(f, 2));
    // The circumcentre lies behind the longest edge.
    if (is_rim(f, i)) return split_chord({t, i});
    const Point inside =
        midpoint(corner(f, i), midpoint(corner(f, i.next()), corner(f, i.previous())));
    const Point centre = circumcentre(f, i);
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) {
      return insert_inside(t, midpoint(corner(f, i.next()), corner(f, i.previous())));
    }
    const Walk walk = walk_straight(cdt_, t, inside, centre);
    passed_ = walk.passed;
    return walk.arrived ? insert_inside(walk.at.triangle, centre) : split_chord(walk.at);
  }

  [[nodiscard]] static bool is_rim(const Triangle& f, Corner i) {
    return f.is_locked(i) || f.n[i] == kNone;
  }

  [[nodiscard]] Point circumcentre(const Triangle& f, Corner apex) const {
    return circumcentre_from(corner(f, apex), corner(f, apex.next()), corner(f, apex.previous()));
  }

  bool insert_inside(std::uint32_t t, Point z) {
    if (!collect_cavity(t, z, /*until_encroached=*/true)) {
      passed_ += cavity_.size();
      return split_chord(rim_at(rim_.back()));
    }
    if (!is_disk(cavity_.size(), rim_.size()) || !fan_is_positive(z)) return false;
    tan_target_.push_back(std::tan(goal_.target_nu));
    dig(z, nullptr);
    return true;
  }

  /// Splits the boundary edge `at`.
  bool split_chord(EdgeRef at) {
    const Triangle& f = cdt_.triangles[at.triangle];
    const std::uint32_t chord = edges_[at.triangle][at.edge];
    if (chord != kNone && chords_[chord].locked) {
      wasted_ += std::exchange(passed_, 0);
      met_locked_.push_back(chord);
      return false;
    }
    if (f.n[at.edge] != kNone || chord == kNone) return false;
    const std::uint32_t a = f.v[at.edge.next()];
    const std::uint32_t b = f.v[at.edge.previous()];
    const Point z = split_point(at, cdt_.points[a], cdt_.points[b]);
    if (z == cdt_.points[a] || z == cdt_.points[b]) return false;
    collect_cavity(at.triangle, z);
    const auto split = std::find_if(rim_.begin(), rim_.end(),
                                    [&](const Rim& rim) { return rim.a == a && rim.b == b; });
    const Rim edge = *split;
    rim_.erase(split);
    if (!is_disk(cavity_.size(), rim_.size() + 1) || !fan_is_positive(z)) return false;
    splits_.push_back({chord, static_cast<std::uint32_t>(cdt_.points.size())});
    tan_target_.push_back(tan_target_of(chords_[chord]));
    dig(z, &edge);
    return true;
  }

  /// Half way; or, from an end where another chord is within 60 degrees, at a power of two between
  /// a third and two thirds of the length: chords that meet sharply then get vertices at equal
  /// distances, which do not encroach upon each other.
  [[nodiscard]] Point split_point(EdgeRef at, Point a, Point b) {
    const bool sharp_a = is_sharp(at, true), sharp_b = !sharp_a && is_sharp(at, false);
    if (!sharp_a && !sharp_b) return midpoint(a, b);
    const double length = cover::length(b - a);
    const double shell = std::ldexp(1.0, std::ilogb(length * (2.0 / 3)));
    return sharp_a ? a + shell / length * (b - a) : b + shell / length * (a - b);
  }

  /// True if, turning about an end of the edge, another boundary edge is met within 60 degrees.
  [[nodiscard]] bool is_sharp(EdgeRef at, bool about_a) {
    const Triangle* f = &cdt_.triangles[at.triangle];
    const std::uint32_t centre = f->v[about_a ? at.edge.next() : at.edge.previous()];
    const Point o = cdt_.points[centre];
    const Vector u = cdt_.points[f->v[about_a ? at.edge.previous() : at.edge.next()]] - o;
    for (std::uint32_t t = at.triangle;; ++seen_) {
      f = &cdt_.triangles[t];
      const Corner c = f->corner_of(centre);
      const Corner far = about_a ? c.previous() : c.next();    // the corner turned to
      const Corner leave = about_a ? c.next() : c.previous();  // the edge from the centre to it
      const Vector v = corner(*f, far) - o;
      const double d = dot(u, v);
      if (d <= 0 || 4 * d * d < squared_length(u) * squared_length(v)) return false;
      if (is_rim(*f, leave)) return true;
      t = f->n[leave];
    }
  }

  /// The triangles around `t` whose circle contains `z`, and the rim around them. False if asked to
  /// stop at a boundary edge that `z` encroaches upon, and there is one: the last of the rim so
  /// far. (Cavities may have all triangles, and most tries end so.)
  bool collect_cavity(std::uint32_t t, Point z, bool until_encroached = false) {
    cavity_.begin(cdt_.triangles.size(), t);
    rim_.clear();
    const bool is_whole = cavity_.grow(z, cdt_, [&](std::uint32_t at, Corner i) {
      const Triangle& f = cdt_.triangles[at];
      const std::uint32_t outer = f.n[i];
      rim_.push_back({f.v[i.next()], f.v[i.previous()], outer,
                      outer == kNone ? Corner() : cdt_.triangles[outer].edge_to(at), edges_[at][i],
                      f.is_locked(i)});
      return !(until_encroached && is_rim(f, i) && is_encroached(rim_.back(), z));
    });
    seen_ += cavity_.size();
    return is_whole;
  }

  [[nodiscard]] bool is_encroached(const Rim& rim, Point z) const {
    return compare_with_90_degrees(cdt_.points[rim.a], z, cdt_.points[rim.b]) != Sign::negative;
  }

  /// The inner side of a rim edge that has not been dug yet.
  [[nodiscard]] EdgeRef rim_at(const Rim& rim) const {
    for (const std::uint32_t t : cavity_.triangles()) {
      const Triangle& f = cdt_.triangles[t];
      for (const Corner i : kCorners) {
        if (f.v[i.next()] == rim.a && f.v[i.previous()] == rim.b) {
          return {t, i};
        }
      }
    }
    return {};
  }

  /// By Euler's formula, whether a cavity of so many triangles and edges on its rim has no hole and
  /// no vertex inside, which would be lost. Where a split chord was rounded outwards, circles of
  /// Delaunay triangles may have vertices inside.
  static bool is_disk(std::size_t triangles, std::size_t edges) { return edges == triangles + 2; }

  [[nodiscard]] bool fan_is_positive(Point z) const {
    return std::all_of(rim_.begin(), rim_.end(), [&](const Rim& rim) {
      return orientation(z, cdt_.points[rim.a], cdt_.points[rim.b]) == Sign::positive;
    });
  }

  /// Replaces the cavity by the fan of `z` over the rim. If `split` is given, that edge was taken
  /// out of the rim, and `z` lies on it.
  void dig(Point z, const Rim* split) {
    const auto vertex = static_cast<std::uint32_t>(cdt_.points.size());
    cdt_.points.push_back(z);
    fan_at_.resize(cdt_.points.size());
    fan_ = cavity_.triangles();
    while (fan_.size() < rim_.size()) {
      fan_.push_back(static_cast<std::uint32_t>(cdt_.triangles.size()));
      cdt_.triangles.emplace_back();
      edges_.push_back({kNone, kNone, kNone});
      version_.push_back(0);
    }
    for (std::size_t k = 0; k < rim_.size(); ++k) fan_at_[rim_[k].a] = fan_[k];
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      const Rim& rim = rim_[k];
      Triangle f;
      f.v = {vertex, rim.a, rim.b};
      f.n[0] = rim.outer;
      f.set_locked(0, rim.locked);
      if (rim.outer != kNone) {
        cdt_.triangles[rim.outer].n[rim.outer_edge] = fan_[k];
      }
      edges_[fan_[k]] = {rim.chord, kNone, kNone};
      cdt_.triangles[fan_[k]] = f;
    }
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      if (split != nullptr && rim_[k].b == split->a) continue;
      const std::uint32_t next = fan_at_[rim_[k].b];
      cdt_.triangles[fan_[k]].n[1] = next;
      cdt_.triangles[next].n[2] = fan_[k];
    }
    if (split != nullptr) close_fan(*split);
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      ++version_[fan_[k]];
      enqueue(fan_[k]);
    }
  }

  /// The two outer edges of a fan whose centre lies on the boundary.
  void close_fan(const Rim& split) {
    const std::uint32_t first = fan_at_[split.b];
    cdt_.triangles[first].set_locked(2, split.locked);
    edges_[first][2] = split.chord;
    const auto last = static_cast<std::size_t>(
        std::find_if(rim_.begin(), rim_.end(), [&](const Rim& r) { return r.b == split.a; }) -
        rim_.begin());
    cdt_.triangles[fan_[last]].set_locked(1, split.locked);
    edges_[fan_[last]][1] = split.chord;
  }

  /// The locked chords on and behind the longest edges of triangles that do not keep `keep_nu`; if
  /// too much was wasted, those that were met instead of those behind.
  [[nodiscard]] std::vector<std::uint32_t> find_blocking() {
    std::vector<std::uint32_t> blocking;
    const bool in_a_hurry = wasted_ > most_wasted();
    if (in_a_hurry) blocking = met_locked_;
    const auto add = [&](EdgeRef at) {
      const std::uint32_t chord = edges_[at.triangle][at.edge];
      if (chord != kNone && chords_[chord].locked) blocking.push_back(chord);
    };
    const double tan_keep = std::tan(goal_.keep_nu);
    for (std::uint32_t t = 0; t < cdt_.triangles.size(); ++t) {
      const Triangle& f = cdt_.triangles[t];
      const Corner i = longest_edge(corner(f, 0), corner(f, 1), corner(f, 2));
      const Vector u = corner(f, i.next()) - corner(f, i),
                   v = corner(f, i.previous()) - corner(f, i);
      if (std::abs(cross(u, v)) >= -tan_keep * dot(u, v)) continue;
      for (const Corner k : kCorners) add({t, k});
      if (in_a_hurry) continue;
      const Point centre = circumcentre(f, i);
      if (is_rim(f, i) || !std::isfinite(centre.x) || !std::isfinite(centre.y)) continue;
      const Walk walk = walk_straight(
          cdt_, t, midpoint(corner(f, i), midpoint(corner(f, i.next()), corner(f, i.previous()))),
          centre);
      if (!walk.arrived) {
        add(walk.at);
        continue;
      }
      collect_cavity(walk.at.triangle, centre);
      for (const Rim& rim : rim_) {
        if (rim.outer != kNone && !rim.locked) continue;
        if (is_encroached(rim, centre)) add(rim_at(rim));
      }
    }
    sort_unique(blocking);
    return blocking;
  }

  struct Split {
    std::uint32_t chord, vertex;
  };

  [[nodiscard]] std::vector<ChordSplit> sorted_splits() {
    const auto along = [&](const Split& s) {
      const Point a = cdt_.points[chords_[s.chord].a], b = cdt_.points[chords_[s.chord].b];
      return dot(cdt_.points[s.vertex] - a, b - a);
    };
    std::sort(splits_.begin(), splits_.end(), [&](const Split& s, const Split& t) {
      return s.chord < t.chord || (s.chord == t.chord && along(s) < along(t));
    });
    std::vector<ChordSplit> result;
    for (const Split& split : splits_) {
      if (result.empty() || result.back().chord != split.chord) result.push_back({split.chord, {}});
      result.back().vertices.push_back(split.vertex);
    }
    return result;
  }

  Triangulation& cdt_;
  ChordEdges& edges_;
  std::span<const Chord> chords_;
  RefineGoal goal_;
  const Team& team_;
  std::size_t first_points_;
  std::vector<double> tan_target_;         ///< by vertex; a triangle has the least of its corners'
  static constexpr int kRightAngle = 120;  ///< bucket of tan nu = 1; the targets lie below
  static constexpr int kGood = -1;
  BucketQueue<Bad> queue_;
  std::vector<std::uint32_t> version_;  ///< by triangle; an entry of the queue may be out of date
  DelaunayCavity cavity_;
  std::vector<Rim> rim_;
  std::vector<std::uint32_t> fan_;  ///< by edge of the rim: the triangle put there
  std::vector<std::uint32_t>
      fan_at_;  ///< by vertex: new triangle on the rim edge that starts there
  std::vector<Split> splits_;
  std::size_t passed_ = 0;                 ///< triangles, by the try at hand
  std::size_t wasted_ = 0;                 ///< triangles passed by tries that a locked chord ended
  std::size_t seen_ = 0;                   ///< triangles in all cavities
  std::vector<std::uint32_t> met_locked_;  ///< chords, by these tries
};

/// Adds the chords that end at one of `vertices`, or all if none does.
void blame_beside(std::vector<std::uint32_t> vertices, std::span<const Chord> chords,
                  std::vector<std::uint32_t>& blamed) {
  if (vertices.empty()) return;
  std::sort(vertices.begin(), vertices.end());
  const std::size_t known = blamed.size();
  const auto is_open = [&](std::uint32_t v) {
    return std::binary_search(vertices.begin(), vertices.end(), v);
  };
  for (std::uint32_t c = 0; c < chords.size(); ++c) {
    if (is_open(chords[c].a) || is_open(chords[c].b)) blamed.push_back(c);
  }
  if (blamed.size() > known) return;
  for (std::uint32_t c = 0; c < chords.size(); ++c) blamed.push_back(c);
}

}  // namespace

std::vector<std::uint32_t> match_chords(const Triangulation& cdt, std::span<const Chord> chords,
                                        ChordEdges& edges) {
  // The chords that start at a vertex form a list; nearly always it has one element.
  std::vector<std::uint32_t> head(cdt.points.size(), kNone), next(chords.size(), kNone);
  for (std::uint32_t c = 0; c < chords.size(); ++c) {
    next[c] = head[chords[c].a];
    head[chords[c].a] = c;
  }
  std::vector<std::uint32_t> blamed, open;  // ends of rim edges without a chord
  std::vector<bool> found(chords.size(), false);
  edges.assign(cdt.triangles.size(), {kNone, kNone, kNone});
  for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t) {
    const Triangle& f = cdt.triangles[t];
    for (const Corner i : kCorners) {
      if (!f.is_locked(i) && f.n[i] != kNone) continue;
      const std::uint32_t a = f.v[i.next()];
      const std::uint32_t b = f.v[i.previous()];
      std::uint32_t c = head[a];
      while (c != kNone && (chords[c].b != b || found[c])) c = next[c];
      if (c != kNone) {
        found[c] = true;
        edges[t][i] = c;
        continue;
      }
      const std::size_t known = blamed.size();
      for (c = head[b]; c != kNone; c = next[c]) {
        if (chords[c].b == a) blamed.push_back(c);
      }
      if (blamed.size() == known) open.insert(open.end(), {a, b});
    }
  }
  for (std::uint32_t c = 0; c < chords.size(); ++c) {
    if (!found[c]) blamed.push_back(c);
  }
  blame_beside(std::move(open), chords, blamed);
  return blamed;
}

void reserve_for_refinement(std::size_t points, std::size_t triangles, Triangulation& cdt,
                            ChordEdges& edges) {
  cdt.points.reserve(points / 8 * 9);
  cdt.triangles.reserve(triangles + points / 4);
  edges.reserve(triangles + points / 4);
}

Refinement refine_large_angles(Triangulation& cdt, ChordEdges& edges, std::span<const Chord> chords,
                               const RefineGoal& goal, const std::stop_token& stop,
                               const Team& team) {
  return Refiner(cdt, edges, chords, goal, team).run(stop);
}

}  // namespace cover
