// Tested by tests/unit/layers/front/offsets_test.cpp.
#include "layers/front/thickness.hpp"

namespace cover::layers {

Thickness::Thickness(const LayerRule& rule, double room) {
  const int most = rule.count > 0 ? rule.count : kMostRows;
  double layer = rule.first;
  for (int k = 0; k < most && totals_.back() + layer <= room; ++k) {
    layers_.push_back(layer);
    totals_.push_back(totals_.back() + layer);
    layer *= rule.growth;
  }
}

}  // namespace cover::layers
