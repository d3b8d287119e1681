// The points and triangles of a mesh for writers that go through them in order.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include <cover/ids.hpp>
#include <cover/point.hpp>

#include "geom/box.hpp"

namespace cover {

/// Groups are those of MeshView::region_groups.
class CellSource {
 public:
  using Use = std::function<void(RegionId, std::span<const std::uint32_t> nodes)>;

  CellSource() = default;
  CellSource(const CellSource&) = delete;
  CellSource& operator=(const CellSource&) = delete;
  virtual ~CellSource() = default;

  [[nodiscard]] virtual std::size_t points() const = 0;
  [[nodiscard]] virtual std::size_t triangles() const = 0;
  [[nodiscard]] virtual std::size_t triangles(std::size_t group) const = 0;
  virtual void each_point(const std::function<void(Point)>& use) const = 0;
  virtual void each_triangle(const Use& use) const = 0;
  virtual void each_triangle(std::size_t group, const Use& use) const = 0;
  /// A node of a line.
  [[nodiscard]] virtual Point line_point(std::uint32_t node) const = 0;
  [[nodiscard]] virtual Box box(std::size_t group) const = 0;
};

}  // namespace cover
