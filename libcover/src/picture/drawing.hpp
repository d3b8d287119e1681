// A picture as primitives in pixels, y downwards, in painting order: what SVG and PNG share.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// An sRGB colour.
struct Colour {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  friend constexpr auto operator<=>(Colour, Colour) = default;
};

/// Triangles of one colour.
struct PaintedPatch {
  Colour colour;
  bool clipped = true;  ///< to Drawing::plot
  std::vector<std::array<Point, 3>> triangles;
};

/// Straight lines of one colour and width.
struct Stroke {
  Colour colour;
  double width = 1;
  double opacity = 1;
  bool clipped = true;
  std::vector<std::array<Point, 2>> lines;
};

/// A circle line.
struct Ring {
  Colour colour;
  Point centre;
  double radius = 6;
  double width = 2;
};

/// A line of text; `at` is the left end, middle or right end of its base line.
struct Label {
  enum class Anchor { start, middle, end };
  std::string text;
  Point at;
  double size = 14;
  Anchor anchor = Anchor::start;
  bool halo = false;  ///< white around the letters, to be read on any ground
  bool bold = false;
  Colour colour{30, 30, 30};  ///< kInk
};

/// A rectangle in pixels.
struct PixelBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

using DrawingItem = std::variant<PaintedPatch, Stroke, Ring, Label>;

/// A picture.
struct Drawing {
  int width = 0;
  int height = 0;
  PixelBox plot;  ///< clipped items show only here
  std::vector<DrawingItem> items;
};

inline constexpr Colour kInk{30, 30, 30};  ///< of lines and letters
inline constexpr double kMargin = 16;      ///< around and between the parts of a picture
inline constexpr double kText = 14;        ///< size of ordinary letters

/// The four sides of a box as lines of `stroke`.
void add_outline(const PixelBox& box, Stroke& stroke);

/// The largest of 1, 2, 5 times a power of ten that is at most `value`.
/// REQUIRES: value > 0
double round_number(double value);

/// Width of a text in pixels, roughly; good enough to place labels and legends.
double text_width(const std::string& text, double size);

}  // namespace cover
