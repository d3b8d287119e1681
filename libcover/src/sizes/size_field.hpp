// The wished edge length at every vertex of a region that is being refined.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include <cover/options.hpp>

#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// Where both are, the smaller; an empty function wishes nothing.
SizeFunction smaller_of(SizeFunction a, SizeFunction b);

/// The background sizes that hold in a region: Options::size_field and
/// RegionBoundary::size_function.
SizeFunction background_of(const RegionBoundary& boundary, const Options& options);

/// Whether sizes are asked for in a region: its own, those of points or those of the background.
bool has_sizes(const RegionBoundary& boundary, const Options& options);

/// What was before sides were cut: neither cuts nor the lengths of pieces are wishes.
struct BeforeCuts {
  VertexId first_cut{kNone};          ///< vertices from this one on are cuts
  std::span<const double> lengths{};  ///< by side, of what it is a piece of; empty: its own
};

/// h(x): the region's own size or that of the background, the smaller, or less near vertices whose
/// size is smaller, from where it grows by (growth - 1) per unit of distance: edges that follow
/// each other then grow by that ratio.
///
/// A growth is a wish of its own, even without sizes.
/// A boundary vertex has the size given for it; else the mean length of its sides, or h(x) without
/// them where that is no more than kNear times as long. A region's size that no edge of its meshes
/// can exceed is no wish. Beside sides more than kNear times as long as h(x), sizes are no smaller
/// than the sides less 0.85 times the distance: angles come before sizes.
class SizeField {
 public:
  /// How much shorter sides may be than the region's size without a graded zone along them.
  static constexpr double kNear = 1.5;

  /// A field without a wish: is_active() is false.
  SizeField() = default;
  /// Where `background` is not finite or not above zero, there is no wish.
  ///
  /// REQUIRES: `cdt` has the points of `boundary`, maybe in another frame, in which `background`
  ///           then is too
  /// Cost:     O(n log n)
  SizeField(const RegionBoundary& boundary, const Triangulation& cdt, std::optional<double> growth,
            SizeFunction background = {}, const BeforeCuts& before = {});

  /// The same, and no wish either where one size is asked for that no edge of the triangulation
  /// exceeds: what is made of that without sizes has shorter edges still, and better angles.
  static SizeField where_it_counts(const RegionBoundary& boundary, const Triangulation& cdt,
                                   std::optional<double> growth, SizeFunction background);

  /// Whether the region has any wish.
  [[nodiscard]] bool is_active() const { return !at_.empty(); }
  /// The size at a vertex.
  [[nodiscard]] double at(std::uint32_t v) const { return at_[v]; }
  /// The size at a distance from a vertex, as far as that vertex has a say.
  [[nodiscard]] double near(std::uint32_t v, double distance) const;
  /// What the size is at least at a distance from a vertex, as far as that vertex has a say: where
  /// sides are long, small triangles beside them would have large angles.
  [[nodiscard]] double least_near(std::uint32_t v, double distance) const;
  /// Gives vertex `v`, a new one, its size, and the least there.
  void set(std::uint32_t v, double size, double least);
  /// The same wishes, for a part of the mesh with these vertices.
  [[nodiscard]] SizeField part(std::span<const std::uint32_t> vertices) const;
  /// Gives vertex `v` what vertex `of` has in `other`.
  void take(std::uint32_t v, const SizeField& other, std::uint32_t of) {
    set(v, other.at_[of], other.least_[of]);
  }
  /// The region's own size or that of the background, the smaller; infinite if there is neither.
  [[nodiscard]] double largest_at(Point p) const;

 private:
  std::vector<double> at_;
  std::vector<double> least_;
  double slope_ = 0;
  double largest_ = 0;
  SizeFunction background_;
};

}  // namespace cover
