// Triangles and the edges on their border lie in R-trees. Of several triangles that contain a
// place, all that share an edge, the first counts, so that the result does not depend on the tree.
// Tested by tests/unit/sizes/size_function_test.cpp.
#include <cover/size_function.hpp>
#include <cover/text.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include <fmt/core.h>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include "base/out_of_memory.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "sizes/spread_sizes.hpp"

namespace cover {
namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeSegment = bg::model::segment<TreePoint>;
using Strategy = bg::index::rstar<16>;
using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

TreePoint tree_point(Point p) { return {p.x, p.y}; }

Edges edges_of(const SizeSamples& samples) {
  Edges edges;
  for (const auto& [a, b, c] : samples.triangles) {
    for (const auto& [u, v] : {std::pair(a, b), {b, c}, {c, a}}) {
      edges.emplace_back(std::min(u, v), std::max(u, v));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Those that occur once, of sorted edges; each point for itself if there are none.
Edges border_of(const Edges& edges, std::size_t points) {
  Edges border;
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t next = k + 1;
    while (next < edges.size() && edges[next] == edges[k]) ++next;
    if (next == k + 1) border.push_back(edges[k]);
    k = next;
  }
  if (!border.empty()) return border;
  for (std::uint32_t v = 0; v < points; ++v) border.emplace_back(v, v);
  return border;
}

/// Linear interpolation between samples.
class Interpolation {
 public:
  Interpolation(const SizeSamples& samples, double growth) : samples_(samples) {
    const Edges edges = edges_of(samples);
    spread_sizes(samples_.points, edges, growth - 1, samples_.sizes);
    border_ = border_of(edges, samples_.points.size());
    std::vector<std::pair<TreeBox, std::uint32_t>> boxes;
    for (std::uint32_t t = 0; t < samples_.triangles.size(); ++t) {
      TreeBox box;
      bg::assign_inverse(box);
      for (const std::uint32_t v : samples_.triangles[t]) {
        bg::expand(box, tree_point(samples_.points[v]));
      }
      boxes.emplace_back(box, t);
    }
    triangles_ = {boxes.begin(), boxes.end()};
    std::vector<std::pair<TreeSegment, std::uint32_t>> segments;
    for (std::uint32_t e = 0; e < border_.size(); ++e) {
      const auto& [a, b] = border_[e];
      segments.emplace_back(
          TreeSegment{tree_point(samples_.points[a]), tree_point(samples_.points[b])}, e);
    }
    segments_ = {segments.begin(), segments.end()};
  }

  [[nodiscard]] double at(Point p) const {
    std::uint32_t first = kNowhere;
    const auto look = [&](const std::pair<TreeBox, std::uint32_t>& entry) {
      if (entry.second < first && contains(entry.second, p)) first = entry.second;
    };
    triangles_.query(bg::index::intersects(tree_point(p)),
                     boost::make_function_output_iterator(look));
    return first == kNowhere ? outside(p) : inside(first, p);
  }

 private:
  static constexpr std::uint32_t kNowhere = 0xffffffffU;

  [[nodiscard]] std::array<Point, 3> corners(std::uint32_t t) const {
    const auto& [a, b, c] = samples_.triangles[t];
    return {samples_.points[a], samples_.points[b], samples_.points[c]};
  }

  [[nodiscard]] bool contains(std::uint32_t t, Point p) const {
    const auto [a, b, c] = corners(t);
    const Sign side = orientation(a, b, c);
    if (side == Sign::zero) return false;
    const Sign wrong = side == Sign::positive ? Sign::negative : Sign::positive;
    return orientation(a, b, p) != wrong && orientation(b, c, p) != wrong &&
           orientation(c, a, p) != wrong;
  }

  [[nodiscard]] double inside(std::uint32_t t, Point p) const {
    const auto [a, b, c] = corners(t);
    const auto& [i, j, k] = samples_.triangles[t];
    const double whole = cross(b - a, c - a);
    const double of_b = cross(p - a, c - a) / whole, of_c = cross(b - a, p - a) / whole;
    const double size = samples_.sizes[i] + of_b * (samples_.sizes[j] - samples_.sizes[i]) +
                        of_c * (samples_.sizes[k] - samples_.sizes[i]);
    const auto [least, most] =
        std::minmax({samples_.sizes[i], samples_.sizes[j], samples_.sizes[k]});
    return std::clamp(size, least, most);
  }

  [[nodiscard]] double outside(Point p) const {
    double size = 0;
    const auto look = [&](const std::pair<TreeSegment, std::uint32_t>& entry) {
      const auto& [a, b] = border_[entry.second];
      const Vector along = samples_.points[b] - samples_.points[a];
      const double whole = squared_length(along);
      const double part =
          whole > 0 ? std::clamp(dot(p - samples_.points[a], along) / whole, 0.0, 1.0) : 0;
      size = samples_.sizes[a] + part * (samples_.sizes[b] - samples_.sizes[a]);
    };
    segments_.query(bg::index::nearest(tree_point(p), 1),
                    boost::make_function_output_iterator(look));
    return size;
  }

  SizeSamples samples_;
  Edges border_;
  bg::index::rtree<std::pair<TreeBox, std::uint32_t>, Strategy> triangles_;
  bg::index::rtree<std::pair<TreeSegment, std::uint32_t>, Strategy> segments_;
};

Error wrong(ErrorCode code, std::string what, std::vector<Point> where = {}) {
  return {code, std::move(what), std::move(where), {}};
}

Status check(const SizeSamples& samples) {
  const std::size_t n = samples.points.size();
  if (n == 0) return wrong(ErrorCode::syntax, "there are no points with sizes");
  if (samples.sizes.size() != n) {
    return wrong(ErrorCode::syntax,
                 fmt::format("there are {} sizes for {} points", samples.sizes.size(), n));
  }
  for (std::size_t v = 0; v < n; ++v) {
    const Point p = samples.points[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      return wrong(ErrorCode::non_finite_coordinate, fmt::format("point {} is not finite", v));
    }
    if (!(samples.sizes[v] > 0 && std::isfinite(samples.sizes[v]))) {
      return wrong(ErrorCode::syntax,
                   fmt::format("the size at point {}, {}, is {}, but must be a positive length", v,
                               describe(p), samples.sizes[v]),
                   {p});
    }
  }
  for (std::size_t t = 0; t < samples.triangles.size(); ++t) {
    for (const std::uint32_t v : samples.triangles[t]) {
      if (v < n) continue;
      return wrong(ErrorCode::id_out_of_range,
                   fmt::format("triangle {} has the point {}, which is not there", t, v));
    }
  }
  return ok();
}

}  // namespace

Result<SizeFunction> size_function(const SizeSamples& samples, double growth) {
  return memory_as_value("size function", [&]() -> Result<SizeFunction> {
    if (Status status = check(samples); !status) return std::move(status).error();
    const auto sizes = std::make_shared<const Interpolation>(samples, growth);
    return SizeFunction([sizes](Point p) { return sizes->at(p); });
  });
}

}  // namespace cover
