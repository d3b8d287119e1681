// Who wins where polygons overlap.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <cover/attribute.hpp>
#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/result.hpp>

#include "base/none.hpp"
#include "clean/network.hpp"
#include "clean/node_edges.hpp"

namespace cover {

/// The place of every polygon in the order of painting; the highest wins: by priority, among equals
/// the last, or with Overlap::first the first.
std::vector<std::uint32_t> ranks_of(const std::vector<InputPolygon>& polygons, Overlap overlap);

/// What a file keeps of a feature (its number plus one; 0: none): the same number for the same
/// value, and for none.
std::uint64_t comparable_value(const Attribute& attribute, std::uint32_t feature);

/// What lies beside an edge, seen from its smaller to its larger index: a polygon, or kNone for
/// the void.
using EdgeOwners = std::array<std::uint32_t, 2>;

/// Who owns what, by edge.
struct Painting {
  std::vector<EdgeOwners> owners;
  /// The first of the polygons that make one region where they touch. Regions end at segments and
  /// lines.
  std::vector<EdgeOwners> regions;
  /// By polygon, of regions whose first it is: the smallest size that their polygons wish.
  std::vector<std::optional<double>> sizes;
};

/// Decides for each edge which polygon owns the face on either side. A face is covered by the
/// polygons whose rings go round it an odd number of times; of these the one of the highest
/// priority wins, among equals the last or the first. Faces that touch are one region with `merge`
/// where they are of equal material, else where their polygons have equal given names, sizes and
/// attributes too.
///
/// Errors: overlapping_polygons with Overlap::error where the winner is not told by priority.
/// EXACT:  on the edges given: parities are counted, nothing is measured
/// Cost:   O(n log n).
Result<Painting> paint(const Input& input, Overlap overlap, bool merge, const Network& network,
                       const EdgeGraph& graph);

}  // namespace cover
