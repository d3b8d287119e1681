// Of several triangles that contain a place, all that share an edge, the first counts, so that the
// result does not depend on the tree.
// Tested by tests/unit/sizes/fields/size_function_test.cpp.
#include <cover/option_ranges.hpp>
#include <cover/size_function.hpp>
#include <cover/text.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "base/faults/out_of_memory.hpp"
#include "geom/foot.hpp"
#include "sizes/fields/triangle_tree.hpp"
#include "sizes/spread_sizes.hpp"

namespace cover {
namespace {

/// Linear interpolation between samples.
class Interpolation {
 public:
  Interpolation(const SizeSamples& samples, double growth)
      : Interpolation(samples, growth, edges_of(samples.triangles)) {}

  [[nodiscard]] double at(Point p) const {
    const std::optional<std::uint32_t> first = tree_.first_at(p);
    return first ? inside(*first, p) : outside(p);
  }

 private:
  Interpolation(const SizeSamples& samples, double growth, const TreeEdges& edges)
      : samples_(samples), tree_(samples.points, samples.triangles, edges) {
    spread_sizes(samples_.points, edges, growth - 1, samples_.sizes);
  }

  [[nodiscard]] double inside(std::uint32_t t, Point p) const {
    const auto& [i, j, k] = samples_.triangles[t];
    const auto [of_b, of_c] =
        shares_in({samples_.points[i], samples_.points[j], samples_.points[k]}, p);
    const double size = samples_.sizes[i] + of_b * (samples_.sizes[j] - samples_.sizes[i]) +
                        of_c * (samples_.sizes[k] - samples_.sizes[i]);
    const auto [least, most] =
        std::minmax({samples_.sizes[i], samples_.sizes[j], samples_.sizes[k]});
    return std::clamp(size, least, most);
  }

  [[nodiscard]] double outside(Point p) const {
    const auto [a, b] = tree_.nearest_border(p);
    const double part = part_on_segment(samples_.points[a], samples_.points[b], p);
    return samples_.sizes[a] + part * (samples_.sizes[b] - samples_.sizes[a]);
  }

  SizeSamples samples_;
  TriangleTree tree_;
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
    if (!ranges::kGrowth.holds(growth))
      return wrong(ErrorCode::bad_option, fmt::format("growth is {}, but must be {}",
                                                      describe(growth), describe(ranges::kGrowth)));
    if (Status status = check(samples); !status) return std::move(status).error();
    const auto sizes = std::make_shared<const Interpolation>(samples, growth);
    return SizeFunction([sizes](Point p) { return sizes->at(p); });
  });
}

}  // namespace cover
