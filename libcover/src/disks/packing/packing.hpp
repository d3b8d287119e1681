// The state of a packing: disks, the cycles of sides that bound what is not yet filled, and the
// triangles made so far.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "disks/packing/disk.hpp"
#include "disks/packing/search/disk_tree.hpp"
#include "disks/packing/search/line_tree.hpp"

namespace cover::disks {

/// Vertices and triangles in the making. A vertex has identity: gaps that meet in a tangency point
/// or a centre share its index, so nothing is ever welded by coordinates.
struct TriangleDraft {
  /// A vertex put on a chord.
  struct OnChord {
    Index chord = 0;
    Index vertex = 0;
  };
  std::vector<Point> points;                    ///< in the packing's own coordinates
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise
  std::vector<OnChord> on_chord;

  Index add(Point p);
  /// Adds a vertex on the rim of `e`; where that is a line, it splits the chord.
  Index add_on(const Element& e, Point p);
  void triangle(Index a, Index b, Index c) { triangles.push_back({a, b, c}); }
};

/// A piece of the rim of an element on the boundary of an unfilled part, which is on its left.
/// Disks lie outside, so their sides run clockwise. Consecutive sides touch in the vertex they
/// share. A lone full circle has no ends; after one contact it runs once around from that vertex.
struct Side {
  Index element = kNone;
  Index start = kNone;  ///< vertex
  Index end = kNone;    ///< vertex
  Index prev = kNone;   ///< side
  Index next = kNone;   ///< side
  Index cycle = kNone;

  [[nodiscard]] bool is_full_circle() const { return start == kNone; }
};

/// A cycle of sides.
struct Cycle {
  Index side = kNone;  ///< one of them
  Index size = 0;      ///< how many
};

/// Where a new disk touches a side.
struct Contact {
  Index side = kNone;
  Point at;
};

/// Sides whose elements come near a point: found by search or, in short cycles, by scan.
class Packing {
 public:
  TriangleDraft draft;
  std::vector<Element> elements;
  std::vector<Side> sides;
  std::vector<Cycle> cycles;

  [[nodiscard]] const Element& element_of(Index side) const {
    return elements[sides[side].element];
  }
  [[nodiscard]] Point point(Index vertex) const { return draft.points[vertex]; }

  Index add_element(const Element& e);
  Index add_side(Index element, Index start, Index end);
  void link(Index side, Index next);
  /// Makes the sides reachable from `side` a cycle.
  Index add_cycle(Index side);
  /// Makes every ring of sides a cycle, in the order of sides.
  void find_cycles();
  /// To be called once, when all lines and corner disks are there.
  void build_index();

  /// The angle of a disk's side, the length of a line's.
  [[nodiscard]] double extent(Index side) const;
  /// Whether the point `x` of the element's rim lies on the side; its ends count, up to rounding.
  [[nodiscard]] bool is_on(Index side, Point x) const;
  /// The side of `element` that `x` lies on; in `cycle` only, unless that is kNone.
  [[nodiscard]] std::optional<Index> side_at(Index element, Point x, Index cycle) const;

  /// The obstacle nearest to `x` and nearer than `bound`, among the sides of a cycle or, where that
  /// is long or kNone, among all.
  [[nodiscard]] Index nearest_obstacle(Point x, double bound, Index cycle, Index skip1,
                                       Index skip2) const;
  /// All elements nearer to `x` than `bound`, in increasing order.
  [[nodiscard]] std::vector<Index> elements_within(Point x, double bound, Index cycle) const;

  /// Adds a disk that touches sides, and splits these. Cycles that it touches in several places
  /// fall apart, cycles that it touches together are joined. Returns the sides of the disk, or
  /// nothing (and no change) where two contacts coincide.
  ///
  /// Does not touch `cycles`.
  std::vector<Index> insert_disk(Circle disk, std::vector<Contact> contacts);
  /// Replaces a cycle by those that the new sides lie on.
  /// Cost: O(size of all new cycles but the largest).
  std::vector<Index> split_cycle(Index cycle, std::span<const Index> new_sides);

 private:
  /// Where on the rim: distance along a line, a clockwise pseudo-angle in [0, 4) on a disk.
  [[nodiscard]] double place(const Element& e, Point x) const;
  void split_side(const Contact& contact, Index vertex, Index* before, Index* after);

  std::vector<std::map<double, Index>> sides_by_place_;  ///< per element, by start; unless full
  std::vector<Index> full_circle_;                       ///< per element
  LineTree lines_;
  DiskTree disks_;
};

}  // namespace cover::disks
