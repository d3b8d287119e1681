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
///
/// Of coupled meshes the zones of free sides are their half discs, those of 90 degrees.
class ClearZones {
 public:
  /// REQUIRES: no vertex sees a side under more than `most`; `view` outlives this
  ClearZones(const RegionView& view, double most, Meshes meshes);

  struct State {
    bool known = false;
    bool clear = false;
    bool cut_at_start = false;  ///< by the side that ends at its start
    bool cut_at_end = false;    ///< by the side that begins at its end
    double cot = 0;             ///< of the angle from which a point is in the zone for sure
  };

  /// Cost: O(triangles that the zone touches) at the first call for a side
  const State& of(std::uint32_t side);

  /// How far around the vertex of a corner no other vertex of a coupled mesh lies, and none of the
  /// region beyond the corner either; 0: not known.
  ///
  /// Cost: O(sides of small regions) at the first call for a corner
  double around(std::uint32_t corner);

  /// The angle from which a point is in a zone that is no half disc for sure.
  [[nodiscard]] double angle() const { return angle_; }
  [[nodiscard]] Meshes meshes() const { return meshes_; }

 private:
  [[nodiscard]] State find_out(const RegionSide& side);
  [[nodiscard]] State walk(const RegionSide& side, double angle);
  [[nodiscard]] double find_around(const RegionCorner& corner, const RegionSide& after) const;

  const RegionView& view_;
  Meshes meshes_;
  double slack_of_bend_;
  double angle_;                ///< of zones that are no half discs
  std::vector<State> state_;    ///< by side
  std::vector<double> around_;  ///< by corner; below 0: not known yet
  std::vector<std::uint64_t> stack_;
};

}  // namespace cover
