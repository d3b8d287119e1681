// From the coordinates of a map's layer to those of a plane.
#pragma once

#include <memory>
#include <string>

#include <ogr_spatialref.h>

#include <cover/result.hpp>

namespace cover {

/// What the coordinates of a layer are, and what becomes of them.
struct MapProjection {
  std::unique_ptr<OGRCoordinateTransformation> transform;  ///< nullptr: they are taken as they are
  bool degrees = false;  ///< whether the result is longitudes and latitudes
  std::string unit;      ///< "m" where the result is said to be metres
};

/// `system` is the layer's and may be nullptr; `wanted` as "EPSG:25832", empty: none.
///
/// Errors: bad_option, where PROJ does not know `wanted` or the layer does not say what it has
Result<MapProjection> projection_of(const OGRSpatialReference* system, const std::string& wanted);

}  // namespace cover
