// Polygon soups for tests.
#pragma once

#include <string>
#include <vector>

#include <cover/input.hpp>

#include "region/region_graph.hpp"
#include "support/inputs/shapes.hpp"

namespace cover::testing {

/// Adds a polygon of one ring.
InputPolygon& add_polygon(Input& input, const Loop& ring, const std::string& material,
                          const std::string& region = "");

/// A rectangle, counter-clockwise.
Loop rectangle(double x0, double y0, double x1, double y1);

/// An input made clean, with its regions.
struct Cleaned {
  Pslg pslg;
  RegionTable table;
  Report report;

  /// The area of all regions of a material.
  [[nodiscard]] double area(const std::string& material) const;
  /// True if a change of this kind, or a note, has these words.
  [[nodiscard]] bool tells(const std::string& words) const;
};

Result<Cleaned> clean(const Input& input, const Options& options = {});

}  // namespace cover::testing
