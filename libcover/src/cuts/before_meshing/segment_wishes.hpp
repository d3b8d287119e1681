// What the regions on both sides of a segment want of it before they are meshed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>

#include "cdt/region_cdt.hpp"
#include "cuts/before_meshing/narrow_strips.hpp"
#include "cuts/whole_segments.hpp"
#include "region/region_boundary.hpp"
#include "sizes/segment_sizes.hpp"

namespace cover {

/// The sides of a segment from which its regions see it: left, right, left | right.
enum class SeenFrom : std::uint8_t { none = 0, left = 1, right = 2 };

constexpr SeenFrom operator|(SeenFrom a, SeenFrom b) {
  return static_cast<SeenFrom>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr SeenFrom without(SeenFrom all, SeenFrom some) {
  return static_cast<SeenFrom>(static_cast<unsigned>(all) & ~static_cast<unsigned>(some));
}

/// From which side of `segment` the region of `boundary` sees its side `s`.
SeenFrom seen_from(const RegionBoundary& boundary, std::size_t s, const Segment& segment);

/// What the regions beside a segment want of it.
struct SegmentWish {
  SeenFrom forced_from = SeenFrom::none;  ///< an angle that is too large is forced on it
  double nu = std::numbers::pi;           ///< of the worst one
  Point apex;                             ///< sees it at that angle
  std::vector<Point> apexes;              ///< of the triangles on both sides
  std::optional<SegmentSizes> sizes;
};

/// The wishes for all segments.
class SegmentWishes {
 public:
  /// Vertices from `first_cut` on are cuts, whose distances are no wish; lengths of pieces are one
  /// with Options::growth alone.
  ///
  /// REQUIRES: Options::split_interfaces; all arguments outlive this
  SegmentWishes(const Pslg& pslg, const Options& options, VertexId first_cut);

  /// Adds the wishes of a region; sizes as its mesh will have them, graded from all of its
  /// boundary, so that no long side is left beside short edges (written to `boundary`).
  ///
  /// REQUIRES: `boundary` outlives this
  /// Returns:  why it bounds nothing, if so
  std::optional<Flaw> add(RegionBoundary& boundary);

  [[nodiscard]] const SegmentWish& of(std::size_t segment) const { return wishes_[segment]; }

  /// Where to cut a segment that is too long at feet of what faces it across a narrow strip; empty
  /// where nothing does.
  [[nodiscard]] std::vector<Point> feet_on(std::size_t segment) const;

  /// Segments across narrow strips from this one that are to have shorter edges and are still too
  /// long for them.
  [[nodiscard]] std::vector<SegmentId> finer_across(std::size_t segment) const;

 private:
  [[nodiscard]] Point at(VertexId v) const { return pslg_->points[v.index()]; }
  /// By side, the length of the segment that it is a piece of.
  [[nodiscard]] std::vector<double> whole_lengths(const RegionBoundary& boundary) const;
  /// Writes the graded sizes to `boundary`. False if it has no wish.
  bool grade(RegionBoundary& boundary, const Triangulation& cdt) const;
  /// Adds that a side is seen from `apex` at pi - nu, if that is too much.
  void add_angle(SegmentWish& wish, const Segment& segment, SeenFrom from, Point apex,
                 double nu) const;

  const Pslg* pslg_;
  const Options* options_;
  VertexId first_cut_;
  WholeSegments whole_;  ///< before these cuts
  double least_nu_;
  bool is_right_;  ///< right angles are asked for
  std::vector<SegmentWish> wishes_;
  std::vector<Facing> facing_;
};

}  // namespace cover
