// Strong 32-bit ids: a vertex cannot be passed where a region is wanted.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace cover {

/// A 32-bit index that is only comparable with ids of the same kind.
template <class Tag>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t value) : value_(value) {}
  constexpr explicit Id(std::size_t value) : value_(static_cast<std::uint32_t>(value)) {}
  constexpr explicit Id(int value) : value_(static_cast<std::uint32_t>(value)) {}

  /// The plain number.
  [[nodiscard]] constexpr std::uint32_t value() const { return value_; }
  /// The number as an index into a vector.
  [[nodiscard]] constexpr std::size_t index() const { return value_; }

  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  std::uint32_t value_ = 0;
};

/// A point of the PSLG and, with the same number, a vertex of the mesh; Steiner vertices follow.
using VertexId = Id<struct VertexTag>;
/// A segment of the PSLG.
using SegmentId = Id<struct SegmentTag>;
/// A region; counts from 1. Zero is the void.
using RegionId = Id<struct RegionTag>;
/// A named line of the mesh: an interface, an outline or a contact; counts from 1. Zero is none.
using InterfaceId = Id<struct InterfaceTag>;

/// The void: what no material covers.
inline constexpr RegionId kVoid{0u};
/// "On no interface".
inline constexpr InterfaceId kNoInterface{0u};

/// Where a region, or an interface, stands in an array by them: their ids count from 1.
///
/// REQUIRES: id is neither kVoid nor kNoInterface
constexpr std::size_t place_of(RegionId id) { return id.index() - 1; }
constexpr std::size_t place_of(InterfaceId id) { return id.index() - 1; }

}  // namespace cover

template <class Tag>
struct std::hash<cover::Id<Tag>> {
  std::size_t operator()(cover::Id<Tag> id) const noexcept {
    return std::hash<std::uint32_t>{}(id.value());
  }
};
