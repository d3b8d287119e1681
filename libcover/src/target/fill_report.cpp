// All angles of a triangle share one cross product, so each costs one division: its cotangent,
// which orders angles as well as the angles do and keeps the digits of flat triangles. Arc tangents
// are taken of the extremes only.
#include "target/fill_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <fmt/core.h>

#include "box/encroached_sides.hpp"
#include "cdt/couplings.hpp"
#include "cdt/region_cdt.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/predicates.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "limits/couplings/forced_sides.hpp"
#include "target/flat_on_hull.hpp"

namespace cover {
namespace {

constexpr double kCotangentOf150 = -std::numbers::sqrt3;
/// In cotangents: from here on doubles tell that an angle is acute, or obtuse.
constexpr double kNearRight = 1e-9;
/// Triangles. The same for any team: areas are summed in the same order.
constexpr std::size_t kTrianglesAtATime = 1 << 17;
constexpr std::size_t kUpToRight = 8;  ///< the bin of 80 to 90 degrees
/// Spacings of doubles: a triangle that is no higher than that cannot be divided.
constexpr double kNoRoom = 64;

/// A triangle from its largest angle's corner on.
struct Sorted {
  Point apex;  ///< corner of the largest angle, opposite to the longest edge
  Point p, q;  ///< the others, counter-clockwise; the smallest angle is at `sharp`
  Point sharp;
  Point blunt;
};

Sorted sort_corners(Point a, Point b, Point c) {
  const double ab = squared_length(b - a), bc = squared_length(c - b), ca = squared_length(a - c);
  // Looked up, without a branch: nobody can predict which corner it is.
  const Point corner[5] = {a, b, c, a, b};
  const double opposite[5] = {bc, ca, ab, bc, ca};
  const bool is_first = (bc >= ab) & (bc >= ca);
  const std::size_t apex = is_first ? 0 : ca >= ab ? 1 : 2;
  const std::size_t sharp =
      apex + 1 + static_cast<std::size_t>(opposite[apex + 2] < opposite[apex + 1]);
  return {corner[apex], corner[apex + 1], corner[apex + 2], corner[sharp],
          corner[2 * apex + 3 - sharp]};
}

double cotangent(Point a, Point corner, Point b, double doubled_area) {
  return dot(a - corner, b - corner) / doubled_area;
}

double largest_nu_of(Point a, Point b, Point c) {
  const Sorted s = sort_corners(a, b, c);
  return accurate_nu_at(s.p, s.apex, s.q);
}

/// Cotangents of 10, 20, ..., 170 degrees, made up to a whole tree of binary search.
using BinLimits = std::array<double, 31>;

BinLimits bin_limits() {
  BinLimits limits;
  limits.fill(std::numeric_limits<double>::quiet_NaN());  // none of them is reached
  for (std::size_t k = 0; k < 17; ++k) {
    limits[k] = 1 / std::tan(Angle::degrees(10.0 * static_cast<double>(k + 1)).in_radians());
  }
  // A right angle is not above 90 degrees: the upper bins hold the obtuse ones.
  limits[kUpToRight] = -std::numeric_limits<double>::min();
  return limits;
}

/// The bin of an angle with this cotangent: how many limits are no smaller. By additions, because
/// nobody can predict a branch.
std::size_t bin_of(double cotangent, const BinLimits& limits) {
  std::size_t bin = 0;
  for (std::size_t step = 16; step > 0; step /= 2) {
    bin += step * static_cast<std::size_t>(cotangent <= limits[bin + step - 1]);
  }
  return bin;
}

/// The triangle with the largest angle.
IndexTriple worst_triangle(std::span<const Point> points, std::span<const IndexTriple> triangles) {
  const auto nu = [&](const IndexTriple& t) {
    return largest_nu_of(points[t[0]], points[t[1]], points[t[2]]);
  };
  return *std::min_element(triangles.begin(), triangles.end(),
                           [&](const auto& s, const auto& t) { return nu(s) < nu(t); });
}

Note bound_missed(const RegionReport& report, std::span<const Point> points, IndexTriple worst) {
  const Point a = points[worst[0]], b = points[worst[1]], c = points[worst[2]];
  const Sorted s = sort_corners(a, b, c);
  const double height = std::abs(cross(s.p - s.apex, s.q - s.apex)) / length(s.q - s.p);
  const double spacing = spacing_at(largest_coordinate(points));
  std::string why;
  if (height < kNoRoom * spacing) {
    why = fmt::format(
        ": it is {:.2g} high where doubles are {:.2g} apart, which leaves no room for a vertex "
        "beside it (--weld joins points so near to each other)",
        height, spacing);
  }
  return {Note::Kind::bound_missed,
          report.id,
          fmt::format("region {}: the triangle ({}, {}), ({}, {}), ({}, {}) has an angle of {:.9g} "
                      "degrees; the bound is {:.9g}{}",
                      report.id.value(), a.x, a.y, b.x, b.y, c.x, c.y,
                      report.quality.largest_nu.supplement().in_degrees(),
                      report.nu_bound.supplement().in_degrees(), why),
          {a, b, c}};
}

Quality measure_some(std::span<const Point> points, std::span<const IndexTriple> triangles,
                     const BinLimits& limits) {
  Quality quality;
  quality.triangles = triangles.size();
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  Sorted flattest, sharpest;
  for (const auto& [i, j, k] : triangles) {
    const Sorted s = sort_corners(points[i], points[j], points[k]);
    const double doubled_area = cross(s.p - s.apex, s.q - s.apex), area = std::abs(doubled_area);
    const double largest = cotangent(s.p, s.apex, s.q, area);
    const double smallest = cotangent(s.apex, s.sharp, s.blunt, area);
    if (largest < lowest) lowest = largest, flattest = s;
    if (smallest > highest) highest = smallest, sharpest = s;
    const Blunt blunt = largest < kNearRight ? bluntness(s.p, s.apex, s.q) : Blunt::no;
    quality.obtuse += blunt == Blunt::yes ? 1 : 0;
    quality.obtuse_by_rounding += blunt == Blunt::by_rounding ? 1 : 0;
    if (largest < -kNearRight) {
      if (compare_with_120_degrees(s.p, s.apex, s.q) == Sign::positive) ++quality.above_120;
      if (largest < kCotangentOf150) ++quality.above_150;
    }
    const std::size_t bin = bin_of(largest, limits);
    ++quality.histogram[blunt == Blunt::yes ? bin : std::min(bin, kUpToRight)];
    ++quality.histogram[bin_of(cotangent(s.apex, s.blunt, s.sharp, area), limits)];
    ++quality.histogram[bin_of(smallest, limits)];
    quality.area += doubled_area / 2;
  }
  if (!triangles.empty()) {
    quality.largest_nu = Angle::radians(accurate_nu_at(flattest.p, flattest.apex, flattest.q));
    quality.smallest = Angle::radians(angle_at(sharpest.apex, sharpest.sharp, sharpest.blunt));
  }
  return quality;
}

}  // namespace

Quality measure_angles(std::span<const Point> points, std::span<const IndexTriple> triangles,
                       const Team& team) {
  static const BinLimits limits = bin_limits();  // small regions come by the thousand
  if (triangles.size() <= kTrianglesAtATime) return measure_some(points, triangles, limits);
  std::vector<Quality> parts(Team::ranges(triangles.size(), kTrianglesAtATime));
  team.each_range(triangles.size(), kTrianglesAtATime, [&](std::size_t first, std::size_t last) {
    parts[first / kTrianglesAtATime] =
        measure_some(points, triangles.subspan(first, last - first), limits);
  });
  Quality sum = parts[0];
  for (std::size_t k = 1; k < parts.size(); ++k) merge(sum, parts[k]);
  return sum;
}

namespace {

/// What is known of half-edges, of which several measures need all.
struct Opposites {
  std::vector<double> cots;           ///< of the angle opposite
  std::vector<std::uint32_t> across;  ///< across_edges()
};

/// `across` is what across_edges() makes, if it is known.
Opposites opposites_of(std::span<const Point> points, std::span<const IndexTriple> triangles,
                       std::span<const IndexPair> sides, const Team& team,
                       std::vector<std::uint32_t> across = {}) {
  Opposites of;
  of.cots.resize(3 * triangles.size());
  team.each_range(triangles.size(), kTrianglesAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto& [i, j, k] = triangles[t];
      const Point corners[3] = {points[i], points[j], points[k]};
      const double doubled_area = cross(corners[1] - corners[0], corners[2] - corners[0]);
      for (std::size_t h = 0; h < 3; ++h)
        of.cots[3 * t + h] =
            cotangent(corners[h], corners[(h + 2) % 3], corners[(h + 1) % 3], doubled_area);
    }
  });
  of.across = across.size() == of.cots.size() ? std::move(across)
                                              : across_edges(points.size(), triangles, sides, team);
  return of;
}

