// Fills a remainder, part by part, with the first fill that keeps the bound.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "almond/fill/fill_memory.hpp"
#include "almond/fill/remainder.hpp"
#include "base/team.hpp"

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

/// Fills one remainder so that every triangle keeps pi - angle >= `nu`, up to rounding of
/// coordinates.
class RemainderFill {
 public:
  /// `plan` and `memory` outlive this object.
  RemainderFill(Remainder remainder, const FillPlan& plan, FillMemory& memory, double nu,
                std::stop_token stop, const Team& team = {});

  /// The first step, if the plan has it: refines the whole remainder.
  /// Returns the locked chords that kept a triangle from the bound; none if the bound holds.
  std::vector<std::uint32_t> refine();

  /// The other fills, for the parts that do not keep the bound so far. Where no fill does, the best
  /// of them is kept.
  FilledRemainder finish();

 private:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  [[nodiscard]] bool all_hold() const;
  [[nodiscard]] bool holds(const std::vector<Point>& points, const Triangles& triangles) const;
  void fill_part(std::span<const std::uint32_t> members);
  void keep_refined(const RemainderPart& part, const Triangles& triangles);
  void keep_filling(const RemainderPart& part, const Filling& filling);

  Remainder r_;
  const FillPlan& plan_;
  FillMemory& memory_;
  double nu_;
  std::stop_token stop_;
  Team team_;
  std::size_t known_;  ///< vertices before refinement
  bool held_ = false;  ///< after refinement
  std::vector<ChordSplit> refined_;
  FilledRemainder out_;
};

}  // namespace cover
