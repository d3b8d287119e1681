// Periodic sides: segments and vertices that are images of each other.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <cover/ids.hpp>
#include <cover/options.hpp>
#include <cover/point.hpp>

namespace cover {

struct Input;

/// A map of the plane that keeps distances: (x, y) -> (xx x + xy y + x0, yx x + yy y + y0). Each
/// coefficient is a double and the rest that it lacks, so that images of points can be rounded
/// once.
struct Isometry {
  using Coefficient = std::array<double, 2>;  ///< rounded, and what rounding left
  Coefficient xx{1, 0}, xy{0, 0}, yx{0, 0}, yy{1, 0}, x0{0, 0}, y0{0, 0};
};

/// Two segments that are images of each other.
struct SegmentPair {
  SegmentId from;
  SegmentId to;
  bool turned = false;     ///< the image of the end a of `from` is the end b of `to`
  std::uint32_t rule = 0;  ///< index into Pslg::isometries
};

/// What came of one PeriodicRule.
struct PeriodicNodes {
  PeriodicRule rule;
  Isometry map;  ///< from the line PeriodicRule::from to PeriodicRule::to
  /// Vertices and their images, by vertex; a vertex that is its own image stands there too.
  std::vector<std::array<std::uint32_t, 2>> vertices;
  /// Edges and their images: the ends of an edge, then the images of these.
  std::vector<std::array<std::uint32_t, 4>> edges;
};

/// The smallest vertex that each of `vertices` vertices is joined to by any rule.
///
/// REQUIRES: all vertices of `periodic` are below `vertices`
std::vector<std::uint32_t> periodic_classes(const std::vector<PeriodicNodes>& periodic,
                                            std::size_t vertices);

/// The pairs that a mesh of `input` has to keep: those of the options, then those of the input;
/// equal ones are one.
std::vector<PeriodicRule> periodic_rules(const Input& input, const Options& options);

/// "'left' and 'right'".
std::string describe(const PeriodicRule& rule);

}  // namespace cover
