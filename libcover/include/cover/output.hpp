// What the calls of the library hand out.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <cover/ids.hpp>
#include <cover/mesh_class.hpp>
#include <cover/periodic.hpp>
#include <cover/plane_field.hpp>
#include <cover/point.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>

namespace cover {

/// Input made clean: what is meshed, and what it took.
struct Prepared {
  Pslg pslg;
  RegionTable table;
  Report report;  ///< gamma_opt and bound per region, changes and warnings; no mesh figures
};

/// An edge whose node of second order is not the double next to its middle.
struct MovedNode {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  Point middle;
};

/// The value of a field at a vertex as one of the regions has it that meet there.
struct RegionValue {
  std::uint32_t vertex = 0;
  RegionId region;
  double value = 0;

  [[nodiscard]] std::pair<std::uint32_t, RegionId> place() const { return {vertex, region}; }
};

/// By field: where a region has another value than the field, by vertex, then by region. Empty
/// where no region has.
using RegionValues = std::vector<std::vector<RegionValue>>;

/// The value of the `k`-th of `fields` at a vertex as a region has it.
inline double value_in(std::span<const PlaneField::Array> fields, const RegionValues& others,
                       std::size_t k, std::uint32_t vertex, RegionId region) {
  if (k >= others.size()) return fields[k].values[vertex];
  const std::pair place(vertex, region);
  const auto found = std::lower_bound(
      others[k].begin(), others[k].end(), place,
      [](const RegionValue& one, const auto& other) { return one.place() < other; });
  return found != others[k].end() && found->place() == place ? found->value
                                                             : fields[k].values[vertex];
}

/// Of two values, NaN being none, the one of the larger magnitude; of 1 and -1, 1.
inline double larger_value(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) ? b : a;
  if (std::abs(a) == std::abs(b)) return std::max(a, b);
  return std::abs(a) > std::abs(b) ? a : b;
}

/// What `cover_mesh` returns.
struct Output {
  Mesh mesh;
  Pslg pslg;
  RegionTable table;
  Report report;
  std::vector<PeriodicNodes> periodic{};  ///< by rule: Options::periodic, then Input::periodic
  /// Values of Input::field at the vertices of the mesh, linear in its triangles; of several in one
  /// place, where a value jumps, the one of the largest magnitude. Outside the field, that of the
  /// nearest place on its border. NaN: none.
  std::vector<PlaneField::Array> fields{};
  /// Of a mesh that was read from triangles of six nodes: those off the middles of their edges,
  /// where no manifest tells the arcs that they lie on. Nothing: triangles had three nodes.
  std::optional<std::vector<MovedNode>> nodes{};
  /// Of `fields`: those of regions where they meet, and one has another value than counts for all.
  RegionValues region_values{};
};

}  // namespace cover
