// Layers of thin triangles, laid row by row on the boundary of a region; the front is what bounds
// the rest of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <cover/layers.hpp>
#include <cover/options.hpp>
#include <cover/point.hpp>

#include "geom/topology/half_edges.hpp"
#include "layers/front/guards.hpp"
#include "layers/front/offsets.hpp"
#include "layers/front/thickness.hpp"
#include "region/region_boundary.hpp"

namespace cover::layers {

/// What became of one side of the region.
struct SideLayers {
  int rows = 0;
  LayerStop stop = LayerStop::none;
};

/// The layers of a region and the front on them.
class LayerFront {
 public:
  /// `most[s]` limits the rows over side s.
  ///
  /// REQUIRES: boundary.layers has a rule for each side, `rules` are Options::layers; all outlive
  ///           this object
  LayerFront(const RegionBoundary& boundary, std::span<const LayerRule> rules,
             std::span<const int> most);

  /// Lays all rows.
  ///
  /// ENSURES: triangles are counter-clockwise, exactly; whether the front is still simple is for
  ///          the caller to check
  /// Cost:    O((n + triangles) log n) per row, n the sides of the region
  void lay();

  /// Vertices that were added; their indices follow those of the boundary.
  [[nodiscard]] const std::vector<Point>& added() const { return added_; }
  /// By added vertex: the side over which it lies.
  [[nodiscard]] const std::vector<std::uint32_t>& side_below() const { return below_; }
  /// What is left of the rows over each side in a mesh with these edges, by their ends, the smaller
  /// first, in order: all below the first row whose top is none of them.
  [[nodiscard]] std::vector<SideLayers> sides_in(
      std::span<const std::pair<Point, Point>> edges) const;
  [[nodiscard]] const std::vector<IndexTriple>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<SideLayers>& sides() const { return sides_; }
  /// How thick that many layers over a side are.
  [[nodiscard]] double thickness(std::uint32_t side, int rows) const;

  /// An edge of the front, the rest of the region on its left.
  struct Edge {
    std::uint32_t a = 0, b = 0;
    std::uint32_t side = 0;  ///< of the boundary; kNone: an edge of layers
  };
  [[nodiscard]] std::vector<Edge> front() const;

  /// An edge on a row, between vertices, the row on its right.
  struct Top {
    std::uint32_t a = 0, b = 0;
    std::uint32_t side = 0;
    int row = 0;  ///< from 1 on
  };
  /// All of them, also where another row lies on top.
  [[nodiscard]] const std::vector<Top>& tops() const { return tops_; }

 private:
  /// A vertex of the front, and the edge from it to the next.
  struct Node {
    std::uint32_t vertex = 0, prev = 0, next = 0;
    bool alive = true;
    std::uint32_t side = 0;    ///< of the boundary; kNone: an edge of layers
    std::uint32_t origin = 0;  ///< the side over which the edge lies; kNone: it has no layers
    std::uint32_t rule = 0;    ///< of the next row: index + 1; 0: there is none
    int rows = 0;              ///< below the edge
    bool taken = false;   ///< a row of another chain will run up it; what is beyond may meet that
    bool slope = false;   ///< a row tapered off here
    bool beside = false;  ///< over a corner of the line, beside `origin`
    Vector normal;        ///< of the edge, unit length, into the region
    double reach = 0;     ///< length that counts as the edge's if it is longer
    Offset offset;        ///< of the vertex, where rows lie on both of its edges
  };

  /// A run of edges that get a row together.
  struct Chain {
    std::vector<std::uint32_t> nodes;
    bool closed = false;
    bool first_met = false, last_met = false;    ///< the row ends in a vertex of the wall there
    bool first_fans = false, last_fans = false;  ///< further cells start where the row below ended
  };

  /// A cell of a row, on an edge or a vertex of the front.
  struct Cell {
    Guard guard;
    std::array<std::uint32_t, 2> nodes{};  ///< whose edges get no row if there is no room
  };

  class RowMaker;
  /// A row on a chain before it becomes part of the front.
  struct Row {
    std::vector<Offset> tops;
    std::vector<std::uint32_t> vertices;  ///< by top
    std::vector<Node> edges;              ///< by top: the edge from it to the next
    std::vector<IndexTriple> triangles;
  };

  void link_sides();
  void reach_out_of_corners();
  [[nodiscard]] Offset offset_at(std::uint32_t n) const;

  [[nodiscard]] bool is_joined(std::uint32_t n) const;
  [[nodiscard]] std::vector<Chain> chains() const;
  [[nodiscard]] bool meets(Vector chain, std::uint32_t wall, Point corner, Point top,
                           const Node& node) const;
  [[nodiscard]] bool meets_before(std::uint32_t n) const;
  [[nodiscard]] bool meets_after(std::uint32_t n) const;
  [[nodiscard]] bool fans(std::uint32_t slope, std::uint32_t at, Point end) const;
  void find_meetings(std::vector<Chain>& chains);
  void stop(std::uint32_t n, LayerStop why);

  [[nodiscard]] std::vector<bool> closing(const Chain& chain) const;
  [[nodiscard]] Offset offset_in(const Chain& chain, const std::vector<bool>& closing,
                                 std::size_t i) const;
  [[nodiscard]] std::vector<Cell> cells_of(const Chain& chain);
  bool make_room(const std::vector<Chain>& chains);
  /// Lays the next row on a chain.
  void lay_chain(Chain chain);
  std::uint32_t add_vertex(Point p, std::uint32_t side_below);
  /// Puts a row in the place of its chain.
  void link_row(const Chain& chain, const Row& row);
  void set_next(Node& edge, double length);

  [[nodiscard]] Point at(std::uint32_t v) const {
    return v < boundary_.points.size() ? boundary_.points[v] : added_[v - boundary_.points.size()];
  }
  [[nodiscard]] Point start_of(std::uint32_t n) const { return at(nodes_[n].vertex); }
  [[nodiscard]] Point end_of(std::uint32_t n) const { return start_of(nodes_[n].next); }
  [[nodiscard]] const Thickness& thickness_of(const Node& node) const {
    return thickness_[node.rule - 1];
  }

  const RegionBoundary& boundary_;
  std::span<const LayerRule> rules_;
  std::span<const int> most_;
  std::vector<Thickness> thickness_;      ///< by rule
  std::vector<std::uint32_t> same_rule_;  ///< by rule: the first with the same numbers
  int row_ = 0;                           ///< rows laid so far
  std::vector<Node> nodes_;
  std::vector<Point> added_;
  std::vector<std::uint32_t> below_;
  std::vector<Top> tops_;
  std::vector<IndexTriple> triangles_;
  std::vector<SideLayers> sides_;
};

}  // namespace cover::layers
