#include "io/images/speckles.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "base/containers/union_find.hpp"

namespace cover {
namespace {

/// The sets of pixels of an image, by number: 0, 1, ... in the order of their first pixels.
struct Sets {
  std::vector<std::uint32_t> of;     ///< by pixel
  std::vector<std::size_t> pixels;   ///< by set: how many
  std::vector<std::uint32_t> label;  ///< by set
};

/// Calls `use(p, q)` for every two pixels that share a side.
template <class Use>
void each_side(const LabelImage& image, Use use) {
  for (std::size_t p = 0; p < image.labels.size(); ++p) {
    if ((p + 1) % image.width != 0) use(p, p + 1);
    if (p + image.width < image.labels.size()) use(p, p + image.width);
  }
}

Sets sets_of(const LabelImage& image) {
  UnionFind joined(image.labels.size());
  each_side(image, [&](std::size_t p, std::size_t q) {
    if (image.labels[p] == image.labels[q])
      joined.unite(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q));
  });
  constexpr std::uint32_t kNew = 0xffffffffU;
  std::vector<std::uint32_t> number(image.labels.size(), kNew);
  Sets sets;
  sets.of.reserve(image.labels.size());
  for (std::size_t p = 0; p < image.labels.size(); ++p) {
    std::uint32_t& set = number[joined.find(static_cast<std::uint32_t>(p))];
    if (set == kNew) {
      set = static_cast<std::uint32_t>(sets.pixels.size());
      sets.pixels.push_back(0);
      sets.label.push_back(image.labels[p]);
    }
    sets.of.push_back(set);
    ++sets.pixels[set];
  }
  return sets;
}

/// The label that each small set takes, or its own where no neighbour is large.
std::vector<std::uint32_t> taken_by(const LabelImage& image, const Sets& sets, std::size_t least) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> sides;  // small set, large set
  each_side(image, [&](std::size_t p, std::size_t q) {
    for (const auto& [small, large] :
         {std::pair(sets.of[p], sets.of[q]), std::pair(sets.of[q], sets.of[p])})
      if (sets.pixels[small] < least && sets.pixels[large] >= least) ++sides[{small, large}];
  });
  std::vector<std::uint32_t> label = sets.label;
  std::vector<std::size_t> longest(label.size(), 0);
  for (const auto& [pair, length] : sides) {
    if (length <= longest[pair.first]) continue;
    longest[pair.first] = length;
    label[pair.first] = sets.label[pair.second];
  }
  return label;
}

}  // namespace

std::size_t take_in_speckles(LabelImage& image, std::size_t least) {
  std::size_t speckles = 0;
  for (bool first = true;; first = false) {
    const Sets sets = sets_of(image);
    if (first)
      speckles = static_cast<std::size_t>(std::count_if(sets.pixels.begin(), sets.pixels.end(),
                                                        [&](std::size_t n) { return n < least; }));
    const std::vector<std::uint32_t> label = taken_by(image, sets, least);
    if (label == sets.label) return speckles;
    for (std::size_t p = 0; p < image.labels.size(); ++p) image.labels[p] = label[sets.of[p]];
  }
}

}  // namespace cover
