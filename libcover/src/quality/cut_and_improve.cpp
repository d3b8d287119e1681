// All regions become one mesh whose sides know what lies beyond them. Around every triangle that is
// left, an excerpt over segments is tried: kicks first, then cuts of the segments near by, at the
// foot of the obtuse corner or half way, each improved and kicked in turn. The best is kept if
// there are fewer such triangles, or less bad ones. Triangles are taken in the order of their
// coordinates, so that the mesh does not depend on the order of the input. Tested by
// tests/unit/pipeline/cut_and_improve_test.cpp.
#include "quality/cut_and_improve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/describe.hpp"
#include "cdt/cdt.hpp"
#include "covering/local_frame.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "quality/excerpt.hpp"
#include "quality/improve.hpp"
#include "quality/kicks.hpp"
#include "quality/merit.hpp"
#include "quality/with_neighbours.hpp"
#include "region/cut_segments.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

constexpr std::size_t kTriangles = 64;  ///< in an excerpt
constexpr std::uint32_t kNear = 16;     ///< triangles of it whose sides may be cut
constexpr double kEnd = 0.01;           ///< of a side: no cut is nearer to its ends
constexpr std::uint64_t kEvaluationsPerPoint = 20000;
constexpr std::uint64_t kEvaluationsAtLeast = 3'000'000;
constexpr std::size_t kKicked = 5;  ///< trials that are kicked
constexpr double kGain = 0.2;       ///< of its excess, that the worst triangle must win for a cut
constexpr double kLightWeight = 1e-4;  ///< of small angles: they only decide between equals

/// Cuts side `s` of `mesh`, and `r` on the other side of its segment (kNone: the void), at `m`, a
/// fixed vertex without triangles. The parts at the starts of both keep their numbers, both parts
/// what was allowed to the whole.
///
/// ENSURES: false, and nothing has changed, if a triangle would not be counter-clockwise
bool cut_side(MutableMesh& mesh, std::uint32_t s, std::uint32_t r, std::uint32_t m) {
  const std::array<std::uint32_t, 2> both{s, r};
  std::array<std::uint32_t, 2> at{kNone, kNone};
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t n : mesh.triangles[t].n) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (both[k] != kNone && n == (kSideBit | both[k])) at[k] = t;
      }
    }
  }
  const auto edge_of = [&](std::size_t k) {
    const auto& n = mesh.triangles[at[k]].n;
    return static_cast<int>(std::find(n.begin(), n.end(), kSideBit | both[k]) - n.begin());
  };
  for (std::size_t k = 0; k < 2; ++k) {
    if (at[k] == kNone) continue;
    const int e = edge_of(k);
    const Point c = mesh.corner(at[k], e), p = mesh.points[m];
    if (orientation(c, mesh.corner(at[k], next3(e)), p) != Sign::positive ||
        orientation(c, p, mesh.corner(at[k], prev3(e))) != Sign::positive) {
      return false;
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (at[k] == kNone) continue;
    const int e = edge_of(k);
    const std::uint32_t t = at[k], t2 = mesh.add_triangle();
    const auto corner = static_cast<std::size_t>(e), a = static_cast<std::size_t>(next3(e)),
               b = static_cast<std::size_t>(prev3(e));
    const MeshTriangle old = mesh.triangles[t];
    const auto side = static_cast<std::uint32_t>(mesh.sides.size());
    mesh.sides.push_back(mesh.sides[both[k]]);
    mesh.allowances.push_back(mesh.allowances[both[k]]);
    mesh.triangles[t] = {{old.v[corner], old.v[a], m}, {kSideBit | both[k], t2, old.n[b]}};
    mesh.triangles[t2] = {{old.v[corner], m, old.v[b]}, {kSideBit | side, old.n[a], t}};
    mesh.link(old.n[a], old.v[b], old.v[corner], t2);
    for (const std::uint32_t v : {old.v[corner], old.v[a], m}) mesh.home[v] = t;
    mesh.home[old.v[b]] = t2;
    mesh.measure(t);
    mesh.measure(t2);
  }
  return true;
}

