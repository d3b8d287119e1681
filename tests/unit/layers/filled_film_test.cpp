#include "layers/filled_film.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include <cover/cover_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"

namespace cover {
namespace {

/// A film from (0, 0) to (8, 1), its long sides in pieces of 1/4, the lower ones called 'gate'.
Input film() {
  constexpr std::uint32_t kPieces = 32;
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (std::uint32_t k = 0; k <= kPieces; ++k) points.push_back({k / 4.0, 0});
  for (std::uint32_t k = 0; k <= kPieces; ++k) points.push_back({(kPieces - k) / 4.0, 1});
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t k = 0; k < n; ++k) ends.push_back({k, (k + 1) % n});
  Input input = testing::segments_between(points, ends);
  for (std::uint32_t k = 0; k < kPieces; ++k) input.segments[k].name = "gate";
  return input;
}

LayerReport layers_of(double first, double growth, int count) {
  Options options;
  options.layers = {{"gate", "", first, growth, count}};
  const Output output = testing::must_mesh(film(), options);
  EXPECT_EQ(testing::violations(output), "");
  EXPECT_EQ(output.report.regions[0].layers.size(), 1U);
  const LayerReport& report = output.report.regions[0].layers[0];
  // Where there is no more room, a warning says so.
  const auto is_room = [](const LayerReport::Short& part) { return part.why == LayerStop::room; };
  const bool warns = std::any_of(report.cut_short.begin(), report.cut_short.end(), is_room);
  std::size_t notes = 0;
  for (const Note& note : output.report.regions[0].notes)
    notes += note.message.find("no more room") != std::string::npos ? 1 : 0;
  EXPECT_EQ(notes, warns ? 1U : 0U);
  return report;
}

bool has_room(const LayerReport& layers) {
  return std::none_of(layers.cut_short.begin(), layers.cut_short.end(),
                      [](const LayerReport::Short& part) { return part.why == LayerStop::room; });
}

TEST(CompleteFilledFilms, TheLastLayerIsWhatTheOthersLeave) {
  for (const auto& [first, growth, count] :
       {std::tuple(0.25, 1.0, 4), {0.125, 1.0, 8}, {1.0 / 15, 2.0, 4}}) {
    const LayerReport layers = layers_of(first, growth, count);
    EXPECT_TRUE(has_room(layers)) << count;
    EXPECT_EQ(layers.most, count);
    EXPECT_NEAR(layers.thickness, 1, 1e-12);
    EXPECT_GT(layers.complete, 15U);  // they taper off towards both ends
  }
}

TEST(CompleteFilledFilms, WhatIsThickerOrThinnerIsNoLayer) {
  for (const auto& [first, count] : {std::pair(0.24, 4), {0.26, 4}, {0.25, 5}, {0.2, 6}}) {
    const LayerReport layers = layers_of(first, 1, count);
    EXPECT_FALSE(has_room(layers)) << first << ", " << count;
    EXPECT_LT(layers.most, count);
  }
}

}  // namespace
}  // namespace cover
