// All regions become a joined mesh whose sides know what lies beyond them. Around every triangle
// that is left, an excerpt over segments is tried: kicks first, then cuts of the segments near by,
// at the foot of the obtuse corner or half way, each improved and kicked in turn. The best is kept
// if there are fewer such triangles, or less bad ones. Triangles are taken in the order of their
// coordinates, so that the mesh does not depend on the order of the input.
// Tested by tests/unit/cuts/after_meshing/cut_and_improve_test.cpp.
#include "cuts/after_meshing/cut_and_improve.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "cuts/cut_segments.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "method/boundaries_with_wishes.hpp"
#include "quality/effort/effort.hpp"
#include "quality/fault/keep_rules.hpp"
#include "quality/fault/merit.hpp"
#include "quality/repair/kicks.hpp"
#include "quality/repair/triangles_above.hpp"

namespace cover {
namespace {

constexpr std::uint32_t kCutAround = 16;  ///< triangles of it whose sides may be cut
constexpr double kEnd = 0.01;             ///< of a side: no cut is nearer to its ends
constexpr std::size_t kKicked = 5;        ///< cuts that are kicked

/// Evaluations that a search has in any case, and that may be spent for each triangle it mends.
constexpr std::uint64_t kInAnyCase = 15'000'000, kForOne = 150'000;

/// A side with the triangle that has it.
struct SidePlace {
  std::uint32_t side;
  std::uint32_t triangle;
  Corner edge;
};

/// Those of two sides that have a triangle; kNone is no side.
std::vector<SidePlace> places_of(const MutableMesh& mesh, std::array<std::uint32_t, 2> sides) {
  std::vector<SidePlace> places;
  for (const std::uint32_t side : sides) {
    if (side == kNone) continue;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& n = mesh.triangles[t].n;
      const auto edge = std::find(n.begin(), n.end(), kSideBit | side);
      if (edge != n.end())
        places.push_back({side, t, static_cast<std::uint32_t>(edge - n.begin())});
    }
  }
  return places;
}

/// Whether both parts of the triangle are counter-clockwise if its side is cut at `p`.
bool may_be_cut_at(const MutableMesh& mesh, const SidePlace& place, Point p) {
  const Point apex = mesh.corner(place.triangle, place.edge);
  const Point a = mesh.corner(place.triangle, place.edge.next());
  const Point b = mesh.corner(place.triangle, place.edge.previous());
  return orientation(apex, a, p) == Sign::positive && orientation(apex, p, b) == Sign::positive;
}

/// REQUIRES: may_be_cut_at() the place of `m`
void cut_one_side(MutableMesh& mesh, const SidePlace& place, std::uint32_t m) {
  const std::uint32_t t = place.triangle, t2 = mesh.add_triangle();
  const Corner corner = place.edge, a = corner.next(), b = corner.previous();
  const MeshTriangle old = mesh.triangles[t];
  const auto side = static_cast<std::uint32_t>(mesh.sides.size());
  mesh.sides.repeat(place.side);
  mesh.allowances.push_back(mesh.allowances[place.side]);
  mesh.triangles[t] = {{old.v[corner], old.v[a], m}, {kSideBit | place.side, t2, old.n[b]}};
  mesh.triangles[t2] = {{old.v[corner], m, old.v[b]}, {kSideBit | side, old.n[a], t}};
  mesh.link(old.n[a], old.v[b], old.v[corner], t2);
  for (const std::uint32_t v : {old.v[corner], old.v[a], m}) mesh.home[v] = t;
  mesh.home[old.v[b]] = t2;
  mesh.measure(t);
  mesh.measure(t2);
}

/// Cuts side `s` of `mesh`, and `r` on the other side of its segment (kNone: the void), at `m`, a
/// fixed vertex without triangles. The parts at the starts of both keep their numbers, both parts
/// what was allowed to the whole.
///
/// ENSURES: false, and nothing has changed, if a triangle would not be counter-clockwise
bool cut_side(MutableMesh& mesh, std::uint32_t s, std::uint32_t r, std::uint32_t m) {
  const std::vector<SidePlace> places = places_of(mesh, {s, r});
  const Point p = mesh.points[m];
  if (!std::all_of(places.begin(), places.end(),
                   [&](const SidePlace& place) { return may_be_cut_at(mesh, place, p); }))
    return false;
  for (const SidePlace& place : places) cut_one_side(mesh, place, m);
  return true;
}

/// The search around every triangle that is left.
class CutSearch {
 public:
  explicit CutSearch(MutableJoinedMesh& whole) : whole_(whole), goal_(whole.goal()) {}

  /// Returns how many there were, and what kept it from trying all of them, if something did.
  CutResult run(Budget& budget) {
    CutResult result;
    const std::uint64_t first = budget.left;
    std::uint64_t mended = 0;
    std::vector<std::uint32_t> first_above = whole_.triangles_above();
    result.above = first_above.size();
    TrianglesAbove above(whole_.mesh(), goal_, std::move(first_above));
    while (!above.empty() && !budget.is_used_up() && !result.was_in_vain) {
      const std::optional<std::uint32_t> t = above.next();
      if (!t) continue;
      const std::vector<std::uint32_t> changed = attempt(*t, budget);
      mended += changed.empty() ? 0 : 1;
      above.add(changed);
      const std::uint64_t spent = first - budget.left;
      result.was_in_vain = spent > kInAnyCase && spent > kForOne * mended;
    }
    result.budget_used_up = !above.empty();
    return result;
  }

