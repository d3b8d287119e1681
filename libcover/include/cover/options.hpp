// Every setting of the mesher, with its unit, default and legal range.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <cover/angle.hpp>
#include <cover/point.hpp>

namespace cover {

/// How a region is meshed.
enum class Method {
  quality,    ///< best of several candidates, improved; never below the almond method's bound
  almond,     ///< the covering triangulation of mitchell_1993_covering
  nonobtuse,  ///< disk packing with split boundary (bmr_1995): 90 degrees, by rounding 90.1
};

/// How the almond method fills what lies outside the almonds.
enum class Fill {
  refine,  ///< Delaunay refinement of large angles
  disks,   ///< nonobtuse triangulation by disk packing
};

/// Which polygon wins where several cover the same place and have equal priority.
enum class Overlap { last, first, error };

/// Which of two triangulations of a region the quality method takes for the better one.
enum class Prefer {
  /// fewer angles above 120 degrees, unless an angle degenerates for it; then the smaller fault, in
  /// which large and small angles weigh alike
  balanced,
  largest,  ///< the smaller largest angle, whatever the smallest one pays for it
};

/// How much the quality method tries.
enum class Effort {
  fast,      ///< refine and improve once
  normal,    ///< what pays for its time
  thorough,  ///< all there is
};

/// Whether angles give way to the box method's couplings or the other way round.
enum class Couplings {
  /// first; with split_interfaces and without box_method, in regions without layers, targets come
  /// before them
  automatic,
  /// no negative coupling that the boundary does not force; targets give way, the bound never
  first,
  last,  ///< targets come first
};

/// Which properties a mesh must have. cover_mesh() makes the mesh and judges none of them:
/// unmet_requirements() tells which it misses.
struct Requirements {
  bool bound = false;       ///< promise 3 in every region, without exception
  bool max_angle = false;   ///< no triangle above max_angle
  bool delaunay = false;    ///< no inner edge that fails the empty-circle test
  bool non_obtuse = false;  ///< no triangle above 90 degrees
  bool box_method = false;  ///< no negative coupling of the box method, by exact signs
};

/// A wished edge length for a material, region, interface, contact or point.
struct SizeRule {
  std::string name;  ///< empty: everywhere
  double size = 0;   ///< length, > 0; no meaning where there is an expression
  bool at = false;   ///< true: at the named line or point; false: inside the named region
  /// The length as a function of the place, "0.1 + 0.3*abs(y)"; empty: `size`. It has numbers, x,
  /// y, pi, ( ), + - * / ^ (to the right, before a sign: -2^2 is -4), and functions: min and max
  /// of one or more values, hypot(x, y) and atan2(y, x), abs, sqrt, exp, log (natural), sin, cos
  /// (radians), asinh, tanh. Where it is no number above zero there is no wish. Not with `at`.
  std::string expression{};
};

/// Layers of thin triangles along a line.
struct LayerRule {
  std::string line;    ///< interface, contact, outline or inner line, as `cover info` names it
  std::string region;  ///< the side on which the layers lie; empty: both
  double first = 0;    ///< thickness of the first layer, > 0; length
  double growth = 1;   ///< thickness of a layer over that of the one before, >= 1
  int count = 0;       ///< layers; 0: until triangles are about isotropic
};

/// Two chains of segments that are images of each other under an isometry.
struct PeriodicRule {
  /// `glide`: a mirror with a shift along its axis: in meshes of others, and never asked for.
  enum class Map { translation, rotation, mirror, glide };
  std::string from;  ///< name of one chain
  std::string to;    ///< name of its image
  Map map = Map::translation;
  Point centre;                     ///< of a rotation
  Angle angle = Angle::degrees(0);  ///< of a rotation, counter-clockwise

  bool operator==(const PeriodicRule&) const = default;
};

/// A wished edge length for every place; not finite or not above zero: none there. It may be called
/// from several threads at a time.
using SizeFunction = std::function<double(Point)>;

/// Options of `cover_mesh`. The default values are those of the command line.
struct Options {
  static constexpr double kGrowth = 1.3;

  Method method = Method::quality;
  Fill fill = Fill::refine;

  bool paper = false;  ///< the publication as printed, without our improvements; needs `almond`
  int pieces = 6;      ///< with `paper`: exterior pieces are at most 1/pieces of the arc; >= 2
  bool hull = false;   ///< mesh the convex hull: the paper's variant for any PSLG

  Angle max_angle = Angle::degrees(100);       ///< target of the quality method, in (60, 180)
  Angle min_angle = Angle::degrees(20);        ///< second target of the quality method, in [0, 60)
  Prefer prefer = Prefer::balanced;            ///< of the quality method
  Effort effort = Effort::normal;              ///< of the quality method
  Couplings couplings = Couplings::automatic;  ///< of the quality method

  /// Where several sizes hold, among them those of RegionSeed, the smallest counts.
  std::vector<SizeRule> sizes;
  bool input_sizes = true;      ///< false: those of the input's regions do not count
  SizeFunction size_field;      ///< background sizes; empty: none. See size_function()
  std::string size_field_name;  ///< of the background sizes, for reports
  double size_field_scale = 1;  ///< of places and lengths in its file, as Input::scale; > 0
  /// The file of the background sizes holds no lengths but values, of which this is a function: its
  /// name, "asinh", or as SizeRule::expression one of arrays' names, x and y; names that are not
  /// made of letters, digits and '_' stand in single quotes. Sizes are such that it changes by at
  /// most size_step from one end of an edge to the other. Empty: lengths.
  std::string size_of;
  double size_step = 1;  ///< > 0
  /// The shortest edge length that the background and expressions ask for, > 0. None: as they say.
  /// Sizes that are plain numbers count as they are.
  std::optional<double> min_size;
  /// Ratio of neighbouring edge lengths, > 1. None: kGrowth where there are sizes; elsewhere
  /// triangles grow as fast as their angles allow. With it and no sizes, they grow from the
  /// boundary's edges.
  std::optional<double> growth;
  bool box_method = false;  ///< cut segments until no coupling of the box method is negative
  std::optional<Angle> split_interfaces;  ///< cut segments until gamma_opt is at most this
  std::vector<LayerRule> layers;
  std::vector<PeriodicRule> periodic;

  Overlap overlap = Overlap::last;
  std::optional<double> weld;    ///< relative tolerance; none: auto for soups, 0 for a PSLG
  bool strict = false;           ///< any change to the input is an error
  bool merge_materials = false;  ///< unite touching faces of equal material

  Requirements require;  ///< for unmet_requirements()
  unsigned threads = 0;  ///< 0: all cores
};

}  // namespace cover
