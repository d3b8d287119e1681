// Coordinates that are angles on a globe.
#pragma once

namespace cover {

/// A warning for maps that are not projected.
inline constexpr const char* kInDegrees =
    "coordinates are longitudes and latitudes: lengths and angles are those of a plane of degrees; "
    "--crs EPSG:... projects them";

}  // namespace cover
