// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/parts/labels.hpp"

#include <algorithm>
#include <array>

namespace cover {
namespace {

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

}  // namespace

bool LabelPlacer::place(Label& label, Point anchor) {
  const double w = text_width(label.text, label.size), h = label.size;
  constexpr std::array<std::array<double, 2>, 8> kSides{
      {{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}}};
  for (const double distance : {9.0, 18.0, 32.0, 50.0, 75.0}) {
    for (const auto& [dx, dy] : kSides) {
      const double cx = anchor.x + dx * (distance + w / 2), cy = anchor.y + dy * (distance + h / 2);
      const PixelBox box{cx - w / 2 - 3, cy - h / 2 - 2, cx + w / 2 + 3, cy + h / 2 + 2};
      if (box.x0 < within_.x0 || box.x1 > within_.x1 || box.y0 < within_.y0 ||
          box.y1 > within_.y1 ||
          std::any_of(taken_.begin(), taken_.end(),
                      [&](const PixelBox& other) { return overlap(box, other); })) {
        continue;
      }
      taken_.push_back(box);
      label.anchor = Label::Anchor::middle;
      label.at = {cx, cy + 0.35 * h};
      return true;
    }
  }
  return false;
}

}  // namespace cover
