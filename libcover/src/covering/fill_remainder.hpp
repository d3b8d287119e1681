// Fills a remainder, part by part, with the first fill that keeps the bound.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "covering/remainder.hpp"

namespace cover {

/// The fills to try, in order.
struct FillPlan {
  bool refine_first = true;                      ///< the default fill, on the whole remainder
  std::vector<std::unique_ptr<Filler>> fillers;  ///< for the parts where that falls short
  std::vector<std::string> names;                ///< by filler
};

/// A filled remainder.
struct FilledRemainder {
  std::vector<Point> points;  ///< those of the remainder, then added ones
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<ChordSplit> splits;  ///< by chord of the remainder, ascending
  struct Fallback {
    std::string filler;  ///< the fill that was kept
    bool held = false;   ///< it kept the bound
    Point at;            ///< a vertex of the part
  };
  std::vector<Fallback> fallbacks;  ///< parts where the first fill fell short
};

/// Fills `remainder` so that every triangle keeps pi - angle >= `nu`, up to rounding of
/// coordinates. Where no fill does, the best of them is kept.
FilledRemainder fill_remainder(Remainder remainder, const FillPlan& plan, double nu,
                               const std::stop_token& stop);

}  // namespace cover