 private:
  /// A triangulation of an excerpt that is better than before, and the cut that it has, if any.
  struct ImprovedExcerpt {
    MutableMesh mesh;
    Merit merit;
    std::uint32_t side = kNone;  ///< of the excerpt
  };

  /// Returns the triangles that changed.
  std::vector<std::uint32_t> attempt(std::uint32_t t, Budget& budget) {
    Excerpt excerpt = whole_.excerpt_around(t, effort::kExcerpt);
    ImprovedExcerpt best{excerpt.mesh, merit_of(excerpt.mesh, goal_)};
    if (kick_and_improve(best.mesh, goal_, budget))
      return whole_.put_back(excerpt, best.mesh, best.side);
    if (!whole_.may_cut() || !try_cuts(excerpt, best, budget)) return {};
    return whole_.put_back(excerpt, best.mesh, best.side);
  }

  /// Tries all cuts near triangle 0 of `excerpt`, and kicks what comes of the most promising ones.
  /// Returns whether `best` has become better.
  bool try_cuts(const Excerpt& excerpt, ImprovedExcerpt& best, Budget& budget) const {
    std::vector<ImprovedExcerpt> cuts;
    const std::uint32_t last =
        std::min(kCutAround, static_cast<std::uint32_t>(excerpt.mesh.triangles.size()));
    for (std::uint32_t t = 0; t < last && !budget.is_used_up(); ++t) {
      for (const Corner e : kCorners) {
        const std::uint32_t n = excerpt.mesh.triangles[t].n[static_cast<std::size_t>(e)];
        if (!is_side(n) || !is_side(excerpt.outside[side_index(n)])) continue;
        if (!whole_.is_free(side_index(excerpt.outside[side_index(n)]))) continue;
        const Point a = excerpt.mesh.corner(t, e.next()), b = excerpt.mesh.corner(t, e.previous());
        for (const Point& place : places_on(a, b, excerpt.mesh)) {
          if (auto cut = cut_at(excerpt, side_index(n), place, budget)) {
            cuts.push_back(*std::move(cut));
          }
        }
      }
    }
    const auto is_less_bad = [](const ImprovedExcerpt& x, const ImprovedExcerpt& y) {
      return x.merit.above != y.merit.above ? x.merit.above < y.merit.above
                                            : x.merit.large < y.merit.large;
    };
    std::stable_sort(cuts.begin(), cuts.end(), is_less_bad);
    const Merit before = best.merit;
    const auto is_kept = [&](const Merit& now) { return is_cut_kept(now, before, goal_); };
    for (std::size_t k = 0; k < std::min(kKicked, cuts.size()); ++k) {
      if (!is_kept(cuts[k].merit)) {
        cuts[k].merit = improve_by_kicks(cuts[k].mesh, goal_, cuts[k].merit, budget);
      }
      if (!is_kept(cuts[k].merit)) continue;
      best = std::move(cuts[k]);
      return true;
    }
    return false;
  }

  /// The middle of ab, and the feet on it of the corners of triangle 0.
  [[nodiscard]] static std::vector<Point> places_on(Point a, Point b, const MutableMesh& mesh) {
    std::vector<Point> places{midpoint(a, b)};
    for (const Corner i : kCorners) {
      const double part = part_on_line(a, b, mesh.corner(0, i));
      if (part > kEnd && part < 1 - kEnd) places.push_back(a + part * (b - a));
    }
    return places;
  }

  /// The excerpt with `side` cut at `place`, improved; nothing where that cannot be.
  [[nodiscard]] std::optional<ImprovedExcerpt> cut_at(const Excerpt& excerpt, std::uint32_t side,
                                                      Point place, Budget& budget) const {
    const std::uint32_t partner = whole_.partner(side_index(excerpt.outside[side]));
    std::uint32_t other = kNone;
    if (partner != kNone) {
      const auto at = std::find(excerpt.outside.begin(), excerpt.outside.end(), kSideBit | partner);
      if (at == excerpt.outside.end()) return std::nullopt;
      other = static_cast<std::uint32_t>(at - excerpt.outside.begin());
    }
    ImprovedExcerpt cut{excerpt.mesh, {}, side};
    cut.mesh.points[excerpt.spare] = place;
    if (!cut_side(cut.mesh, side, other, excerpt.spare)) return std::nullopt;
    improve_with_slack(cut.mesh, budget);
    cut.merit = merit_of(cut.mesh, goal_);
    return cut;
  }

  MutableJoinedMesh& whole_;
  Goal goal_;
};

}  // namespace

Result<CutResult> cut_and_improve(Work& work, MutableJoinedMesh& joined, const Options& options,
                                  Budget& budget) {
  CutResult result = CutSearch(joined).run(budget);
  if (!joined.has_changed() || !joined.is_valid()) return result;
  Work cut = work;
  cut_segments(cut.pslg, cut.table, joined.segment_cuts(work.pslg));
  // What comes after looks at the sizes.
  Result<std::vector<RegionBoundary>> boundaries =
      boundaries_with_wishes(cut.pslg, cut.table, options);
  if (!boundaries) return std::move(boundaries).error();
  cut.boundaries = *std::move(boundaries);
  joined.separate(cut.pslg, cut.boundaries, cut.meshes);
  if (!is_sound(cut)) return result;
  work = std::move(cut);
  result.above = joined.triangles_above().size();
  return result;
}

}  // namespace cover
