// How two lines are images of each other, and what keeps them from being so.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>

namespace cover {

/// How two lines are images of each other.
struct SidesMatch {
  Isometry map;                    ///< from the line PeriodicRule::from to PeriodicRule::to
  double tolerance = 0;            ///< how far off an image may be
  std::vector<SegmentPair> pairs;  ///< in the order of the segments of `from`; their rule is 0
  std::vector<std::array<VertexId, 2>> vertices;  ///< points and their images, by point
  std::vector<VertexId> from_alone;               ///< points of `from` without an image, in order
  std::vector<VertexId> to_alone;                 ///< points of `to` that are no image
  std::vector<SegmentId> segments_alone;  ///< of both lines, between points that have images
};

/// Finds the lines that `rule` names, among interfaces, contacts, outlines and boundary markers,
/// and the map that takes the one to the other, and compares their points and segments. Points
/// match within `tolerance` times the size of both lines.
///
/// A translation is found from the lines' extents, the axis of a mirror from their centroids; among
/// maps that differ by rounding, the one with most images exact is taken.
/// Errors: bad_option: unknown names; lines that share segments (as where a rotation takes a line
///         to itself); lines for which there is no such map
/// Cost:   O(n log n)
Result<SidesMatch> match_sides(const Pslg& pslg, const RegionTable& table, const PeriodicRule& rule,
                               double tolerance);

/// What `match` lacks, as a sentence with places; nothing if all points and segments of both lines
/// have partners.
std::optional<Error> unmatched(const Pslg& pslg, const PeriodicRule& rule, const SidesMatch& match);

}  // namespace cover
