// Tested by tests/unit/cuts/needles/warn_of_needles_test.cpp.
#include "cuts/needles/warn_of_needles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/core.h>

#include <cover/angle.hpp>
#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "cdt/cdt.hpp"
#include "cdt/region_cdt.hpp"
#include "cuts/unite_pieces.hpp"
#include "geom/cotangent.hpp"
#include "geom/foot.hpp"
#include "geom/topology/corner.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "sizes/size_field.hpp"

namespace cover {
namespace {

constexpr double kSharp = 1;         ///< degrees: larger angles are not told
constexpr double kFarBelow = 0.1;    ///< of the smallest angle without cuts
constexpr double kFarNearer = 1e-3;  ///< of the least distance without cuts

/// Lengths and angles of triangles, the least of all.
struct Least {
  double angle = kInfinity;  ///< radians
  Point sharpest;
  double distance = kInfinity;
  Point nearest;  ///< one of the two
};

double angle_at_corner(const std::array<Point, 3>& p, Corner i) {
  const Vector u = p[i.next()] - p[i], v = p[i.previous()] - p[i];
  return angle_of_cot(dot(u, v) / std::abs(cross(u, v)));
}

void add(const std::array<Point, 3>& p, Least& least) {
  for (const Corner i : kCorners) {
    if (const double angle = angle_at_corner(p, i); angle < least.angle)
      least.angle = angle, least.sharpest = p[i];
    if (const double edge = length(p[i.next()] - p[i]); edge < least.distance)
      least.distance = edge, least.nearest = p[i];
  }
}

Least least_of(const RegionBoundary& boundary, const RegionMesh& mesh) {
  const std::vector<Point> points = all_points(boundary, mesh);
  Least least;
  for (const auto& [a, b, c] : mesh.triangles) add({points[a], points[b], points[c]}, least);
  return least;
}

/// That of a region before its mesh: also of vertices and the sides opposite to them.
Least least_of(const Triangulation& cdt) {
  Least least;
  for (const Triangle& t : cdt.triangles) {
    const std::array<Point, 3> p{cdt.points[t.v[0]], cdt.points[t.v[1]], cdt.points[t.v[2]]};
    add(p, least);
    for (const Corner i : kCorners) {
      if (t.is_locked(i))
        least.distance =
            std::min(least.distance, distance_to_segment(p[i], p[i.next()], p[i.previous()]));
    }
  }
  return least;
}

/// What is told of all regions.
class Findings {
 public:
  explicit Findings(const Options& options) : options_(options) {}

  void add(const RegionBoundary& boundary, const RegionMesh& mesh, const Least& now,
           const Least& before) {
    const double limit = std::min(Angle::degrees(kSharp).in_radians(), kFarBelow * before.angle);
    if (now.angle < limit) {
      sharp_ += sharper_than(limit, boundary, mesh);
      if (now.angle < sharpest_.angle)
        sharpest_ = now, region_ = boundary.id, angle_before_ = before.angle;
    }
    if (!has_sizes(boundary, options_) && now.distance < kFarNearer * before.distance &&
        now.distance < nearest_.distance)
      nearest_ = now, region_of_nearest_ = boundary.id, distance_before_ = before.distance;
  }

  void tell(std::vector<Note>& notes) const {
    const auto degrees = [](double radians) { return Angle::radians(radians).in_degrees(); };
    if (sharp_ > 0)
      notes.push_back(
          {Note::Kind::warning,
           kVoid,
           fmt::format(
               "{} far below what the input forces, the smallest of {:.2g} degrees in "
               "region {} at {}: before segments were cut, none there or beside it was below "
               "{:.2g}",
               counted(sharp_, "triangle") + (sharp_ == 1 ? " has an angle" : " have angles"),
               degrees(sharpest_.angle), region_.value(), describe(sharpest_.sharpest),
               degrees(angle_before_)),
           {sharpest_.sharpest}});
    if (nearest_.distance < kInfinity)
      notes.push_back(
          {Note::Kind::warning,
           kVoid,
           fmt::format("two vertices of region {} are {} apart at {}: before segments were cut, "
                       "nothing in it or beside it was nearer than {}",
                       region_of_nearest_.value(), describe_roughly(nearest_.distance),
                       describe(nearest_.nearest), describe_roughly(distance_before_)),
           {nearest_.nearest}});
  }

