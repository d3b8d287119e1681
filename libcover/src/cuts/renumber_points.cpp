// Tested by tests/unit/cuts/renumber_points_test.cpp.
#include "cuts/renumber_points.hpp"

#include <algorithm>

namespace cover {
namespace {

/// Moves every value to the place of its new id; a list that is left empty stays so.
template <class T>
void permute(std::vector<T>& values, std::span<const VertexId> new_ids) {
  std::vector<T> before = values;
  for (std::size_t v = 0; v < before.size(); ++v) values[new_ids[v].index()] = std::move(before[v]);
}

}  // namespace

void renumber_points(Pslg& pslg, RegionTable& table, std::span<const VertexId> new_ids) {
  permute(pslg.points, new_ids);
  permute(pslg.point_ids, new_ids);
  permute(pslg.point_markers, new_ids);
  const auto renumber = [&](VertexId& v) { v = new_ids[v.index()]; };
  for (NamedPoint& point : pslg.named_points) renumber(point.vertex);
  for (Segment& s : pslg.segments) {
    renumber(s.a);
    renumber(s.b);
  }
  for (VertexId& v : table.void_points) renumber(v);
  std::sort(table.void_points.begin(), table.void_points.end());
  for (IsolatedPoint& p : table.isolated_points) renumber(p.vertex);
  for (HullSide& side : table.hull_sides) {
    renumber(side.a);
    renumber(side.b);
  }
}

}  // namespace cover
