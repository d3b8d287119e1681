// Scan conversion of a drawing, text left out.
#pragma once

#include <cstdint>
#include <vector>

#include "picture/drawing.hpp"

namespace cover {

/// An image, rows from the top, three bytes per pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  /// Mixes `colour` into a pixel; outside the image nothing happens.
  void blend(int x, int y, Colour colour, double share);
};

/// Paints everything but the labels, with smooth edges, on white.
Image paint(const Drawing& drawing);

}  // namespace cover
