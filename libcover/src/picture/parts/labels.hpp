// Places labels beside points so that they do not cover each other.
#pragma once

#include <vector>

#include "picture/drawing.hpp"

namespace cover {

/// Remembers what is covered already.
class LabelPlacer {
 public:
  explicit LabelPlacer(PixelBox within) : within_(within) {}

  /// Moves `label`, which belongs to the point `anchor`, to the nearest free place around it.
  /// False if there is none; then the label is better left out.
  bool place(Label& label, Point anchor);
  /// Marks a box as covered.
  void block(PixelBox box) { taken_.push_back(box); }

 private:
  PixelBox within_;
  std::vector<PixelBox> taken_;
};

}  // namespace cover
