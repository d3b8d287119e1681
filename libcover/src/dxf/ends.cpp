// Tested by tests/unit/dxf/read_dxf_test.cpp.
#include "dxf/ends.hpp"

#include <cmath>

namespace cover {

CurveEnds::CurveEnds(double size)
    : reach_(std::ldexp(size, -40)), farthest_(std::ldexp(size, 10)) {}

CurveEnds::Cell CurveEnds::cell_of(Point p) const {
  return {static_cast<std::int64_t>(std::floor(p.x / reach_)),
          static_cast<std::int64_t>(std::floor(p.y / reach_))};
}

void CurveEnds::add(Point p) {
  if (has_cell(p) && same(p) == p) points_.emplace(cell_of(p), p);
}

Point CurveEnds::same(Point p) const {
  if (!has_cell(p)) return p;
  const Cell cell = cell_of(p);
  for (std::int64_t x = cell.first - 1; x <= cell.first + 1; ++x) {
    for (std::int64_t y = cell.second - 1; y <= cell.second + 1; ++y) {
      const auto found = points_.find({x, y});
      if (found == points_.end()) continue;
      const Point q = found->second;
      if (std::abs(q.x - p.x) <= reach_ && std::abs(q.y - p.y) <= reach_) return q;
    }
  }
  return p;
}

}  // namespace cover
