// The cells of a mesh in memory.
#pragma once

#include <cstdint>
#include <functional>

#include <cover/mesh_view.hpp>

#include "base/containers/buckets.hpp"
#include "geom/box.hpp"
#include "io/write_mesh/cell_source.hpp"

namespace cover {

/// A mesh in memory.
class ViewCells final : public CellSource {
 public:
  /// Groups are asked for only `by_group`.
  ViewCells(const MeshView& view, bool by_group)
      : view_(view),
        groups_(view.region_groups.size(), by_group ? view.triangles.size() : 0,
                [&](std::size_t t) { return view.region_group[place_of(view.region[t])]; }) {}

  [[nodiscard]] std::size_t points() const override { return view_.points.size(); }
  [[nodiscard]] std::size_t triangles() const override { return view_.triangles.size(); }
  [[nodiscard]] std::size_t triangles(std::size_t group) const override {
    return groups_[group].size();
  }
  void each_point(const std::function<void(Point)>& use) const override {
    for (const Point& p : view_.points) use(p);
  }
  void each_triangle(const Use& use) const override {
    for (std::size_t t = 0; t < view_.triangles.size(); ++t)
      use(view_.region[t], view_.triangles[t]);
  }
  void each_triangle(std::size_t group, const Use& use) const override {
    for (const std::size_t t : groups_[group]) use(view_.region[t], view_.triangles[t]);
  }
  [[nodiscard]] Point line_point(std::uint32_t node) const override { return view_.points[node]; }
  [[nodiscard]] Box box(std::size_t group) const override {
    Box box;
    for (const std::size_t t : groups_[group]) {
      for (const std::uint32_t node : view_.triangles[t]) box.add(view_.points[node]);
    }
    return box;
  }

 private:
  const MeshView& view_;
  Buckets groups_;
};

}  // namespace cover