 private:
  static std::size_t sharper_than(double limit, const RegionBoundary& boundary,
                                  const RegionMesh& mesh) {
    const std::vector<Point> points = all_points(boundary, mesh);
    return static_cast<std::size_t>(
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const IndexTriple& t) {
          Least least;
          cover::add({points[t[0]], points[t[1]], points[t[2]]}, least);
          return least.angle < limit;
        }));
  }

  const Options& options_;
  std::size_t sharp_ = 0;
  Least sharpest_, nearest_;
  RegionId region_, region_of_nearest_;
  double angle_before_ = 0, distance_before_ = 0;
};

/// A region that may have something to tell.
struct Suspect {
  std::size_t region;  ///< its index
  Least least;
};

/// Regions with cuts and without layers, which are as thin as was asked.
std::vector<Suspect> suspects_of(const Work& work) {
  std::vector<Suspect> suspects;
  const auto is_cut = [&](VertexId v) { return v.index() >= work.report.input_points; };
  for (std::size_t r = 0; r < work.meshes.size(); ++r) {
    const RegionBoundary& boundary = work.boundaries[r];
    if (work.meshes[r].layer_triangles > 0 ||
        std::none_of(boundary.vertices.begin(), boundary.vertices.end(), is_cut))
      continue;
    const Least least = least_of(boundary, work.meshes[r]);
    double longest = 0;
    for (const auto& [a, b] : boundary.sides)
      longest = std::max(longest, length(boundary.points[b] - boundary.points[a]));
    if (least.angle < Angle::degrees(kSharp).in_radians() || least.distance < kFarNearer * longest)
      suspects.push_back({r, least});
  }
  return suspects;
}

/// The regions before segments were cut.
class Uncut {
 public:
  explicit Uncut(const Work& work) : pslg_(work.pslg), table_(work.table) {
    unite_pieces(pslg_, table_, work.report.input_points);
    boundaries_ = split_regions(pslg_, table_);
    least_.resize(boundaries_.size());
  }

  /// The least of a region and of those beside it, for which its segments may have been cut.
  Least least_around(std::size_t region) {
    Least least = least_in(region);
    for (const SegmentId s : boundaries_[region].segments) {
      if (s == kHullSide) continue;
      for (const RegionId r : {table_.sides[s.index()].left, table_.sides[s.index()].right}) {
        if (r == kVoid) continue;
        const Least& other = least_in(place_of(r));
        least.angle = std::min(least.angle, other.angle);
        least.distance = std::min(least.distance, other.distance);
      }
    }
    return least;
  }

 private:
  const Least& least_in(std::size_t region) {
    std::optional<Least>& least = least_[region];
    if (!least) {
      const RegionBoundary& boundary = boundaries_[region];
      const CdtResult cdt = triangulate_domain(boundary.points, boundary.sides);
      // Cuts on arcs stay, and what was straightened beside them may meet them by rounding: then
      // nothing is known.
      const bool is_known = !find_flaw(cdt, boundary.points, boundary.sides);
      least = is_known ? least_of(cdt.triangulation) : Least{0, {}, 0, {}};
    }
    return *least;
  }

  Pslg pslg_;
  RegionTable table_;
  std::vector<RegionBoundary> boundaries_;
  std::vector<std::optional<Least>> least_;  ///< by region
};

}  // namespace

void warn_of_needles(const Work& work, const Options& options, std::vector<Note>& notes) {
  const std::size_t first = work.report.input_points;
  if (work.pslg.points.size() == first || !work.pslg.periodic.empty()) return;
  const std::vector<Suspect> suspects = suspects_of(work);
  if (suspects.empty()) return;
  Uncut uncut(work);
  Findings findings(options);
  for (const Suspect& s : suspects)
    findings.add(work.boundaries[s.region], work.meshes[s.region], s.least,
                 uncut.least_around(s.region));
  findings.tell(notes);
}

}  // namespace cover
