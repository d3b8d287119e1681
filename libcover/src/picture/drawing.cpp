// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/drawing.hpp"

#include <cmath>

namespace cover {

void add_outline(const PixelBox& b, Stroke& stroke) {
  const Point p{b.x0, b.y0}, q{b.x1, b.y0}, r{b.x1, b.y1}, s{b.x0, b.y1};
  stroke.lines.insert(stroke.lines.end(), {{p, q}, {q, r}, {r, s}, {s, p}});
}

double round_number(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double f : {5.0, 2.0}) {
    if (f * power <= value) return f * power;
  }
  return power;
}

double text_width(const std::string& text, double size) {
  double units = 0;
  for (const char c : text) {
    if ((c & 0xC0) == 0x80) continue;  // a further byte of one UTF-8 letter
    units += c == 'i' || c == 'l' || c == '.' || c == ',' || c == ' ' ? 0.29
             : c >= 'A' && c <= 'Z'                                   ? 0.68
                                                                      : 0.56;
  }
  return units * size;
}

}  // namespace cover
