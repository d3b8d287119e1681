// A corner of a triangle, and with it the edge opposite.
#pragma once

#include <array>
#include <cstdint>

namespace cover {

/// 0, 1 or 2, counter-clockwise: a corner, or the edge opposite to it, which runs from the next
/// corner to the previous one. It indexes whatever a triangle has three of.
///
/// A half-edge 3 t + i starts at corner i instead, so that it is the edge opposite to the previous.
class Corner {
 public:
  /// REQUIRES: index < 3
  constexpr Corner(std::uint32_t index = 0) : index_(index) {}

  constexpr operator std::uint32_t() const { return index_; }

  [[nodiscard]] constexpr Corner next() const { return index_ == 2 ? 0 : index_ + 1; }
  [[nodiscard]] constexpr Corner previous() const { return index_ == 0 ? 2 : index_ - 1; }

 private:
  std::uint32_t index_;
};

/// The corner of a triangle at which vertex `w` is, or the edge across which triangle `w` is.
///
/// REQUIRES: `w` is one of the three
constexpr Corner corner_with(const std::array<std::uint32_t, 3>& three, std::uint32_t w) {
  return three[0] == w ? 0U : three[1] == w ? 1U : 2U;
}

/// The three corners in order: `for (const Corner i : kCorners)`.
inline constexpr struct AllCorners {
  struct Iterator {
    std::uint32_t index;
    constexpr Corner operator*() const { return index; }
    constexpr Iterator& operator++() { return ++index, *this; }
    constexpr bool operator==(const Iterator&) const = default;
  };
  [[nodiscard]] static constexpr Iterator begin() { return {0}; }
  [[nodiscard]] static constexpr Iterator end() { return {3}; }
} kCorners;

}  // namespace cover