/// Of the triangles from `first` to before `last`.
BoxMethod measure_some_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                             const Opposites& opposites, std::size_t first, std::size_t last) {
  BoxMethod box;
  const auto& [cots, across] = opposites;
  for (std::size_t t = first; t < last; ++t) {
    const Point corner[3] = {points[triangles[t][0]], points[triangles[t][1]],
                             points[triangles[t][2]]};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto h = static_cast<std::uint32_t>(3 * t + i);
      const Point from = corner[i], to = corner[(i + 1) % 3], beside = corner[(i + 2) % 3];
      // |e| d_e / 2 with d_e = |e| |cot| / 2, the distance from the edge's midpoint to the
      // circumcentre
      box.box_area += squared_length(to - from) * std::abs(cots[h]) / 4;
      const std::uint32_t twin = across[h];
      if (twin == kNone) {
        const bool is_obtuse = cots[h] < kNearRight && bluntness(from, beside, to) == Blunt::yes;
        box.obtuse_sides += is_obtuse ? 1 : 0;
      } else if (h < twin && cots[h] + cots[twin] < -kNearRight) {
        const std::uint32_t beyond = HalfEdges::previous(twin);
        if (in_circle(from, to, beside, points[triangles[beyond / 3][beyond % 3]]) ==
            Sign::positive)
          ++box.non_delaunay_edges;
      }
    }
  }
  return box;
}

BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        const Opposites& opposites, const Team& team) {
  std::vector<BoxMethod> parts(Team::ranges(triangles.size(), kTrianglesAtATime));
  team.each_range(triangles.size(), kTrianglesAtATime, [&](std::size_t first, std::size_t last) {
    parts[first / kTrianglesAtATime] =
        measure_some_boxes(points, triangles, opposites, first, last);
  });
  BoxMethod sum;
  for (const BoxMethod& part : parts) {
    sum.box_area += part.box_area;
    sum.obtuse_sides += part.obtuse_sides;
    sum.non_delaunay_edges += part.non_delaunay_edges;
  }
  return sum;
}

}  // namespace

BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        std::span<const IndexPair> sides) {
  return measure_boxes(points, triangles, opposites_of(points, triangles, sides, Team()), Team());
}

namespace {

/// The triangles of a triangulation that are beyond the bound, by more than rounding.
std::vector<std::array<Point, 3>> triangles_beyond(const Triangulation& cdt, Angle nu_bound) {
  std::vector<std::array<Point, 3>> beyond;
  const double farthest = largest_coordinate(cdt.points);
  for (const Triangle& t : cdt.triangles) {
    const Point a = cdt.points[t.v[0]], b = cdt.points[t.v[1]], c = cdt.points[t.v[2]];
    if (largest_nu_of(a, b, c) + angle_rounding(a, b, c, farthest) < nu_bound.in_radians())
      beyond.push_back({a, b, c});
  }
  return beyond;
}

/// The triangulation of the points of the boundary, and of what else is given.
Triangulation cdt_of_given(const RegionBoundary& boundary, std::span<const Point> given) {
  if (given.size() == boundary.points.size())
    return triangulate_in_order(boundary.points, boundary.sides, boundary.known_triangles());
  return triangulate_domain(given, boundary.sides).triangulation;
}

/// Of the sides that are given up: those that the bound forces.
void find_forced(const RegionBoundary& boundary, Angle nu_bound,
                 std::vector<NegativeCoupling>& couplings) {
  using Kind = NegativeCoupling::Kind;
  const auto is_inside = [](const NegativeCoupling& c) { return c.kind == Kind::inside; };
  if (std::any_of(couplings.begin(), couplings.end(), is_inside) || boundary.has_hull_sides())
    return;
  const Triangulation cdt = cdt_of_given(boundary, boundary.points);
  std::vector<bool> is_free(boundary.sides.size(), true);
  for (const EncroachedSide& e : encroached_sides(cdt, locate_sides(cdt, boundary.sides)))
    is_free[e.side] = false;
  std::vector<NegativeCoupling*> given_up;
  for (NegativeCoupling& c : couplings) {
    if (c.kind == Kind::given_up) given_up.push_back(&c);
  }
  tell_forced(boundary.points, boundary.sides, is_free, triangles_beyond(cdt, nu_bound), given_up);
}

/// The edges of a region's mesh with a negative coupling, exactly; counted in `box`. O(n), O(n log
/// n) where a side has one.
std::vector<NegativeCoupling> measure_couplings(const RegionBoundary& boundary,
                                                const RegionMesh& mesh,
                                                std::span<const Point> points,
                                                const Opposites& opposites, const Team& team,
                                                BoxMethod& box) {
  std::vector<NegativeCoupling> found;
  const std::vector<NegativeEdge> negative =
      negative_edges(points, mesh.triangles, opposites.across, opposites.cots, team);
  // Layers were asked for, so their vertices are as given as those of the boundary.
  const auto given = points.first(boundary.points.size() + mesh.layer_vertices);
  // In a Delaunay mesh it is the apex that sees a side under the largest angle: if it is given, no
  // triangulation of what is given needs to tell who encroaches the side.
  const bool apexes_tell =
      std::all_of(negative.begin(), negative.end(),
                  [&](const NegativeEdge& e) { return e.is_side && e.apex < given.size(); });
  std::vector<std::uint32_t> encroached_by(boundary.sides.size(), kNone);
  if (!apexes_tell) {
    const Triangulation cdt = cdt_of_given(boundary, given);
    for (const EncroachedSide& e : encroached_sides(cdt, locate_sides(cdt, boundary.sides)))
      encroached_by[e.side] = e.vertex;
  }
  for (const NegativeEdge& e : negative) {
    auto kind = NegativeCoupling::Kind::inside;
    Point apex = points[e.apex];
    if (e.is_side) {
      const auto side = std::lower_bound(boundary.sides.begin(), boundary.sides.end(), e.edge);
      // A side of the hull may have been split: its pieces are no sides of the boundary.
      const bool is_whole = side != boundary.sides.end() && *side == e.edge;
      const std::uint32_t by =
          !is_whole     ? kNone
          : apexes_tell ? e.apex
                        : encroached_by[static_cast<std::size_t>(side - boundary.sides.begin())];
      kind = by == kNone ? NegativeCoupling::Kind::given_up : NegativeCoupling::Kind::encroached;
      if (by != kNone) apex = points[by];
    }
    found.push_back({kind, boundary.id, points[e.edge[0]], points[e.edge[1]], apex});
  }
  if (std::any_of(found.begin(), found.end(), [](const NegativeCoupling& c) {
        return c.kind == NegativeCoupling::Kind::given_up;
      }))
    find_forced(boundary, mesh.report.nu_bound, found);
  const auto count = [&](NegativeCoupling::Kind kind) {
    return static_cast<std::size_t>(std::count_if(
        found.begin(), found.end(), [&](const NegativeCoupling& c) { return c.kind == kind; }));
  };
  box.negative_couplings = found.size();
  box.negative_inside = count(NegativeCoupling::Kind::inside);
  box.negative_encroached = count(NegativeCoupling::Kind::encroached);
  box.negative_forced = count(NegativeCoupling::Kind::forced);
  box.negative_given_up = count(NegativeCoupling::Kind::given_up);
  return found;
}

}  // namespace

