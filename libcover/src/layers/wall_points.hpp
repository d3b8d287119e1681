// Where walls at the ends of layered lines would have to be cut for layers to run up to them, and
// lines at their inner corners.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>

#include "region/region_boundary.hpp"

namespace cover::layers {

/// A point that a side should have.
struct WallPoint {
  std::uint32_t side = 0;
  Point at;  ///< on the side; where this is a chord, at the same share as the point of the arc
  double height = 0;  ///< along the side, from the line's end
  double layer = 0;   ///< thickness of the layer below; at a foot, the way from the one before
  std::size_t rule = 0;
};

/// The vertices next to the ends of a segment, towards its other end.
struct NextToEnds {
  Point after_a, before_b;
};

/// Line by line, upwards: the heights of rows over lines that end at about a right angle with the
/// side, as far as the side reaches. Of a side that is a chord of an arc, the points of the arc
/// have these heights. Lines are no walls of their own. Where straight sides of lines with the same
/// counted layers turn inwards by more than kMitre and less than kInnerMitre: the feet of the rows'
/// vertices in that mitre, on both.
///
/// `pieces`, by segment, tells what segments are going to be cut to: heights are those over the
/// piece at the end of a line. None: they stay as they are.
/// REQUIRES: boundary.layers has a rule for each side, `rules` are Options::layers; `boundary` is
///           one of `pslg`
std::vector<WallPoint> wall_points(const Pslg& pslg, const RegionBoundary& boundary,
                                   std::span<const LayerRule> rules,
                                   std::span<const NextToEnds> pieces = {});

}  // namespace cover::layers
