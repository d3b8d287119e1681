// Joined meshes to be thinned out and mended.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "mend/joined_mesh.hpp"

namespace cover::testing {

/// Rectangles beside each other, columns x rows small squares in all, halved by diagonals; the
/// regions change at every `width`-th column. Lines may be cut, and are, where squares meet them.
inline JoinedMesh rectangles(std::uint32_t columns, std::uint32_t rows, std::uint32_t width) {
  JoinedMesh mesh;
  const auto number = [&](std::uint32_t x, std::uint32_t y) { return y * (columns + 1) + x; };
  const double top = rows;
  const std::uint32_t strips = columns / width;
  // Lines: bottom and top of every strip, then walls from left to right.
  for (std::uint32_t s = 0; s < strips; ++s) {
    const double x = s * width, to = x + width;
    mesh.lines.push_back({{x, 0}, {to, 0}});
    mesh.lines.push_back({{x, top}, {to, top}});
  }
  for (std::uint32_t s = 0; s <= strips; ++s)
    mesh.lines.push_back({{double(s * width), 0}, {double(s * width), top}});
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) {
      mesh.points.push_back({double(x), double(y)});
      const bool wall = x % width == 0, edge = y == 0 || y == rows;
      const std::uint32_t strip = std::min(x / width, strips - 1);
      mesh.line.push_back(wall && edge ? JoinedMesh::kFixed
                          : wall       ? 2 * strips + x / width
                          : edge       ? 2 * strip + (y == 0 ? 0 : 1)
                                       : JoinedMesh::kInside);
      if (x < columns && edge)
        mesh.pieces.push_back({number(x, y), number(x + 1, y), 2 * strip + (y == 0 ? 0 : 1)});
      if (y < rows && wall)
        mesh.pieces.push_back({number(x, y), number(x, y + 1), 2 * strips + x / width});
      if (x == columns || y == rows) continue;
      mesh.triangles.push_back({number(x, y), number(x + 1, y), number(x + 1, y + 1)});
      mesh.triangles.push_back({number(x, y), number(x + 1, y + 1), number(x, y + 1)});
      mesh.region.insert(mesh.region.end(), 2, x / width);
    }
  }
  return mesh;
}

/// One triangle, 4 long and so high, whose sides may be cut.
inline JoinedMesh flat_triangle(double height) {
  const Point a{0, 0}, b{4, 0}, c{2, height};
  JoinedMesh mesh;
  mesh.points = {a, b, c};
  mesh.line.assign(3, JoinedMesh::kFixed);
  mesh.lines = {{a, b}, {b, c}, {c, a}};
  mesh.pieces = {{0, 1, 0}, {1, 2, 1}, {2, 0, 2}};
  mesh.triangles = {{0, 1, 2}};
  mesh.region = {0};
  return mesh;
}

/// A regular hexagon, whose sides stay whole, with a vertex inside.
inline JoinedMesh hexagon_around(Point inside) {
  JoinedMesh mesh;
  for (std::uint32_t k = 0; k < 6; ++k) {
    const double turn = std::numbers::pi / 3 * k;
    mesh.points.push_back({2 * std::cos(turn), 2 * std::sin(turn)});
    mesh.line.push_back(JoinedMesh::kFixed);
    mesh.pieces.push_back({k, (k + 1) % 6, k});
    mesh.triangles.push_back({k, (k + 1) % 6, 6});
    mesh.region.push_back(0);
  }
  mesh.points.push_back(inside);
  mesh.line.push_back(JoinedMesh::kInside);
  return mesh;
}

}  // namespace cover::testing
