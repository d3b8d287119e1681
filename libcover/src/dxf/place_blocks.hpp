// All blocks of a drawing put where they are inserted.
#pragma once

#include <string>
#include <vector>

#include <cover/result.hpp>

#include "dxf/drawing.hpp"

namespace cover {

/// (x, y) -> (a x + b y + c, d x + e y + f)
struct Affine {
  double a = 1, b = 0, c = 0, d = 0, e = 1, f = 0;

  [[nodiscard]] Point operator()(Point p) const {
    return {a * p.x + b * p.y + c, d * p.x + e * p.y + f};
  }
  /// First `inner`, then this.
  [[nodiscard]] Affine after(const Affine& inner) const;
  [[nodiscard]] bool is_identity() const;
  /// Whether circles stay circles, up to rounding.
  [[nodiscard]] bool is_similar() const;
  [[nodiscard]] bool is_mirrored() const { return a * e - b * d < 0; }
};

template <class Thing>
struct Placed {
  const Thing* thing = nullptr;
  Affine place;
  const std::string* layer = nullptr;  ///< its own, or that of the insert it is seen through
};

struct PlacedDrawing {
  std::vector<Placed<DxfCurve>> curves;
  std::vector<Placed<DxfText>> texts;
  std::vector<std::string> missing;  ///< blocks that are inserted and not there
};

/// Goes through all inserts. What is on layer 0 of a block is on the layer of the insert.
///
/// ENSURES: the result points into `drawing`
/// Errors:  unsupported_format, where blocks contain themselves, or hold more than kLayoutShapes
///          and kCellDepth allow
Result<PlacedDrawing> place_blocks(const DxfDrawing& drawing, const std::string& source);

}  // namespace cover
