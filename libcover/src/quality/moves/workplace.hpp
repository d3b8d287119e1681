// What a move changes, and what it leaves behind.
//
// A move of improvement takes a triangle that misses the goal and tries to make the triangles
// around it better: `bool try_it(Workplace& work, std::uint32_t t)`. The keep-rule is the same for
// these four (flip, relocate, remove, restar): the largest excess of the triangles that are
// replaced goes down by what is worth the time (improvement_of), or, with fewer triangles, does not
// go up. What comes of joint and kick, which work on a copy, is judged by whoever asked for them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quality/fault/keep_rules.hpp"
#include "quality/mutable/cavity.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// A triangulation that moves are made on, with their buffers.
struct Workplace {
  static constexpr std::size_t kRoom = 64;  ///< for what most moves change
  static constexpr std::uint64_t kFewFlips = 4'096;
  static constexpr std::uint64_t kFlipsPerTriangle = 64;

  explicit Workplace(MutableMesh& whole) : mesh(whole), cavity(whole) { again.reserve(kRoom); }

  MutableMesh& mesh;
  Cavity cavity;
  Installed installed;
  std::vector<std::uint32_t> again;  ///< triangles to be looked at again after a move, in order
  std::uint64_t evaluations = 0;     ///< stars looked at so far
  /// A flip may make triangles beside its two worse, by their couplings, so that flips could follow
  /// each other around a vertex for ever. A few for each triangle are what is needed.
  std::uint64_t flips_left = kFewFlips + kFlipsPerTriangle * mesh.triangles.size();

  /// A changed triangle and those beside it are to be looked at again.
  void look_around(std::uint32_t t) {
    again.push_back(t);
    for (const std::uint32_t n : mesh.triangles[t].n) {
      if (!is_side(n)) again.push_back(n);
    }
  }
  void look_around_installed() {
    for (int k = 0; k < installed.count; ++k) {
      look_around(installed.triangles[static_cast<std::size_t>(k)]);
    }
  }
};

/// Tries something around triangle `t`.
///
/// ENSURES: false, and nothing has changed, if that helps nothing; else Workplace::again has grown
using Move = bool (*)(Workplace& work, std::uint32_t t);

}  // namespace cover
