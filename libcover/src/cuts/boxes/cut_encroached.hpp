// Cutting the segments on which the input forces a negative coupling of the box method.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <cover/output.hpp>
#include <cover/pslg.hpp>
#include <cover/report.hpp>

namespace cover {

/// Cuts segments until no side has a visible vertex in its open diametral disk. Only segments that
/// are encroached are cut, by the input or by cuts of others, and each as often as it must be for
/// the vertices there are; where there is a choice, so that the cut encroaches no other side. Both
/// sides of a segment get the same points. Hull sides are passed over.
///
/// Report::box_cuts gets what was cut, with the reasons: vertices from `first_cut` on count as cuts
/// there, not as points of the input.
///
/// REQUIRES: points from Report::input_points on are cuts
/// ENSURES:  points and regions fit each other
/// Returns:  the middles of pieces that doubles leave no room to cut, or in which cuts go on for
///           ever because feet are rounded (more than 16 passes, and most_points_for_boxes()
///           exceeded)
/// Cost:     O(n log n) per pass
/// Ref:      docs/box_method.md
std::vector<Point> cut_encroached(Prepared& prepared, VertexId first_cut);

/// What cut_encroached() would do.
struct CountedBoxCuts {
  std::size_t cuts = 0;
  std::size_t uncut = 0;  ///< pieces without room
};
/// Nothing where its passes would look at more than `most_looks` points for that: in each pass at
/// all, and at those of regions that changed.
std::optional<CountedBoxCuts> count_box_cuts(Prepared prepared, std::size_t most_looks);

/// With more points than this, of which `cuts` were added, cutting for the box method is a cascade
/// in a layer too thin for doubles.
/// Cost: O(1)
std::size_t most_points_for_boxes(const Pslg& pslg, std::span<const BoxCut> cuts);

}  // namespace cover
