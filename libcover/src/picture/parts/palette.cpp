// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/parts/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cover {
namespace {

std::uint8_t channel(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

/// Hue in [0, 1), saturation and lightness in [0, 1].
Colour from_hsl(double hue, double saturation, double lightness) {
  const double reach = saturation * std::min(lightness, 1 - lightness);
  const auto part = [&](double n) {
    const double k = std::fmod(n + 12 * hue, 12.0);
    return channel(lightness - reach * std::max(-1.0, std::min({k - 3, 9 - k, 1.0})));
  };
  return {part(0), part(8), part(4)};
}

}  // namespace

Colour material_colour(std::size_t n) {
  constexpr std::array<Colour, 12> kChosen{{{158, 193, 223},
                                            {242, 196, 141},
                                            {172, 211, 158},
                                            {229, 159, 154},
                                            {196, 177, 214},
                                            {246, 224, 138},
                                            {150, 210, 203},
                                            {222, 176, 205},
                                            {203, 189, 171},
                                            {190, 206, 121},
                                            {166, 178, 196},
                                            {238, 186, 186}}};
  if (n < kChosen.size()) return kChosen[n];
  // The golden ratio spreads any number of hues evenly.
  const double hue = std::fmod(0.13 + 0.6180339887498949 * static_cast<double>(n), 1.0);
  return from_hsl(hue, 0.45, n % 3 == 0 ? 0.68 : n % 3 == 1 ? 0.76 : 0.82);
}

Colour shade(Colour colour, std::size_t variant) {
  constexpr std::array kFactor{0.0, 0.35, -0.12, 0.2, -0.06, 0.5};
  const double f = kFactor[variant % kFactor.size()];
  const auto mix = [&](std::uint8_t c) {
    const double v = c / 255.0;
    return channel(f >= 0 ? v + f * (1 - v) : v * (1 + f));
  };
  return {mix(colour.r), mix(colour.g), mix(colour.b)};
}

Colour contact_colour(std::size_t n) {
  constexpr std::array<Colour, 6> kChosen{
      {{192, 32, 38}, {24, 90, 170}, {20, 120, 70}, {150, 50, 140}, {190, 95, 0}, {0, 120, 135}}};
  return kChosen[n % kChosen.size()];
}

double part_of(double value, double low, double high) {
  if (!(high > low)) return 0;
  if (std::isinf(value)) return value > 0 ? 1 : 0;
  // Halves where no double is as large as the range.
  const double scale = std::isfinite(high - low) && std::isfinite(value - low) ? 1 : 0.5;
  return std::clamp((scale * value - scale * low) / (scale * high - scale * low), 0.0, 1.0);
}

Colour value_colour(double t) {
  // Nine samples of the map known as viridis, linear between.
  constexpr std::array<Colour, 9> kMap{{{68, 1, 84},
                                        {71, 44, 122},
                                        {59, 81, 139},
                                        {44, 113, 142},
                                        {33, 144, 141},
                                        {39, 173, 129},
                                        {92, 200, 99},
                                        {170, 220, 50},
                                        {253, 231, 37}}};
  const double s = std::clamp(t, 0.0, 1.0) * (kMap.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(s), kMap.size() - 2);
  const double f = s - static_cast<double>(i);
  const auto mix = [&](std::uint8_t a, std::uint8_t b) { return channel((a + f * (b - a)) / 255); };
  return {mix(kMap[i].r, kMap[i + 1].r), mix(kMap[i].g, kMap[i + 1].g),
          mix(kMap[i].b, kMap[i + 1].b)};
}

}  // namespace cover
