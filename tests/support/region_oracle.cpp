#include "support/region_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/core.h>

#include "geom/predicates.hpp"
#include "support/inputs/shapes.hpp"

namespace cover::testing {
namespace {

struct View {
  const RegionBoundary& boundary;
  const RegionMesh& mesh;
  [[nodiscard]] Point at(std::uint32_t v) const {
    const std::size_t n = boundary.points.size();
    return v < n ? boundary.points[v] : mesh.steiner.at(v - n);
  }
};

long double nu_of(Point a, Point p, Point b) {
  const long double ux = static_cast<long double>(a.x) - p.x,
                    uy = static_cast<long double>(a.y) - p.y;
  const long double vx = static_cast<long double>(b.x) - p.x,
                    vy = static_cast<long double>(b.y) - p.y;
  return std::atan2(std::abs(ux * vy - uy * vx), -(ux * vx + uy * vy));
}

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

std::string judge_edges(const View& view) {
  std::vector<IndexPair> edges;
  for (const auto& t : view.mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice != edges.end()) {
    return fmt::format("edge {} -> {} occurs twice", (*twice)[0], (*twice)[1]);
  }
  const auto& sides = view.boundary.sides;
  for (const IndexPair& side : sides) {
    if (!std::binary_search(edges.begin(), edges.end(), side) &&
        view.boundary.segments[static_cast<std::size_t>(&side - sides.data())] != kHullSide) {
      return fmt::format("side {} -> {} is no edge", side[0], side[1]);
    }
  }
  for (const IndexPair& edge : edges) {
    const bool inner = std::binary_search(edges.begin(), edges.end(), IndexPair{edge[1], edge[0]});
    const bool side = std::binary_search(sides.begin(), sides.end(), edge);
    const bool back = std::binary_search(sides.begin(), sides.end(), IndexPair{edge[1], edge[0]});
    if (inner ? side != back : !side) {
      return fmt::format("edge {} -> {} is on the wrong side of the boundary", edge[0], edge[1]);
    }
  }
  return {};
}

}  // namespace

std::string judge_region(const RegionBoundary& boundary, const RegionMesh& mesh,
                         const RegionDemand& demand) {
  const View view{boundary, mesh};
  std::vector<bool> used(boundary.points.size() + mesh.steiner.size(), false);
  double area = 0, largest = 0;
  const Point o = boundary.points.at(0);
  for (const Point& p : boundary.points)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const double spacing = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  for (const auto& t : mesh.triangles) {
    const Point a = view.at(t[0]), b = view.at(t[1]), c = view.at(t[2]);
    if (orientation(a, b, c) != Sign::positive) {
      return fmt::format("triangle {} {} {} is not counter-clockwise", t[0], t[1], t[2]);
    }
    area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    for (const std::uint32_t v : t) used[v] = true;
    const long double nu = std::min({nu_of(b, a, c), nu_of(c, b, a), nu_of(a, c, b)});
    const double allowed = 4 * spacing / std::min({distance(a, b), distance(b, c), distance(c, a)});
    const double needed = mesh.report.nu_bound.in_radians();
    if (demand.bound && nu + allowed < needed * (1 - 1e-9)) {
      return fmt::format("triangle {} {} {} has nu {}, needed {} (rounding {})", t[0], t[1], t[2],
                         static_cast<double>(nu), needed, allowed);
    }
  }
  const bool hull = std::find(boundary.segments.begin(), boundary.segments.end(), kHullSide) !=
                    boundary.segments.end();
  if (!hull) {
    if (std::string fault = judge_edges(view); !fault.empty()) return fault;
  }
  const auto lost = std::find(used.begin(), used.end(), false);
  if (lost != used.end()) return fmt::format("vertex {} is not in use", lost - used.begin());
  double reach = 0;
  for (const Point& p : boundary.points) reach = std::max(reach, distance(o, p));
  if (std::abs(area - area_of(boundary)) >
      1e-12 * reach * reach + 64 * spacing * (spacing + reach)) {
    return fmt::format("area {}, not {}", area, area_of(boundary));
  }
  return {};
}

long double smallest_nu(const RegionBoundary& boundary, const RegionMesh& mesh) {
  const View view{boundary, mesh};
  long double smallest = 4;
  for (const auto& t : mesh.triangles) {
    const Point a = view.at(t[0]), b = view.at(t[1]), c = view.at(t[2]);
    smallest = std::min({smallest, nu_of(b, a, c), nu_of(c, b, a), nu_of(a, c, b)});
  }
  return smallest;
}

}  // namespace cover::testing