/// All regions in one mesh.
class Joined {
 public:
  /// REQUIRES: no hull sides
  Joined(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
         std::span<const RegionMesh> meshes, const Goal& goal)
      : goal_(goal), frame_(pslg.points), points_(pslg.points.size()) {
    std::vector<Point> points = frame_.points();
    points.resize(2 * points_);  // room for as many cuts
    first_steiner_ = points.size();
    std::vector<IndexTriple> triangles;
    struct Side {
      IndexPair ends;
      std::uint32_t region, segment;
      SideLimit limit;
    };
    std::vector<Side> sides;
    for (std::size_t r = 0; r < meshes.size(); ++r) {
      const RegionBoundary& boundary = boundaries[r];
      const std::size_t offset = points.size() - boundary.points.size();
      const auto global = [&](std::uint32_t v) {
        return static_cast<std::uint32_t>(v < boundary.points.size() ? boundary.vertices[v].index()
                                                                     : offset + v);
      };
      for (const Point& p : meshes[r].steiner) points.push_back(frame_.enter(p));
      for (const auto& [a, b, c] : meshes[r].triangles) {
        triangles.push_back({global(a), global(b), global(c)});
      }
      const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
      const std::vector<SideLimit> limits = side_limits(cdt, locate_sides(cdt, boundary.sides));
      for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
        sides.push_back({{global(boundary.sides[s][0]), global(boundary.sides[s][1])},
                         static_cast<std::uint32_t>(r),
                         static_cast<std::uint32_t>(boundary.segments[s].index()),
                         limits[s]});
      }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& x, const Side& y) { return x.ends < y.ends; });
    std::vector<IndexPair> pairs;
    std::vector<SideLimit> limits;
    for (const Side& side : sides) {
      pairs.push_back(side.ends);
      limits.push_back(side.limit);
      region_.push_back(side.region);
      segment_.push_back(side.segment);
    }
    const Triangulation all = with_neighbours(std::move(points), triangles);
    const std::vector<EdgeRef> at = locate_sides(all, pairs);
    mesh_ = MutableMesh(all, static_cast<std::uint32_t>(first_steiner_), at, std::move(limits));
    mesh_.set_goal({goal.large, goal.small, goal.weight * kLightWeight});
    for (const auto& [a, b] : pairs) {
      const auto other = std::lower_bound(pairs.begin(), pairs.end(), IndexPair{b, a});
      const bool is_there = other != pairs.end() && *other == IndexPair{b, a};
      const auto number = static_cast<std::uint32_t>(other - pairs.begin());
      partner_.push_back(is_there ? number : kNone);
      beyond_.push_back(is_there ? at[number].triangle : kNone);
    }
  }

  void work(std::stop_token stop) {
    Budget budget{kEvaluationsAtLeast + kEvaluationsPerPoint * points_, stop};
    std::vector<std::uint32_t> queue = seeds();
    for (std::size_t head = 0; head < queue.size() && !budget.is_used_up(); ++head) {
      const std::uint32_t t = queue[head];
      if (!is_above(mesh_, t, goal_)) continue;
      for (const std::uint32_t changed : attempt(t, budget)) {
        if (is_above(mesh_, changed, goal_)) queue.push_back(changed);
      }
    }
  }

  [[nodiscard]] std::size_t cuts() const { return cuts_; }
  [[nodiscard]] bool has_changed() const { return has_changed_; }

  /// The new points, by segment.
  [[nodiscard]] std::vector<SegmentCut> segment_cuts(const Pslg& pslg) const {
    std::vector<std::pair<std::uint32_t, Point>> all = cut_points_;
    const auto along = [&](const std::pair<std::uint32_t, Point>& cut) {
      const Segment& segment = pslg.segments[cut.first];
      const Point a = pslg.points[segment.a.index()], b = pslg.points[segment.b.index()];
      return dot(cut.second - a, b - a);
    };
    std::sort(all.begin(), all.end(), [&](const auto& x, const auto& y) {
      return x.first != y.first ? x.first < y.first : along(x) < along(y);
    });
    std::vector<SegmentCut> cuts;
    for (const auto& [segment, point] : all) {
      if (cuts.empty() || cuts.back().segment != SegmentId{segment}) {
        cuts.push_back({SegmentId{segment}, {}});
      }
      cuts.back().points.push_back(point);
    }
    return cuts;
  }

  /// Whether rounding on the way back to the plane turns no triangle over.
  [[nodiscard]] bool is_valid() const {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (mesh_.is_hole(t)) continue;
      const Point a = frame_.restore(mesh_.corner(t, 0)), b = frame_.restore(mesh_.corner(t, 1)),
                  c = frame_.restore(mesh_.corner(t, 2));
      if (orientation(a, b, c) != Sign::positive) return false;
    }
    return true;
  }

  /// The meshes of the regions, over the boundaries that `pslg` has after the cuts.
  void separate(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                std::vector<RegionMesh>& meshes) const {
    const std::vector<std::uint32_t> region = regions_of_triangles();
    std::vector<std::uint32_t> number(mesh_.points.size(), kNone);
    std::vector<VertexId> id(first_steiner_);
    for (std::size_t v = 0; v < points_; ++v) id[v] = VertexId{v};
    std::vector<std::pair<Point, VertexId>> added;
    for (std::size_t v = points_; v < pslg.points.size(); ++v) {
      added.push_back({pslg.points[v], VertexId{v}});
    }
    std::sort(added.begin(), added.end());
    for (std::size_t v = points_; v < points_ + cuts_; ++v) {
      const std::pair wanted(frame_.restore(mesh_.points[v]), VertexId{0});
      id[v] = std::lower_bound(added.begin(), added.end(), wanted)->second;
    }
    std::vector<std::vector<std::uint32_t>> of_region(meshes.size());
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!mesh_.is_hole(t)) of_region[region[t]].push_back(t);
    }
    std::vector<std::uint32_t> local(pslg.points.size());
    for (std::size_t r = 0; r < meshes.size(); ++r) {
      const RegionBoundary& boundary = boundaries[r];
      for (std::uint32_t v = 0; v < boundary.vertices.size(); ++v) {
        local[boundary.vertices[v].index()] = v;
      }
      meshes[r].steiner.clear();
      meshes[r].triangles.clear();
      for (const std::uint32_t t : of_region[r]) {
        IndexTriple triangle{};
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t v = mesh_.triangles[t].v[i];
          if (v < first_steiner_) {
            triangle[i] = local[id[v].index()];
            continue;
          }
          if (number[v] == kNone) {
            number[v] =
                static_cast<std::uint32_t>(boundary.points.size() + meshes[r].steiner.size());
            meshes[r].steiner.push_back(frame_.restore(mesh_.points[v]));
          }
          triangle[i] = number[v];
        }
        meshes[r].triangles.push_back(triangle);
      }
    }
  }

 private:
  /// A triangulation of an excerpt that is better than before, and the cut that it has, if any.
  struct Trial {
    MutableMesh mesh;
    Merit merit;
    std::uint32_t side = kNone;  ///< of the excerpt
  };

  /// The triangles above the goal, in the order of their coordinates.
  [[nodiscard]] std::vector<std::uint32_t> seeds() const {
    std::vector<std::pair<std::array<Point, 3>, std::uint32_t>> found;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!is_above(mesh_, t, goal_)) continue;
      std::array<Point, 3> corners{mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
      std::sort(corners.begin(), corners.end());
      found.push_back({corners, t});
    }
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> out;
    for (const auto& [corners, t] : found) out.push_back(t);
    return out;
  }

  /// Returns the triangles that changed.
  std::vector<std::uint32_t> attempt(std::uint32_t t, Budget& budget) {
    const bool may_cut = cuts_ < points_;
    const auto spare = static_cast<std::uint32_t>(points_ + cuts_);
    Excerpt excerpt(mesh_, t, kTriangles, beyond_, may_cut ? spare : kNone);
    Trial best{excerpt.mesh, merit_of(excerpt.mesh, goal_)};
    if (kick_and_improve(best.mesh, goal_, budget)) return put_back(excerpt, best);
    if (!may_cut || !try_cuts(excerpt, best, budget)) return {};
    return put_back(excerpt, best);
  }

  /// Tries all cuts near triangle 0 of `excerpt`, and kicks what comes of the most promising ones.
  /// Returns whether `best` has become better.
  bool try_cuts(const Excerpt& excerpt, Trial& best, Budget& budget) const {
    std::vector<Trial> trials;
    const std::uint32_t last =
        std::min(kNear, static_cast<std::uint32_t>(excerpt.mesh.triangles.size()));
    for (std::uint32_t t = 0; t < last && !budget.is_used_up(); ++t) {
      for (int e = 0; e < 3; ++e) {
        const std::uint32_t n = excerpt.mesh.triangles[t].n[static_cast<std::size_t>(e)];
        if (!is_side(n) || !is_side(excerpt.outside[side_index(n)])) continue;
        const Point a = excerpt.mesh.corner(t, next3(e)), b = excerpt.mesh.corner(t, prev3(e));
        for (const Point& place : places_on(a, b, excerpt.mesh)) {
          if (auto trial = cut_at(excerpt, side_index(n), place, budget)) {
            trials.push_back(*std::move(trial));
          }
        }
      }
    }
    const auto is_less_bad = [](const Trial& x, const Trial& y) {
      return x.merit.above != y.merit.above ? x.merit.above < y.merit.above
                                            : x.merit.large < y.merit.large;
    };
    std::stable_sort(trials.begin(), trials.end(), is_less_bad);
    const Merit before = best.merit;
    const auto is_worth_it = [&](const Merit& now) {
      return now.large <= before.large &&
             (now.above < before.above ||
              (now.above == before.above &&
               now.large - goal_.large < (1 - kGain) * (before.large - goal_.large)));
    };
    for (std::size_t k = 0; k < std::min(kKicked, trials.size()); ++k) {
      if (!is_worth_it(trials[k].merit)) {
        improve_by_kicks(trials[k].mesh, goal_, trials[k].merit, budget);
      }
      if (!is_worth_it(trials[k].merit)) continue;
      best = std::move(trials[k]);
      return true;
    }
    return false;
  }

  /// The middle of ab, and the feet on it of the corners of triangle 0.
  [[nodiscard]] static std::vector<Point> places_on(Point a, Point b, const MutableMesh& mesh) {
    std::vector<Point> places{midpoint(a, b)};
    for (int i = 0; i < 3; ++i) {
      const double part = dot(mesh.corner(0, i) - a, b - a) / squared_length(b - a);
      if (part > kEnd && part < 1 - kEnd) places.push_back(a + part * (b - a));
    }
    return places;
  }

  /// The excerpt with `side` cut at `place`, improved; nothing where that cannot be.
  [[nodiscard]] std::optional<Trial> cut_at(const Excerpt& excerpt, std::uint32_t side, Point place,
                                            Budget& budget) const {
    const std::uint32_t partner = partner_[side_index(excerpt.outside[side])];
    std::uint32_t other = kNone;
    if (partner != kNone) {
      const auto at = std::find(excerpt.outside.begin(), excerpt.outside.end(), kSideBit | partner);
      if (at == excerpt.outside.end()) return std::nullopt;
      other = static_cast<std::uint32_t>(at - excerpt.outside.begin());
    }
    Trial trial{excerpt.mesh, {}, side};
    trial.mesh.points[excerpt.spare] = place;
    if (!cut_side(trial.mesh, side, other, excerpt.spare)) return std::nullopt;
    improve_with_slack(trial.mesh, budget);
    trial.merit = merit_of(trial.mesh, goal_);
    return trial;
  }

  std::vector<std::uint32_t> put_back(Excerpt& excerpt, const Trial& trial) {
    has_changed_ = true;
    if (trial.side != kNone) {
      const std::uint32_t s = side_index(excerpt.outside[trial.side]), r = partner_[s];
      const std::uint32_t s2 = add_side(s, excerpt);
      if (r != kNone) {  // start of s beside end of r, and the other way round
        const std::uint32_t r2 = add_side(r, excerpt);
        partner_[s] = r2, partner_[r2] = s;
        partner_[r] = s2, partner_[s2] = r;
      }
      cut_points_.push_back({segment_[s], frame_.restore(trial.mesh.points[excerpt.spare])});
      ++cuts_;
    }
    const std::vector<std::uint32_t> changed = excerpt.replace(mesh_, trial.mesh);
    for (const std::uint32_t t : changed) {
      for (const std::uint32_t n : mesh_.triangles[t].n) {
        if (is_side(n) && partner_[side_index(n)] != kNone) beyond_[partner_[side_index(n)]] = t;
      }
    }
    return changed;
  }

  /// A new side, like `parent`, for the whole and the excerpt.
  std::uint32_t add_side(std::uint32_t parent, Excerpt& excerpt) {
    const auto number = static_cast<std::uint32_t>(mesh_.sides.size());
    mesh_.sides.push_back(mesh_.sides[parent]);
    mesh_.allowances.push_back(mesh_.allowances[parent]);
    excerpt.outside.push_back(kSideBit | number);
    region_.push_back(region_[parent]);
    segment_.push_back(segment_[parent]);
    partner_.push_back(kNone);
    beyond_.push_back(kNone);
    return number;
  }

  /// By triangle: the index of the region that it lies in.
  [[nodiscard]] std::vector<std::uint32_t> regions_of_triangles() const {
    std::vector<std::uint32_t> region(mesh_.triangles.size(), kNone), stack;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (mesh_.is_hole(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        if (is_side(mesh_.triangles[t].n[i])) {
          region[t] = region_[side_index(mesh_.triangles[t].n[i])];
          stack.push_back(t);
        }
      }
    }
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (const std::uint32_t n : mesh_.triangles[t].n) {
        if (is_side(n) || region[n] != kNone) continue;
        region[n] = region[t];
        stack.push_back(n);
      }
    }
    return region;
  }

  Goal goal_;
  LocalFrame frame_;
  bool has_changed_ = false;
  std::size_t points_;  ///< of the PSLG; then come cuts, then Steiner vertices
  std::size_t first_steiner_ = 0;
  std::size_t cuts_ = 0;
  MutableMesh mesh_;
  std::vector<std::uint32_t> region_;   ///< by side: the index of its region
  std::vector<std::uint32_t> segment_;  ///< by side: the segment that it is a piece of
  std::vector<std::uint32_t> partner_;  ///< by side: the one on the other side; kNone: void
  std::vector<std::uint32_t> beyond_;   ///< by side: the triangle there; kNone: void
  std::vector<std::pair<std::uint32_t, Point>> cut_points_;  ///< with their segments
};

}  // namespace

bool cut_and_improve(Pslg& pslg, RegionTable& table, std::vector<RegionBoundary>& boundaries,
                     std::vector<RegionMesh>& meshes, const Options& options, std::stop_token stop,
                     std::vector<Note>& notes) {
  if (!options.split_interfaces || !table.hull_sides.empty()) return false;
  Joined joined(pslg, boundaries, meshes, Goal::of(options.max_angle, options.min_angle));
  joined.work(stop);
  if (!joined.has_changed() || !joined.is_valid()) return false;
  const std::vector<SegmentCut> cuts = joined.segment_cuts(pslg);
  cut_segments(pslg, table, cuts);
  boundaries = split_regions(pslg, table);
  joined.separate(pslg, boundaries, meshes);
  if (!cuts.empty()) {
    notes.push_back({Note::Kind::change,
                     kVoid,
                     fmt::format("segments cut where triangles were left above {:.6g} degrees: {} "
                                 "added, the first at {}",
                                 options.max_angle.in_degrees(), counted(joined.cuts(), "point"),
                                 describe(cuts.front().points.front())),
                     {cuts.front().points.front()}});
  }
  return true;
}

}  // namespace cover
