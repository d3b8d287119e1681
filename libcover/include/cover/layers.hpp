// What became of the layers along a line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cover/options.hpp>
#include <cover/point.hpp>

namespace cover {

/// Why layers along a part of a line are fewer than asked for.
enum class LayerStop {
  none,       ///< they are as many as asked for
  isotropic,  ///< no number was asked for, and the next one would be thicker than segments are long
  corner,     ///< layers of another line, or of another side, lie there, which is as good
  end,        ///< they taper off towards an end of the line, or towards where there are fewer
  room,       ///< another segment, a point or other layers are in the way
  turned,     ///< the line bends too much for them
  withdrawn,  ///< the region would break the bound
  couplings,  ///< couplings inside would be negative, which Couplings::last allows
};
inline constexpr std::size_t kLayerStops = 8;

/// "they taper off", ...; empty where nothing is cut short.
const char* describe(LayerStop stop);

/// The layers along one line, in one region.
struct LayerReport {
  LayerRule asked;
  std::size_t segments = 0;  ///< sides of the line in the region
  double length = 0;         ///< of them
  std::size_t complete = 0;  ///< segments with all layers asked for, or until isotropic
  int fewest = 0;            ///< layers over a whole segment
  int most = 0;
  double thickness = 0;  ///< of the most
  /// Segments with fewer.
  struct Short {
    LayerStop why = LayerStop::none;
    std::size_t segments = 0;
    Point at;  ///< the middle of the first
  };
  std::vector<Short> cut_short;  ///< in the order of LayerStop
};

}  // namespace cover
