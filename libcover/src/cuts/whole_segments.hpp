// The segments that pieces are of, so that cuts of cuts stay on them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cover/pslg.hpp>

namespace cover {

/// The ends that every segment had before it was cut.
class WholeSegments {
 public:
  /// REQUIRES: points from `uncut_points` on came from cut_segments()
  /// Cost:     O(n)
  WholeSegments(const Pslg& pslg, std::size_t uncut_points);

  /// The ends of the segment of which `s` is a piece, in its direction.
  [[nodiscard]] std::array<Point, 2> ends(SegmentId s) const { return ends_[s.index()]; }

  /// A cut of the piece `s`, on the line of the segment that was cut first if rounding left it
  /// beside that: by more than 2 units in the last place and no more than 16. Feet from wall to
  /// wall come one by one, each on the piece that the last one left: rounded every time, they would
  /// leave the line by half a unit in the last place each. Chords of arcs are left alone.
  /// Cost: O(1)
  [[nodiscard]] Point on_whole(SegmentId s, Point p) const;

 private:
  std::vector<std::array<Point, 2>> ends_;  ///< by segment
  std::vector<std::uint8_t> is_chord_;      ///< by segment
};

}  // namespace cover