void merge(Quality& sum, const Quality& part) {
  sum.triangles += part.triangles;
  sum.largest_nu = std::min(sum.largest_nu, part.largest_nu);
  sum.smallest = std::min(sum.smallest, part.smallest);
  sum.obtuse += part.obtuse;
  sum.obtuse_by_rounding += part.obtuse_by_rounding;
  sum.above_120 += part.above_120;
  sum.above_150 += part.above_150;
  for (std::size_t i = 0; i < sum.histogram.size(); ++i) sum.histogram[i] += part.histogram[i];
  sum.area += part.area;
}

std::size_t count_above(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        Angle wanted) {
  const double least_nu = wanted.supplement().in_radians();
  const auto is_above = [&](const IndexTriple& t) {
    return largest_nu_of(points[t[0]], points[t[1]], points[t[2]]) < least_nu;
  };
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), is_above));
}

bool holds_bound(std::span<const Point> points, std::span<const IndexTriple> triangles,
                 Angle nu_bound) {
  const double largest = largest_coordinate(points);
  return std::all_of(triangles.begin(), triangles.end(), [&](const IndexTriple& t) {
    const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
    const double nu = largest_nu_of(a, b, c);
    return nu >= nu_bound.in_radians() ||
           nu + angle_rounding(a, b, c, largest) >= nu_bound.in_radians();
  });
}

