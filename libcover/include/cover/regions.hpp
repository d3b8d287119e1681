// Which regions, materials and interfaces a PSLG has: what `cover info` shows.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/attribute.hpp>
#include <cover/error.hpp>
#include <cover/ids.hpp>
#include <cover/point.hpp>
#include <cover/pslg.hpp>

namespace cover {

/// A region: a maximal connected open set bounded by segments, of one material.
struct Region {
  RegionId id;
  int material = 0;             ///< positive
  std::string name;             ///< of the region; never empty
  std::string material_name;    ///< never empty
  std::optional<Point> inside;  ///< a point strictly inside; none where there is no double
  double area = 0;
  std::size_t sides = 0;       ///< segments on its boundary, slits counted twice
  std::optional<double> size;  ///< wished edge length, if a seed gives one
};

/// What a named line separates.
enum class InterfaceKind {
  interface,  ///< two regions
  outline,    ///< a region and the void
  slit,       ///< a region and itself
  contact,    ///< a part of any of these that the input named
};

/// "interface", "outline", "slit", "contact".
std::string describe(InterfaceKind kind);

/// The segments between one pair of regions, or one contact between them.
/// `left` is the lower region id that is not the void. A segment keeps the direction that it has in
/// the PSLG, in which any of both may be on its left: RegionTable::sides tells.
struct Interface {
  InterfaceId id;
  InterfaceKind kind = InterfaceKind::interface;
  std::string name;  ///< unique per (name, left, right)
  RegionId left;
  RegionId right;  ///< kVoid for an outline
  double length = 0;
  /// Chain by chain, each so that `left` is on its left.
  std::vector<SegmentId> segments;
};

/// The two sides of a segment, seen from its point a to its point b.
struct SegmentSides {
  RegionId left;
  RegionId right;
  InterfaceId interface = kNoInterface;  ///< none where both sides are void
};

/// A point inside a region that is on no segment.
struct IsolatedPoint {
  VertexId vertex;
  RegionId region;
};

/// An edge of the convex hull that is no segment, seen from the region on its left (`--hull`).
struct HullSide {
  VertexId a;
  VertexId b;
  RegionId region;
};

/// The regions of a PSLG.
struct RegionTable {
  std::vector<Region> regions;           ///< by RegionId - 1
  std::vector<Interface> interfaces;     ///< by InterfaceId - 1
  std::vector<SegmentSides> sides;       ///< by SegmentId
  std::vector<VertexId> void_points;     ///< points that touch no region: left out of the mesh
  std::vector<SegmentId> void_segments;  ///< segments that touch no region: left out of the mesh
  std::vector<IsolatedPoint> isolated_points;
  std::vector<HullSide> hull_sides;  ///< only where the convex hull is the domain
  std::vector<Point> void_seeds;     ///< a point inside each enclosed void face
  /// Kept attributes of a map, by RegionId - 1. Where several features are one region, those of the
  /// first count.
  std::vector<Attribute> attributes;

  /// REQUIRES: id is not kVoid
  [[nodiscard]] const Region& region(RegionId id) const { return regions[place_of(id)]; }
  [[nodiscard]] Region& region(RegionId id) { return regions[place_of(id)]; }
  /// REQUIRES: id is not kNoInterface
  [[nodiscard]] const Interface& interface(InterfaceId id) const {
    return interfaces[place_of(id)];
  }
  [[nodiscard]] Interface& interface(InterfaceId id) { return interfaces[place_of(id)]; }
};

/// The regions meant by `name`: those with this name or this name of their material; where there
/// are none, those with this number of their material ("3"); else the one with this id
/// ("region:17"). In the order of ids; none if nothing is called so.
std::vector<RegionId> named_regions(const RegionTable& table, std::string_view name);

/// The segments of the interface, contact, outline or inner line called `name`; where there is
/// none, those of interfaces between two regions whose names make it, in either order; else those
/// with this boundary marker, "7" or "marker 7". In order.
std::vector<SegmentId> named_segments(const Pslg& pslg, const RegionTable& table,
                                      std::string_view name);

/// Why named_segments() finds nothing although the input has a line of that name: "the line 'gate'
/// touches no region that is meshed: ..."; empty where it has none.
std::string line_in_void(const Pslg& pslg, std::string_view name);

/// bad_option: there is no region of that name; "`what`: ..." and the nearest name that there is.
Error no_such_region(const RegionTable& table, const std::string& what, const std::string& name);

}  // namespace cover
