// Where no vertex may be: too near to a side.
#pragma once

#include <cstdint>
#include <vector>

#include "limits/angles/angle_range.hpp"
#include "limits/angles/region_view.hpp"

namespace cover {

/// The zone of a side are the points on its left that see it under more than `most`, regardless of
/// what is in between; where the next side cuts it off, those on the left of that as well, and the
/// same with the one before. It is clear if no other side comes into it: then all of it is seen,
/// and no vertex of a mesh with angles up to `most` lies in it (Lemma 1). In a region that is
/// convex, or almost, all zones are clear whatever comes into them. It is convex if `most` is at
/// least 90 degrees, and a part of a disk otherwise, which is convex, too.
class ClearZones {
 public:
  /// REQUIRES: no vertex sees a side under more than `most`; `view` outlives this
  ClearZones(const RegionView& view, double most);

  struct State {
    bool known = false;
    bool clear = false;
    bool cut_at_start = false;  ///< by the side that ends at its start
    bool cut_at_end = false;    ///< by the side that begins at its end
  };

  /// Cost: O(triangles that the zone touches) at the first call for a side
  const State& of(std::uint32_t side);

  /// The angle from which a point is in the zone for sure.
  [[nodiscard]] double angle() const { return angle_; }

 private:
  [[nodiscard]] State find_out(const RegionSide& side);

  const RegionView& view_;
  double slack_of_bend_;
  double angle_;
  double cot_;
  double sin_;
  std::vector<State> state_;  ///< by side
  std::vector<std::uint64_t> stack_;
};

}  // namespace cover