void set_limits(const AngleLimit& limit, RegionReport& report) {
  report.nu_opt = Angle::radians(limit.nu);
  report.nu_bound = Angle::radians(limit.promised_nu());
  report.forced_above_120 = limit.above_120;
  report.forced_above_150 = limit.above_150;
}

void fill_report(const RegionBoundary& boundary, RegionMesh& mesh, const Team& team,
                 std::vector<std::uint32_t> across) {
  const std::vector<Point> points = all_points(boundary, mesh);
  RegionReport& report = mesh.report;
  team.each(2, [&](std::size_t k) {
    if (k == 1) {
      report.quality = measure_angles(points, mesh.triangles, team);
      return;
    }
    const Opposites opposites =
        opposites_of(points, mesh.triangles, boundary.sides, team, std::move(across));
    report.box = measure_boxes(points, mesh.triangles, opposites, team);
    report.couplings = measure_couplings(boundary, mesh, points, opposites, team, report.box);
  });
  report.input_vertices = boundary.points.size();
  report.steiner_vertices = mesh.steiner.size();
  report.bound_held =
      !mesh.triangles.empty() && (report.quality.largest_nu >= report.nu_bound ||
                                  holds_bound(points, mesh.triangles, report.nu_bound));
  // What was missed before something was mended is missed no more.
  std::erase_if(report.notes, [](const Note& n) { return n.kind == Note::Kind::bound_missed; });
  if (!report.bound_held && !mesh.triangles.empty()) {
    Note note = bound_missed(report, points, worst_triangle(points, mesh.triangles));
    const auto others = without_flat_on_hull(boundary, points, mesh.triangles);
    if (others.size() < mesh.triangles.size() && holds_bound(points, others, report.nu_bound))
      note.kind = Note::Kind::below_resolution;
    report.notes.push_back(std::move(note));
  }
}

}  // namespace cover
