// The clean planar straight-line graph that is meshed: what `-o x.poly` writes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <cover/arcs.hpp>
#include <cover/attribute.hpp>
#include <cover/ids.hpp>
#include <cover/input.hpp>
#include <cover/periodic.hpp>
#include <cover/point.hpp>

namespace cover {

/// A segment of the PSLG. On its left lies the region that `SegmentSides::left` names.
struct Segment {
  VertexId a;
  VertexId b;
  int marker = 0;            ///< boundary marker, 0 if none
  std::uint32_t name = 0;    ///< index into Pslg::names; 0 is "no name"
  long id = -1;              ///< of the user's file; -1: none
  std::uint32_t circle = 0;  ///< index into Pslg::circles plus one; 0: a straight line
};

/// A point that the input calls by a name. Several may have one name, and one may have several.
struct NamedPoint {
  VertexId vertex;
  std::string name;
};

/// Points and segments that meet only at points. Made by prepare() alone.
struct Pslg {
  std::vector<Point> points;           ///< by VertexId; all different
  std::vector<long> point_ids;         ///< of the user's file; -1: made by the split
  std::vector<int> point_markers;      ///< by VertexId, 0 if none
  std::vector<Segment> segments;       ///< by SegmentId; no two on the same pair of points
  std::vector<std::string> names{""};  ///< names of contacts and interfaces
  std::vector<RegionSeed> seeds;
  std::vector<HoleSeed> holes;
  VoidRule void_rule = VoidRule::holes_only;
  /// By SegmentId: the seeds of the faces on its left and right, seen from a to b: an index into
  /// `seeds` plus one, or 0 for the void. Empty: faces are told by the places of seeds and holes.
  std::vector<std::array<std::uint32_t, 2>> side_seeds;
  std::vector<Attribute> attributes;  ///< by RegionSeed::feature
  std::vector<ArcCircle> circles;     ///< of the segments that are chords of arcs
  std::vector<SegmentPair> periodic;  ///< segments that are images of each other
  std::vector<Isometry> isometries;   ///< of `periodic`, one for each rule
  std::string source;                 ///< file name for messages
  std::vector<NamedPoint> named_points{};
  bool seeds_may_miss = false;  ///< as Input has it
};

}  // namespace cover
