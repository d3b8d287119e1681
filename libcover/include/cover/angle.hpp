// Angles without a unit to guess.
#pragma once

#include <compare>
#include <numbers>

namespace cover {

/// An angle. Large angles are kept as their supplement nu = pi - angle wherever accuracy matters:
/// an angle of pi - 1e-12 loses all its digits as a double, its supplement none.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * std::numbers::pi / 180); }

  [[nodiscard]] constexpr double in_radians() const { return radians_; }
  [[nodiscard]] constexpr double in_degrees() const { return radians_ * 180 / std::numbers::pi; }
  /// pi - this angle.
  [[nodiscard]] constexpr Angle supplement() const { return Angle(std::numbers::pi - radians_); }

  friend constexpr auto operator<=>(Angle, Angle) = default;

 private:
  constexpr explicit Angle(double radians) : radians_(radians) {}
  double radians_ = 0;
};

}  // namespace cover
