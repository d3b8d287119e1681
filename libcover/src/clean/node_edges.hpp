// Cutting lines where they meet, until they meet at points only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include <cover/point.hpp>

#include "base/team.hpp"
#include "cdt/cdt.hpp"
#include "clean/network.hpp"

namespace cover {

/// The edges of a network: no two of them on the same pair of points.
struct EdgeGraph {
  std::vector<IndexPair> edges;    ///< smaller index first, ascending
  std::vector<std::size_t> first;  ///< of edge k: network.strands[first[k], first[k + 1])
  Triangulation triangulation;     ///< of the hull, with the edges as locked edges, if it was made
  int passes = 0;                  ///< that cut anything

  /// The strands on edge `k` of the network that the graph was made of.
  [[nodiscard]] std::span<const Strand> strands(const Network& network, std::size_t k) const {
    return {network.strands.data() + first[k], first[k + 1] - first[k]};
  }
};

/// Calls visit(polygon, times) for each polygon whose ring has edge `k`, by number, with how often
/// it has it: a polygon that has it an odd number of times has an inside on one side of it.
/// `buffer` is used again and again.
template <class Visit>
void each_polygon_on(const EdgeGraph& graph, const Network& network, std::size_t k,
                     std::vector<std::uint32_t>& buffer, Visit visit) {
  buffer.clear();
  for (const Strand& s : graph.strands(network, k)) {
    const Origin origin = network.raws[s.raw].origin;
    if (origin.kind == Origin::Kind::ring) buffer.push_back(origin.index);
  }
  std::sort(buffer.begin(), buffer.end());
  for (auto first = buffer.begin(), last = first; first != buffer.end(); first = last) {
    last = std::upper_bound(first, buffer.end(), *first);
    visit(*first, last - first);
  }
}

/// Thrown where rounded crossings make further ones, far more than the lines had: beside 0, where
/// doubles are as fine as nowhere else, that goes on for as long as doubles get finer; or where a
/// `crowd` of lines lies within rounding of each other. Becomes the error coordinate_out_of_range
/// (make_pslg).
class RoundingCascade : public std::runtime_error {
 public:
  explicit RoundingCascade(Point where, bool is_crowd = false)
      : std::runtime_error("rounded crossings make further ones"),
        where_(where),
        is_crowd_(is_crowd) {}
  [[nodiscard]] Point where() const { return where_; }
  [[nodiscard]] bool is_crowd() const { return is_crowd_; }

 private:
  Point where_;
  bool is_crowd_;
};

/// Thrown where lines cross so often that the pieces cannot fit into memory. Becomes the error
/// out_of_memory (make_pslg).
class TooManyCrossings : public std::runtime_error {
 public:
  explicit TooManyCrossings(double at_least)
      : std::runtime_error("lines cross too often"), at_least_(at_least) {}
  [[nodiscard]] double at_least() const { return at_least_; }

 private:
  double at_least_;
};

/// About as many bytes as each crossing of lines takes until regions are known.
inline constexpr double kBytesPerCrossing = 1000;

/// Sorts the strands of `network` by edge; makes no triangulation.
///
/// Cost: O(n log n).
EdgeGraph index_edges(Network& network);

/// Cuts the strands of `network` at all their common points, and at lone points on them, and sorts
/// them by edge.
///
/// Intersections are computed exactly and rounded to the nearest doubles, or to the end of one of
/// the lines if that is next to it. Rounding moves pieces by a few units in the last place, which
/// may make new crossings; so the pieces are cut again until a pass finds them clean by exact
/// predicates (iterated snap rounding). Ends of lines and lone points never move.
/// ENSURES: points and edges are a PSLG; it always comes to that (node_edges.cpp)
/// Throws:  RoundingCascade, long before memory is full; TooManyCrossings
/// Cost:    O((n + k) log n) a pass for k crossings; one pass per generation of new crossings.
/// Ref:     D. Halperin, E. Packer, Iterated snap rounding, CGTA 23 (2002)
///
/// Where it is known that strands meet inside, `may_be_clean` saves the test.
EdgeGraph node_edges(Network& network, bool may_be_clean = true, const Team& team = {});

/// Leaves out the points that no strand ends at and that are neither lone nor named.
void compact(Network& network);

}  // namespace cover
