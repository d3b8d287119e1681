// Whether the triangle on a side can have any apex at all.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/containers/stamped_set.hpp"
#include "geom/vector.hpp"
#include "limits/angles/angle_range.hpp"
#include "limits/angles/clear_zones.hpp"
#include "limits/angles/fan_growth.hpp"
#include "limits/angles/region_view.hpp"

namespace cover {

/// Searches the plane for apices of the triangle on a side, for a mesh all of whose angles are in a
/// range, by branch and bound over boxes of its angles at the ends of the side.
class ApexSearch {
 public:
  /// REQUIRES: no vertex sees a side under more than range.most; `zones` are for range.most; all
  ///           outlive this. Boxes below `smallest_box`, in radians, are not cut any more
  ApexSearch(const RegionView& view, ClearZones& zones, const FanGrowth& growth,
             double smallest_box);

  /// True: no covering mesh has a triangle on this side, with all angles in the range. False: it
  /// may have one.
  ///
  /// `budget` is the number of boxes that may be looked at; what was used is taken off it.
  /// EXACT: a proof, up to kAngleSlack in favour of a mesh
  /// Ref:   docs/limits.md
  bool has_none(std::uint32_t side, std::uint64_t& budget);

 private:
  /// An angle with its sine and cosine.
  struct Direction {
    double angle, sine, cosine;
  };
  static Direction direction_of(double angle);
  /// Apices whose angles at the ends of the side lie between two each.
  struct Box {
    Direction a[2], b[2];
  };
  /// A place in the frame of the side, which leads from (0, 0) to (1, 0), and how far rounding may
  /// have moved it.
  struct Place {
    double x, y, fuzz;
  };
  /// A side that an apex must keep clear of.
  struct Obstacle {
    Place c, d;
    Place before, after;  ///< known where the zone is cut there
    double cot;           ///< of the angle of its zone
    bool has_zone, cut_at_start, cut_at_end;
    bool faces_a, faces_b;  ///< the ends of the side lie strictly on its left
  };
  /// An end of the side.
  struct End {
    double corner = 0;        ///< angle of the region there
    std::vector<Place> seen;  ///< joined to it, in the order in which they are met from the side
    std::vector<double> direction;
    std::vector<double> distance;
    mutable FanGrowth::Ending next_side;  ///< of coupled meshes; it remembers what is asked
  };
  /// A vertex that no other one is near, in coupled meshes.
  struct Lonely {
    Place place;
    double reach;
  };
  /// A corner of the triangles around the side.
  struct Vertex {
    Place place;
    std::uint32_t number;
  };
  /// What an obstacle, or a vertex seen from an end, forbids: a convex set each.
  enum class Ban : std::uint8_t { zone, around, shadow_of_a, shadow_of_b, wedge_at_a, wedge_at_b };

  void enter(std::uint32_t side);
  void enter_end(End& end, const RegionCorner& corner, bool reversed);
  void collect_obstacles(const RegionSide& side);
  [[nodiscard]] Place local(std::uint32_t v) const;
  void collect_lonely();
  [[nodiscard]] bool ear_is_possible(bool at_a) const;
  [[nodiscard]] bool some_vertex_is_possible(const RegionSide& side) const;
  [[nodiscard]] bool vertex_is_possible(const Place& p) const;
  [[nodiscard]] bool apex_is_allowed(double low, double high) const;
  [[nodiscard]] bool angles_are_in_range(double x, double y, double z) const;
  [[nodiscard]] bool reaches_next(const End& end, double low, double high, double near,
                                  double far) const;
  template <Ban ban>
  [[nodiscard]] bool is_in(std::size_t which, const Place& p) const;
  [[nodiscard]] bool is_in_wedge(const Place& at, double turn, const Place& w,
                                 const Place& p) const;
  [[nodiscard]] bool is_tip_of_zone(std::size_t which, const Place& p) const;
  template <Ban ban>
  [[nodiscard]] bool are_in(std::size_t which, std::span<const Place> corners);
  [[nodiscard]] bool are_in_last(std::span<const Place> corners);
  [[nodiscard]] bool is_banned(std::span<const Place> corners);
  [[nodiscard]] static Place place_of(const Direction& a, const Direction& b, double& to_a,
                                      double& to_b);
  /// The corners of a convex set that has all apices of a box in it, and the extremes of their
  /// distances from the ends of the side.
  struct Shape {
    std::array<Place, 7> corners;
    std::size_t count = 0;
    double near_a = 1e300, far_a = 0, near_b = 1e300, far_b = 0;
    [[nodiscard]] std::span<const Place> all() const { return {corners.data(), count}; }
  };
  static void add_corner(Shape& shape, const Direction& a, const Direction& b);
  [[nodiscard]] static Shape shape_of(const Box& box);
  [[nodiscard]] bool add_corners_within_reach(const Box& box, Shape& shape) const;
  [[nodiscard]] bool is_out(const Box& box);
  [[nodiscard]] bool nothing_forbids(const Direction& at_a, const Direction& at_b);
  [[nodiscard]] std::array<Direction, 2> probed_in(const Box& box) const;
  [[nodiscard]] bool contains_vertex(const Box& box) const;
  [[nodiscard]] bool end_is_out(const End& end, double low, double high, double near,
                                double far) const;

  const RegionView& view_;
  ClearZones& zones_;
  const FanGrowth& growth_;
  double smallest_box_;
  AngleRange range_;
  bool minds_ending_;
  double cot_;       ///< of the angle that an edge may be seen under
  Direction reach_;  ///< the sum of the angles at the ends of the side, at most
  AngleRange apex_;  ///< the angles that the apex may have

  std::array<std::uint32_t, 2> ends_{};
  Point origin_;
  Vector along_;  ///< unit vector
  double length_ = 1;
  End a_, b_;
  bool is_triangle_ = false;  ///< the region is one triangle
  std::vector<Vertex> vertices_;
  std::vector<Lonely> lonely_;
  std::vector<Obstacle> obstacles_;
  std::vector<std::uint32_t> visited_;
  StampedSet is_visited_;
  Ban last_ban_ = Ban::zone;
  std::size_t last_which_ = 0;
  std::vector<Box> stack_;
};

}  // namespace cover
