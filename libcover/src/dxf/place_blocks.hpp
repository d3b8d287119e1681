// All blocks of a drawing put where they are inserted.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <cover/result.hpp>

#include "dxf/drawing.hpp"
#include "geom/affine.hpp"

namespace cover {

template <class Thing>
struct Placed {
  const Thing* thing = nullptr;
  Affine place;
  const std::string* layer = nullptr;   ///< its own, or that of the insert it is seen through
  const std::string* frozen = nullptr;  ///< the frozen layer of such an insert; nullptr: none is
};

struct PlacedDrawing {
  std::vector<Placed<DxfCurve>> curves;
  std::vector<Placed<DxfPoint>> points;
  std::vector<Placed<DxfText>> texts;
  std::vector<std::string> missing;  ///< blocks that are inserted and not there
};

/// Goes through all inserts. What is on layer 0 of a block is on the layer of the insert. What is
/// on `hidden` layers is not left out.
///
/// ENSURES: the result points into `drawing`
/// Errors:  unsupported_format, where blocks contain themselves, or hold more than kLayoutShapes
///          and kCellDepth allow
Result<PlacedDrawing> place_blocks(const DxfDrawing& drawing, const std::string& source,
                                   const std::map<std::string, HiddenLayer>& hidden);

}  // namespace cover
