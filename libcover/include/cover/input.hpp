// What a reader hands to the library: geometry as the user has it, clean or not.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cover/arcs.hpp>
#include <cover/attribute.hpp>
#include <cover/change.hpp>
#include <cover/options.hpp>
#include <cover/plane_field.hpp>
#include <cover/point.hpp>

namespace cover {

/// A segment between two points of Input::points.
struct InputSegment {
  std::uint32_t a = 0;       ///< index into Input::points
  std::uint32_t b = 0;       ///< index into Input::points
  int marker = 0;            ///< boundary marker of a .poly, 0 if none
  long id = 0;               ///< the id under which the user's file knows it
  int line = 0;              ///< line of the file, 0 if unknown
  std::string name;          ///< name of the contact or interface it belongs to, empty if none
  std::uint32_t circle = 0;  ///< index into Input::circles plus one; 0: a straight line
  std::uint32_t file = 0;    ///< index into Input::files, unless these are empty
};

/// "The region around this point is made of this material."
struct RegionSeed {
  Point at;
  std::string material;        ///< name, or the number as written; empty: a number of its own
  std::string region;          ///< name of the region, empty if none
  std::optional<double> size;  ///< wished edge length, if the file gives one; > 0
  long id = 0;
  int line = 0;
  std::uint32_t feature = 0;     ///< index into Input::attributes' values plus one; 0: none
  std::string label_layer = {};  ///< on which the text stands that it is made of; empty: of none
};

/// A seed of the void.
struct HoleSeed {
  Point at;
  long id = 0;
  int line = 0;
  std::string label_layer = {};  ///< as RegionSeed has it
};

/// A painted polygon of a soup. Rings are closed implicitly; inside is even-odd.
struct InputPolygon {
  std::vector<std::vector<Point>> rings;
  std::string material;
  std::string region;              ///< empty if none
  std::optional<double> priority;  ///< larger wins over smaller, and over the order
  long id = 0;
  std::optional<double> size;  ///< wished edge length where it is seen, if the file gives one; > 0
  /// By ring and point: the circle of the segment from that point on, as in InputSegment; a ring
  /// without any may be left out.
  std::vector<std::vector<std::uint32_t>> circles{};
  std::uint32_t feature = 0;  ///< index into Input::attributes' values plus one; 0: none
  std::uint32_t file = 0;     ///< index into Input::files, unless these are empty
};

/// A named open or closed polyline that must appear in the mesh: a contact.
struct InputLine {
  std::string name;
  std::vector<Point> points;
  long id = 0;
  std::vector<std::uint32_t> circles{};  ///< by point, as in InputPolygon; may be left out
  std::uint32_t file = 0;                ///< as InputSegment has it
};

/// A point that the input calls by a name, such as a well of a map. Several may have one name.
struct PointName {
  std::uint32_t point = 0;  ///< index into Input::points
  std::string name;         ///< not empty
};

/// Which bounded faces of a PSLG are void.
enum class VoidRule {
  holes_only,      ///< what a hole seed or the outside reaches (.poly)
  unseeded_faces,  ///< where there are region seeds: also every face without one (JSON, gmsh)
};

/// A field or a layer of a map that an option names.
struct AskedName {
  std::string option;     ///< as "material_field"
  std::string name;       ///< what it names
  bool is_there = false;  ///< whether the input has it
  std::string missing;    ///< else the sentence that tells, with the names that there are
};

/// Geometry before any check. Either the PSLG members or the polygons, or both, are filled.
struct Input {
  std::string source;                 ///< file name for messages
  std::string unit;                   ///< what the coordinates mean, as "nm"; empty: not said
  double scale = 1;                   ///< what the file's coordinates were multiplied by; > 0
  std::vector<std::string> warnings;  ///< what the reader left out; they go into the report
  std::vector<Point> points;
  std::vector<long> point_ids;     ///< by point, as the file numbers them; empty: index
  std::vector<int> point_lines;    ///< lines of the file; empty: unknown
  std::vector<int> point_markers;  ///< empty: none
  std::vector<InputSegment> segments;
  std::vector<HoleSeed> holes;
  std::vector<RegionSeed> seeds;
  VoidRule void_rule = VoidRule::holes_only;
  std::vector<InputPolygon> polygons;
  std::vector<InputLine> lines;
  std::shared_ptr<const PlaneField>
      field;                           ///< values that the file has beside its geometry: doping
  std::vector<Attribute> attributes;   ///< ReadOptions::keep_fields, by feature of a map
  std::vector<ArcCircle> circles;      ///< of segments, rings and lines that are chords of arcs
  std::vector<PeriodicRule> periodic;  ///< beside those of Options::periodic; equal ones are one
  std::vector<LayerRule> layers;       ///< before Options::layers, which win over them
  std::vector<Change> changes{};       ///< what the reader did to the geometry of its file
  /// The coordinate system of a map: "EPSG:25832" where its number is known, else its name as the
  /// file has it; empty: not said.
  std::string system{};
  std::vector<AskedName> asked{};  ///< filled where ReadOptions::is_one_of_several
  std::vector<PointName> point_names{};
  /// Whether VoidRule::unseeded_faces may make a face void by mistake, which is told then. Holes of
  /// a mesh that is read as geometry are meant.
  bool seeds_may_miss = false;
  /// What a drawing says of its unit where `unit` cannot be that, as "inches"; see units.hpp.
  std::string other_unit{};
  bool is_picture = false;            ///< coordinates are those of pixels, in no system of a map
  std::vector<std::string> fields{};  ///< attributes of a map, which options may name
  std::vector<std::string> files{};   ///< of which it was joined, each a `source`; empty: of none
};

}  // namespace cover
