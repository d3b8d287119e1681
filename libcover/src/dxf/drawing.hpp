// A drawing as dxflib tells it: curves and texts, in blocks.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include <cover/point.hpp>
#include <cover/result.hpp>

#include "dxf/dxf_groups.hpp"

namespace cover {

/// A corner of a polyline, and the tangent of a quarter of the angle that the arc to the next one
/// spans; 0: straight; negative: clockwise.
struct BulgeCorner {
  Point at;
  double bulge = 0;
};

struct BulgePolyline {
  std::vector<BulgeCorner> corners;
  bool closed = false;
  bool wide = false;  ///< drawn with a width
};

/// A piece of a circle, counter-clockwise; degrees, to > from.
struct DxfArc {
  Point centre;
  double radius = 0;
  double from = 0;
  double to = 360;
};

/// centre + cos(t) major + sin(t) minor, t in degrees, to > from.
struct DxfEllipse {
  Point centre;
  Point major;
  Point minor;
  double from = 0;
  double to = 360;
};

/// A rational B-spline, or points that one was laid through.
struct DxfSpline {
  std::size_t degree = 3;
  std::vector<double> knots;
  std::vector<Point> controls;
  std::vector<double> weights;  ///< as many
  std::vector<Point> fits;
  bool closed = false;
};

struct DxfCurve {
  std::string layer;
  std::variant<BulgePolyline, DxfArc, DxfEllipse, DxfSpline> shape;
};

struct DxfPoint {
  std::string layer;
  Point at;
};

struct DxfText {
  std::string layer;
  Point at;
  std::string text;
};

/// A block in a drawing or block, once or in rows and columns that are apart.
struct DxfInsert {
  std::string layer;
  std::string block;
  Point at;
  double scale_x = 1;
  double scale_y = 1;
  double angle = 0;  ///< degrees
  int columns = 1;
  int rows = 1;
  double column_step = 0;
  double row_step = 0;
  bool mirrored = false;  ///< seen from behind: x is negated last
};

struct DxfBlock {
  Point base;
  std::vector<DxfCurve> curves;
  std::vector<DxfPoint> points;
  std::vector<DxfText> texts;
  std::vector<DxfInsert> inserts;
};

struct DxfDrawing {
  DxfBlock model;
  std::map<std::string, DxfBlock> blocks;
  std::size_t tilted = 0;          ///< entities that are not in the plane: left out
  std::size_t without_radius = 0;  ///< circles and arcs whose radius is not positive: left out
  std::size_t meshes = 0;          ///< polylines that are surfaces: left out
  std::size_t in_space = 0;        ///< lines and curves whose z differs along them: it is dropped
};

/// Lets dxflib read the text.
///
/// Errors: syntax
Result<DxfDrawing> build_drawing(const CheckedDxf& checked, const std::string& source);

}  // namespace cover
