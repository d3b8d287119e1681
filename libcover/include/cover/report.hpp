// What was reached, region by region.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <cover/angle.hpp>
#include <cover/change.hpp>
#include <cover/error.hpp>
#include <cover/ids.hpp>
#include <cover/layers.hpp>
#include <cover/limits.hpp>
#include <cover/point.hpp>

namespace cover {

/// Anything about a region that the user should know of, with its place.
struct Note {
  enum class Kind {
    fallback,          ///< the method asked for did not hold and another one was used
    repair,            ///< rounding broke a construction; mended by rule
    below_resolution,  ///< an almond too flat for double coordinates (promise 3)
    target_missed,     ///< a target of the quality method was not reached
    bound_missed,      ///< promise 3 does not hold: the run is incomplete
    warning,           ///< near miss, tiny gap, ...
    change,            ///< the input was changed: split, welded, dropped, merged
    cut,               ///< segments were cut, as Options::split_interfaces asks; at all places
    box_cut,           ///< the same, as Options::box_method asks
  };
  Kind kind = Kind::warning;
  RegionId region;      ///< kVoid: the whole input
  std::string message;  ///< a sentence with coordinates and ids
  std::vector<Point> where;
};

/// Angle statistics of a set of triangles.
/// Largest angles are kept as nu = pi - angle, which stays accurate for flat triangles.
struct Quality {
  std::size_t triangles = 0;
  Angle largest_nu = Angle::degrees(180);  ///< pi - largest angle
  Angle smallest = Angle::degrees(180);    ///< smallest angle
  /// Triangles above 90 degrees by more than what rounding the coordinates of their own corners can
  /// make: 4 units in the last place of the largest over the shortest edge, in radians.
  std::size_t obtuse = 0;
  std::size_t obtuse_by_rounding = 0;  ///< those above 90 degrees exactly, but by no more
  std::size_t above_120 = 0;
  std::size_t above_150 = 0;
  std::array<std::size_t, 18> histogram{};  ///< all angles, bins of 10 degrees; of right
                                            ///< angles, as for `obtuse`, that of 80 to 90
  double area = 0;
};

/// What the box method (finite volumes) will meet.
struct BoxMethod {
  std::size_t obtuse_sides = 0;        ///< sides with an obtuse opposite angle, as `obtuse` is
  std::size_t non_delaunay_edges = 0;  ///< inner edges with a + b > pi, by 1e-9
  /// cot a + cot b < 0 inside, cot a < 0 at sides: the exact signs. Those at sides that a vertex
  /// of the boundary encroaches cannot be helped without cuts.
  std::size_t negative_couplings = 0;
  std::size_t negative_inside = 0;      ///< those of them on inner edges
  std::size_t negative_encroached = 0;  ///< those on sides that a vertex of the boundary encroaches
  std::size_t negative_forced = 0;      ///< those on other sides that the bound provably forces
  std::size_t negative_given_up = 0;    ///< those on any others: given up for the angle
  double box_area = 0;                  ///< sum of |e| d_e / 2 with unsigned distances

  /// Adds what another region, or another part of this one, has.
  BoxMethod& operator+=(const BoxMethod& other);
};

/// An edge with a negative coupling in one region.
struct NegativeCoupling {
  enum class Kind {
    inside,      ///< an inner edge that is not locally Delaunay
    encroached,  ///< a side with a visible vertex of the boundary or of layers in its open
                 ///< diametral disk
    given_up,    ///< any other side
    forced,      ///< another side; no mesh within the bound has fewer negative couplings there
  };
  Kind kind = Kind::inside;
  RegionId region;
  Point a, b;  ///< the edge, with the region on its left
  Point apex;  ///< the corner opposite to it; of an encroached side: the vertex that encroaches it
};

/// A cut that the box method asked for.
struct BoxCut {
  enum class Reason {
    encroached,         ///< by a vertex of the input
    encroached_by_cut,  ///< by a vertex that was put on another segment
    given_up,           ///< a mesh had a negative coupling there for the sake of its angles
  };
  Point at;
  Reason reason = Reason::encroached;
  Point by;  ///< the vertex that encroached the segment, or saw it at too large an angle
};

/// How a mesh came about, so that it can be traced.
struct Provenance {
  /// An option of the command line and its value.
  struct Setting {
    std::string name;
    std::string value;
    friend bool operator==(const Setting&, const Setting&) = default;
  };
  std::string source;             ///< the input's file as it was named; empty: unknown
  std::string version;            ///< of cover; empty: unknown
  std::vector<Setting> settings;  ///< the method, and whatever differs from its default
};

/// Seconds.
struct StageTime {
  std::string stage;
  double seconds = 0;
};

/// One region of the result.
struct RegionReport {
  RegionId id;
  std::string method;  ///< which candidate was kept: "cdt", "almond", ...
  Angle nu_opt;        ///< B = pi - gamma_opt: no covering mesh has a larger nu
  Angle nu_bound;      ///< min(B/2, 30 degrees): the promise
  Quality quality;
  BoxMethod box;
  std::vector<NegativeCoupling> couplings;  ///< the negative ones
  std::size_t input_vertices = 0;  ///< on the boundary as it was meshed, cuts too, and lone points
  std::size_t steiner_vertices = 0;
  std::size_t forced_above_120 = 0;  ///< sides whose own gamma_opt is above
  std::size_t forced_above_150 = 0;
  std::vector<LayerReport> layers;  ///< along its lines, as Options::layers ask
  RegionLimits limits;              ///< what no mesh can have better, where a target is missed
  /// Couplings leave no room for a vertex: the half discs over the sides cover the region.
  bool has_no_room = false;
  bool bound_held = false;  ///< promise 3, up to rounding of coordinates
  std::vector<Note> notes;
  double seconds = 0;  ///< by the clock; threads that helped worked meanwhile

  /// pi minus the lowest largest angle that a mesh of the region can have: nu_opt, but for that no
  /// triangulation is below 60 degrees.
  [[nodiscard]] Angle lowest_nu() const { return std::min(nu_opt, Angle::degrees(120)); }

  /// (pi - gamma) / min(B, pi/2). Where B is no more than pi/2, 1 is the optimum; else it is above
  /// 1 where all angles are below 90 degrees, and 1 with a right angle as the largest.
  [[nodiscard]] double rho() const;
};

/// What a region had in an existing mesh before it was meshed again.
struct Replaced {
  RegionId region;
  std::size_t triangles = 0;
  std::size_t steiner_vertices = 0;
};

/// The whole run.
struct Report {
  std::vector<RegionReport> regions;  ///< by RegionId - 1
  Quality quality;                    ///< over all regions
  std::vector<Note> notes;            ///< about the input as a whole
  std::vector<Change> changes;        ///< every one; the notes sum them up
  std::vector<BoxCut> box_cuts;       ///< Options::box_method: all of them, with their reasons
  std::vector<Replaced> replaced;     ///< remesh(): by region; else empty
  std::vector<StageTime> times;
  Provenance provenance;
  std::string unit;  ///< of the coordinates, as "nm"; empty: not said
  double scale = 1;  ///< what the file's coordinates were multiplied by
  /// Of the clean input, before any segment was cut; with cuts, Output::pslg has more. In a mesh
  /// that was read, as far as its file tells.
  std::size_t input_points = 0, input_segments = 0;
  std::size_t steiner_vertices = 0;  ///< inside regions: without those that cut segments
  unsigned threads = 1;
};

}  // namespace cover
